//! A ball that touches two surfaces.

use crate::base::vector::{Point3, Vec3};

/// A ball that touches two surfaces, each in one point.
///
/// ```
/// use cyclide::{Point2, surface::SkewCylinders};
/// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?; // axes 4 apart
/// let smallest = pair.ball(Point2::new(0.0, std::f64::consts::FRAC_PI_2))?;
/// assert!((smallest.radius - 0.75).abs() < 1e-15); // half the gap
/// assert!((smallest.contacts[1].z - 0.5).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingBall {
    /// Center.
    pub center: Point3,
    /// Radius; negative for a ball inside both surfaces.
    pub radius: f64,
    /// Where it touches the first and the second surface.
    pub contacts: [Point3; 2],
    /// Unit normals of the surfaces there: `contact = center - radius * normal`.
    pub normals: [Vec3; 2],
}
