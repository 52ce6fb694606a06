//! The extremes of what a moving body does: how fast, and how suddenly.
//!
//! Each span is cut where quadrature of the speed and of the angular speed cuts it, so that a cell is as narrow as what happens in it, and
//! each cell into even parts. A place that is higher than its neighbours is between these, where sections in the golden ratio find it
//! (`docs/math/motions.md#extremes`).

use super::moving_body::Schedule;
use crate::base::golden_section::GoldenSection;
use crate::base::quadrature;

/// Even parts of a cell: on it one 8-point rule gives the integral to 1e-13, so that it bends little.
const PARTS: usize = 16;
/// Sections of a bracket, which leave 4e-9 of it: of a smooth peak nothing that counts, of a valley with a kink as much of its height.
const SECTIONS: u32 = 40;
/// Sections after which a peak has been reached. One that still grows has no top.
const REACHED: u32 = 20;
/// By how much a peak without a top still grows: by 1.2e2 where it rises as the root of the distance falls.
const GROWS: f64 = 1.5;
/// Next to a place without a top values grow by as much from the first to the second of these distances, in parts of the span; a peak that has one is wider.
const NEXT_TO: [f64; 2] = [1e-10, 1e-12];
/// Brackets that are searched for each figure, the most promising first.
const SEARCHED: usize = 64;
/// Sums of terms below this part of these are rounding, and count as zero.
const CANCELLED: f64 = 1e-10;
/// Cells beyond this many follow the rounding of a speed that vanishes, and none of its peaks.
const MOST_CELLS: usize = 512;
/// Peaks of a speed are looked at on spans with at least this part of the whole way, or turn.
const COUNTS: f64 = 1e-6;
/// Turns below this, in radians, are rounding.
const NO_TURN: f64 = 1e-9;

/// The extremes of a moving body: of its tool the speed, acceleration and jerk, and of the body the angular speed, all by the time that it takes. They are
/// those between joints, where velocities may jump, and right to about 1e-8 of themselves. Infinite is what grows beyond every bound, as an
/// acceleration does where a law goes by a way that turns back.
///
/// ```
/// use cyclide::{MovingBody, Pose, Quat, RationalMotion, TimeLaw, TimedPose, Vec3};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let body = MovingBody::new(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 8.0)])?.into());
/// let found = body.with_law(TimeLaw::Eased, 1.0)?.schedule()?.extremes();
/// assert!((found.speed[1] - 15.0).abs() < 1e-9 && found.angular_speed == [0.0; 2]);
/// assert!((found.acceleration - 8.0 * 10.0 / 3.0_f64.sqrt()).abs() < 1e-9);
/// assert!((found.jerk - 8.0 * 60.0).abs() < 1e-9); // at both ends
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MotionExtremes {
    /// Least and largest speed of the tool.
    pub speed: [f64; 2],
    /// Least and largest angular speed, radians per unit of time.
    pub angular_speed: [f64; 2],
    /// Largest acceleration of the tool.
    pub acceleration: f64,
    /// Largest jerk of the tool.
    pub jerk: f64,
    /// Where the speed of the tool, or the angular speed, is the most times as large as on average over the same span.
    pub peak: Option<SpeedPeak>,
}

/// A place at which a body is fast against the average of the span.
///
/// ```
/// use cyclide::{MovingBody, Pose, Quat, RationalMotion, TimedPose, Vec3};
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

/// What is looked for the largest of.
#[derive(Clone, Copy)]
enum Figure {
    Speed,
    Slowness,
    Turning,
    TurningSlowness,
    Acceleration,
    Jerk,
}

const FIGURES: [Figure; 6] =
    [Figure::Speed, Figure::Slowness, Figure::Turning, Figure::TurningSlowness, Figure::Acceleration, Figure::Jerk];

/// A place that is higher than those beside it.
#[derive(Clone, Copy)]
struct Bracket {
    span: usize,
    at: f64,
    ends: [f64; 2],
    /// The value at the place, and about how high it may be between its neighbours.
    value: f64,
    may_be: f64,
}

