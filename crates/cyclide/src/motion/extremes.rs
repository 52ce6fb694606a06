//! The extremes of what a moving body does: how fast, and how suddenly.
//!
//! Each span is cut where quadrature of the speed and of the angular speed cuts it, so that a cell is as narrow as what happens in it, and
//! each cell into even parts. A place that is higher than its neighbors is between these, where sections in the golden ratio find it
//! (`docs/math/motions.md#extremes`).

use super::moving_body::Schedule;
use super::span_cells::{SpanCells, in_parts};
use super::speed_peak::SpeedPeak;
use crate::base::golden_section::GoldenSection;

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

/// The extremes of a moving body: of its tool the speed, acceleration and jerk, and of the body the angular speed, all by the time that it takes. They are
/// those between joints, where velocities may jump, and right to about 1e-8 of themselves. Infinite is what grows beyond every bound, as an
/// acceleration does where a law goes by a way that turns back.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimeLaw, TimedPose}};
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
    /// Where the speed is the largest.
    pub speed_at: MotionPlace,
    /// Least and largest angular speed, radians per unit of time.
    pub angular_speed: [f64; 2],
    /// Where the angular speed is the largest.
    pub angular_speed_at: MotionPlace,
    /// Largest acceleration of the tool.
    pub acceleration: f64,
    /// Where.
    pub acceleration_at: MotionPlace,
    /// Largest jerk of the tool.
    pub jerk: f64,
    /// Where.
    pub jerk_at: MotionPlace,
    /// Where the speed of the tool, or the angular speed, is the most times as large as on average over the same span.
    pub peak: Option<SpeedPeak>,
}

/// A place in a motion.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{MovingBody, Pose, RationalMotion, TimedPose}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let body = MovingBody::new(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 4.0)])?.into()); // x = t²
/// let fastest = body.schedule()?.extremes().speed_at;
/// assert!(fastest.span == 1 && (fastest.time - 2.0).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionPlace {
    /// The span, from 0.
    pub span: usize,
    /// The time, from the start of the motion.
    pub time: f64,
}

/// What is looked for the largest of.
#[derive(Clone, Copy)]
pub(super) enum Figure {
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
pub(super) struct Bracket {
    span: usize,
    /// The ends of the span.
    of_span: [f64; 2],
    at: f64,
    ends: [f64; 2],
    /// The value at the place, and about how high it may be between its neighbors.
    value: f64,
    pub(super) may_be: f64,
}

/// The largest value so far, and where it is, as a part of the duration.
#[derive(Clone, Copy)]
struct Best {
    value: f64,
    span: usize,
    at: f64,
}

impl Best {
    const NONE: Self = Self { value: f64::NEG_INFINITY, span: 0, at: 0.0 };

    fn raise(&mut self, value: f64, span: usize, at: f64) {
        if value > self.value {
            *self = Self { value, span, at };
        }
    }
}

impl Schedule<'_> {
    /// The extremes of the body and its tool.
    #[must_use]
    pub fn extremes(&self) -> MotionExtremes {
        let mut brackets: [Vec<Bracket>; 6] = Default::default();
        let mut best = [Best::NONE; 6];
        let spans = self.span_cells();
        for cells in spans {
            let places = in_parts(&self.breaks_of(cells), PARTS);
            let values: Vec<[f64; 6]> = places.iter().map(|x| self.figures(cells.span, *x)).collect();
            for (k, (found, best)) in brackets.iter_mut().zip(&mut best).enumerate() {
                let column: Vec<f64> = values.iter().map(|v| v[k]).collect();
                places.iter().zip(&column).for_each(|(at, value)| best.raise(*value, cells.span, *at));
                found.extend(raised(cells, &places, &column));
            }
        }
        for ((figure, found), best) in FIGURES.into_iter().zip(&mut brackets).zip(&mut best) {
            found.sort_by(|a, b| b.may_be.total_cmp(&a.may_be));
            for bracket in found.iter().take(SEARCHED).filter(|b| b.may_be > b.value) {
                if bracket.may_be > best.value {
                    let (at, value) = self.highest(figure, *bracket);
                    best.raise(value, bracket.span, at);
                }
            }
        }
        // The velocity turns over in no time.
        if let Some(reversal) = self.reversals().iter().find(|reversal| reversal.inside && reversal.velocity_jump > 0.0)
        {
            let at = reversal.time / self.duration();
            best[4..].iter_mut().for_each(|best| best.raise(f64::INFINITY, reversal.span, at));
        }
        let value = |figure: Figure| match best[figure as usize].value {
            value if value > f64::NEG_INFINITY => value,
            _ => 0.0,
        };
        let place = |figure: Figure| {
            let Best { span, at, .. } = best[figure as usize];
            MotionPlace { span, time: at * self.duration() }
        };
        MotionExtremes {
            speed: [-value(Figure::Slowness) + 0.0, value(Figure::Speed)],
            speed_at: place(Figure::Speed),
            angular_speed: [-value(Figure::TurningSlowness) + 0.0, value(Figure::Turning)],
            angular_speed_at: place(Figure::Turning),
            acceleration: value(Figure::Acceleration),
            acceleration_at: place(Figure::Acceleration),
            jerk: value(Figure::Jerk),
            jerk_at: place(Figure::Jerk),
            peak: self.speed_peak(spans),
        }
    }

    /// The figures at a part of the duration; those that are not known there are below all others.
    pub(super) fn figures(&self, span: usize, fraction: f64) -> [f64; 6] {
        let (jet, [acceleration, jerk]) = self.jet_with_terms(span, fraction);
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
    pub(super) fn highest(&self, figure: Figure, bracket: Bracket) -> (f64, f64) {
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
        let [from, to] = bracket.of_span;
        let beside = |step: f64| {
            let step = step * (to - from);
            value((best.0 - step).max(from)).max(value((best.0 + step).min(to)))
        };
        let [near, nearer] = NEXT_TO.map(beside);
        let grows = best.1 > GROWS * reached || (near > 0.0 && nearer > GROWS * near);
        (best.0, if best.1 > 0.0 && grows { f64::INFINITY } else { best.1 })
    }
}

/// The places of a span that are as high as their neighbors; at its ends there is one of them only.
pub(super) fn raised<'a>(
    cells: &'a SpanCells,
    places: &'a [f64],
    values: &'a [f64],
) -> impl Iterator<Item = Bracket> + 'a {
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
        Some(Bracket {
            span: cells.span,
            of_span: cells.ends,
            at: places[k],
            ends: [places[before], places[after]],
            value,
            may_be,
        })
    })
}
