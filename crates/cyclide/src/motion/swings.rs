//! Where a spline motion runs beyond its poses and back.
//!
//! A cubic from value to value that starts or ends more than three times as fast as it goes on average need not be monotone. The dual quaternion as a
//! whole hides a part that swings behind the other one: place and turn are looked at apart as well. Of them it is told only where they go on beyond
//! the poses and come back, not where they turn round in between: a way that is as fast back as it came is that of the samples of a wave.

use super::dual_quat::DualQuat;
use super::rational_motion::MotionSpan;
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::warning::{SwingPart, Warning};

/// Ratios of the speed at an end to that on average above which a cubic need not be monotone.
const SWINGS: f64 = 3.0;
/// A part of the motion that is looked at alone swings if it runs beyond its poses by more than this part of the largest step beside it.
const BEYOND: f64 = 0.02;
/// Places that run beyond by up to this part of the extent of all poses are measured ones, with their noise,
const SAME_PLACE: f64 = 1e-4;
/// or, where they are far from the origin, by so many roundings of their coordinates,
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// and so are turns by up to this, in radians.
const SAME_TURN: f64 = 1e-3;
/// Steps up to this part of those beside them are none: there is no average speed.
const NO_STEP: f64 = 1e-9;
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
}

impl Swings {
    /// Those of the spans of a spline, if there are any.
    pub(super) fn of(spans: &[MotionSpan], ground: Ground) -> Option<Self> {
        let places: Vec<Run> = spans.iter().map(|span| Run::of_place(span, ground.unit)).collect();
        let turns: Vec<Run> = spans.iter().map(Run::of_turn).collect();
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
                let beyond = [places[i].beyond(ways()[0]), turns[i].beyond(ways()[1])];
                return (beyond[0] > least || beyond[1] > SAME_TURN).then_some((ratio, SwingPart::All));
            }
            let of_place = swing(&places, i, least, || ways()[0]);
            let of_turn = swing(&turns, i, SAME_TURN, || ways()[1]);
            let parts = [(of_place, SwingPart::Place), (of_turn, SwingPart::Turn)];
            let swinging = parts.into_iter().filter_map(|(ratio, part)| ratio.map(|ratio| (ratio, part)));
            swinging.max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut found: Option<Self> = None;
        for (span, (ratio, part)) in (0..spans.len()).filter_map(|i| Some((i, told(i)?))) {
            let count = found.map_or(0, |found| found.count) + 1;
            let most = found.filter(|found| found.ratio >= ratio).unwrap_or(Self { span, count, ratio, part });
            found = Some(Self { count, ..most });
        }
        found
    }

    pub(super) fn warning(self) -> Warning {
        let Self { span, count, ratio, part } = self;
        Warning::MotionSwings { span, count, ratio, part, limit: SWINGS }
    }
}

/// How place or turn go over a span.
#[derive(Debug, Clone, Copy)]
struct Run {
    /// From end to end.
    step: f64,
    /// Velocities at both ends, by the part of the span.
    ends: [Vec3; 2],
}

impl Run {
    fn of_place(span: &MotionSpan, unit: f64) -> Self {
        let step = (place(span, unit, 1.0) - place(span, unit, 0.0)).length();
        let ends = [0.0, 1.0].map(|s| {
            let [at, by] = bernstein::derivatives::<8, 2>(&span.0, s).map(DualQuat::from_array);
            let back = at.real.conj();
            // With |p| = 1 at the poses: (r p⁻¹)' = r' p̄ − r p̄ p' p̄.
            let moving = by.dual * back - at.dual * back * (by.real * back);
            moving.vector() * (2.0 * unit)
        });
        Self { step, ends }
    }

    fn of_turn(span: &MotionSpan) -> Self {
        let ends = [0.0, 1.0].map(|s| {
            let [at, by] = bernstein::derivatives::<8, 2>(&span.0, s).map(DualQuat::from_array);
            (by.real * at.real.conj()).vector() * 2.0
        });
        Self { step: angle(span, 0.0, 1.0), ends }
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

/// How many times as fast as on average a part starts or ends a span, if it runs beyond the poses and back there, by more than `least`.
fn swing(runs: &[Run], i: usize, least: f64, way: impl Fn() -> f64) -> Option<f64> {
    let run = runs[i];
    let beside = runs[i.saturating_sub(1)..(i + 2).min(runs.len())].iter().map(|run| run.step).fold(0.0, f64::max);
    let fastest = run.ends[0].length().max(run.ends[1].length());
    if !(fastest > SWINGS * run.step) || run.turns_round() {
        return None;
    }
    let ratio = if run.step > NO_STEP * beside { fastest / run.step } else { f64::INFINITY };
    (run.beyond(way()) > (BEYOND * beside).max(least)).then_some(ratio)
}

/// The ratio of the dual quaternion as a whole.
fn ratio_of_all(span: &MotionSpan) -> f64 {
    let length = |a: &[f64; 8], b: &[f64; 8]| (0..8).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
    match span.0.as_slice() {
        [a, b, c, d] => 3.0 * length(a, b).max(length(c, d)) / length(a, d),
        _ => 0.0,
    }
}

/// Where the origin of the body is, from the centre.
fn place(span: &MotionSpan, unit: f64, s: f64) -> Vec3 {
    let at = DualQuat::from_array(bernstein::eval(&span.0, s));
    (at.dual * at.real.conj()).vector() * (2.0 * unit / at.real.dot(at.real))
}

/// The angle between two places of a span.
fn angle(span: &MotionSpan, from: f64, to: f64) -> f64 {
    let [a, b] = [from, to].map(|s| DualQuat::from_array(bernstein::eval(&span.0, s)).real);
    let between = b * a.conj();
    2.0 * between.vector().length().atan2(between.w.abs())
}

fn way_of_place(span: &MotionSpan, unit: f64) -> f64 {
    parts().map(|[from, to]| (place(span, unit, to) - place(span, unit, from)).length()).sum()
}

fn way_of_turn(span: &MotionSpan) -> f64 {
    parts().map(|[from, to]| angle(span, from, to)).sum()
}

fn parts() -> impl Iterator<Item = [f64; 2]> {
    (0..PARTS).map(|k| [k, k + 1].map(|k| f64::from(k) / f64::from(PARTS)))
}
