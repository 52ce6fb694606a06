//! Motions whose place and turn are interpolated apart: straight lines and slerp, curves and splines of rotations, smoothed noise.

mod by_noise;
mod curve;
mod linear;
mod pose_noise;
mod rational_form;
mod smoothed;
mod smoothing_spline;
mod span;
mod turns;

pub use rational_form::RationalForm;
pub use smoothed::{MotionDeviation, MotionTolerance, PoseLimit};
pub(super) use span::angular_jet;

use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::span_of;
use super::timed_pose::{HalfTurns, Prepared, TimeOrder, TimedPose};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::CircleSpline;
use crate::error::{PoseError, Result};
use crate::warning::Warning;
use linear::ShortBlends;
use span::{PlaceSpan, TurnSpan};

/// A motion whose place and turn are interpolated apart, each by its own rule.
///
/// Made by [`linear`](Self::linear), [`polyline`](Self::polyline), [`on_curve`](Self::on_curve), [`smoothed`](Self::smoothed).
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{DecoupledMotion, Pose, TimedPose}};
/// let at = |time: f64, x: f64, turn: f64| TimedPose {
///     time,
///     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, turn), Vec3::X * x).unwrap(),
/// };
/// let motion = DecoupledMotion::linear(&[at(0.0, 0.0, 0.0), at(4.0, 100.0, 3.0)], None, 0.0)?;
/// let quarter = motion.pose(1.0);
/// assert!((quarter.translation() - Vec3::X * 25.0).length() < 1e-13);
/// assert!((quarter.angle_to(Pose::IDENTITY) - 0.75).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DecoupledMotion {
    /// Rising, one more than spans.
    times: Vec<f64>,
    places: Vec<PlaceSpan>,
    turns: Vec<TurnSpan>,
    /// On which the places are that are no polynomials.
    curve: Option<CircleSpline>,
    /// When it takes its poses, or passes them.
    pose_times: Vec<f64>,
    /// Where the origin of the body is in these poses.
    pose_places: Vec<Vec3>,
    half_turns: Option<HalfTurns>,
    short_blends: Option<ShortBlends>,
    deviation: Option<MotionDeviation>,
    /// Of noisy poses and their tolerances.
    smoothing: Vec<Warning>,
}

/// Poses of a motion, checked; the first one again at the end of a closed one.
struct Given {
    times: Vec<f64>,
    places: Vec<Vec3>,
    /// Neighbors on the same side.
    rotations: Vec<Quat>,
    closed: bool,
    half_turns: Option<HalfTurns>,
}

