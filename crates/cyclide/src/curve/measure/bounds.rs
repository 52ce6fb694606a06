//! The smallest box around a curve.

use super::maximum::maximum;
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::curve::{ParamCurve, PieceForm};

/// The smallest box around the curve: exact for arcs and circles; elsewhere the stationary points of each coordinate
/// are bracketed by an adaptive scan and refined, so that the box touches the curve to 1e-12 of its size.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let found = cyclide::curve::bounds(&arc);
/// assert!((found.max - Point3::new(1.0, 1.0, 0.0)).length() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn bounds(curve: &dyn ParamCurve) -> Aabb {
    let n = curve.piece_count();
    let mut total = Aabb::of_point(curve.piece_point(0, 0.0));
    for piece in 0..n {
        total = total.including(curve.piece_point(piece, 0.0)).including(curve.piece_point(piece, 1.0));
    }
    for piece in 0..n {
        let outer = curve.piece_bounds(piece);
        match curve.piece_form(piece) {
            PieceForm::Arc(_) | PieceForm::Circle(_) => total = total.union(outer),
            // A piece whose own box lies inside adds nothing.
            PieceForm::Free if total.contains(outer) => {}
            PieceForm::Free => {
                for axis in 0..3 {
                    for sign in [1.0, -1.0] {
                        let outermost = if sign > 0.0 { outer.max[axis] } else { -outer.min[axis] };
                        let reached = if sign > 0.0 { total.max[axis] } else { -total.min[axis] };
                        if outermost > reached {
                            total = total.including(extreme_point(curve, piece, axis, sign));
                        }
                    }
                }
            }
        }
    }
    total
}

/// The point of a piece where `sign` times a coordinate is largest.
fn extreme_point(curve: &dyn ParamCurve, piece: usize, axis: usize, sign: f64) -> Point3 {
    let (s, _) = maximum(&mut |s| {
        let jet = curve.piece_jet(piece, s);
        (sign * jet.point[axis], sign * jet.d1[axis])
    });
    curve.piece_point(piece, s)
}
