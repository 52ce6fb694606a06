//! Spheres and planes, circles and lines: where they meet, at which angles, and the nearest points (`docs/math/conformal.md#meetings`).

mod angle;
mod meet;
mod nearest;

use super::Circle;
use crate::conformal::{Line, Plane, Sphere};

pub use angle::CircleAngle;
pub use meet::{CurveMeeting, SurfaceMeeting};
pub use nearest::NearestPoint;

/// Differences up to this part of the lengths they are of are none: surfaces that touch, points on an axis.
const LIMIT: f64 = 1e-10;

/// A sphere, or a plane, which is one through infinity.
///
/// ```
/// use cyclide::{Point3, Vec3, conformal::{Plane, Sphere}, curve::{CircleOrLine, SphereOrPlane, SurfaceMeeting}};
/// let sphere = SphereOrPlane::Sphere(Sphere::new(Point3::ORIGIN, 5.0)?);
/// let plane = SphereOrPlane::Plane(Plane::new(Point3::new(0.0, 0.0, 3.0), Vec3::Z)?);
/// let SurfaceMeeting::Curve(CircleOrLine::Circle(circle)) = sphere.meet(&plane)? else { panic!("a circle") };
/// assert_eq!((circle.center(), circle.radius()), (Point3::new(0.0, 0.0, 3.0), 4.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SphereOrPlane {
    /// A sphere.
    Sphere(Sphere),
    /// A plane.
    Plane(Plane),
}

/// A circle, or a straight line, which is one through infinity.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, CircleOrLine}, conformal::Line};
/// let circle = CircleOrLine::Circle(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
/// let line = CircleOrLine::Line(Line::new(Point3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 1.0))?);
/// assert!((circle.angle_with(&line).angle.expect("they meet") - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CircleOrLine {
    /// A circle, right-handed about its normal.
    Circle(Circle),
    /// A straight line.
    Line(Line),
}