impl Given {
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`, `parameter-out-of-range` (a coordinate).
    fn new(poses: &[TimedPose], closing: Option<f64>) -> Result<Self> {
        if poses.len() < 2 {
            return Err(PoseError::WrongPoseCount { given: poses.len(), needed: 2, or_more: true }.into());
        }
        let again = closing.map(|time| TimedPose { time, pose: poses[0].pose });
        let all: Vec<TimedPose> = poses.iter().copied().chain(again).collect();
        let prepared = Prepared::new(&all, TimeOrder::Increasing)?;
        Ok(Self {
            times: all.iter().map(|timed| timed.time).collect(),
            places: all.iter().map(|timed| timed.pose.translation()).collect(),
            rotations: prepared.poses.iter().map(|pose| pose.real).collect(),
            closed: closing.is_some(),
            half_turns: prepared.half_turns,
        })
    }

    fn spans(&self) -> usize {
        self.times.len() - 1
    }

    fn step(&self, span: usize) -> f64 {
        self.times[span + 1] - self.times[span]
    }

    fn steps(&self) -> Vec<f64> {
        (0..self.spans()).map(|span| self.step(span)).collect()
    }

    /// The straight line from a pose to the next.
    fn line(&self, span: usize) -> PlaceSpan {
        PlaceSpan::line([self.places[span], self.places[span + 1]])
    }

    /// The motion with a span from each pose to the next.
    fn into_motion(self, places: Vec<PlaceSpan>, turns: Vec<TurnSpan>) -> DecoupledMotion {
        DecoupledMotion {
            times: self.times.clone(),
            places,
            turns,
            curve: None,
            pose_times: self.times,
            pose_places: self.places,
            half_turns: self.half_turns,
            short_blends: None,
            deviation: None,
            smoothing: Vec::new(),
        }
    }
}

impl DecoupledMotion {
    /// The times at which spans start, and the end.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The times of the poses that it was made through: it takes them then, but for a blend passes beside them.
    #[must_use]
    pub fn pose_times(&self) -> &[f64] {
        &self.pose_times
    }

    /// Where the origin of the body is in these poses.
    pub(super) fn pose_places(&self) -> &[Vec3] {
        &self.pose_places
    }

    /// The pose at a time, clamped to those of the motion.
    #[must_use]
    pub fn pose(&self, time: f64) -> Pose {
        let (span, u, _) = self.place_in_span(span_of(&self.times, time), time);
        Pose::of_unit(self.turns[span].rotation(u), self.places[span].place(u, self.curve.as_ref()))
    }

    /// What the body and one of its points do at a time. At a joint, on the span that starts there.
    #[must_use]
    pub fn jet(&self, time: f64, point: Point3) -> MotionJet {
        self.jet_in_span(span_of(&self.times, time), time, point)
    }

    /// The same on a span that the time is in or at an end of.
    pub(super) fn jet_in_span(&self, span: usize, time: f64, point: Point3) -> MotionJet {
        let (span, u, duration) = self.place_in_span(span, time);
        let turn = self.turns[span].jet(u);
        let place = self.places[span].jet(u, self.curve.as_ref());
        // A point of the body is at y from its origin: y' = ω × y and so on.
        let [omega, alpha, beta] = turn.angular;
        let y = turn.rotation.rotate(point.to_vec());
        let y1 = omega.cross(y);
        let y2 = alpha.cross(y) + omega.cross(y1);
        let y3 = beta.cross(y) + alpha.cross(y1) * 2.0 + omega.cross(y2);
        let mut moving = place;
        moving.point = place.point + y;
        moving.d1 = place.d1 + y1;
        moving.d2 = place.d2 + y2;
        moving.d3 = place.d3 + y3;
        let (first, second, third) = (1.0 / duration, duration.powi(-2), duration.powi(-3));
        MotionJet {
            pose: Pose::of_unit(turn.rotation, place.point.to_vec()),
            point: moving.scaled(first),
            angular_velocity: omega * first,
            angular_acceleration: alpha * second,
            angular_jerk: beta * third,
        }
    }

    /// The span, the part of it that is done, and how long it takes.
    fn place_in_span(&self, span: usize, time: f64) -> (usize, f64, f64) {
        let [from, to] = [self.times[span], self.times[span + 1]];
        (span, ((time - from) / (to - from)).clamp(0.0, 1.0), to - from)
    }

    /// How far a smoothed motion is from its poses; `None` of others, which take them.
    #[must_use]
    pub fn deviation(&self) -> Option<MotionDeviation> {
        self.deviation
    }

    /// What should be known of it: that a pose is half a turn away from the one before, and the sign of its rotation decides (`half-turn`), of
    /// blends that are shorter than asked for (`blends-shortened`), of poses that do not belong to the others (`outlier`), and of tolerances that are below the noise of the
    /// poses (`tolerance-below-noise`) or far above it (`shape-smoothed-away`, `wide-tolerance`), and of smoothed motions that overshoot their poses (`motion-swings`).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let short = self.short_blends.map(ShortBlends::warning);
        let half_turns = self.half_turns.map(HalfTurns::warning);
        half_turns.into_iter().chain(short).chain(self.smoothing.iter().cloned()).collect()
    }
}
