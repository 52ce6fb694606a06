//! The range of numbers the kernel computes in: far enough inside that of doubles that derivatives, which hold powers
//! and quotients of the data, stay finite too.

use super::bounds::Aabb;
use super::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, PointError, Result};

/// Largest absolute coordinate accepted.
pub(crate) const MAX_COORDINATE: f64 = 1e150;

/// Smallest distance accepted between points that differ.
pub(crate) const MIN_DISTANCE: f64 = 1e-150;

/// Smallest and largest length accepted for a weight ratio, which is the ratio of the end speed to the start speed.
pub(crate) const WEIGHT_RATIO: [f64; 2] = [1e-30, 1e30];

/// Refuses a point (as a vector from the origin) that is not finite or too far out.
pub fn check_point(index: usize, p: Vec3) -> Result<()> {
    let value = p.max_abs();
    if !p.is_finite() {
        Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into())
    } else if value > MAX_COORDINATE {
        Err(NumberError::ParameterOutOfRange {
            name: ErrorItem::Coordinate,
            value,
            min: -MAX_COORDINATE,
            max: MAX_COORDINATE,
        }
        .into())
    } else {
        Ok(())
    }
}

/// Refuses a derivative that is not finite or as long as no coordinate may be.
pub(crate) fn check_derivative(index: usize, v: Vec3) -> Result<()> {
    let value = v.max_abs();
    if !v.is_finite() {
        Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into())
    } else if value > MAX_COORDINATE {
        let (min, max) = (-MAX_COORDINATE, MAX_COORDINATE);
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::Tangent, value, min, max }.into())
    } else {
        Ok(())
    }
}

/// Refuses a distance that is neither zero nor in range.
pub fn check_distance(value: f64) -> Result<()> {
    check_length(ErrorItem::Distance, value)
}

fn check_length(name: ErrorItem, value: f64) -> Result<()> {
    let (min, max) = (MIN_DISTANCE, 4.0 * MAX_COORDINATE);
    if value == 0.0 || (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(NumberError::ParameterOutOfRange { name, value, min, max }.into())
    }
}

/// Refuses a radius that is no number above zero, or out of range.
pub(crate) fn check_radius(what: ErrorItem, index: usize, radius: f64) -> Result<()> {
    if !radius.is_finite() {
        return Err(NumberError::NotFinite { what, index }.into());
    }
    if radius <= 0.0 {
        return Err(NumberError::RadiusNotPositive { what, index, radius }.into());
    }
    check_length(ErrorItem::Radius, radius)
}

/// Refuses a thickness that is not a length, or not above the smallest distance.
pub(crate) fn check_thickness(value: f64) -> Result<()> {
    if !value.is_finite() {
        Err(NumberError::NotFinite { what: ErrorItem::Thickness, index: 0 }.into())
    } else if value < MIN_DISTANCE {
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::Thickness, value, min: MIN_DISTANCE, max: f64::MAX }
            .into())
    } else {
        Ok(())
    }
}

/// Roundings (of the largest coordinate) that a surface is across at least: points are off by half of one in each coordinate,
/// 1.3e-5 of such a size in space. That is what files are within by default, so that smaller surfaces have no file, and
/// their normals are known to no more than four digits. Far beyond it no edge differs from another. It leaves a tenth of
/// a millimeter at coordinates of 5000 km.
pub(crate) const SMALLEST_IN_PLACE: f64 = 65536.0 * f64::EPSILON;

/// Refuses points that are so close to each other and so far from the origin that their differences are rounding.
pub(crate) fn check_place(what: ErrorItem, points: &[Point3]) -> Result<()> {
    let Some(bounds) = Aabb::of_points(points.iter().copied()) else {
        return Ok(());
    };
    check_size_in_place(what, bounds.diagonal(), bounds.max_abs(), SMALLEST_IN_PLACE)
}

/// Refuses a size that is not above the given part of the largest coordinate `place`.
pub(crate) fn check_size_in_place(what: ErrorItem, size: f64, place: f64, part: f64) -> Result<()> {
    let limit = part * place;
    if size > limit { Ok(()) } else { Err(PointError::BelowRoundingOfPlace { what, size, place, limit }.into()) }
}

/// Refuses a length of a weight ratio out of range.
pub(crate) fn check_weight_ratio(value: f64) -> Result<()> {
    let [min, max] = WEIGHT_RATIO;
    if (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::WeightRatio, value, min, max }.into())
    }
}
