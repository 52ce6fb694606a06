//! Cusps of a curve: places where its velocity vanishes and its direction jumps.
//!
//! The speed of a smooth piece has a kink at a cusp, at which quadrature halves its cells. A place of a cell that is slower than its neighbors
//! is searched by sections in the golden ratio; it is a cusp if hardly a speed is left there and the tangents on both sides point against each other.

use crate::base::golden_section::GoldenSection;
use crate::base::jet::AT_REST;
use crate::base::quadrature;
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve;

/// Even parts of a cell whose speeds are looked at.
const PARTS: usize = 8;
/// Sections of a bracket: to 4e-14 of it.
const SECTIONS: u32 = 64;
/// Tangents are compared so far beside the place, in parts of the bracket.
const BESIDE: f64 = 1e-3;
/// They are compared not nearer than this, in the parameter of the piece: velocities next to zero are rounding.
const LEAST_STEP: f64 = 1e-6;
/// A place at which this part of the speed beside it is left has none.
const NO_SPEED: f64 = 1e-6;
/// Tangents at a joint that differ by more than this, in radians, are a corner.
const CORNER: f64 = 1e-6;
/// A curvature that is so many times as large ten times nearer to an end grows without bound: as the root of the distance falls, it is 3.2 times.
const GROWS: f64 = 2.0;
/// Bends of a chord by less than this, in radians, are rounding beside an end at which the curve stands.
const STRAIGHT: f64 = 1e-3;
/// Part of the largest speed of a piece below which the least of some places tells of a cusp.
const SUSPICIOUS: f64 = 0.25;
/// Cells beyond this many follow rounding.
const MOST_CELLS: usize = 512;

/// A place where a curve comes to a stand and turns.
///
/// ```
/// use cyclide::{Point3, curve::cusps, rational::NurbsCurve};
/// let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from).to_vec();
/// let curve = NurbsCurve::new(3, vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], points, vec![1.0; 4])?;
/// let found = cusps(&curve);
/// assert!(found.len() == 1 && (found[0].t - 0.5).abs() < 1e-9);
/// assert!((found[0].angle - std::f64::consts::PI).abs() < 1e-2);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CurveCusp {
    /// The parameter, from 0 to 1.
    pub t: f64,
    /// The point there.
    pub point: Point3,
    /// The turn, radians: half a turn but at a joint, as seen a little beside the place.
    pub angle: f64,
}

/// The cusps of a curve within its pieces, and those of its joints at which both pieces come to a stand, in order. Joints at which the curve runs at
/// a speed and turns are corners: see [`joints`](crate::curve::joints).
#[must_use]
pub fn cusps(curve: &dyn ParamCurve) -> Vec<CurveCusp> {
    let n = curve.piece_count();
    let mut found = Vec::new();
    let mut before: Option<End> = None;
    for piece in 0..n {
        let Some(own) = OfPiece::new(curve, piece) else {
            before = None;
            continue;
        };
        if let (Some(End { stands: true, way: Some(a) }), End { stands: true, way: Some(b) }) = (before, own.ends[0]) {
            let angle = a.angle(b);
            if angle > CORNER.max(2.0 * BESIDE) {
                found.push(CurveCusp { t: piece as f64 / n as f64, point: curve.piece_point(piece, 0.0), angle });
            }
        }
        let place = |&(s, angle): &(f64, f64)| CurveCusp {
            t: (piece as f64 + s) / n as f64,
            point: curve.piece_point(piece, s),
            angle,
        };
        found.extend(own.inside.iter().map(place));
        before = Some(own.ends[1]);
    }
    found
}

/// True unless speeds, taken all over a piece, speak against a [cusp](place_of_cusp): that halves the speed of the places beside it at least, and the
/// search for it is dear.
pub(super) fn may_have_cusp(speeds: impl Iterator<Item = f64>) -> bool {
    let (least, most) =
        speeds.fold((f64::INFINITY, 0.0_f64), |(least, most), speed| (least.min(speed), most.max(speed)));
    // Not `<=`: what is no number speaks against nothing.
    !(least > SUSPICIOUS * most)
}

