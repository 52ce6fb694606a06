//! The range of numbers the kernel computes in: far enough inside that of doubles that derivatives, which hold powers
//! and quotients of the data, stay finite too.

use super::vector::Vec3;
use crate::error::{Error, Result};

/// Largest absolute coordinate accepted.
pub(crate) const MAX_COORDINATE: f64 = 1e150;

/// Smallest distance accepted between points that differ.
pub(crate) const MIN_DISTANCE: f64 = 1e-150;

/// Smallest and largest length accepted for a weight ratio, which is the ratio of the end speed to the start speed.
pub(crate) const WEIGHT_RATIO: [f64; 2] = [1e-30, 1e30];

/// Refuses a point (as a vector from the origin) that is not finite or too far out.
pub(crate) fn check_point(index: usize, p: Vec3) -> Result<()> {
    let value = p.max_abs();
    if !p.is_finite() {
        Err(Error::NotFinite { what: "point", index })
    } else if value > MAX_COORDINATE {
        Err(Error::ParameterOutOfRange { name: "coordinate", value, min: -MAX_COORDINATE, max: MAX_COORDINATE })
    } else {
        Ok(())
    }
}

/// Refuses a distance that is neither zero nor in range.
pub(crate) fn check_distance(value: f64) -> Result<()> {
    if value == 0.0 || (MIN_DISTANCE..=4.0 * MAX_COORDINATE).contains(&value) {
        Ok(())
    } else {
        Err(Error::ParameterOutOfRange { name: "distance", value, min: MIN_DISTANCE, max: 4.0 * MAX_COORDINATE })
    }
}

/// Refuses a length of a weight ratio out of range.
pub(crate) fn check_weight_ratio(value: f64) -> Result<()> {
    let [min, max] = WEIGHT_RATIO;
    if (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(Error::ParameterOutOfRange { name: "length of the weight ratio", value, min, max })
    }
}
