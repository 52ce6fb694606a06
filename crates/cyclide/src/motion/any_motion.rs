//! Any motion of the kernel.

use super::decoupled::DecoupledMotion;
use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::rational_motion::RationalMotion;
use super::screw_motion::ScrewMotion;
use super::span_of;
use crate::base::vector::{Point3, Vec3};
use crate::error::{MotionError, Result};
use crate::warning::Warning;

/// Places that differ by up to this part of their coordinates are one.
const SAME_PLACE: f64 = 1e-12;

/// Ends of a way that comes back are not farther apart than this part of it.
const SAME_END: f64 = 1e-6;

/// Any motion of a rigid body over rising times.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{Motion, Pose, RationalMotion, TimedPose}};
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
    /// Place and turn each by its own rule.
    Decoupled(DecoupledMotion),
}

impl Motion {
    /// The times at which spans start, and the end.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        match self {
            Self::Rational(motion) => motion.times(),
            Self::Screw(motion) => motion.times(),
            Self::Decoupled(motion) => motion.times(),
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
            Self::Decoupled(motion) => motion.pose(time),
        }
    }

    /// What the body and one of its points do at a time. At a joint, on the span that starts there.
    #[must_use]
    pub fn jet(&self, time: f64, point: Point3) -> MotionJet {
        match self {
            Self::Rational(motion) => motion.jet(time, point),
            Self::Screw(motion) => motion.jet(time, point),
            Self::Decoupled(motion) => motion.jet(time, point),
        }
    }

    /// As [`jet`](Self::jet), on a span that the time is in or at an end of.
    pub(super) fn jet_in_span(&self, span: usize, time: f64, point: Point3) -> MotionJet {
        match self {
            Self::Rational(motion) => motion.jet_in_span(span, time, point),
            Self::Screw(motion) => motion.jet_in_span(span, time, point),
            Self::Decoupled(motion) => motion.jet_in_span(span, time, point),
        }
    }

    /// Velocity of a point of the body, and the angular velocity, at a time.
    pub(super) fn velocities(&self, time: f64, point: Point3) -> [Vec3; 2] {
        self.velocities_in_span(span_of(self.times(), time), time, point)
    }

    /// The same on a span that the time is in or at an end of.
    pub(super) fn velocities_in_span(&self, span: usize, time: f64, point: Point3) -> [Vec3; 2] {
        match self {
            Self::Rational(motion) => motion.velocities_in_span(span, time, point),
            Self::Screw(_) | Self::Decoupled(_) => {
                let jet = self.jet_in_span(span, time, point);
                [jet.point.d1, jet.angular_velocity]
            }
        }
    }

    /// The angle from the first pose to the last, 0 to π, if the origin of the body moves and comes back to where it began, to 1e-12 of the
    /// coordinates and a millionth of its way: by so much the body does not close. `None` of other motions.
    ///
    /// ```
    /// use cyclide::{Point3, Quat, construct::ArcSplineOptions, curve::{ArcPath, QbSpline}, motion::{Motion, RationalMotion}};
    /// let corners = [[4.0, 0.0, 0.0], [2.0, 3.0, 2.0], [-2.0, 3.0, -1.0], [-4.0, 1.0, 0.5], [0.0, -3.0, 1.5]].map(Point3::from);
    /// let turn = |closed: bool| {
    ///     let curve = ArcPath::spline(&corners, &ArcSplineOptions { closed, ..Default::default() })?;
    ///     let motion = RationalMotion::along(&QbSpline::from_arcs(&curve), Quat::ONE)?;
    ///     Ok::<_, cyclide::Error>(Motion::from(motion).closing_turn())
    /// };
    /// assert!(turn(true)?.is_some_and(|turn| turn > 0.01) && turn(false)?.is_none());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn closing_turn(&self) -> Option<f64> {
        let [first, last] = self.domain().map(|time| self.pose(time));
        let size = self.times().iter().map(|t| self.pose(*t).translation().max_abs()).fold(0.0, f64::max);
        let apart = (last.translation() - first.translation()).length();
        // Far from the origin a short way is next to the rounding of its ends: those of one that goes on are no small part of it.
        let comes_back = apart <= SAME_PLACE * size && {
            let way = self.way(Point3::ORIGIN);
            way > SAME_PLACE * size && apart <= SAME_END * way
        };
        comes_back.then(|| first.angle_to(last))
    }

    /// The times at which it takes the poses that it was made through, or passes them in a blend, rising; none along a curve.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::{Motion, Pose, RationalMotion, TimedPose}};
    /// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::new(1.0, 0.0, 0.0, time), Vec3::X * x).unwrap() };
    /// let motion = Motion::from(RationalMotion::conic(&[at(0.0, 0.0), at(1.0, 2.0), at(3.0, 3.0)])?);
    /// assert_eq!(motion.pose_times(), [0.0, 1.0, 3.0]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn pose_times(&self) -> &[f64] {
        match self {
            Self::Rational(motion) => motion.pose_times(),
            Self::Screw(motion) => motion.times(),
            Self::Decoupled(motion) => motion.pose_times(),
        }
    }

    /// What should be known of it, as where poses were taken for planar ones (`poses-rounded`).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        match self {
            Self::Rational(motion) => motion.warnings(),
            Self::Screw(motion) => motion.warnings(),
            Self::Decoupled(motion) => motion.warnings(),
        }
    }

    /// The motion as one whose points run on rational curves exactly; [`to_rational`](Self::to_rational) takes others within a bound.
    ///
    /// # Errors
    /// `motion-not-rational`.
    pub fn rational(&self) -> Result<&RationalMotion> {
        match self {
            Self::Rational(motion) => Ok(motion),
            Self::Screw(_) | Self::Decoupled(_) => Err(MotionError::NotRational.into()),
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

impl From<DecoupledMotion> for Motion {
    fn from(motion: DecoupledMotion) -> Self {
        Self::Decoupled(motion)
    }
}
