//! Curvature where a curve comes to a stand: its limit from inside the piece.

use crate::base::vector::Vec3;
use crate::curve::ParamCurve;

/// From the end at which a piece stands to the place inside that tells its curvature, in the parameter, and so a millionth of the way: nearer, the
/// curvature is made of the roundings of a speed next to zero.
const INSIDE: f64 = 1e-3;
/// Bends of the chord by less than this, in radians, are none there.
const STRAIGHT: f64 = 1e-6;

/// The place that tells the curvature of a piece at a parameter: itself, but next to an end at which the piece stands and does not bend without bound.
pub(super) fn place_of_curvature(curve: &dyn ParamCurve, piece: usize, s: f64) -> f64 {
    let (end, inside) = match s {
        s if s < INSIDE => (0.0, INSIDE),
        s if s > 1.0 - INSIDE => (1.0, 1.0 - INSIDE),
        _ => return s,
    };
    let jet = curve.piece_jet(piece, end);
    if jet.tangent().is_none() && !jet.bends_from_rest() { inside } else { s }
}

/// The curvature vector at an end of a piece, 0 or 1, or its limit where the speed vanishes: `None` where it has no bound, zero on a line.
pub(super) fn limit_curvature(curve: &dyn ParamCurve, piece: usize, end: f64) -> Option<Vec3> {
    let jet = curve.piece_jet(piece, end);
    if jet.tangent().is_some() {
        return jet.curvature_vector();
    }
    if jet.bends_from_rest() {
        return None;
    }
    let chord = curve.piece_point(piece, 0.0).distance(curve.piece_point(piece, 1.0));
    let beside = curve.piece_jet(piece, place_of_curvature(curve, piece, end)).curvature_vector();
    Some(beside.filter(|k| k.length() * chord > STRAIGHT).unwrap_or(Vec3::ZERO))
}