/// The parameter at which a piece turns at a stand inside, or that of an end at which it comes to a stand and bends without bound.
pub(super) fn place_of_cusp(curve: &dyn ParamCurve, piece: usize) -> Option<f64> {
    let size = curve.piece_point(piece, 0.0).distance(curve.piece_point(piece, 1.0));
    let bends = |end: usize| {
        let at = |off: f64| if end == 0 { off } else { 1.0 - off };
        let bend = |off: f64| curve.piece_jet(piece, at(off)).curvature().unwrap_or(0.0);
        let [far, near] = [BESIDE, 0.1 * BESIDE].map(bend);
        near > GROWS * far && near * size > STRAIGHT
    };
    let own = OfPiece::new(curve, piece)?;
    let at_end = |end: usize| (own.ends[end].stands && bends(end)).then_some(end as f64);
    own.inside.first().map(|(s, _)| *s).or_else(|| at_end(0)).or_else(|| at_end(1))
}

/// Where a piece comes to a stand.
struct OfPiece {
    /// Cusps inside: parameter of the piece, and turn.
    inside: Vec<(f64, f64)>,
    ends: [End; 2],
}

impl OfPiece {
    /// `None` if the speeds follow rounding.
    fn new(curve: &dyn ParamCurve, piece: usize) -> Option<Self> {
        let mut speed = |s: f64| curve.piece_speed(piece, s);
        let cells = quadrature::cells(&mut speed, 0.0, 1.0);
        if cells.len() > MOST_CELLS {
            return None;
        }
        let part = |k: usize| k as f64 / PARTS as f64;
        let places: Vec<f64> =
            cells.iter().flat_map(|c| (0..PARTS).map(move |k| c.a + (c.b - c.a) * part(k))).chain([1.0]).collect();
        let speeds: Vec<f64> = places.iter().map(|s| speed(*s)).collect();
        let largest = speeds.iter().copied().fold(0.0, f64::max);
        let ends = [[0, 1], [places.len() - 1, places.len() - 2]].map(|[end, next]| {
            let inside = places[end] + BESIDE * (places[next] - places[end]);
            let way = curve.piece_jet(piece, inside).d1.unit();
            let stands = speeds[end] <= AT_REST * largest || curve.piece_jet(piece, places[end]).tangent().is_none();
            End { stands, way }
        });
        let mut inside: Vec<(f64, f64)> = Vec::new();
        for k in 1..places.len() - 1 {
            if speeds[k] <= speeds[k - 1] && speeds[k] <= speeds[k + 1] {
                let bracket = [places[k - 1], places[k + 1]];
                if let Some((s, angle)) = cusp_between(curve, piece, bracket, &mut speed) {
                    // Two places that are equally slow have the same one between them.
                    if inside.last().is_none_or(|(last, _)| s - last > 2.0 * LEAST_STEP) {
                        inside.push((s, angle));
                    }
                }
            }
        }
        Some(Self { inside, ends })
    }
}

/// How a piece ends, seen inside.
#[derive(Clone, Copy)]
struct End {
    stands: bool,
    way: Option<Vec3>,
}

/// The place of a cusp and its turn, if there is one.
fn cusp_between(
    curve: &dyn ParamCurve,
    piece: usize,
    [a, b]: [f64; 2],
    speed: &mut impl FnMut(f64) -> f64,
) -> Option<(f64, f64)> {
    let s = GoldenSection::lowest(&mut *speed, [a, b], SECTIONS);
    let step = (BESIDE * (b - a)).max(LEAST_STEP);
    let [before, after] = [(s - step).max(0.0), (s + step).min(1.0)];
    if speed(s) > NO_SPEED * speed(before).min(speed(after)) {
        return None;
    }
    let [before, after] = [before, after].map(|s| curve.piece_jet(piece, s).d1.unit());
    let angle = before?.angle(after?);
    (angle > std::f64::consts::FRAC_PI_2).then_some((s, angle))
}

