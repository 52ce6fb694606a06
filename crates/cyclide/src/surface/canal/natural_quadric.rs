//! Cylinders and cones of revolution.

use crate::base::frame::Frame;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use std::f64::consts::FRAC_PI_2;

/// A cylinder or a cone of revolution, touched by balls from outside.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::NaturalQuadric};
/// let cone = NaturalQuadric::cone(Point3::ORIGIN, Vec3::Z * 2.0, 0.5)?;
/// assert_eq!((cone.axis(), cone.half_angle()), (Vec3::Z, 0.5));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NaturalQuadric {
    /// A point of the axis of a cylinder, the apex of a cone; third axis along the axis, into the cone.
    pub(super) frame: Frame,
    /// Zero for a cone.
    pub(super) radius: f64,
    /// Zero for a cylinder.
    pub(super) half_angle: f64,
}

impl NaturalQuadric {
    /// The cylinder about an axis of any length.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`, `radius-not-positive`, `parameter-out-of-range` (beyond 1e-150 to 1e150).
    pub fn cylinder(point: Point3, axis: Vec3, radius: f64) -> Result<Self> {
        range::check_radius(ErrorItem::Radius, 0, radius)?;
        Ok(Self { frame: placed(point, axis)?, radius, half_angle: 0.0 })
    }

    /// The nappe of a cone on the side of its apex that the axis (of any length) points to.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`, `angle-out-of-range` (unless between 0 and a right angle), `parameter-out-of-range`.
    pub fn cone(apex: Point3, axis: Vec3, half_angle: f64) -> Result<Self> {
        if !(half_angle > 0.0 && half_angle < FRAC_PI_2) {
            return Err(NumberError::AngleOutOfRange {
                name: ErrorItem::Angle,
                angle: half_angle,
                min: 0.0,
                max: FRAC_PI_2,
            }
            .into());
        }
        Ok(Self { frame: placed(apex, axis)?, radius: 0.0, half_angle })
    }

    /// A point of the axis; of a cone its apex.
    #[must_use]
    pub fn origin(&self) -> Point3 {
        self.frame.origin()
    }

    /// Direction of the axis, unit.
    #[must_use]
    pub fn axis(&self) -> Vec3 {
        self.frame.z()
    }

    /// Radius of a cylinder; 0 for a cone.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Half the opening angle of a cone, radians; 0 for a cylinder.
    #[must_use]
    pub fn half_angle(&self) -> f64 {
        self.half_angle
    }

    /// The linear forms `X`, `Y`, `L` of `(1, center, radius)` about an origin: a ball touches from outside where `X² + Y² = L²`, `L >= 0`.
    /// `X`, `Y` are the coordinates of the center across the axis, `L = r + R` or `(R + height sin w)/cos w`.
    pub(super) fn forms(&self, origin: Point3) -> [[f64; 5]; 3] {
        let (f, to_origin) = (self.frame, origin - self.frame.origin());
        let across = |v: Vec3| [v.dot(to_origin), v.x, v.y, v.z, 0.0];
        let (sin, cos) = self.half_angle.sin_cos();
        let height = across(f.z() * (sin / cos));
        let distance = [height[0] + self.radius, height[1], height[2], height[3], 1.0 / cos];
        [across(f.x()), across(f.y()), distance]
    }
}

fn placed(point: Point3, axis: Vec3) -> Result<Frame> {
    let frame = Frame::from_normal(point, axis, axis.any_perpendicular())?;
    range::check_point(0, point.to_vec())?;
    Ok(frame)
}
