//! Planes and straight lines: spheres and circles through infinity.

use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, Result};

/// A plane by a point and its unit normal.
///
/// ```
/// use cyclide::{Point3, conformal::Plane};
/// let plane = Plane::through_points([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from))?;
/// assert!((plane.height(Point3::ORIGIN) + 3_f64.sqrt() / 3.0).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    point: Point3,
    normal: Vec3,
}

impl Plane {
    /// The plane through a point across a normal of any length.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `zero-axis`.
    pub fn new(point: Point3, normal: Vec3) -> Result<Self> {
        range::check_point(0, point.to_vec())?;
        Ok(Self { point, normal: unit(normal, ErrorItem::Normal)? })
    }

    /// The plane through three points, with the normal of `(p1 - p0) × (p2 - p0)`.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `zero-axis` (points on one line, to 1e-12 of the product of the two longest sides).
    pub fn through_points(points: [Point3; 3]) -> Result<Self> {
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        // From the two longest sides: rounding of the points turns them least.
        let shortest =
            (0..3).min_by(|i, j| side(&points, *i).length().total_cmp(&side(&points, *j).length())).unwrap_or(0);
        let (a, b) = (side(&points, (shortest + 1) % 3), side(&points, (shortest + 2) % 3));
        let across = a.cross(b);
        if !(across.length() > 1e-12 * a.length() * b.length()) {
            return Err(Error::zero_axis(ErrorItem::Normal));
        }
        Self::new(points[0], across)
    }

    /// The point by which it is given.
    #[must_use]
    pub fn point(&self) -> Point3 {
        self.point
    }

    /// Unit normal.
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Distance of a point from the plane, positive on the side of the normal.
    #[must_use]
    pub fn height(&self, p: Point3) -> f64 {
        (p - self.point).dot(self.normal)
    }
}

/// The side from the k-th point to the next.
fn side(points: &[Point3; 3], k: usize) -> Vec3 {
    points[(k + 1) % 3] - points[k]
}

/// A straight line by a point and its unit direction.
///
/// ```
/// use cyclide::{Point3, Vec3, conformal::Line};
/// let line = Line::new(Point3::new(0.0, 2.0, 0.0), Vec3::X * 3.0)?;
/// assert_eq!(line.foot(Point3::new(5.0, 0.0, 1.0)), Point3::new(5.0, 2.0, 0.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    point: Point3,
    direction: Vec3,
}

impl Line {
    /// The line through a point in a direction of any length.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `zero-axis`.
    pub fn new(point: Point3, direction: Vec3) -> Result<Self> {
        range::check_point(0, point.to_vec())?;
        Ok(Self { point, direction: unit(direction, ErrorItem::Axis)? })
    }

    /// The point by which it is given.
    #[must_use]
    pub fn point(&self) -> Point3 {
        self.point
    }

    /// Unit direction.
    #[must_use]
    pub fn direction(&self) -> Vec3 {
        self.direction
    }

    /// The foot of the perpendicular from a point.
    #[must_use]
    pub fn foot(&self, p: Point3) -> Point3 {
        self.point + self.direction * (p - self.point).dot(self.direction)
    }
}

/// A vector of length 1.
fn unit(v: Vec3, what: ErrorItem) -> Result<Vec3> {
    if !v.is_finite() {
        return Err(NumberError::NotFinite { what, index: 0 }.into());
    }
    v.unit().ok_or(Error::zero_axis(what))
}
