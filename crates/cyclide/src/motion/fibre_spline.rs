//! C1 motions through any number of poses: a cubic spline through their dual quaternions, read along the fibers of the quadric.
//!
//! Derivatives at inner poses are those of the parabola through three of them, at the ends that of the chord and the neighbor
//! (`2ΔY/h − D`), so that the spline runs as the parabola does there; between poses that are the same it rests. Reading along fibers commutes with displacements on both
//! sides, so the motion is the same in every frame (`docs/math/motions.md#fiber-projection`).

use super::leaves_chords::LeavesChords;
use super::rational_motion::{MotionSpan, RationalMotion};
use super::swings::{Ground, Swings};
use super::timed_pose::{Prepared, TimeOrder, TimedPose};
use crate::error::{PoseError, Result};

/// Roundings by which dual quaternions of one displacement differ: of angles, matrices, and products with the center.
const RESTING: f64 = 16.0;

impl RationalMotion {
    /// The C1 motion through two poses or more at rising times. Between neighbors it takes the shorter way round; at half a
    /// turn the sign of the second rotation decides. Points run on C1 curves of degree 6. For two poses, the straight way.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`, `rotation-too-large` (a span turns so far that its direction
    /// is lost: insert a pose).
    pub fn spline(poses: &[TimedPose]) -> Result<Self> {
        spline(poses, false)
    }

    /// The closed C1 motion through poses, which is back at the first one at the time `closing` and goes on as it began; the first is not repeated.
    /// The body may have come round.
    ///
    /// ```
    /// use cyclide::{Point3, Quat, Vec3, motion::{Pose, RationalMotion, TimedPose}};
    /// let at = |time: f64| {
    ///     let turn = Quat::from_axis_angle(Vec3::Z, time);
    ///     TimedPose { time, pose: Pose::new(turn, turn.rotate(Vec3::X * 50.0)).unwrap() }
    /// };
    /// let motion = RationalMotion::closed_spline(&[at(0.0), at(1.5), at(3.0), at(4.5)], std::f64::consts::TAU)?;
    /// let [start, end] = [0, 3].map(|span| motion.jet([0.0, std::f64::consts::TAU][span / 3], Point3::ORIGIN).point.d1);
    /// assert!((start - end).length() < 1e-12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`spline`](Self::spline).
    pub fn closed_spline(poses: &[TimedPose], closing: f64) -> Result<Self> {
        let again = poses.first().map(|first| TimedPose { time: closing, ..*first });
        let all: Vec<TimedPose> = poses.iter().copied().chain(again.filter(|_| poses.len() > 1)).collect();
        spline(&all, true)
    }
}

/// The spline through poses, of which the last is the first again if it is closed.
fn spline(poses: &[TimedPose], closed: bool) -> Result<RationalMotion> {
    if poses.len() < 2 {
        return Err(PoseError::WrongPoseCount { given: poses.len(), needed: 2, or_more: true }.into());
    }
    let prepared = Prepared::new(poses, TimeOrder::Increasing)?;
    let values: Vec<[f64; 8]> = prepared.poses.iter().map(|d| d.to_array()).collect();
    let steps: Vec<f64> = prepared.places.windows(2).map(|w| w[1] - w[0]).collect();
    let same = RESTING * f64::EPSILON + prepared.rounding;
    let rests = |i: usize| (0..8).all(|k| (values[i + 1][k] - values[i][k]).abs() <= same);
    let derivatives = derivatives(&values, &steps, closed, rests);
    let spans: Vec<MotionSpan> = (0..steps.len())
        .map(|i| {
            // To the bit, so that a rest is known as one.
            if rests(i) {
                return MotionSpan(vec![values[i]; 4]);
            }
            let ([a, b], h) = ([values[i], values[i + 1]], steps[i] / 3.0);
            let towards = |from: [f64; 8], d: [f64; 8], h: f64| std::array::from_fn(|k| from[k] + h * d[k]);
            MotionSpan(vec![a, towards(a, derivatives[i], h), towards(b, derivatives[i + 1], -h), b])
        })
        .collect();
    spans.iter().enumerate().try_for_each(|(i, span)| span.check_length(i))?;
    let times: Vec<f64> = poses.iter().map(|p| p.time).collect();
    let ground = Ground { unit: prepared.unit, centre: prepared.centre };
    let swings = Swings::of(&spans, &steps, closed, ground);
    // One warning of one span: both have the same remedy.
    let leaves = if swings.is_none() { LeavesChords::of(&spans, closed, ground) } else { None };
    let pose_times = Vec::clone(&times);
    let motion = RationalMotion::of_spans(times, spans, prepared.centre, prepared.unit).through(pose_times);
    Ok(motion.swinging(swings, leaves).half_turning(prepared.half_turns))
}

/// Three-point derivatives at the values, 0 at those that are the same as a neighbor.
fn derivatives(values: &[[f64; 8]], steps: &[f64], closed: bool, rests: impl Fn(usize) -> bool) -> Vec<[f64; 8]> {
    let last = steps.len();
    let slope = |i: usize| -> [f64; 8] { std::array::from_fn(|k| (values[i + 1][k] - values[i][k]) / steps[i]) };
    if last == 1 {
        return vec![slope(0); 2];
    }
    let inner = |i: usize| -> [f64; 8] {
        if rests(i - 1) || rests(i) {
            return [0.0; 8];
        }
        let ([before, after], [h0, h1]) = ([slope(i - 1), slope(i)], [steps[i - 1], steps[i]]);
        std::array::from_fn(|k| (before[k] * h1 + after[k] * h0) / (h0 + h1))
    };
    if closed {
        // The last value is the first one, on the one side or the other.
        let side = if (0..4).map(|k| values[0][k] * values[last][k]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let ([before, after], [h0, h1]) = ([slope(last - 1), slope(0)], [steps[last - 1], steps[0]]);
        let joint: [f64; 8] = match rests(0) || rests(last - 1) {
            true => [0.0; 8],
            false => std::array::from_fn(|k| (side * before[k] * h1 + after[k] * h0) / (h0 + h1)),
        };
        let between = (1..last).map(inner);
        return [joint].into_iter().chain(between).chain([joint.map(|v| side * v)]).collect();
    }
    let end = |chord: [f64; 8], neighbor: [f64; 8]| std::array::from_fn(|k| 2.0 * chord[k] - neighbor[k]);
    (0..=last)
        .map(|i| match i {
            0 if rests(0) => [0.0; 8],
            i if i == last && rests(last - 1) => [0.0; 8],
            0 => end(slope(0), inner(1)),
            i if i == last => end(slope(last - 1), inner(last - 1)),
            i => inner(i),
        })
        .collect()
}
