//! Axes of a plane by its normal.

use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// A direction within this angle of the normal, radians, has none across it.
const ALONG: f64 = 1e-6;

/// Right-handed unit axes x, y, z of which z is the normal, and x the direction given as far as it is across it: that of space if none is given, or its y where its x
/// is the normal.
///
/// # Errors
/// `not-finite`, `zero-axis`: no normal, or a direction along it.
pub(super) fn plane_axes(normal: Vec3, x_direction: Option<Vec3>) -> Result<[Vec3; 3]> {
    let finite = |v: Vec3| v.to_array().iter().all(|x| x.is_finite());
    if !finite(normal) || !x_direction.is_none_or(finite) {
        return Err(NumberError::NotFinite { what: ErrorItem::FrameVector, index: 0 }.into());
    }
    let none = |index: usize, length: f64, limit: f64| {
        Error::Point(PointError::ZeroAxis { what: ErrorItem::Normal, index, length, limit })
    };
    let z = normal.unit().ok_or_else(|| none(0, normal.length(), 0.0))?;
    let across = |v: Vec3| {
        let x = v - z * v.dot(z);
        x.unit().filter(|_| x.length() > ALONG * v.length())
    };
    let x = match x_direction {
        Some(given) => across(given.unit().unwrap_or(given)),
        None => across(Vec3::X).or_else(|| across(Vec3::Y)),
    };
    let x = x.ok_or_else(|| none(1, 0.0, ALONG))?;
    Ok([x, z.cross(x), z])
}
