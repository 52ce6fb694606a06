//! Spheres through four points.

use crate::base::range;
use crate::base::vector::Point3;
use crate::error::{ArcError, ErrorItem, PointError, Result};

/// Smallest relative volume of four points that have a sphere.
const COPLANAR_LIMIT: f64 = 1e-12;

/// A sphere.
///
/// ```
/// use cyclide::{Point3, conformal::Sphere};
/// let points = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// assert!((Sphere::through_points(points)?.radius() - 1.0).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    /// The sphere of a center and a radius.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `radius-not-positive`.
    pub fn new(center: Point3, radius: f64) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        range::check_radius(ErrorItem::Radius, 0, radius)?;
        Ok(Self { center, radius })
    }

    /// The sphere through four points (`docs/math/conformal.md#sphere-through-four-points`).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `coincident-points`,
    /// `degenerate-sphere` (volume at most 1e-12 of the product of the edges).
    pub fn through_points(points: [Point3; 4]) -> Result<Self> {
        for (index, p) in points.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let edge = |i: usize| points[i] - points[0];
        let lengths = [1, 2, 3].map(|i| edge(i).length());
        if let Some(i) = lengths.iter().position(|l| *l == 0.0) {
            return Err(PointError::CoincidentPoints { first: 0, second: i + 1, distance: 0.0, limit: 0.0 }.into());
        }
        let [lp, lq, lr] = lengths;
        let (p, q, r) = (edge(1) / lp, edge(2) / lq, edge(3) / lr);
        let volume = p.dot(q.cross(r));
        if volume.abs() <= COPLANAR_LIMIT {
            return Err(ArcError::DegenerateSphere { volume, limit: COPLANAR_LIMIT }.into());
        }
        let offset = (q.cross(r) * lp + r.cross(p) * lq + p.cross(q) * lr) / (2.0 * volume);
        Ok(Self { center: points[0] + offset, radius: offset.length() })
    }

    /// Center.
    #[must_use]
    pub fn center(&self) -> Point3 {
        self.center
    }

    /// Radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }
}
