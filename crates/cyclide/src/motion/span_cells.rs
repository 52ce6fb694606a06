//! Spans of a motion cut where quadrature of the speed and of the angular speed of the body cuts them: a cell is as narrow as what happens in it
//! (`docs/math/motions.md#extremes`).

use super::moving_body::Schedule;
use super::timing::TimeLaw;
use crate::base::quadrature;
use std::sync::{Arc, OnceLock};

/// Cells beyond this many follow the rounding of a speed that vanishes, and none of its peaks.
const MOST_CELLS: usize = 512;
/// Turns below this, in radians, are rounding.
pub(super) const NO_TURN: f64 = 1e-9;

/// The cells of all spans of a body, found when they are asked for first. They follow from the body: bodies are the same without them, and a copy
/// has them too.
#[derive(Debug, Clone, Default)]
pub(super) struct KnownCells(OnceLock<Arc<[SpanCells]>>);

impl PartialEq for KnownCells {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// A span cut into cells.
#[derive(Debug)]
pub(super) struct SpanCells {
    pub(super) span: usize,
    /// Parts of the duration at its ends.
    pub(super) ends: [f64; 2],
    /// Times of the motion at which its cells start, and its end.
    pub(super) times: Vec<f64>,
    /// The way of the tool, and the turn.
    pub(super) ways: [f64; 2],
}

impl Schedule<'_> {
    /// The cells of all spans that take time.
    pub(super) fn span_cells(&self) -> &[SpanCells] {
        self.known_cells().0.get_or_init(|| self.cut_spans().into())
    }

    fn cut_spans(&self) -> Vec<SpanCells> {
        let timing = self.timing();
        let (joints, times) = (timing.joints(), self.motion().times());
        let ends = joints.windows(2).zip(times.windows(2)).enumerate();
        // A law that goes by the way has no time for a span without one.
        ends.filter(|(_, (ends, _))| ends[1] > ends[0])
            .map(|(span, (ends, times))| {
                let of_speed = |k: usize| {
                    let mut speed = |t: f64| self.motion().velocities_in_span(span, t, self.tool())[k].length();
                    quadrature::cells(&mut speed, times[0], times[1])
                };
                let cells = [of_speed(0), of_speed(1)];
                let ways = [0, 1].map(|k| cells[k].iter().map(|cell| cell.integral).sum::<f64>());
                let told = |k: usize| cells[k].len() <= MOST_CELLS && ways[k] > [0.0, NO_TURN][k];
                let own = [0, 1].into_iter().filter(|k| told(*k)).flat_map(|k| &cells[k]).map(|cell| cell.a);
                let mut inner: Vec<f64> = own.collect();
                // By the times of the poses the body goes without a look at its way.
                if timing.law() != TimeLaw::AsGiven {
                    inner.extend(timing.cell_starts(times[0], times[1]));
                }
                inner.retain(|time| *time > times[0] && *time < times[1]);
                inner.sort_by(f64::total_cmp);
                inner.dedup_by(|a, b| *a <= *b);
                let times = [times[0]].into_iter().chain(inner).chain([times[1]]).collect();
                SpanCells { span, ends: [ends[0], ends[1]], times, ways }
            })
            .collect()
    }

    /// The parts of the duration at which the cells of a span start, rising, and its end.
    pub(super) fn breaks_of(&self, cells: &SpanCells) -> Vec<f64> {
        let mut breaks = vec![cells.ends[0]];
        for time in &cells.times[1..cells.times.len() - 1] {
            let fraction = self.timing().fraction_at(*time);
            if fraction > breaks[breaks.len() - 1] && fraction < cells.ends[1] {
                breaks.push(fraction);
            }
        }
        breaks.push(cells.ends[1]);
        breaks
    }

    /// Parts of the duration, rising, between which the body does little else than a polynomial of low degree: the joints among them, and closer
    /// where it is fast.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimedPose}};
    /// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
    /// let body = MovingBody::new(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 8.0), at(4.0, 9.0)])?.into());
    /// let breaks = body.schedule()?.breaks();
    /// assert!(breaks[0] == 0.0 && breaks.contains(&0.25) && breaks.ends_with(&[1.0]));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        let mut breaks = vec![0.0];
        self.span_cells().iter().for_each(|cells| breaks.extend(&self.breaks_of(cells)[1..]));
        breaks
    }
}

/// Each interval of rising places cut into so many even parts, and the end.
pub(super) fn in_parts(ends: &[f64], parts: usize) -> Vec<f64> {
    let of_cell = |ends: &[f64]| {
        let [a, b] = [ends[0], ends[1]];
        (0..parts).map(move |k| a + (b - a) * (k as f64 / parts as f64))
    };
    ends.windows(2).flat_map(of_cell).chain(ends.last().copied()).collect()
}
