//! The place of a curve farthest from another one.

use super::closest::CurveIndex;
use super::maximum::maximum;
use crate::base::vector::Point3;
use crate::curve::ParamCurve;

/// Relative error of a length in a bound of what is between.
const LENGTH_ERROR: f64 = 1e-11;
/// Roundings of the largest coordinate up to which a point lies on the other curve: of both points and their difference.
const ON_IT: f64 = 16.0 * f64::EPSILON;

/// The place of a curve that is farthest from another one.
///
/// ```
/// use cyclide::{Point3, curve::{Arc, farthest_point}};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let (arc, chord) = (Arc::from_three_points(a, b, c)?, Arc::segment(a, c)?);
/// let found = farthest_point(&arc, &chord);
/// assert!((found.distance - 1.0).abs() < 1e-15 && found.point.distance(b) < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FarthestPoint {
    /// Parameter in `[0, 1]`, the first such place.
    pub t: f64,
    /// The point there.
    pub point: Point3,
    /// Its distance from the nearest point of the other curve.
    pub distance: f64,
}

/// The place of `curve` that is farthest from `other`, each place measured to the point of `other` nearest to it: maxima of the distance are
/// bracketed by an adaptive scan of each piece and refined to rounding (`docs/math/curve-measures.md#farthest-point`); a distance of a few roundings is 0.
///
/// With `q` the point nearest to `x`, the derivative of the distance is `(x - q)·x'/|x - q|`: that `q` moves changes it in second order only.
///
/// A piece is left out if no point of it can be as far as the farthest one known: from a segment, which is convex, a chord is nowhere farther than at its
/// ends, and a piece of length `L` over a chord `c` is within `√(L² − c²)/2` of that (it lies in the ellipse with the foci there). Pieces that may be the
/// farthest come first, so that of curves through many points of a polygon few are searched.
///
/// ```
/// use cyclide::{Point3, curve::{ArcPath, farthest_point}, rational::NurbsCurve};
/// let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from);
/// let parabola = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points.to_vec(), vec![1.0; 3])?;
/// let legs = ArcPath::rounded_polyline(&points, false, &[0.0; 3])?;
/// assert!((farthest_point(&legs, &parabola).distance - 1.0).abs() < 1e-12); // the corner
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn farthest_point(curve: &dyn ParamCurve, other: &dyn ParamCurve) -> FarthestPoint {
    let index = CurveIndex::new(other);
    let mut pieces: Vec<(usize, f64)> =
        (0..curve.piece_count()).map(|piece| (piece, most_distance(curve, piece, &index))).collect();
    pieces.sort_by(|a, b| b.1.total_cmp(&a.1));
    let (mut place, mut distance) = ((0, 0.0), -1.0);
    for (piece, bound) in pieces {
        if bound < distance {
            break;
        }
        let (s, most) = maximum(&mut |s| {
            let jet = curve.piece_jet(piece, s);
            let nearest = index.closest_point(jet.point);
            let d = nearest.distance;
            if d <= ON_IT * jet.point.to_vec().max_abs() {
                return (0.0, 0.0);
            }
            let slope = (jet.point - nearest.point).dot(jet.d1) / d;
            (d, if slope.is_finite() { slope } else { 0.0 })
        });
        // The first of those that are equally far.
        if most > distance || (most >= distance && piece < place.0) {
            (place, distance) = ((piece, s), most);
        }
    }
    let (piece, s) = place;
    let t = (piece as f64 + s) / curve.piece_count() as f64;
    FarthestPoint { t, point: curve.piece_point(piece, s), distance }
}

/// A bound on the distance of all points of a piece from the curve of an index, by the segment that is nearest to its middle; infinite where that is none.
fn most_distance(curve: &dyn ParamCurve, piece: usize, index: &CurveIndex<'_>) -> f64 {
    let ends = [0.0, 1.0].map(|s| curve.piece_point(piece, s));
    let Some(segment) = index.segment_near(curve.piece_point(piece, 0.5)) else { return f64::INFINITY };
    let of_chord = ends.map(|end| end.distance_to_segment(segment));
    let (length, chord) = (curve.piece_length(piece, 0.0, 1.0) * (1.0 + LENGTH_ERROR), ends[0].distance(ends[1]));
    of_chord[0].max(of_chord[1]) + 0.5 * ((length - chord).max(0.0) * (length + chord)).sqrt()
}
