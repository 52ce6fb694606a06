//! Nearest and farthest points (source: `004`, (9)).

use super::{CircleOrLine, LIMIT, SphereOrPlane};
use crate::base::vector::{Point3, Vec3};
use crate::error::{PointError, Result};

/// The nearest point of a sphere, plane, circle or line.
///
/// ```
/// use cyclide::{Point3, conformal::Sphere, curve::SphereOrPlane};
/// let ball = SphereOrPlane::Sphere(Sphere::new(Point3::ORIGIN, 2.0)?);
/// let nearest = ball.nearest(Point3::new(0.0, 0.5, 0.0))?;
/// assert_eq!((nearest.point, nearest.distance, nearest.signed), (Point3::new(0.0, 2.0, 0.0), 1.5, Some(-1.5)));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NearestPoint {
    /// The nearest point.
    pub point: Point3,
    /// Its distance.
    pub distance: f64,
    /// The distance of a surface with a sign: positive outside of a sphere and on the side of a plane's normal. `None` of curves.
    pub signed: Option<f64>,
    /// The farthest point of a sphere or circle.
    pub farthest: Option<Point3>,
}

impl SphereOrPlane {
    /// The point nearest to a given one.
    ///
    /// # Errors
    /// `nearest-undefined` in the center of a sphere, to 1e-10 of its radius.
    pub fn nearest(&self, p: Point3) -> Result<NearestPoint> {
        match self {
            Self::Sphere(sphere) => {
                let (center, r, way) = (sphere.center(), sphere.radius(), p - sphere.center());
                let out = direction(way, r)? * r;
                let signed = way.length() - r;
                let farthest = Some(center - out);
                Ok(NearestPoint { point: center + out, distance: signed.abs(), signed: Some(signed), farthest })
            }
            Self::Plane(plane) => {
                let height = plane.height(p);
                let point = p - plane.normal() * height;
                Ok(NearestPoint { point, distance: height.abs(), signed: Some(height), farthest: None })
            }
        }
    }
}

impl CircleOrLine {
    /// The point nearest to a given one.
    ///
    /// # Errors
    /// `nearest-undefined` on the axis of a circle, to 1e-10 of its radius.
    pub fn nearest(&self, p: Point3) -> Result<NearestPoint> {
        let (point, farthest) = match self {
            Self::Circle(circle) => {
                let (center, normal, way) = (circle.center(), circle.normal(), p - circle.center());
                let out = direction(way - normal * way.dot(normal), circle.radius())? * circle.radius();
                (center + out, Some(center - out))
            }
            Self::Line(line) => (line.foot(p), None),
        };
        Ok(NearestPoint { point, distance: point.distance(p), signed: None, farthest })
    }
}

/// The direction of a way that is more than rounding beside a radius.
///
/// # Errors
/// `nearest-undefined`.
fn direction(way: Vec3, radius: f64) -> Result<Vec3> {
    let (distance, limit) = (way.length(), LIMIT * radius);
    let undefined = PointError::NearestUndefined { distance, limit };
    way.unit().filter(|_| distance > limit).ok_or_else(|| undefined.into())
}
