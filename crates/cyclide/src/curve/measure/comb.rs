//! The curvature comb: how evenly a curve bends, drawn.

use crate::base::vector::Point3;
use crate::curve::ParamCurve;

/// Teeth of the curvature comb as pairs of the foot on the curve and the tip: `foot - scale · curvature vector`, so
/// teeth stand on the outer side of a bend and have length `scale · curvature`.
///
/// Each piece gets `per_piece + 1` teeth at equal steps of its own parameter, both ends included, so that a jump of
/// curvature at a joint shows as a step; `per_piece = 0` is taken as 1. Places without a tangent are left out.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let teeth = cyclide::curve::curvature_comb(&arc, 4, 0.5);
/// // Teeth as long as the curvature times the scale.
/// assert!(teeth.iter().all(|(foot, tip)| (foot.distance(*tip) - 0.5).abs() < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn curvature_comb(curve: &dyn ParamCurve, per_piece: usize, scale: f64) -> Vec<(Point3, Point3)> {
    let steps = per_piece.max(1);
    let mut comb = Vec::with_capacity(curve.piece_count() * (steps + 1));
    for piece in 0..curve.piece_count() {
        for i in 0..=steps {
            let jet = curve.piece_jet(piece, i as f64 / steps as f64);
            if let Some(k) = jet.curvature_vector() {
                comb.push((jet.point, jet.point - k * scale));
            }
        }
    }
    comb
}
