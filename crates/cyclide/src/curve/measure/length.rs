//! Arc length: total, and the constant-speed parameter.

use crate::curve::ParamCurve;

/// Length of the whole curve: closed form for arcs and circles, else each piece to 1e-12 of itself.
#[must_use]
pub fn length(curve: &dyn ParamCurve) -> f64 {
    (0..curve.piece_count()).map(|piece| curve.piece_length(piece, 0.0, 1.0)).sum()
}
