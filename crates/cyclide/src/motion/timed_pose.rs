//! Poses at times, and what every construction of a motion does with them first.

use super::dual_quat::DualQuat;
use super::pose::Pose;
use super::study_form::{rounding, vanished};
use crate::base::quat::Quat;
use crate::base::range::MAX_COORDINATE;
use crate::base::vector::Vec3;
use crate::error::{ErrorItem, InterpolationError, NumberError, PoseError, Result};
use crate::warning::{MotionWarning, Warning};

/// A pose and the time, or other parameter, at which a motion takes it.
///
/// ```
/// use cyclide::motion::{Pose, TimedPose};
/// let start = TimedPose { time: 0.0, pose: Pose::IDENTITY };
/// assert_eq!(start.pose.translation().length(), 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedPose {
    /// Time, in a unit of the user's.
    pub time: f64,
    /// Where the body is then.
    pub pose: Pose,
}

/// Rotations at an angle of more than half a turn have a product below this: at exactly half a turn its sign is rounding.
const OPPOSITE: f64 = -1e-12;

/// Turns are half a turn within this, in radians: what six digits of a matrix or a quaternion leave unknown.
const HALF_TURN: f64 = 2e-6;

/// Poses that are half a turn away from the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HalfTurns {
    /// The first one.
    pose: usize,
    count: usize,
    /// How much is missing to half a turn.
    off: f64,
}

impl HalfTurns {
    pub(super) fn warning(self) -> Warning {
        let Self { pose, count, off } = self;
        Warning::Motion(MotionWarning::HalfTurn { pose, count, off, limit: HALF_TURN })
    }
}

/// Poses as dual quaternions, made ready: about their centroid, in units of their size, neighbors in time on the same side.
///
/// Both are a change of frame and of unit, which the constructions commute with; they cost fewer digits there.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Smallest and largest time.
    pub(super) domain: [f64; 2],
    /// The times on the scale of the domain, 0 to 1.
    pub(super) places: Vec<f64>,
    /// Real parts of length 1, dual parts of length at most 1.
    pub(super) poses: Vec<DualQuat>,
    /// The centroid of the translations.
    pub(super) centre: Vec3,
    /// Length of the largest dual part before it was taken as unit; 1 if all vanish.
    pub(super) unit: f64,
    /// Study forms between the poses may be off by this: their coordinates are rounded.
    pub(super) rounding: f64,
    /// Study forms between the poses up to this are zero.
    pub(super) vanished: f64,
    /// Neighbors in time between which both ways round are as short.
    pub(super) half_turns: Option<HalfTurns>,
}

/// How the times of a construction may be ordered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TimeOrder {
    /// In any order, but different.
    Distinct,
    /// Each after the one before it.
    Increasing,
}

impl Prepared {
    /// Makes poses ready.
    ///
    /// # Errors
    /// `not-finite`; `repeated-parameter` or `parameters-not-increasing`.
    pub(super) fn new(given: &[TimedPose], order: TimeOrder) -> Result<Self> {
        if let Some(index) = given.iter().position(|p| !p.time.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Time, index }.into());
        }
        let times = || given.iter().map(|p| p.time);
        let domain = [times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max)];
        // Products of coordinates stay finite.
        if let Some(far) = given.iter().map(|p| p.pose.translation().max_abs()).find(|value| *value > MAX_COORDINATE) {
            let (value, min, max) = (far, -MAX_COORDINATE, MAX_COORDINATE);
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Translation, value, min, max }.into());
        }
        let range = domain[1] - domain[0];
        if !range.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Time, index: given.len() - 1 }.into());
        }
        let places: Vec<f64> = times().map(|t| (t - domain[0]) / range).collect();
        check_order(given, &places, order)?;
        let share = 1.0 / given.len() as f64;
        let centre = given.iter().fold(Vec3::ZERO, |sum, p| sum + p.pose.translation() * share);
        let mut poses: Vec<DualQuat> = given
            .iter()
            .map(|p| DualQuat::from_rotation_translation(p.pose.rotation(), p.pose.translation() - centre))
            .collect();
        if let Some(index) = poses.iter().position(|d| !d.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Translation, index }.into());
        }
        let largest = poses.iter().map(|d| d.dual.norm()).fold(0.0, f64::max);
        let unit = if largest > 0.0 { largest } else { 1.0 };
        for pose in &mut poses {
            pose.dual = Quat::from(pose.dual.to_array().map(|v| v / unit));
        }
        // Neighbors in time, whatever the order of the list: the motion is the same for all.
        let mut by_time: Vec<usize> = (0..poses.len()).collect();
        by_time.sort_by(|a, b| places[*a].total_cmp(&places[*b]));
        let mut half_turns: Option<HalfTurns> = None;
        for pair in by_time.windows(2) {
            let cosine = poses[pair[1]].real.dot(poses[pair[0]].real);
            if cosine < OPPOSITE {
                poses[pair[1]] = poses[pair[1]] * -1.0;
            }
            // The cosine of half the angle.
            let off = 2.0 * cosine.abs();
            if off <= HALF_TURN {
                let first = half_turns.unwrap_or(HalfTurns { pose: pair[1], count: 0, off });
                half_turns = Some(HalfTurns { count: first.count + 1, ..first });
            }
        }
        let farthest = given.iter().map(|p| p.pose.translation().max_abs()).fold(0.0, f64::max);
        let rounding = rounding(farthest, unit);
        Ok(Self { domain, places, poses, centre, unit, rounding, vanished: vanished(rounding), half_turns })
    }
}

/// # Errors
/// `repeated-parameter` or `parameters-not-increasing`.
fn check_order(given: &[TimedPose], places: &[f64], order: TimeOrder) -> Result<()> {
    for second in 1..given.len() {
        let value = given[second].time;
        match order {
            TimeOrder::Increasing if !(places[second] > places[second - 1]) => {
                let before = given[second - 1].time;
                return Err(PoseError::ParametersNotIncreasing { index: second, value, before }.into());
            }
            TimeOrder::Distinct => {
                if let Some(first) = (0..second).find(|first| places[*first].total_cmp(&places[second]).is_eq()) {
                    return Err(InterpolationError::RepeatedParameter { first, second, value }.into());
                }
            }
            TimeOrder::Increasing => {}
        }
    }
    Ok(())
}
