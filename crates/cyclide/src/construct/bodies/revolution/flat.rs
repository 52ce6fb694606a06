//! Profiles in a plane across the axis, which sweep a part of that plane.

use super::{PLACES, Revolution};
use crate::curve::ParamCurve as _;
use crate::error::{ProfileError, Result};
use crate::topology::EdgeCurve;

/// A profile is in a plane across the axis if its heights differ by less than this part of its size.
const FLAT: f64 = 1e-6;
/// A curve runs round the axis where its distance from it changes by less than this part of its way: there the ring that it sweeps
/// has no normal.
const ROUND: f64 = 1e-6;

/// Whether a profile is in a plane across the axis. What goes round an area, by itself or with the axis, is so only if its heights are
/// one up to the rounding that is given then: it is a disk or a washer, however thin.
///
/// # Errors
/// `folded-profile` if it is, and does not go straight away from the axis or towards it: what it sweeps covers a part of the plane
/// twice, or has no normal.
pub(super) fn is_flat(turn: &Revolution, pieces: &[EdgeCurve], rounding: Option<f64>) -> Result<bool> {
    let at = |k: u32| f64::from(k) / f64::from(PLACES);
    let jets = || {
        pieces.iter().enumerate().flat_map(|(i, piece)| (0..=PLACES).map(move |k| (i, k, piece.piece_jet(0, at(k)))))
    };
    let [mut low, mut high, mut farthest] = [f64::INFINITY, f64::NEG_INFINITY, 0.0_f64];
    for (_, _, jet) in jets() {
        let height = turn.height(jet.point);
        (low, high) = (low.min(height), high.max(height));
        farthest = farthest.max(turn.way_off_axis(jet.point).length());
    }
    if high - low > rounding.unwrap_or(FLAT * farthest) {
        return Ok(false);
    }
    let mut outwards: Option<bool> = None;
    for (piece, k, jet) in jets() {
        let way = turn.way_off_axis(jet.point);
        let distance = way.length();
        let Some(along) = way.unit().filter(|_| distance > FLAT * farthest) else { continue };
        // A piece that starts or ends at rest goes on in a direction of its own.
        let side = if k < PLACES { 1.0 } else { -1.0 };
        let grows = jet.limit_tangent(side).unwrap_or_default().dot(along);
        let round = !(grows.abs() > ROUND);
        if round || *outwards.get_or_insert(grows > 0.0) != (grows > 0.0) {
            return Err(ProfileError::Folded { piece, distance }.into());
        }
    }
    Ok(true)
}
