//! Where a spline motion runs beyond its poses and back.
//!
//! A cubic from value to value that starts or ends more than three times as fast as it goes on average need not be monotone. The dual quaternion as a
//! whole hides a part that swings behind the other one: place and turn are looked at apart as well. Of them it is reported only where they go on beyond
//! the poses and come back, not at the crest of a wave that was sampled on both sides of it: there they turn round as fast as they came, and have slowed
//! down before, or get faster after (`docs/math/motions.md#fiber-projection`).

use super::dual_quat::DualQuat;
use super::rational_motion::MotionSpan;
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::warning::{MotionWarning, SwingPart, Warning};

/// Ratios of the speed at an end to that on average above which a cubic need not be monotone.
const SWINGS: f64 = 3.0;
/// A part of the motion that is looked at alone swings if it runs beyond its poses by more than this part of the largest step beside it.
const BEYOND: f64 = 0.02;
/// Places that run beyond by up to this part of the extent of all poses are measured ones, with their noise,
pub(super) const SAME_PLACE: f64 = 1e-4;
/// or, where they are far from the origin, by so many roundings of their coordinates,
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// and so are turns by up to this, in radians.
pub(super) const SAME_TURN: f64 = 1e-3;
/// Steps up to this part of those beside them are none: there is no average speed.
const NO_STEP: f64 = 1e-9;
/// Towards a crest the samples of a wave slow down at least to this part of their speed: those of a sine with 12 samples to 0.58, with 8 to 0.71.
const SLOWS: f64 = 0.75;
/// Even parts of a span of which the way is summed.
const PARTS: u32 = 16;

/// What the dual parts of spans are relative to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ground {
    pub(super) unit: f64,
    pub(super) centre: Vec3,
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
    /// What of it does.
    part: SwingPart,
    /// How far: a length, or radians of a turn.
    beyond: f64,
}

impl Swings {
    /// Those of the spans of a spline with these durations, if there are any; `closed` if the last span leads to the first.
    pub(super) fn of(spans: &[MotionSpan], steps: &[f64], closed: bool, ground: Ground) -> Option<Self> {
        let places = spans.iter().zip(steps).map(|(span, step)| Run::of_place(span, ground.unit, *step));
        let places = Runs { runs: places.collect(), closed };
        let turns = spans.iter().zip(steps).map(|(span, step)| Run::of_turn(span, *step));
        let turns = Runs { runs: turns.collect(), closed };
        let ends = spans.iter().flat_map(|span| [0.0, 1.0].map(|s| Point3::ORIGIN + place(span, ground.unit, s)));
        let least = Aabb::of_points(ends).map_or(0.0, |of_poses| {
            let coordinates = of_poses.max_abs() + ground.centre.max_abs();
            SAME_PLACE * (of_poses.max - of_poses.min).max_abs() + ROUNDINGS * coordinates
        });
        let told = |i: usize| {
            let ways = || [way_of_place(&spans[i], ground.unit), way_of_turn(&spans[i])];
            let ratio = ratio_of_all(&spans[i]);
            // A rest runs nowhere, and its ratio is no number.
            if ratio > SWINGS && ratio.is_finite() {
                let beyond = [places.runs[i].beyond(ways()[0]), turns.runs[i].beyond(ways()[1])];
                let swings = beyond[0] > least || beyond[1] > SAME_TURN;
                return swings.then_some((ratio, SwingPart::All, beyond[0]));
            }
            let of_place = places.swing(i, least, || ways()[0]);
            let of_turn = turns.swing(i, SAME_TURN, || ways()[1]);
            let parts = [(of_place, SwingPart::Place), (of_turn, SwingPart::Turn)];
            let swinging = parts.into_iter().filter_map(|(found, part)| found.map(|(ratio, far)| (ratio, part, far)));
            swinging.max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut found: Option<Self> = None;
        for (span, (ratio, part, beyond)) in (0..spans.len()).filter_map(|i| Some((i, told(i)?))) {
            let count = found.map_or(0, |found| found.count) + 1;
            let most = found.filter(|found| found.ratio >= ratio);
            let most = most.unwrap_or(Self { span, count, ratio, part, beyond });
            found = Some(Self { count, ..most });
        }
        found
    }

    pub(super) fn warning(self) -> Warning {
        let Self { span, count, ratio, part, beyond } = self;
        Warning::Motion(MotionWarning::Swings { span, count, ratio, part, beyond, limit: SWINGS })
    }
}

/// How place or turn go over a span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    /// From end to end.
    step: f64,
    /// The same by time, with its direction.
    average: Vec3,
    /// Velocities at both ends, by the part of the span.
    ends: [Vec3; 2],
}

/// Where a part of a motion runs beyond its poses and back.
#[derive(Debug, Clone, Copy)]
pub(super) struct PartSwings {
    /// The span where it is most so.
    pub(super) span: usize,
    /// How many such spans there are.
    pub(super) count: usize,
    /// How many times as fast as on average it starts or ends there.
    pub(super) ratio: f64,
    /// How far: a length, or radians of a turn.
    pub(super) beyond: f64,
}

impl PartSwings {
    /// Of a part that goes so over its spans, by more than `least`.
    pub(super) fn of(runs: Vec<Run>, closed: bool, least: f64, way: impl Fn(usize) -> f64) -> Option<Self> {
        let runs = Runs { runs, closed };
        let mut found: Option<Self> = None;
        for span in 0..runs.runs.len() {
            if let Some((ratio, beyond)) = runs.swing(span, least, || way(span)) {
                let count = found.map_or(0, |found| found.count) + 1;
                let most = found.filter(|found| found.ratio >= ratio);
                found = Some(Self { count, ..most.unwrap_or(Self { span, count, ratio, beyond }) });
            }
        }
        found
    }
}

