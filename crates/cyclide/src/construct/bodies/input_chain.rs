//! Chains of curves as they are given: pieces that follow each other, with positive weights.

use crate::error::{CurveError, NurbsError, Result};
use crate::topology::EdgeCurve;

/// Refuses pieces of which one does not begin where the one before ends, the first after the last if `closed`.
///
/// # Errors
/// `disconnected` beyond a gap of `limit`.
pub(super) fn check_connected(pieces: &[EdgeCurve], closed: bool, limit: f64) -> Result<()> {
    let n = pieces.len();
    for next in usize::from(!closed)..n {
        let piece = (next + n - 1) % n;
        let gap = pieces[piece].end().distance(pieces[next].start());
        if gap > limit {
            return Err(CurveError::Disconnected { piece, next, gap, limit }.into());
        }
    }
    Ok(())
}

/// Refuses the piece of this number if a weight of it is not positive.
///
/// # Errors
/// `weight-not-positive`.
pub(super) fn check_weights(piece: &EdgeCurve, index: usize) -> Result<()> {
    let EdgeCurve::Rational(curve) = piece else { return Ok(()) };
    match curve.rows().iter().map(|row| row[3]).find(|weight| !(*weight > 0.0)) {
        Some(weight) => Err(NurbsError::WeightNotPositive { index, weight }.into()),
        None => Ok(()),
    }
}
