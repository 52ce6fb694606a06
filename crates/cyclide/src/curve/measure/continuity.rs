//! Continuity at the joints of a curve, measured.

use super::rest::limit_curvature;
use crate::curve::ParamCurve;

/// How two consecutive pieces meet.
///
/// ```
/// use cyclide::{Point3, curve::{ArcPath, joints}};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
/// let sharp = ArcPath::rounded_polyline(&corner, false, &[0.0; 3])?;
/// assert!((joints(&sharp)[0].angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Joint {
    /// The piece that ends here.
    pub piece: usize,
    /// The piece that starts here. It is `piece + 1`, 0 at the closing joint, or a later one where pieces of no
    /// extent lie between.
    pub next: usize,
    /// Distance between the end and the start (0 if they are the same doubles).
    pub gap: f64,
    /// Angle between the unit tangents in `[0, pi]`, radians, accurate near 0.
    pub angle: f64,
    /// Length of the difference of the two curvature vectors, in 1/length. Infinite where a piece ends in a cusp.
    pub curvature_jump: f64,
}

/// Every joint of the curve in order; the last one joins the end to the start if the curve is closed.
///
/// Tangents are those of the geometry: where the first derivative vanishes, the limit direction is taken. A piece
/// without any direction (all its points are one) is passed over, and its gaps are added to those of the joint.
///
/// ```
/// use cyclide::{Point3, curve::ArcPath};
/// let bend = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&bend, false, &[0.0, 2.0, 0.0])?;
/// assert!(cyclide::curve::joints(&path).iter().all(|joint| joint.angle < 1e-12 && (joint.curvature_jump - 0.5).abs() < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn joints(curve: &dyn ParamCurve) -> Vec<Joint> {
    let n = curve.piece_count();
    let start = |i: usize| curve.piece_jet(i, 0.0);
    let end = |i: usize| curve.piece_jet(i, 1.0);
    let extended = |i: &usize| start(*i).limit_tangent(1.0).is_some() && end(*i).limit_tangent(-1.0).is_some();
    let pieces: Vec<usize> = (0..n).filter(extended).collect();
    let inner = pieces.windows(2).map(|w| (w[0], w[1]));
    let closing = match (pieces.first(), pieces.last()) {
        (Some(&first), Some(&last)) if curve.is_closed() => Some((last, first)),
        _ => None,
    };
    let measure = |(piece, next): (usize, usize)| {
        let (before, after) = (end(piece), start(next));
        // One step to the next piece, more over pieces without extent; once around for a single closed piece.
        let steps = if next > piece { next - piece } else { next + n - piece };
        let between = |k: usize| {
            let (at, to) = ((piece + k) % n, (piece + k + 1) % n);
            curve.piece_point(at, 1.0).distance(curve.piece_point(to, 0.0))
        };
        let gap = (0..steps).map(between).sum();
        let angle = match (before.limit_tangent(-1.0), after.limit_tangent(1.0)) {
            (Some(a), Some(b)) => a.angle(b),
            // Not reached: only pieces with directions are listed.
            _ => 0.0,
        };
        let curvature_jump = match (limit_curvature(curve, piece, 1.0), limit_curvature(curve, next, 0.0)) {
            (Some(a), Some(b)) => (b - a).length(),
            _ => f64::INFINITY,
        };
        Joint { piece, next, gap, angle, curvature_jump }
    };
    inner.chain(closing).map(measure).collect()
}
