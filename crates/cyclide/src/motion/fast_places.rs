//! Parts of a motion on which it is faster than a machine allows.

use super::extremes::{Figure, raised};
use super::moving_body::Schedule;
use super::span_cells::in_parts;

/// Even parts of a cell that are looked at, as for all extremes.
const PARTS: usize = 16;
/// Halvings between a place that is slower and one that is faster: of a part of a cell they leave a rounding.
const HALVINGS: u32 = 40;

/// What is above a limit by no more than this part of it is at the limit: a speed is a product of derivatives with a way that was measured, and a law at
/// constant speed is at its limit everywhere.
const ROUNDED: f64 = 1e-12;

/// What of a moving body is limited.
///
/// ```
/// use cyclide::motion::SpeedKind;
/// assert_ne!(SpeedKind::Tool, SpeedKind::Turn);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpeedKind {
    /// The speed of the tool.
    Tool,
    /// The angular speed.
    Turn,
}

/// A part of a motion that is faster than asked for, by its fastest place.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, SpeedKind, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let body = MovingBody::new(RationalMotion::conic(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 4.0)])?.into()); // x = t²
/// let fast = body.schedule()?.faster_than(SpeedKind::Tool, 3.0);
/// assert!(fast.len() == 1 && (fast[0].from - 1.5).abs() < 1e-9 && (fast[0].to - 2.0).abs() < 1e-9);
/// assert!((fast[0].value - 4.0).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FastPlace {
    /// The largest speed of the part.
    pub value: f64,
    /// The span where that is, from 0.
    pub span: usize,
    /// When, from the start of the motion.
    pub time: f64,
    /// When the part begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
}

impl Schedule<'_> {
    /// The parts, in the order of time, on which the tool or the turn is faster than a limit, by more than 1e-12 of it.
    #[must_use]
    pub fn faster_than(&self, kind: SpeedKind, limit: f64) -> Vec<FastPlace> {
        let limit = limit + ROUNDED * limit.abs();
        let figure = match kind {
            SpeedKind::Tool => Figure::Speed,
            SpeedKind::Turn => Figure::Turning,
        };
        let mut found: Vec<FastPlace> = Vec::new();
        for cells in self.span_cells() {
            let value = |x: f64| self.figures(cells.span, x)[figure as usize];
            let places = in_parts(&self.breaks_of(cells), PARTS);
            let values: Vec<f64> = places.iter().map(|x| value(*x)).collect();
            // A peak between two places may be above the limit, and they below.
            let peaks = raised(cells, &places, &values).filter(|bracket| bracket.may_be > limit);
            let mut all: Vec<(f64, f64)> = peaks.map(|bracket| self.highest(figure, bracket)).collect();
            all.extend(places.into_iter().zip(values));
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            let crossing = |below: f64, above: f64| {
                let (mut below, mut above) = (below, above);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (below + above);
                    *(if value(middle) > limit { &mut above } else { &mut below }) = middle;
                }
                above * self.duration()
            };
            let mut before: Option<(f64, f64)> = None;
            for (x, speed) in all {
                let time = x * self.duration();
                let was_fast = before.is_some_and(|(_, before)| before > limit);
                if speed > limit {
                    let starts = match before {
                        Some((start, _)) if !was_fast => crossing(start, x),
                        _ => time,
                    };
                    // A part goes on from one span to the next.
                    match found.last_mut().filter(|part| was_fast || before.is_none() && part.to >= starts) {
                        Some(part) => part.reach(speed, cells.span, time),
                        None => found.push(FastPlace { value: speed, span: cells.span, time, from: starts, to: time }),
                    }
                } else if was_fast && let (Some(part), Some((end, _))) = (found.last_mut(), before) {
                    part.to = crossing(x, end);
                }
                before = Some((x, speed));
            }
        }
        found
    }
}

impl FastPlace {
    fn reach(&mut self, value: f64, span: usize, time: f64) {
        self.to = time;
        if value > self.value {
            (self.value, self.span, self.time) = (value, span, time);
        }
    }
}
