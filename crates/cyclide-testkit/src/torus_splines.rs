//! Awkward problems of splines on tori, and the laws that every such spline obeys, measured without what the kernel says of itself.

use crate::attack::Random;
use cyclide::{
    Frame, Point2, Point3, Vec2, Vec3,
    construct::{TorusSplineOptions, TorusTangent, TorusWinding},
    curve::ParamCurve,
    surface::{Torus, TorusSpline},
};
use std::f64::consts::PI;

/// A problem: the torus, the places, and how they are to be joined.
#[derive(Debug, Clone)]
pub struct Problem {
    /// The torus.
    pub torus: Torus,
    /// Places, modulo pi.
    pub places: Vec<Point2>,
    /// The rest.
    pub options: TorusSplineOptions,
}

impl Problem {
    /// A random problem of one of the hard kinds: random tangents, points along a circle with tangents turned back, repeated points,
    /// speeds of several decades, all kinds of windings, uneven knots, thin and fat tori in any position.
    #[must_use]
    pub fn awkward(seed: u64, case: u64) -> Self {
        let mut r = Random::new(seed, case);
        let torus = torus(&mut r);
        let n = 2 + r.below(5);
        let closed = r.chance(0.6);
        let kind = r.below(5);
        let speed = if kind == 3 { [-3.0, 2.0] } else { [-0.5, 0.5] };
        let line = r.pick(&[[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]]);
        let along = Vec2::new(line[0], line[1]);
        let mut places: Vec<Point2> = (0..n)
            .map(|i| match kind {
                // Along a circle.
                1 => Point2::new(0.3, 0.2) + along * (0.4 * i as f64),
                _ => Point2::new(r.between(-PI, PI), r.between(-PI, PI)),
            })
            .collect();
        if kind == 2 && n > 2 {
            let twin = r.below(n - 1);
            places[twin + 1] = places[twin] + Vec2::new(PI * r.pick(&[-1.0, 0.0, 1.0]), 0.0);
        }
        let tangents = (0..n).map(|_| tangent(&mut r, kind, along, speed)).collect();
        let half_turns = |r: &mut Random| [0, 1].map(|_| r.pick(&[-2, -1, 0, 1, 2]));
        let winding = if closed && r.chance(0.7) {
            TorusWinding::Total(half_turns(&mut r))
        } else if r.chance(0.2) {
            TorusWinding::PerSegment((0..if closed { n } else { n - 1 }).map(|_| half_turns(&mut r)).collect())
        } else {
            TorusWinding::Shortest
        };
        let mut knots = Vec::new();
        if r.chance(0.3) {
            let mut u = r.between(-5.0, 5.0);
            knots.push(u);
            for _ in 0..if closed { n } else { n - 1 } {
                u += r.decades(-1.5, 1.5);
                knots.push(u);
            }
        }
        Self { torus, places, options: TorusSplineOptions { closed, tangents, knots, winding, loops: kind == 2 } }
    }

    /// The spline.
    ///
    /// # Errors
    /// As the kernel refuses it.
    pub fn solve(&self) -> Result<TorusSpline, cyclide::Error> {
        TorusSpline::through_places(&self.torus, &self.places, &self.options)
    }

    /// What is wrong with a solution, as sentences: none where every law holds.
    #[must_use]
    pub fn faults(&self, spline: &TorusSpline) -> Vec<String> {
        let mut faults = faults(spline);
        self.interpolation(spline, &mut faults);
        if let (TorusWinding::Total(want), true) = (&self.options.winding, self.options.closed) {
            let got = winding(spline);
            if got != want.map(i64::from) || spline.winding() != Some(got) {
                faults.push(format!("winding {got:?}, told as {:?}, asked for {want:?}", spline.winding()));
            }
        }
        faults
    }

    fn interpolation(&self, spline: &TorusSpline, faults: &mut Vec<String>) {
        let size = self.torus.major_radius() + self.torus.minor_radius();
        for (i, place) in self.places.iter().enumerate() {
            let u = self.options.knots.get(i).copied().unwrap_or(i as f64);
            let jet = spline.jet_at_knot(u);
            let far = self.torus.frame().origin().to_vec().max_abs();
            // Rounding of a few operations on coordinates of this size.
            let gap = jet.point.distance(self.torus.point(*place));
            if !(gap <= 1e-14 * (size + far)) {
                faults.push(format!("point {i} is missed by {gap:e}"));
            }
            if let Some(TorusTangent::Rate(rate)) = self.options.tangents.get(i) {
                let want = self.torus.tangent(*place, *rate);
                let (piece, s) = spline.locate_knot(u);
                let h = spline.knots()[piece + 1] - spline.knots()[piece];
                let (error, allowed) = ((jet.d1 - want).length(), c1_bound(want, size, h));
                if !(error <= allowed) {
                    faults.push(format!("tangent {i} at {s} is off by {error:e}, allowed {allowed:e}"));
                }
            }
        }
    }
}

/// The bound on a jump of the first derivative: a tangent has an absolute error of about 1e-13 of the size over the piece, from control
/// points, whatever its length.
fn c1_bound(v: Vec3, size: f64, h: f64) -> f64 {
    1e-8 * v.length() + 1e-12 * size / h
}

