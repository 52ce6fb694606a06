//! Right-handed orthonormal frames: the border between space and a plane in it.

use super::planar::{Point2, Vec2};
use super::quat::Quat;
use super::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, Result};

/// An origin and three orthonormal axes, right-handed.
///
/// ```
/// use cyclide::{Frame, Point2, Point3, Vec3};
/// let frame = Frame::from_normal(Point3::new(0.0, 0.0, 5.0), Vec3::Z * 2.0, Vec3::Y)?;
/// assert_eq!(frame.to_local(Point3::new(0.0, 3.0, 6.0)), (Point2::new(3.0, 0.0), 1.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    origin: Point3,
    x: Vec3,
    y: Vec3,
    z: Vec3,
}

impl Frame {
    /// The frame of the coordinate axes.
    pub const WORLD: Self = Self { origin: Point3::ORIGIN, x: Vec3::X, y: Vec3::Y, z: Vec3::Z };

    /// Frame with third axis along `normal` and first axis along the part of `toward` perpendicular to it
    /// (any perpendicular if there is none).
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`.
    pub fn from_normal(origin: Point3, normal: Vec3, toward: Vec3) -> Result<Self> {
        if !(origin.is_finite() && normal.is_finite() && toward.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Frame, index: 0 }.into());
        }
        let z = normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        let t = toward.unit().unwrap_or(Vec3::ZERO);
        let across = t - z * t.dot(z);
        // Below 1e-9 the direction left over is rounding of `toward`.
        let x = if across.length() > 1e-9 { across.unit() } else { None }.unwrap_or_else(|| z.any_perpendicular());
        // One more step: z × x is perpendicular to rounding, and so is x to z again.
        let y = z.cross(x).unit().unwrap_or(Vec3::Y);
        Ok(Self { origin, x: y.cross(z), y, z })
    }

    /// The frame of axes that are orthonormal and right-handed already.
    pub(crate) fn of_axes(origin: Point3, [x, y, z]: [Vec3; 3]) -> Self {
        Self { origin, x, y, z }
    }

    /// Origin.
    #[must_use]
    pub fn origin(&self) -> Point3 {
        self.origin
    }

    /// First axis, unit.
    #[must_use]
    pub fn x(&self) -> Vec3 {
        self.x
    }

    /// Second axis, unit.
    #[must_use]
    pub fn y(&self) -> Vec3 {
        self.y
    }

    /// Third axis, unit.
    #[must_use]
    pub fn z(&self) -> Vec3 {
        self.z
    }

    /// The unit quaternion that turns the coordinate axes to those of the frame.
    #[must_use]
    pub(crate) fn rotation(&self) -> Quat {
        let (x, y, z) = (self.x, self.y, self.z);
        // Four times the products of one coefficient with all: the largest of the four rows, so nothing cancels.
        let rows = [
            Quat::new(1.0 + x.x + y.y + z.z, y.z - z.y, z.x - x.z, x.y - y.x),
            Quat::new(y.z - z.y, 1.0 + x.x - y.y - z.z, y.x + x.y, z.x + x.z),
            Quat::new(z.x - x.z, y.x + x.y, 1.0 - x.x + y.y - z.z, z.y + y.z),
            Quat::new(x.y - y.x, z.x + x.z, z.y + y.z, 1.0 - x.x - y.y + z.z),
        ];
        let diagonal = [rows[0].w, rows[1].x, rows[2].y, rows[3].z];
        let largest = (1..4).fold(0, |best, k| if diagonal[k] > diagonal[best] { k } else { best });
        rows[largest] * (1.0 / rows[largest].norm())
    }

    /// Plane coordinates and height of a point of space.
    #[must_use]
    pub fn to_local(&self, p: Point3) -> (Point2, f64) {
        let v = p - self.origin;
        (Point2::new(v.dot(self.x), v.dot(self.y)), v.dot(self.z))
    }

    /// The point of space at plane coordinates `p` and height 0.
    #[must_use]
    pub fn to_world(&self, p: Point2) -> Point3 {
        self.origin + self.x * p.x + self.y * p.y
    }

    /// Plane components of a vector of space.
    #[must_use]
    pub fn vector_to_local(&self, v: Vec3) -> Vec2 {
        Vec2::new(v.dot(self.x), v.dot(self.y))
    }

    /// The vector of space with plane components `v`.
    #[must_use]
    pub fn vector_to_world(&self, v: Vec2) -> Vec3 {
        self.x * v.x + self.y * v.y
    }
}