impl Schedule<'_> {
    /// The extremes of the body and its tool.
    #[must_use]
    pub fn extremes(&self) -> MotionExtremes {
        let mut brackets: [Vec<Bracket>; 6] = Default::default();
        let mut best = [f64::NEG_INFINITY; 6];
        let spans: Vec<SpanCells> = self.span_cells();
        let whole = [0, 1].map(|k| spans.iter().map(|cells| cells.ways[k]).sum::<f64>());
        let mut peak: Option<(Bracket, SpeedPeak)> = None;
        for cells in &spans {
            let places = cells.places();
            let values: Vec<[f64; 6]> = places.iter().map(|x| self.figures(cells.span, *x)).collect();
            for (k, found) in brackets.iter_mut().enumerate() {
                let column: Vec<f64> = values.iter().map(|v| v[k]).collect();
                best[k] = column.iter().copied().fold(best[k], f64::max);
                found.extend(raised(cells.span, &places, &column));
            }
            for (way, (figure, turning)) in [(Figure::Speed, false), (Figure::Turning, true)].into_iter().enumerate() {
                let limit = COUNTS * whole[way];
                let average = cells.ways[way] / (cells.ends[1] - cells.ends[0]) / self.duration();
                if !(cells.ways[way] > limit && (!turning || whole[way] > NO_TURN)) {
                    continue;
                }
                let of_span = brackets[figure as usize].iter().filter(|b| b.span == cells.span);
                let Some(highest) = of_span.max_by(|a, b| a.value.total_cmp(&b.value)) else { continue };
                let ratio = highest.value / average;
                if peak.is_none_or(|(_, known)| ratio > known.ratio) {
                    peak = Some((*highest, SpeedPeak { span: cells.span, time: 0.0, ratio, turning }));
                }
            }
        }
        for ((figure, found), best) in FIGURES.into_iter().zip(&mut brackets).zip(&mut best) {
            found.sort_by(|a, b| b.may_be.total_cmp(&a.may_be));
            for bracket in found.iter().take(SEARCHED).filter(|b| b.may_be > b.value) {
                if bracket.may_be > *best {
                    *best = best.max(self.highest(figure, *bracket).1);
                }
            }
        }
        let [speed, slowness, turning, turning_slowness, acceleration, jerk] =
            best.map(|value| if value > f64::NEG_INFINITY { value } else { 0.0 });
        MotionExtremes {
            speed: [-slowness + 0.0, speed],
            angular_speed: [-turning_slowness + 0.0, turning],
            acceleration,
            jerk,
            peak: peak.map(|(bracket, peak)| self.refined(bracket, peak)),
        }
    }

    fn refined(&self, bracket: Bracket, peak: SpeedPeak) -> SpeedPeak {
        let (place, value) = self.highest(if peak.turning { Figure::Turning } else { Figure::Speed }, bracket);
        SpeedPeak { time: place * self.duration(), ratio: peak.ratio * (value / bracket.value).max(1.0), ..peak }
    }

    /// The figures at a part of the duration; those that are not known there are below all others.
    fn figures(&self, span: usize, fraction: f64) -> [f64; 6] {
        let jet = self.jet_in_span(span, fraction);
        let [acceleration, jerk] = self.sizes_of_terms(span, fraction);
        let known = |value: f64, terms: f64| match value {
            value if !value.is_finite() || !terms.is_finite() => f64::NEG_INFINITY,
            value if value <= CANCELLED * terms => 0.0,
            value => value,
        };
        let (speed, turning) = (jet.point.speed(), jet.angular_velocity.length());
        let both = known(speed, 0.0).min(known(turning, 0.0)) > f64::NEG_INFINITY;
        let [speed, turning] = [speed, turning].map(|value| if both { value } else { f64::NAN });
        let or_unknown = |value: f64| if value.is_nan() { f64::NEG_INFINITY } else { value };
        let accelerations = [known(jet.point.d2.length(), acceleration), known(jet.point.d3.length(), jerk)];
        [
            or_unknown(speed),
            or_unknown(-speed),
            or_unknown(turning),
            or_unknown(-turning),
            accelerations[0],
            accelerations[1],
        ]
    }

    /// The highest place of a bracket, and how high it is: infinitely, if it still grows where it should have been reached.
    fn highest(&self, figure: Figure, bracket: Bracket) -> (f64, f64) {
        let value = |x: f64| self.figures(bracket.span, x)[figure as usize];
        let mut search = GoldenSection::new(|x| -value(x), bracket.ends);
        let (mut best, mut reached) = ((bracket.at, bracket.value), bracket.value);
        for section in 0..SECTIONS {
            search.section();
            for (place, lowered) in search.inside() {
                if -lowered > best.1 {
                    best = (place, -lowered);
                }
            }
            if section == REACHED {
                reached = best.1;
            }
        }
        let joints = self.timing().joints();
        let [from, to] = [joints[bracket.span], joints[bracket.span + 1]];
        let beside = |step: f64| {
            let step = step * (to - from);
            value((best.0 - step).max(from)).max(value((best.0 + step).min(to)))
        };
        let [near, nearer] = NEXT_TO.map(beside);
        let grows = best.1 > GROWS * reached || (near > 0.0 && nearer > GROWS * near);
        (best.0, if best.1 > 0.0 && grows { f64::INFINITY } else { best.1 })
    }

    fn span_cells(&self) -> Vec<SpanCells> {
        let timing = self.timing();
        let (joints, times) = (timing.joints(), self.motion().times());
        let ends = joints.windows(2).zip(times.windows(2)).enumerate();
        // A law that goes by the way has no time for a span without one.
        ends.filter(|(_, (ends, _))| ends[1] > ends[0])
            .map(|(span, (ends, times))| {
                let end = times[1].next_down().max(times[0]);
                let of_speed = |k: usize| {
                    let mut speed = |t: f64| self.motion().velocities(t.min(end), self.tool())[k].length();
                    quadrature::cells(&mut speed, times[0], times[1])
                };
                let cells = [of_speed(0), of_speed(1)];
                let ways = [0, 1].map(|k| cells[k].iter().map(|cell| cell.integral).sum::<f64>());
                let told = |k: usize| cells[k].len() <= MOST_CELLS && ways[k] > [0.0, NO_TURN][k];
                let own = [0, 1].into_iter().filter(|k| told(*k)).flat_map(|k| &cells[k]).map(|cell| cell.a);
                let mut inner: Vec<f64> = own.chain(timing.cell_starts(times[0], times[1])).collect();
                inner.sort_by(f64::total_cmp);
                inner.dedup_by(|a, b| *a <= *b);
                let mut breaks = vec![ends[0]];
                for time in inner {
                    let fraction = timing.fraction_at(time);
                    if fraction > breaks[breaks.len() - 1] && fraction < ends[1] {
                        breaks.push(fraction);
                    }
                }
                breaks.push(ends[1]);
                SpanCells { span, ends: [ends[0], ends[1]], breaks, ways }
            })
            .collect()
    }

    /// Parts of the duration, rising, between which the body does little else than a polynomial of low degree: the joints among them, and closer
    /// where it is fast.
    ///
    /// ```
    /// use cyclide::{MovingBody, Pose, Quat, RationalMotion, TimedPose, Vec3};
    /// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
    /// let body = MovingBody::new(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 8.0), at(4.0, 9.0)])?.into());
    /// let breaks = body.schedule()?.breaks();
    /// assert!(breaks[0] == 0.0 && breaks.contains(&0.25) && breaks.ends_with(&[1.0]));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        let mut breaks = vec![0.0];
        self.span_cells().into_iter().for_each(|cells| breaks.extend(&cells.breaks[1..]));
        breaks
    }
}

