//! C1 motions through any number of poses: a cubic spline through their dual quaternions, read along the fibres of the quadric.
//!
//! Derivatives at inner poses are those of the parabola through three of them, at the ends that of the chord and the neighbour
//! (`2ΔY/h − D`), so that the spline runs as the parabola does there; between poses that are the same it rests. Reading along fibres commutes with displacements on both
//! sides, so the motion is the same in every frame (`docs/math/motions.md#fibre-projection`).

use super::rational_motion::{MotionSpan, RationalMotion};
use super::timed_pose::{Prepared, TimeOrder, TimedPose};
use crate::error::{Error, Result};
use crate::warning::Warning;

/// Roundings by which dual quaternions of one displacement differ: of angles, matrices, and products with the centre.
const RESTING: f64 = 16.0;
/// A cubic from value to value that starts or ends more times as fast than it goes on average need not be monotone.
const SWINGS: f64 = 3.0;

impl RationalMotion {
    /// The C1 motion through two poses or more at rising times. Between neighbours it takes the shorter way round; at half a
    /// turn the sign of the second rotation decides. Points run on C1 curves of degree 6. For two poses, the straight way.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`, `rotation-too-large` (a span turns so far that its direction
    /// is lost: insert a pose).
    pub fn spline(poses: &[TimedPose]) -> Result<Self> {
        if poses.len() < 2 {
            return Err(Error::WrongPoseCount { given: poses.len(), needed: 2, or_more: true });
        }
        let prepared = Prepared::new(poses, TimeOrder::Increasing)?;
        let values: Vec<[f64; 8]> = prepared.poses.iter().map(|d| d.to_array()).collect();
        let steps: Vec<f64> = prepared.places.windows(2).map(|w| w[1] - w[0]).collect();
        let derivatives = derivatives(&values, &steps, RESTING * f64::EPSILON + prepared.rounding);
        let spans: Vec<MotionSpan> = (0..steps.len())
            .map(|i| {
                let ([a, b], h) = ([values[i], values[i + 1]], steps[i] / 3.0);
                let towards = |from: [f64; 8], d: [f64; 8], h: f64| std::array::from_fn(|k| from[k] + h * d[k]);
                MotionSpan(vec![a, towards(a, derivatives[i], h), towards(b, derivatives[i + 1], -h), b])
            })
            .collect();
        spans.iter().enumerate().try_for_each(|(i, span)| span.check_length(i))?;
        let times: Vec<f64> = poses.iter().map(|p| p.time).collect();
        let swings = Swings::of(&spans);
        let pose_times = Vec::clone(&times);
        let motion = Self::of_spans(times, spans, prepared.centre, prepared.unit).through(pose_times);
        Ok(motion.swinging(swings).half_turning(prepared.half_turns))
    }
}

/// Where a spline runs beyond its poses and back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Swings {
    /// The span where it is most so.
    span: usize,
    /// How many such spans there are.
    count: usize,
    /// How many times as fast as on average it starts or ends there.
    ratio: f64,
}

impl Swings {
    /// Those of the spans of a spline, if there are any.
    fn of(spans: &[MotionSpan]) -> Option<Self> {
        let length = |a: &[f64; 8], b: &[f64; 8]| (0..8).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
        let ratio = |span: &MotionSpan| match span.0.as_slice() {
            [a, b, c, d] => 3.0 * length(a, b).max(length(c, d)) / length(a, d),
            _ => 0.0,
        };
        // A rest runs nowhere, and its ratio is no number.
        let swinging = spans.iter().map(ratio).enumerate().filter(|(_, ratio)| *ratio > SWINGS && ratio.is_finite());
        let count = swinging.clone().count();
        let (span, ratio) = swinging.max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Self { span, count, ratio })
    }

    pub(super) fn warning(self) -> Warning {
        let Self { span, count, ratio } = self;
        Warning::MotionSwings { span, count, ratio, limit: SWINGS }
    }
}

/// Three-point derivatives at the values, 0 at those that are the same as a neighbour.
fn derivatives(values: &[[f64; 8]], steps: &[f64], same: f64) -> Vec<[f64; 8]> {
    let last = steps.len();
    let rests = |i: usize| (0..8).all(|k| (values[i + 1][k] - values[i][k]).abs() <= same);
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
    let end = |chord: [f64; 8], neighbour: [f64; 8]| std::array::from_fn(|k| 2.0 * chord[k] - neighbour[k]);
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
