//! Screw-linear interpolation: between two poses the body turns about one axis and slides along it, both at constant speed.
//!
//! `D(t) = D_0 (D_0⁻¹ D_1)^t` (`docs/math/motions.md#screw-linear-interpolation`). With the relative displacement `p + ε r`, `s = |Im p|`,
//! `φ = atan2(s, Re p)`, axis `l = Im p / s` and slide `δ = 2 Im(r p̄)·l`, the power is
//!
//! ```text
//! p_t = cos tφ + l sin tφ
//! r_t = −½ t δ sin tφ + (sin tφ/sin φ) Im r + ½ δ (t cos tφ − cos φ sin tφ/sin φ) l
//! ```

use super::dual_quat::DualQuat;
use super::motion_jet::MotionJet;
use super::pose::Pose;
use super::timed_pose::{HalfTurns, Prepared, TimeOrder, TimedPose};
use crate::base::jet::CurveJet;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{PoseError, Result};
use crate::warning::Warning;

/// Below this half angle the quotients are taken from their series, which then are exact to rounding.
const SMALL_HALF_ANGLE: f64 = 1e-4;

/// A motion through poses that is a screw between two of them each: the shortest turns, of constant speed. From span to span
/// velocities jump (C0). Not rational: the paths of points are helices.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{Pose, ScrewMotion, TimedPose}};
/// let half = Pose::new(Quat::new(0.0, 0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, 4.0))?;
/// let motion = ScrewMotion::new(&[
///     TimedPose { time: 0.0, pose: Pose::IDENTITY },
///     TimedPose { time: 2.0, pose: half },
/// ])?;
/// let middle = motion.pose(1.0);
/// assert!((middle.translation() - Vec3::new(0.0, 0.0, 2.0)).length() < 1e-15);
/// assert!((middle.angle_to(Pose::IDENTITY) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ScrewMotion {
    times: Vec<f64>,
    screws: Vec<Screw>,
    half_turns: Option<HalfTurns>,
}

impl ScrewMotion {
    /// The motion through two poses or more. At half a turn there are two shortest ways: the sign of the second rotation decides.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`.
    pub fn new(poses: &[TimedPose]) -> Result<Self> {
        if poses.len() < 2 {
            return Err(PoseError::WrongPoseCount { given: poses.len(), needed: 2, or_more: true }.into());
        }
        let prepared = Prepared::new(poses, TimeOrder::Increasing)?;
        let screws = prepared.poses.windows(2).zip(poses);
        Ok(Self {
            times: poses.iter().map(|p| p.time).collect(),
            screws: screws.map(|(pair, from)| Screw::new([pair[0], pair[1]], prepared.unit, from.pose)).collect(),
            half_turns: prepared.half_turns,
        })
    }

    /// The times of the poses.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The pose at a time, clamped to those of the motion.
    #[must_use]
    pub fn pose(&self, time: f64) -> Pose {
        let (screw, t, _) = self.screw_in_span(super::span_of(&self.times, time), time);
        screw.start.after(screw.power(t))
    }

    /// What the body and one of its points do at a time. At a joint, the screw that starts there.
    #[must_use]
    pub fn jet(&self, time: f64, point: Point3) -> MotionJet {
        self.jet_in_span(super::span_of(&self.times, time), time, point)
    }

    /// The same on a span that the time is in or at an end of.
    pub(super) fn jet_in_span(&self, span: usize, time: f64, point: Point3) -> MotionJet {
        let (screw, t, duration) = self.screw_in_span(span, time);
        screw.jet(t, duration, point)
    }

    /// What should be known of it: that a pose is half a turn away from the one before, and the sign of its rotation decides (`half-turn`).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.half_turns.map(HalfTurns::warning).into_iter().collect()
    }

    /// The screw of a span, the part of it that is done, and how long it takes.
    fn screw_in_span(&self, span: usize, time: f64) -> (&Screw, f64, f64) {
        let [from, to] = [self.times[span], self.times[span + 1]];
        (&self.screws[span], ((time - from) / (to - from)).clamp(0.0, 1.0), to - from)
    }
}

/// One screw from a pose; the relative displacement in the frame of that pose.
#[derive(Debug, Clone, PartialEq)]
struct Screw {
    start: Pose,
    half_angle: f64,
    axis: Vec3,
    slide: f64,
    /// `Im r`.
    dual: Vec3,
}

impl Screw {
    /// Between two displacements about a center, their dual parts in units of `unit`.
    fn new([from, to]: [DualQuat; 2], unit: f64, start: Pose) -> Self {
        let relative = from.conj() * to;
        let (p, r) = (relative.real, relative.dual * unit);
        let sine = p.vector().length();
        // Without a turn the axis does not matter.
        let axis = if sine > 0.0 { p.vector() / sine } else { Vec3::ZERO };
        let translation = (r * p.conj()).vector() * 2.0;
        Self { start, half_angle: sine.atan2(p.w), axis, slide: translation.dot(axis), dual: r.vector() }
    }

    /// The relative displacement after the part `t`.
    fn power(&self, t: f64) -> Pose {
        let (phi, l) = (self.half_angle, self.axis);
        let (sin, cos) = (t * phi).sin_cos();
        let (ratio, bracket) = if phi < SMALL_HALF_ANGLE {
            (t * (1.0 + (1.0 - t * t) * phi * phi / 6.0), t * (1.0 - t * t) * phi * phi / 3.0)
        } else {
            let ratio = sin / phi.sin();
            (ratio, t * cos - phi.cos() * ratio)
        };
        let p = Quat::from_parts(cos, l * sin);
        let r = Quat::from_parts(-0.5 * t * self.slide * sin, self.dual * ratio + l * (0.5 * self.slide * bracket));
        Pose::of_unit(p, (r * p.conj()).vector() * 2.0)
    }

    /// Velocity of the point at the origin of the start's frame, by `t`.
    fn velocity(&self) -> Vec3 {
        let phi = self.half_angle;
        let (ratio, bracket) = if phi < SMALL_HALF_ANGLE {
            (1.0 + phi * phi / 6.0, phi * phi / 3.0)
        } else {
            let ratio = phi / phi.sin();
            (ratio, 1.0 - phi.cos() * ratio)
        };
        self.dual * (2.0 * ratio) + self.axis * (self.slide * bracket)
    }

    fn jet(&self, t: f64, duration: f64, point: Point3) -> MotionJet {
        let relative = self.power(t);
        let (turn, slide) = (self.axis * (2.0 * self.half_angle / duration), self.velocity() / duration);
        // A point at y moves with slide + turn × y.
        let d1 = slide + turn.cross(relative.apply(point).to_vec());
        let d2 = turn.cross(d1);
        let d3 = turn.cross(d2);
        let world = |v: Vec3| self.start.rotation().rotate(v);
        let pose = self.start.after(relative);
        MotionJet {
            pose,
            point: CurveJet { point: pose.apply(point), d1: world(d1), d2: world(d2), d3: world(d3) },
            angular_velocity: world(turn),
            angular_acceleration: Vec3::ZERO,
            angular_jerk: Vec3::ZERO,
        }
    }
}