impl Run {
    /// From end to end in a time, with the velocities at both ends by the part of the span.
    pub(super) fn new(chord: Vec3, time: f64, ends: [Vec3; 2]) -> Self {
        Self { step: chord.length(), average: chord / time, ends }
    }

    fn of_place(span: &MotionSpan, unit: f64, time: f64) -> Self {
        let chord = place(span, unit, 1.0) - place(span, unit, 0.0);
        let ends = [0.0, 1.0].map(|s| {
            let [at, by] = bernstein::derivatives::<8, 2>(&span.0, s).map(DualQuat::from_array);
            let back = at.real.conj();
            // With |p| = 1 at the poses: (r p⁻¹)' = r' p̄ − r p̄ p' p̄.
            let moving = by.dual * back - at.dual * back * (by.real * back);
            moving.vector() * (2.0 * unit)
        });
        Self::new(chord, time, ends)
    }

    fn of_turn(span: &MotionSpan, time: f64) -> Self {
        let ends = [0.0, 1.0].map(|s| {
            let [at, by] = bernstein::derivatives::<8, 2>(&span.0, s).map(DualQuat::from_array);
            (by.real * at.real.conj()).vector() * 2.0
        });
        Self::new(rotation_vector(span, 0.0, 1.0), time, ends)
    }

    /// How far it runs beyond the ends, both together, by its way.
    fn beyond(&self, way: f64) -> f64 {
        0.5 * (way - self.step)
    }

    /// Whether it turns round, about as fast back as it came.
    fn turns_round(&self) -> bool {
        let [a, b] = self.ends.map(Vec3::length);
        self.ends[0].dot(self.ends[1]) < 0.0 && a.min(b) * SWINGS > a.max(b)
    }
}

/// How place or turn go over all spans.
struct Runs {
    runs: Vec<Run>,
    closed: bool,
}

impl Runs {
    /// The run so many spans after one, or before it.
    fn beside(&self, i: usize, by: isize) -> Option<Run> {
        let (at, count) = (i as isize + by, self.runs.len() as isize);
        if self.closed {
            return Some(self.runs[at.rem_euclid(count) as usize]);
        }
        (0..count).contains(&at).then(|| self.runs[at as usize])
    }

    /// How many times as fast as on average a part starts or ends a span, and how far it runs beyond the poses and back there, if by more than `least`.
    fn swing(&self, i: usize, least: f64, way: impl Fn() -> f64) -> Option<(f64, f64)> {
        let run = self.runs[i];
        let steps = [-1, 0, 1].map(|by| self.beside(i, by).map_or(0.0, |run| run.step));
        let largest = steps.into_iter().fold(0.0, f64::max);
        let fastest = run.ends[0].length().max(run.ends[1].length());
        if !(fastest > SWINGS * run.step) || (run.turns_round() && self.is_crest(i)) {
            return None;
        }
        let ratio = if run.step > NO_STEP * largest { fastest / run.step } else { f64::INFINITY };
        let beyond = run.beyond(way());
        (beyond > (BEYOND * largest).max(least)).then_some((ratio, beyond))
    }

    /// Whether the samples on one side slow down towards the span, as those of a wave do at its crest: what stops short beside it, as a lift before a turn
    /// does, has none.
    fn is_crest(&self, i: usize) -> bool {
        [-1, 1].into_iter().any(|side| match (self.beside(i, side), self.beside(i, 2 * side)) {
            (Some(near), Some(far)) => {
                near.average.dot(far.average) > 0.0 && near.average.length() <= SLOWS * far.average.length()
            }
            _ => false,
        })
    }
}

/// The ratio of the dual quaternion as a whole.
fn ratio_of_all(span: &MotionSpan) -> f64 {
    let length = |a: &[f64; 8], b: &[f64; 8]| (0..8).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
    match span.0.as_slice() {
        [a, b, c, d] => 3.0 * length(a, b).max(length(c, d)) / length(a, d),
        _ => 0.0,
    }
}

/// Where the origin of the body is, from the center.
pub(super) fn place(span: &MotionSpan, unit: f64, s: f64) -> Vec3 {
    let at = DualQuat::from_array(bernstein::eval(&span.0, s));
    (at.dual * at.real.conj()).vector() * (2.0 * unit / at.real.dot(at.real))
}

/// The turn from one place of a span to another, the shorter way: along its axis, as long as its angle.
fn rotation_vector(span: &MotionSpan, from: f64, to: f64) -> Vec3 {
    let [a, b] = [from, to].map(|s| DualQuat::from_array(bernstein::eval(&span.0, s)).real);
    let between = b * a.conj();
    let sine = between.vector().length();
    if !(sine > 0.0) {
        return Vec3::ZERO;
    }
    between.vector() * (2.0 * sine.atan2(between.w.abs()) * between.w.signum() / sine)
}

fn way_of_place(span: &MotionSpan, unit: f64) -> f64 {
    parts().map(|[from, to]| (place(span, unit, to) - place(span, unit, from)).length()).sum()
}

fn way_of_turn(span: &MotionSpan) -> f64 {
    parts().map(|[from, to]| rotation_vector(span, from, to).length()).sum()
}

pub(super) fn parts() -> impl Iterator<Item = [f64; 2]> {
    (0..PARTS).map(|k| [k, k + 1].map(|k| f64::from(k) / f64::from(PARTS)))
}