/// A span cut into cells.
struct SpanCells {
    span: usize,
    /// Parts of the duration at its ends.
    ends: [f64; 2],
    /// The same of its cells.
    breaks: Vec<f64>,
    /// The way of the tool, and the turn.
    ways: [f64; 2],
}

impl SpanCells {
    /// The places that are looked at.
    fn places(&self) -> Vec<f64> {
        let part = |k: usize| k as f64 / PARTS as f64;
        let of_cell = |ends: &[f64]| {
            let [a, b] = [ends[0], ends[1]];
            (0..PARTS).map(move |k| a + (b - a) * part(k))
        };
        self.breaks.windows(2).flat_map(of_cell).chain([self.ends[1]]).collect()
    }
}

/// The places of a span that are as high as their neighbours; at its ends there is one of them only.
fn raised<'a>(span: usize, places: &'a [f64], values: &'a [f64]) -> impl Iterator<Item = Bracket> + 'a {
    let last = values.len() - 1;
    (0..=last).filter_map(move |k| {
        let (before, after) = (k.saturating_sub(1), (k + 1).min(last));
        let value = values[k];
        let beside = [values[before], values[after]];
        // A place that is not known may be beside one without bounds.
        if !beside.iter().all(|other| value >= *other) || value <= f64::NEG_INFINITY {
            return None;
        }
        // A parabola goes beyond the middle one of its places by an eighth of their bend at most.
        let may_be = value + (value - beside[0]) + (value - beside[1]);
        Some(Bracket { span, at: places[k], ends: [places[before], places[after]], value, may_be })
    })
}
