//! Checks of what comes in from the user (`60`, section 4).

use crate::base::planar::Point2;
use crate::error::{Error, Result};

/// # Errors
/// `too-few-points`, `not-finite`.
pub(super) fn check_points(points: &[Point2], needed: usize) -> Result<()> {
    if points.len() < needed {
        return Err(Error::TooFewPoints { given: points.len(), needed });
    }
    match points.iter().position(|p| !p.is_finite()) {
        Some(index) => Err(Error::NotFinite { what: "point", index }),
        None => Ok(()),
    }
}

/// # Errors
/// `tolerance-not-positive` (also for NaN), `not-finite` (infinite).
pub(super) fn check_tolerance(tolerance: f64) -> Result<()> {
    if !(tolerance > 0.0) {
        return Err(Error::ToleranceNotPositive { tolerance });
    }
    if tolerance.is_finite() { Ok(()) } else { Err(Error::NotFinite { what: "tolerance", index: 0 }) }
}
