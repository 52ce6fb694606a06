//! Any motion of the kernel.

use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::rational_motion::RationalMotion;
use super::screw_motion::ScrewMotion;
use crate::base::vector::Point3;
use crate::error::{Error, Result};

/// Any motion of a rigid body over rising times.
///
/// ```
/// use cyclide::{Motion, Pose, Quat, RationalMotion, TimedPose, Vec3};
/// let at = |time: f64| TimedPose { time, pose: Pose::new(Quat::new(1.0, 0.0, 0.0, time), Vec3::X * time).unwrap() };
/// let motion = Motion::from(RationalMotion::spline(&[at(0.0), at(0.5), at(2.0)])?);
/// assert_eq!(motion.times(), [0.0, 0.5, 2.0]);
/// assert!((motion.pose(0.5).translation() - Vec3::X * 0.5).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Points run on rational curves.
    Rational(RationalMotion),
    /// Screws, one after the other.
    Screw(ScrewMotion),
}

impl Motion {
    /// The times at which spans start, and the end.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        match self {
            Self::Rational(motion) => motion.times(),
            Self::Screw(motion) => motion.times(),
        }
    }

    /// First and last time.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        let times = self.times();
        [times[0], times[times.len() - 1]]
    }

    /// The pose at a time, clamped to those of the motion.
    #[must_use]
    pub fn pose(&self, time: f64) -> Pose {
        match self {
            Self::Rational(motion) => motion.pose(time),
            Self::Screw(motion) => motion.pose(time),
        }
    }

    /// What the body and one of its points do at a time. At a joint, on the span that starts there.
    #[must_use]
    pub fn jet(&self, time: f64, point: Point3) -> MotionJet {
        match self {
            Self::Rational(motion) => motion.jet(time, point),
            Self::Screw(motion) => motion.jet(time, point),
        }
    }

    /// The motion as one whose points run on rational curves.
    ///
    /// # Errors
    /// `motion-not-rational`.
    pub fn rational(&self) -> Result<&RationalMotion> {
        match self {
            Self::Rational(motion) => Ok(motion),
            Self::Screw(_) => Err(Error::MotionNotRational),
        }
    }
}

impl From<RationalMotion> for Motion {
    fn from(motion: RationalMotion) -> Self {
        Self::Rational(motion)
    }
}

impl From<ScrewMotion> for Motion {
    fn from(motion: ScrewMotion) -> Self {
        Self::Screw(motion)
    }
}