#[cfg(test)]
mod tests {
    use super::super::{curvature::extreme_curvature, fairness::fairness};
    use super::*;
    use crate::rational::NurbsCurve;

    fn found(degree: usize, knots: &[f64], points: &[[f64; 2]]) -> Vec<CurveCusp> {
        let points: Vec<Point3> = points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
        let weights = vec![1.0; points.len()];
        cusps(&NurbsCurve::new(degree, knots.to_vec(), points, weights).unwrap())
    }

    #[test]
    fn ends_that_stand_are_cusps_where_they_bend() {
        let curve = |points: &[[f64; 2]]| {
            let points: Vec<Point3> = points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
            let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
            NurbsCurve::new(3, knots, points, vec![1.0; 4]).unwrap()
        };
        // It starts along x, at rest, and bends as one over the parameter.
        let bent = curve(&[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [2.0, 1.0]]);
        assert_eq!(place_of_cusp(&bent, 0), Some(0.0));
        assert!(fairness(&bent).variation.is_none());
        assert!(extreme_curvature(&bent).max.is_infinite());
        // On a line nothing bends, wherever it stands.
        for line in [[[0.0, 0.0], [0.0, 0.0], [1.0, 0.3], [2.0, 0.6]], [[5.0, 1.0], [5.1, 1.1], [5.7, 1.7], [5.7, 1.7]]]
        {
            let line = curve(&line);
            assert_eq!(place_of_cusp(&line, 0), None);
        }
    }

    #[test]
    fn cusps_are_found_within_pieces_and_at_joints() {
        let unit = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        // The velocity vanishes at a half, also of points moved and scaled.
        for (scale, move_by) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 1.0), (1.0, 1e5)] {
            let points = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]].map(|p| p.map(|v| v * scale + move_by));
            let cusps = found(3, &unit, &points);
            assert!(cusps.len() == 1 && (cusps[0].t - 0.5).abs() < 1e-5, "{scale} {cusps:?}");
            assert!((cusps[0].point.x - (0.5 * scale + move_by)).abs() < 1e-9 * (scale + move_by));
        }
        // A loop and a bend that is only tight are none.
        for x in [0.01, 0.5, -0.01, -0.5] {
            assert!(found(3, &unit, &[[0.0, 0.0], [1.0 + x, 1.0], [-x, 1.0], [1.0, 0.0]]).is_empty(), "{x}");
        }
        // There and back on a line.
        let back = found(2, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &[[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]]);
        assert!(back.len() == 1 && (back[0].t - 2.0 / 3.0).abs() < 1e-9, "{back:?}");
        // As many coincident control points as the degree: it stands at the knot, and turns by the angle of the legs.
        let doubled = found(
            2,
            &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0],
            &[[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]],
        );
        assert!(doubled.len() == 1 && (doubled[0].t - 1.0 / 3.0).abs() < 1e-15, "{doubled:?}");
        assert!((doubled[0].angle - std::f64::consts::FRAC_PI_2).abs() < 1e-2);
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0];
        let tripled =
            found(3, &knots, &[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [2.0, 2.0], [2.0, 2.0], [3.0, 0.0], [4.0, 4.0]]);
        assert!(tripled.len() == 1 && (tripled[0].t - 0.5).abs() < 1e-15, "{tripled:?}");
        assert!((tripled[0].angle - (std::f64::consts::FRAC_PI_4 + 2_f64.atan())).abs() < 1e-2);
        // Straight on after a stop.
        assert!(
            found(3, &knots, &[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [2.0, 2.0], [2.0, 2.0], [3.0, 3.0], [4.0, 4.0]])
                .is_empty()
        );
    }
}