fn torus(r: &mut Random) -> Torus {
    let major = r.decades(-1.0, 2.0);
    let minor = major * if r.chance(0.1) { 1.0 - r.decades(-3.0, -1.0) } else { r.between(0.05, 0.95) };
    let direction = |r: &mut Random| Vec3::new(r.normal(), r.normal(), r.normal());
    let origin = Point3::ORIGIN + direction(r) * major;
    let frame = if r.chance(0.3) { Ok(Frame::WORLD) } else { Frame::from_normal(origin, direction(r), direction(r)) };
    frame.and_then(|frame| Torus::new(frame, major, minor)).unwrap_or_else(|e| unreachable!("a ring torus: {e}"))
}

fn tangent(r: &mut Random, kind: usize, along: Vec2, speed: [f64; 2]) -> TorusTangent {
    if r.chance(0.25) {
        return TorusTangent::Free;
    }
    let length = r.decades(speed[0], speed[1]);
    let angle = r.between(-PI, PI);
    TorusTangent::Rate(match kind {
        // Along the circle, mostly backwards.
        1 => along * if r.chance(0.7) { -length } else { length },
        // Along one of the four families exactly.
        4 => {
            let [x, y] = r.pick(&[[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]]);
            Vec2::new(x, y) * if r.chance(0.5) { -length } else { length }
        }
        _ => Vec2::new(angle.cos(), angle.sin()) * length,
    })
}

/// What is wrong with a spline by itself: pieces apart, kinks, points off the torus, a rational form that is another curve.
#[must_use]
pub fn faults(spline: &TorusSpline) -> Vec<String> {
    let torus = spline.torus();
    let size = torus.major_radius() + torus.minor_radius();
    let reach = size + torus.frame().origin().to_vec().max_abs();
    let mut faults = Vec::new();
    let rational: Vec<_> = spline.pieces().iter().map(|piece| torus.piece_to_rational(piece)).collect();
    let n = rational.len();
    let length = |piece: usize| spline.knots()[piece + 1] - spline.knots()[piece];
    for piece in 0..n {
        if !(1..=4).contains(&rational[piece].degree()) {
            faults.push(format!("piece {piece} has degree {}", rational[piece].degree()));
        }
        for k in 0..=8 {
            let s = f64::from(k) / 8.0;
            let p = spline.piece_point(piece, s);
            // Rounding: of the angles, which are a few radians, and of coordinates.
            if !(off_torus(torus, p) <= 2e-14 * reach) {
                faults.push(format!("piece {piece} at {s} is {:e} off the torus", off_torus(torus, p)));
            }
            let gap = rational[piece].point(s).distance(p);
            if !(gap <= 1e-12 * reach) {
                faults.push(format!("piece {piece} at {s}: the rational form is {gap:e} away"));
            }
        }
        let next = if piece + 1 < n { piece + 1 } else { 0 };
        if piece + 1 == n && !spline.is_closed() {
            continue;
        }
        let (end, start) = (rational[piece].jet(1.0), rational[next].jet(0.0));
        let gap = end.point.distance(start.point);
        if !(gap <= 1e-13 * reach) {
            faults.push(format!("gap {gap:e} after piece {piece}"));
        }
        let (v, w) = (end.d1 / length(piece), start.d1 / length(next));
        let allowed = c1_bound(w, size, length(piece).min(length(next)));
        if !((v - w).length() <= allowed) {
            faults.push(format!(
                "jump {:e} of the derivative after piece {piece}, allowed {allowed:e}",
                (v - w).length()
            ));
        }
        // Through the angles the derivative has all its digits: this is the bound of rounding of the angles themselves.
        let (v, w) = (spline.unrolled_rate(piece, 1.0), spline.unrolled_rate(next, 0.0));
        let (error, allowed) = ((v - w).length(), 1e-11 * v.length() + 1e-14 / length(piece).min(length(next)));
        if !(error <= allowed) {
            faults.push(format!("jump {error:e} of the speed in the plane after piece {piece}, allowed {allowed:e}"));
        }
    }
    match spline.to_nurbs() {
        Ok(nurbs) if nurbs.weights().iter().all(|w| *w > 0.0) => {}
        Ok(_) => faults.push("a weight is not positive".into()),
        Err(error) => faults.push(format!("no rational form: {error}")),
    }
    faults
}

/// Distance of a point from a torus.
#[must_use]
pub fn off_torus(torus: &Torus, p: Point3) -> f64 {
    let (plane, z) = torus.frame().to_local(p);
    ((plane.x.hypot(plane.y) - torus.major_radius()).hypot(z) - torus.minor_radius()).abs()
}

/// Half turns of a closed spline, counted on dense points: places are found again and followed by the shortest way.
#[must_use]
pub fn winding(spline: &TorusSpline) -> [i64; 2] {
    let place = |piece: usize, s: f64| {
        spline.torus().locate(spline.piece_point(piece, s), f64::INFINITY).unwrap_or(Point2::new(f64::NAN, f64::NAN))
    };
    let (mut sum, mut last) = (Vec2::default(), place(0, 0.0));
    for piece in 0..spline.pieces().len() {
        for k in 1..=16 {
            let next = place(piece, f64::from(k) / 16.0);
            let d = next - last;
            let short = |x: f64| x - PI * (x / PI).round();
            sum += Vec2::new(short(d.x), short(d.y));
            last = next;
        }
    }
    [sum.x, sum.y].map(|x| (x / PI).round() as i64)
}
