//! A moving body at one moment: pose, velocities and what follows.

use super::pose::Pose;
use crate::base::jet::CurveJet;
use crate::base::vector::Vec3;

/// What a moving body does at one moment, and one of its points.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{Pose, ScrewMotion, TimedPose}};
/// let quarter = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
/// let poses = [(0.0, Quat::ONE), (1.0, quarter)].map(|(time, rotation)| TimedPose {
///     time,
///     pose: Pose::new(rotation, Vec3::ZERO).unwrap(),
/// });
/// let motion = ScrewMotion::new(&poses)?;
/// let jet = motion.jet(0.5, Point3::new(2.0, 0.0, 0.0));
/// assert!((jet.angular_velocity.z - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// assert!((jet.point.speed() - std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionJet {
    /// Where the body is.
    pub pose: Pose,
    /// Place, velocity, acceleration and jerk of the point, by the time of the motion, in the world.
    pub point: CurveJet,
    /// Angular velocity in the world, radians per unit of time.
    pub angular_velocity: Vec3,
    /// Angular acceleration in the world.
    pub angular_acceleration: Vec3,
    /// Derivative of the angular acceleration, in the world.
    pub angular_jerk: Vec3,
}
