//! Where a body gets fast against what it does on average: within a span, and on a span against all of them.
//!
//! Speeds are looked at by the time of the motion, which is cheap and as good: a cell of it is as narrow as what happens in it.

use super::moving_body::Schedule;
use super::span_cells::{NO_TURN, SpanCells, in_parts};
use super::timing::TimeLaw;
use crate::base::golden_section::GoldenSection;

/// Even parts of a cell that are looked at, as for all extremes.
const PARTS: usize = 16;
/// Sections of a bracket.
const SECTIONS: u32 = 40;
/// Peaks of a speed are looked at on spans with at least this part of the whole way, or turn.
const COUNTS: f64 = 1e-6;
/// Turns below this, in radians, are no matter however fast they are.
const LITTLE_TURN: f64 = 1e-2;

/// A place at which a body is fast against the average of the span.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let motion = RationalMotion::conic(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 4.0)])?; // x = t²
/// let body = MovingBody::new(motion.into());
/// let peak = body.schedule()?.extremes().peak.unwrap();
/// assert!((peak.time - 2.0).abs() < 1e-6 && (peak.ratio - 2.0).abs() < 1e-6 && !peak.turning);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SpeedPeak {
    /// The span, from 0.
    pub span: usize,
    /// The time, from the start of the motion.
    pub time: f64,
    /// How many times as fast as on average.
    pub ratio: f64,
    /// True of the angular speed.
    pub turning: bool,
}

/// A span on which a body turns much faster than it does on average over the whole motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FastTurn {
    pub(super) span: usize,
    /// By how much it turns there, radians.
    pub(super) turn: f64,
    /// How long that takes.
    pub(super) seconds: f64,
    /// How many times as fast as on average.
    pub(super) ratio: f64,
}

/// Where it may be: times beside it, and the value there.
#[derive(Clone, Copy)]
struct Bracket {
    ends: [f64; 2],
    at: f64,
    value: f64,
}

impl Schedule<'_> {
    /// The place at which the speed of the tool, or the angular speed, is the most times as large as on average over the same span.
    pub(super) fn speed_peak(&self, spans: &[SpanCells]) -> Option<SpeedPeak> {
        let whole = [0, 1].map(|k| spans.iter().map(|cells| cells.ways[k]).sum::<f64>());
        let mut peak: Option<(SpeedPeak, Bracket)> = None;
        for cells in spans {
            let counts = [0, 1].map(|k| cells.ways[k] > COUNTS * whole[k] && (k == 0 || whole[k] > NO_TURN));
            if counts == [false; 2] {
                continue;
            }
            let places = in_parts(&cells.times, PARTS);
            let values: Vec<[f64; 2]> = places.iter().map(|time| self.speeds_by_part(cells, *time)).collect();
            for k in (0..2).filter(|k| counts[*k]) {
                let average = cells.ways[k] / (cells.ends[1] - cells.ends[0]);
                let known = values.iter().enumerate().filter(|(_, value)| value[k].is_finite());
                let Some((highest, value)) = known.max_by(|a, b| a.1[k].total_cmp(&b.1[k])) else { continue };
                let ratio = value[k] / average;
                if peak.is_none_or(|(known, _)| ratio > known.ratio) {
                    let ends = [highest.saturating_sub(1), (highest + 1).min(places.len() - 1)].map(|i| places[i]);
                    let found = SpeedPeak { span: cells.span, time: places[highest], ratio, turning: k == 1 };
                    peak = Some((found, Bracket { ends, at: places[highest], value: value[k] }));
                }
            }
        }
        let (found, bracket) = peak?;
        let cells = spans.iter().find(|cells| cells.span == found.span)?;
        let value = |time: f64| self.speeds_by_part(cells, time)[usize::from(found.turning)];
        let place = GoldenSection::lowest(|time| -value(time), bracket.ends, SECTIONS);
        let refined = value(place);
        let better = refined.is_finite() && refined > bracket.value;
        let (time, factor) = if better { (place, refined / bracket.value) } else { (bracket.at, 1.0) };
        let time = self.timing().fraction_at(time) * self.duration();
        Some(SpeedPeak { time, ratio: found.ratio * factor, ..found })
    }

    /// Speed of the tool and angular speed, by the part of the duration, at a time of the motion in a span; not finite where a law stands still.
    fn speeds_by_part(&self, cells: &SpanCells, time: f64) -> [f64; 2] {
        let [from, to] = [cells.times[0], cells.times[cells.times.len() - 1]];
        let inside = time.min(to.next_down().max(from));
        let rate = self.timing().time_by_part(inside);
        self.motion().velocities(inside, self.tool()).map(|velocity| velocity.length() * rate)
    }

    /// Under a law that goes by the way, the span on which the body turns the most times as fast as on average over all of them.
    pub(super) fn fastest_turn(&self, spans: &[SpanCells]) -> Option<FastTurn> {
        let whole = spans.iter().map(|cells| cells.ways[1]).sum::<f64>();
        let turns = spans.iter().filter(|cells| cells.ways[1] > LITTLE_TURN).map(|cells| {
            let part = cells.ends[1] - cells.ends[0];
            let (turn, seconds) = (cells.ways[1], part * self.duration());
            FastTurn { span: cells.span, turn, seconds, ratio: turn / whole / part }
        });
        turns.filter(|_| self.timing().law() != TimeLaw::AsGiven).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }
}
