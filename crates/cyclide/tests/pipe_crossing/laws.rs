//! Balls whose radius follows a law, and balls inside: against the balls that have exactly that radius, each found by itself, and the volume under their envelope
//! by quadrature.

use super::{askew, canals, crossing, normal, off_axes};
use cyclide::{
    Error, Point3, Vec3,
    construct::{CrossingPipe, CrossingSide, MadeCrossing, PipeCrossing},
    error::{CrossingError, PointError},
    surface::ParamSurface,
    topology::{Body, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Nodes and weights of Gauss and Legendre for six places of [-1, 1], those on one side.
const GAUSS: [[f64; 2]; 3] = [
    [0.238_619_186_083_196_9, 0.467_913_934_572_691],
    [0.661_209_386_466_264_5, 0.360_761_573_048_138_6],
    [0.932_469_514_203_152, 0.171_324_492_379_170_35],
];

/// The pair: radii, distance of the axes, their angle, and on which side the ball is.
#[derive(Clone, Copy)]
struct Pair {
    radii: [f64; 2],
    distance: f64,
    degrees: f64,
    side: CrossingSide,
}

/// A ball with the outer normals of both pipes at its contacts.
struct Ball {
    centre: Vec3,
    normals: [Vec3; 2],
}

impl Pair {
    fn whole(&self, blend: f64) -> PipeCrossing {
        askew(self.radii, self.distance, blend, self.degrees).with_side(self.side)
    }

    /// By how much of the ball's radius its center is farther from the axes than the pipes' surfaces.
    fn signs(&self) -> [f64; 2] {
        match self.side {
            CrossingSide::Outside => [1.0, 1.0],
            CrossingSide::Inside => [-1.0, -1.0],
            CrossingSide::Mixed => [1.0, -1.0],
        }
    }

    /// Outer normals point to the center, 1, or away from it, -1.
    fn towards(&self) -> f64 {
        if self.side == CrossingSide::Outside { 1.0 } else { -1.0 }
    }

    /// The ball of a radius in a direction: over the squares of both distances from the common normal of the axes, two linear conditions on the height and its square.
    fn ball(&self, angle: f64, radius: f64) -> Ball {
        let turn = self.degrees.to_radians();
        let [l1, l2] = [0, 1].map(|k: usize| self.radii[k] + self.signs()[k] * radius);
        let (d, s1, s2) = (self.distance, angle.sin().powi(2), (turn - angle).sin().powi(2));
        // (l1² - z²) s2 = (l2² - (d - z)²) s1.
        let (a, b, c) = (s1 - s2, -2.0 * d * s1, l1 * l1 * s2 - l2 * l2 * s1 + d * d * s1);
        let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
        // Both roots without cancelling; one has both distances real.
        let q = -0.5 * (b - root);
        let far = |z: f64| if s1 > s2 { (l1 * l1 - z * z) / s1 } else { (l2 * l2 - (d - z) * (d - z)) / s2 };
        let height = [c / q, q / a].into_iter().filter(|z| z.is_finite()).max_by(|x, y| far(*x).total_cmp(&far(*y)));
        let height = height.expect("a ball");
        let (sin, cos) = angle.sin_cos();
        let centre = Vec3::new(cos, sin, 0.0) * far(height).sqrt() + Vec3::Z * height;
        let second = Vec3::new(turn.cos(), turn.sin(), 0.0);
        let above = centre - Vec3::Z * d;
        let normals = [(centre - Vec3::X * centre.x) / l1, (above - second * above.dot(second)) / l2];
        Ball { centre, normals }
    }

    /// Volume of the body whose balls have the radii of a law, by quadrature of `z n_z` over its surface.
    fn volume(&self, law: impl Fn(f64) -> f64, length: f64) -> f64 {
        let steps = 1500;
        let h = 1e-5;
        let point = |angle: f64, part: f64| {
            let ball = self.ball(angle, law(angle));
            let motion =
                (self.ball(angle + h, law(angle + h)).centre - self.ball(angle - h, law(angle - h)).centre) / (2.0 * h);
            // Of directions from the center into the envelope the part along its way.
            let growth = -(law(angle + h) - law(angle - h)) / (2.0 * h);
            let axis = motion.unit().expect("a motion");
            let cosine = growth / motion.length();
            let ways = [0, 1].map(|k: usize| ball.normals[k] * -self.signs()[k]);
            let arms = ways.map(|n| (n - axis * n.dot(axis)).unit().expect("an arm"));
            let turn = arms[0].dot(arms[1]).clamp(-1.0, 1.0).acos();
            let arm = (arms[0] * ((1.0 - part) * turn).sin() + arms[1] * (part * turn).sin()) / turn.sin();
            let way = axis * cosine + arm * (1.0 - cosine * cosine).sqrt();
            (ball.centre + way * law(angle), way * -self.towards())
        };
        let mut sum = 0.0;
        let mut holes = [0.0, 0.0];
        let step = TAU / f64::from(steps);
        for k in 0..steps {
            // Beside the directions of the axes, where the ball is found as 0/0.
            let angle = (f64::from(k) + 0.371) * step;
            for (part, weight) in
                GAUSS.into_iter().flat_map(|[x, w]| [(0.5 - 0.5 * x, 0.5 * w), (0.5 + 0.5 * x, 0.5 * w)])
            {
                let along = (point(angle + h, part).0 - point(angle - h, part).0) / (2.0 * h);
                let turn = (point(angle, part + h).0 - point(angle, part - h).0) / (2.0 * h);
                let (at, n) = point(angle, part);
                let area = along.cross(turn);
                sum += at.z * n.z * area.length() * weight * step;
            }
            // What the contacts cut from both pipes, by Green's theorem.
            let ends = [angle - 0.5 * step, angle + 0.5 * step].map(|angle| self.ball(angle, law(angle)));
            for (pipe, hole) in holes.iter_mut().enumerate() {
                let (r, turn) = (self.radii[pipe], self.degrees.to_radians());
                let second = Vec3::new(turn.cos(), turn.sin(), 0.0);
                let across = Vec3::new(turn.sin(), -turn.cos(), 0.0);
                let place = |ball: &Ball| {
                    let n = ball.normals[pipe];
                    if pipe == 0 {
                        [ball.centre.x, n.y.atan2(n.z)]
                    } else {
                        [ball.centre.dot(second), n.dot(across).atan2(-n.z)]
                    }
                };
                let [[a0, f0], [a1, f1]] = ends.each_ref().map(place);
                let middle = 0.5 * (f0 + f1);
                let z = if pipe == 0 { r * middle.cos() } else { self.distance - r * middle.cos() };
                let nz = if pipe == 0 { middle.cos() } else { -middle.cos() };
                let way = if pipe == 0 { 1.0 } else { -1.0 };
                *hole += way * 0.5 * (a0 + a1) * (f1 - f0) * r * z * nz;
            }
        }
        let pipes = self.radii.map(|r| PI * r * r * length);
        sum + match self.side {
            CrossingSide::Outside => pipes[0] + pipes[1] - holes[0] - holes[1],
            CrossingSide::Inside => holes[0] + holes[1],
            CrossingSide::Mixed => pipes[1] - holes[1] - holes[0],
        }
    }
}

/// Pipes that overlap, a bridge, askew and not; outside, inside and mixed; with a radius and how much it changes.
const CASES: [(Pair, f64, f64); 10] = [
    (Pair { radii: [2.0, 2.0], distance: 3.0, degrees: 90.0, side: CrossingSide::Outside }, 0.5, 0.2),
    (Pair { radii: [2.0, 3.0], distance: 3.5, degrees: 70.0, side: CrossingSide::Outside }, 0.6, 0.15),
    (Pair { radii: [2.0, 1.5], distance: 3.8, degrees: 100.0, side: CrossingSide::Outside }, 0.9, 0.2),
    (Pair { radii: [2.0, 2.0], distance: 1.6, degrees: 90.0, side: CrossingSide::Inside }, 0.4, 0.0),
    (Pair { radii: [2.0, 3.0], distance: 2.5, degrees: 65.0, side: CrossingSide::Inside }, 0.4, 0.15),
    (Pair { radii: [3.0, 1.0], distance: 2.7, degrees: 115.0, side: CrossingSide::Inside }, 0.2, 0.08),
    (Pair { radii: [2.0, 2.0], distance: 3.0, degrees: 90.0, side: CrossingSide::Mixed }, 0.3, 0.0),
    (Pair { radii: [2.0, 3.0], distance: 4.0, degrees: 70.0, side: CrossingSide::Mixed }, 0.4, 0.12),
    (Pair { radii: [3.0, 2.0], distance: 3.6, degrees: 105.0, side: CrossingSide::Mixed }, 0.4, 0.15),
    (Pair { radii: [1.0, 3.0], distance: 2.8, degrees: 80.0, side: CrossingSide::Mixed }, 0.3, 0.1),
];

const VALUES: usize = 16;

/// A wave once up and twice, met in places between which the law has no other least or largest values.
fn wave(radius: f64, change: f64) -> Vec<[f64; 2]> {
    let at = |k: usize| TAU * k as f64 / VALUES as f64 + 0.2;
    let value = |angle: f64| radius + change * (0.7 * angle.cos() + 0.3 * (2.0 * angle + 1.0).sin());
    (0..VALUES).map(|k| [at(k), value(at(k))]).collect()
}

fn made(pair: &Pair, radius: f64, change: f64, tolerance: f64) -> MadeCrossing {
    let whole = pair.whole(radius).with_radii(&wave(radius, change)).and_then(|c| c.with_tolerance(tolerance));
    whole.and_then(|c| c.made()).expect("a crossing")
}

#[test]
fn balls_touch_both_pipes_and_have_the_radii_of_the_law() {
    for (pair, radius, change) in CASES {
        let tolerance = 1e-3 * radius;
        let crossing = made(&pair, radius, change, tolerance);
        assert!(crossing.body.is_solid() && crossing.blend.deviation <= tolerance);
        let values = wave(radius, change);
        let [least, most] = values.iter().fold([f64::INFINITY, 0.0_f64], |[a, b], [_, r]| [a.min(*r), b.max(*r)]);
        let [low, high] = crossing.blend.radii;
        let rounding = 1e-12 * most;
        assert!(low >= least - tolerance && low <= least + rounding, "{low} {least}");
        assert!(high >= most - rounding && high <= most + tolerance, "{high} {most}");
        let mut met = 0;
        for (surface, face) in canals(&crossing.body) {
            for s in [0.0, 0.3, 0.8] {
                let contacts = [0.0, 1.0].map(|t| surface.point(s, t));
                for (pipe, contact) in contacts.into_iter().enumerate() {
                    let off = off_axes(contact, pair.distance, pair.degrees)[pipe] - pair.radii[pipe];
                    assert!(off.abs() < 1e-12 * pair.distance, "{off}");
                }
                // The ball from its contact and the normals at both ends of the circle.
                let normals = [0.0, 1.0].map(|t| normal(surface, face, s, t));
                let (gap, turn) = (contacts[1] - contacts[0], normals[0] - normals[1]);
                let signed = gap.dot(turn) / turn.length_squared();
                let centre = contacts[0] + normals[0] * signed;
                let off = off_axes(centre, pair.distance, pair.degrees);
                for (off, (r, sign)) in off.into_iter().zip(pair.radii.into_iter().zip(pair.signs())) {
                    assert!((off - r - sign * signed.abs()).abs() < 1e-9 * pair.distance, "{off} {r} {signed}");
                }
                assert!(signed * pair.towards() > 0.0);
                for t in [0.25, 0.7] {
                    let (q, m) = (surface.point(s, t), normal(surface, face, s, t));
                    assert!((q + m * signed).distance(centre) < 1e-8 * pair.distance, "{t}");
                }
                // Between the values beside it, and one of them where it is.
                let angle = centre.y.atan2(centre.x).rem_euclid(TAU);
                let place = ((angle - values[0][0]).rem_euclid(TAU) / TAU * VALUES as f64 + 1e-9).floor();
                let [a, b] = [0, 1].map(|k: usize| values[(place as usize + k) % VALUES]);
                let (near, ball) = ((angle - a[0]).abs(), signed.abs());
                assert!(ball > a[1].min(b[1]) - tolerance && ball < a[1].max(b[1]) + tolerance);
                if near < 1e-9 {
                    met += 1;
                    assert!((ball - a[1]).abs() < 1e-9, "{ball} {}", a[1]);
                }
            }
        }
        // Each value starts one canal; corners of holes are put there too.
        assert_eq!(met, VALUES, "{radius}");
    }
}

#[test]
fn bodies_are_smooth_and_have_the_volume_under_the_envelope() {
    for (pair, radius, change) in CASES {
        let (angles, tolerance) = (wave(radius, change), 1e-5 * radius);
        let crossing = made(&pair, radius, change, tolerance);
        for shell in crossing.body.shells() {
            for joint in surface_joints(shell) {
                let crease = pair.side != CrossingSide::Inside && (joint.angle - FRAC_PI_2).abs() < 1e-9;
                assert!(joint.gap < 1e-12 * super::END && (joint.angle < 1e-8 || crease), "{joint:?}");
            }
        }
        // The law: cubic between values, slopes the harmonic means of chords, flat where these change their sign.
        let value = |k: usize| angles[k % VALUES][1];
        let gap = TAU / VALUES as f64;
        let slope = |k: usize| {
            let [left, right] = [value(k) - value(k + VALUES - 1), value(k + 1) - value(k)].map(|rise| rise / gap);
            if left * right > 0.0 { 2.0 * left * right / (left + right) } else { 0.0 }
        };
        let law = |angle: f64| {
            let x = (angle - angles[0][0]).rem_euclid(TAU) / gap;
            let (k, x) = (x.floor() as usize, x.fract());
            let (d, y) = (value(k + 1) - value(k), 1.0 - x);
            value(k) + d * x * x * (3.0 - 2.0 * x) + gap * x * y * (slope(k) * y - slope(k + 1) * x)
        };
        let expected = pair.volume(law, 2.0 * super::END + 1.0);
        let volume = crossing.body.outer.volume();
        // Of the quadrature, second order in steps of 1/1500 of the turn.
        assert!((volume - expected).abs() < 1e-3 * radius * radius * pair.distance, "{volume} {expected}");
    }
}

#[test]
fn hollows_and_notched_tubes_have_walls_of_one_thickness() {
    let wall = 0.15;
    let lens = Pair { radii: [2.0, 3.0], distance: 2.5, degrees: 65.0, side: CrossingSide::Inside };
    let body = lens.whole(0.4).with_wall(wall).and_then(|c| c.made()).expect("a hollow").body;
    assert!(body.is_solid() && body.voids.len() == 1);
    check_walls(&body, wall);
    let thick = lens.whole(0.4).with_wall(0.4).and_then(|c| c.made()).expect_err("no ball is left");
    assert_eq!(thick.reason(), "parameter-out-of-range");
    let notch = Pair { radii: [2.0, 3.0], distance: 4.0, degrees: 65.0, side: CrossingSide::Mixed };
    let body = notch.whole(0.4).with_wall(wall).and_then(|c| c.made()).expect("a tube").body;
    assert!(body.is_solid() && body.voids.is_empty());
    check_walls(&body, wall);
}

fn check_walls(body: &Body, wall: f64) {
    let faces = canals(body);
    let (outer, inner) = faces.split_at(faces.len() / 2);
    for ((outside, face), (inside, _)) in outer.iter().zip(inner) {
        for (s, t) in [(0.0, 0.0), (0.3, 0.4), (0.7, 1.0)] {
            let below = outside.point(s, t) - normal(outside, face, s, t) * wall;
            assert!(below.distance(inside.point(s, t)) < 1e-10);
        }
    }
}

#[test]
fn a_law_of_one_radius_is_that_radius_and_half_turns_take_laws_with_them() {
    let volume =
        |whole: Result<PipeCrossing, Error>| whole.and_then(|c| c.made()).expect("a crossing").body.outer.volume();
    let pair = || crossing([2.0, 3.0], 3.5, 0.6);
    let one = volume(pair());
    assert!((volume(pair().and_then(|c| c.with_radii(&[[1.0, 0.6], [4.0, 0.6]]))) / one - 1.0).abs() < 1e-6);
    // Pipes as long on both sides; the half turn about the common normal takes each to itself.
    let symmetric = |values: &[[f64; 2]]| {
        let pipes = [2.0, 3.0].map(|radius| CrossingPipe { radius, taper: 0.0, ends: [-12.0, 12.0] });
        volume(PipeCrossing::new(pipes, 3.5, 0.6).and_then(|c| c.with_angle(1.2)).and_then(|c| c.with_radii(values)))
    };
    let values = [[0.3, 0.5], [1.5, 0.7], [4.0, 0.6]];
    let turned = values.map(|[angle, radius]| [angle + PI, radius]);
    let (first, second) = (symmetric(&values), symmetric(&turned));
    assert!((first / second - 1.0).abs() < 1e-7 && (first / one - 1.0).abs() > 1e-6, "{first} {second}");
}

#[test]
fn laws_that_are_none_are_refused() {
    let refused = |values: &[[f64; 2]]| {
        crossing([2.0, 2.0], 4.4, 0.6)
            .and_then(|c| c.with_radii(values))
            .and_then(|c| c.made())
            .map(|_| ())
            .expect_err("no law")
    };
    assert_eq!(refused(&[]).reason(), "too-few-points");
    assert_eq!(refused(&[[0.0, 0.6], [1.0, -0.6]]).reason(), "radius-not-positive");
    assert_eq!(refused(&[[0.0, 0.6], [TAU, 0.7]]).reason(), "coincident-points");
    // Below half the gap in one place.
    assert_eq!(refused(&[[0.0, 0.6], [1.0, 0.2]]).reason(), "radius-too-small");
    // A law that leaps: the ball grows more than it moves on.
    let wild = crossing([2.0, 2.0], 3.0, 0.5).and_then(|c| c.with_radii(&[[0.0, 0.3], [0.1, 1.6], [0.2, 0.3]]));
    let wild = wild.and_then(|c| c.made()).map(|_| ()).expect_err("it folds");
    assert!(matches!(wild, Error::Crossing(CrossingError::Folds { left, .. }) if left <= 0.0), "{wild}");
    // One that no pieces follow, however short.
    let pair = Pair { radii: [1.46, 2.0], distance: 2.566, degrees: 90.0, side: CrossingSide::Inside };
    let leap = pair.whole(0.2).with_radii(&[[3.9566, 0.29], [3.9926, 0.1835]]).and_then(|c| c.made());
    assert_eq!(leap.map(|_| ()).expect_err("no pieces").reason(), "too-many-pieces");
}

#[test]
fn points_of_a_lens_are_in_both_pipes_and_of_a_notch_in_one() {
    let lens = Pair { radii: [2.0, 3.0], distance: 2.5, degrees: 65.0, side: CrossingSide::Inside };
    let body = lens.whole(0.4).made().expect("a lens").body;
    for face in body.outer.faces() {
        for (s, t) in [(0.2, 0.1), (0.5, 0.5), (0.9, 0.8)] {
            let p: Point3 = face.surface.point(s, t);
            let off = off_axes(p, lens.distance, lens.degrees);
            assert!(off[0] < 2.0 + 1e-12 && off[1] < 3.0 + 1e-12, "{off:?}");
        }
    }
    let notch = Pair { radii: [1.0, 3.0], distance: 2.8, degrees: 80.0, side: CrossingSide::Mixed };
    let body = notch.whole(0.3).made().expect("a notch").body;
    let mut cut = 0;
    for face in body.outer.faces() {
        for (s, t) in [(0.2, 0.1), (0.5, 0.5), (0.9, 0.8)] {
            let off = off_axes(face.surface.point(s, t), notch.distance, notch.degrees);
            assert!(off[0] > 1.0 - 1e-12 && off[1] < 3.0 + 1e-12, "{off:?}");
            cut += usize::from((off[0] - 1.0).abs() < 1e-9);
        }
    }
    assert!(cut > 0);
    let apart = Pair { distance: 4.2, ..notch }.whole(0.3).made().expect_err("they do not meet");
    assert_eq!(apart.reason(), "crossing-pipes-apart");
    // Hardly in each other: the shallowest notch that is cut is a solid.
    let shallow = |distance: f64| Pair { distance, ..notch }.whole(1e-4).made();
    assert!(shallow(3.9959).expect("a notch").body.is_solid());
    assert_eq!(shallow(3.9961).expect_err("too shallow").reason(), "crossing-pipes-apart");
}

/// What a pipe has in common with one a thousand times as wide: a lens of which the rounding of the wide pipe is the shape is refused by the size of its ball, a larger one is made.
#[test]
fn tiny_lenses_of_wide_pipes_are_made_or_refused_by_their_size() {
    let pipe = |radius| CrossingPipe { radius, taper: 0.0, ends: [-2000.0, 2000.0] };
    let lens = |overlap: f64, ball: f64| {
        let pair = PipeCrossing::new([pipe(1.0), pipe(1000.0)], 1001.0 - overlap, ball)?;
        pair.with_side(CrossingSide::Inside).made()
    };
    let made = lens(1e-2, 1e-3).unwrap_or_else(|e| panic!("{e}"));
    let bounds = made.body.bounds();
    assert!(made.body.is_solid() && bounds.max.z - 1.0 < 1e-12 && bounds.min.z - 0.99 > -1e-12, "{bounds:?}");
    for (overlap, ball) in [(1e-3, 1e-4), (1e-4, 1e-5)] {
        match lens(overlap, ball).map(|_| ()) {
            Err(Error::Point(PointError::BelowRoundingOfPlace { size, place, limit, .. })) => {
                assert!((size - ball).abs() <= 0.0 && place > 1000.0 && limit >= 2.0 * size);
            }
            other => panic!("{other:?}"),
        }
    }
}
