//! Time laws: how a body runs along its motion.

use super::any_motion::Motion;
use crate::base::quadrature;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, MotionError, NumberError, Result};
use std::sync::OnceLock;

/// A way, also that of a span, up to this part of what it is measured in is no way: rounding.
const AT_REST: f64 = 1e-12;
/// Turns up to this, in radians, are those of poses that are the same but for the six digits they are written with.
const NO_TURN: f64 = 1e-6;

/// Halvings of half the duration until a place in it is known to rounding.
const BISECTIONS: u32 = 56;

/// How a body runs along its motion in the time from first to last.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{Motion, Pose, RationalMotion, TimeLaw, TimedPose, Timing}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let motion = Motion::from(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 3.0), at(2.0, 4.0)])?);
/// let steady = Timing::new(&motion, TimeLaw::ConstantSpeed, Point3::ORIGIN, 0.0)?;
/// assert!((motion.pose(steady.time_at(0.5)).translation().x - 2.0).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
pub enum TimeLaw {
    /// With the times of the poses.
    #[default]
    AsGiven,
    /// At constant speed.
    ConstantSpeed,
    /// From rest to rest: after the fraction x of the time the body has covered the fraction `10x³ − 15x⁴ + 6x⁵` of the
    /// path, so that velocity and acceleration vanish at both ends.
    Eased,
}

/// A part of a motion over which one quadrature rule gives the way.
#[derive(Debug)]
struct WayCell {
    cell: quadrature::Cell,
    /// The way of the motion up to its end.
    end: f64,
    /// The speeds at its ends.
    speeds: [f64; 2],
}

/// A motion with a time law, measured once: the way is `∫ √(|v|² + a²|ω|²)` with the velocity of a point of the body, the angular
/// velocity, and an arm `a`, the length by which a turn counts.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{Motion, Pose, RationalMotion, TimeLaw, TimedPose, Timing}};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let motion = Motion::from(RationalMotion::spline(&[at(0.0, 0.0), at(2.0, 6.0)])?);
/// let eased = Timing::new(&motion, TimeLaw::Eased, Point3::ORIGIN, 0.0)?;
/// assert!((eased.way() - 6.0).abs() < 1e-12);
/// assert!(motion.pose(eased.time_at(0.1)).translation().x < 0.06); // it starts slowly
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug)]
pub struct Timing<'a> {
    motion: &'a Motion,
    law: TimeLaw,
    point: Point3,
    arm: f64,
    /// Measured when it is asked for first: the times of the poses need no way.
    measured: OnceLock<Measured>,
}

/// The way of a motion.
#[derive(Debug)]
struct Measured {
    /// Parts of the motion over which one quadrature rule gives the way, each with the way up to its end.
    cells: Vec<WayCell>,
    /// The way up to the end of each span.
    ways: Vec<f64>,
    total: f64,
    /// Spans and ways up to this are rounding.
    limit: f64,
    /// Spans without a way.
    at_rest: Vec<usize>,
}

impl<'a> Timing<'a> {
    /// Measures a motion by the way of a point of the body and an arm.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (an arm below 0); for a law that goes by the way `motion-at-rest`, where there is none, and
    /// `span-without-way`, where the body turns on the spot, for which the law has no time.
    pub fn new(motion: &'a Motion, law: TimeLaw, point: Point3, arm: f64) -> Result<Self> {
        if !point.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index: 0 }.into());
        }
        if !(arm >= 0.0 && arm.is_finite()) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Arm, value: arm, min: 0.0, max: f64::MAX }.into()
            );
        }
        let timing = Self { motion, law, point, arm, measured: OnceLock::new() };
        if law != TimeLaw::AsGiven {
            timing.check_ways()?;
        }
        Ok(timing)
    }

    /// Refuses what a law that goes by the way has no time for.
    ///
    /// # Errors
    /// `motion-at-rest`, `span-without-way`.
    fn check_ways(&self) -> Result<()> {
        let Measured { total, limit, at_rest, .. } = self.measured();
        if !(*total > *limit) {
            return Err(
                MotionError::AtRest { length: *total, limit: *limit, still: self.motion.turn() <= NO_TURN }.into()
            );
        }
        for &span in at_rest {
            let ends = &self.motion.times()[span..span + 2];
            let mut turning = in_span(self.motion, span, self.point, |[_, turning]| turning.length());
            let turn = quadrature::integrate(&mut turning, ends[0], ends[1]);
            if turn > NO_TURN {
                let length = quadrature::integrate(&mut self.speed_in_span(span), ends[0], ends[1]);
                return Err(MotionError::SpanWithoutWay { span, turn, length, limit: *limit }.into());
            }
        }
        Ok(())
    }

    /// The way, measured once.
    fn measured(&self) -> &Measured {
        self.measured.get_or_init(|| {
            let places = self.motion.times().iter().map(|t| self.motion.pose(*t).apply(self.point).to_vec().max_abs());
            let limit = AT_REST * places.fold(self.arm, f64::max);
            let (mut cells, mut ways, mut total, mut at_rest) = (Vec::new(), Vec::new(), 0.0, Vec::new());
            for (span, ends) in self.motion.times().windows(2).enumerate() {
                let mut speed = self.speed_in_span(span);
                let of_span = quadrature::cells(&mut speed, ends[0], ends[1]);
                // A span at rest has no way, and a law that goes by the way no time for it.
                if of_span.iter().map(|cell| cell.integral).sum::<f64>() > limit {
                    for cell in of_span {
                        total += cell.integral;
                        let speeds = [speed(cell.a), speed(cell.b)];
                        cells.push(WayCell { cell, end: total, speeds });
                    }
                } else {
                    at_rest.push(span);
                }
                ways.push(total);
            }
            Measured { cells, ways, total, limit, at_rest }
        })
    }

    /// The speed of the way at times in a span.
    fn speed_in_span(&self, span: usize) -> impl FnMut(f64) -> f64 {
        let arm = self.arm;
        in_span(self.motion, span, self.point, move |velocities| way_speed(velocities, arm))
    }

    /// The law.
    pub(super) fn law(&self) -> TimeLaw {
        self.law
    }

    /// The spans without a way.
    pub(super) fn at_rest(&self) -> &[usize] {
        &self.measured().at_rest
    }

    /// Velocity of the point and angular velocity by the way, instead of by time: of a direction only, as long as 1 with the arm.
    pub(super) fn by_way(&self, time: f64) -> [Vec3; 2] {
        let velocities = self.motion.velocities(time, self.point);
        let speed = way_speed(velocities, self.arm);
        velocities.map(|velocity| velocity / speed)
    }

    /// The arm by which turns count.
    pub(super) fn arm(&self) -> f64 {
        self.arm
    }

    /// The way between two times of one span.
    pub(super) fn way_between(&self, from: f64, to: f64) -> f64 {
        let cells = &self.measured().cells;
        let first = cells.partition_point(|part| part.cell.a < from);
        cells[first..].iter().take_while(|part| part.cell.a < to).map(|part| part.cell.integral).sum()
    }

    /// The derivative of the way that is done by the part of the duration, under a law that goes by it.
    pub(super) fn way_by_part(&self, fraction: f64) -> f64 {
        match self.law {
            TimeLaw::Eased => 30.0 * (fraction * (1.0 - fraction)).powi(2) * self.way(),
            _ => self.way(),
        }
    }

    /// The derivative of the motion's time by the part of the duration, at a time of the motion.
    pub(super) fn time_by_part(&self, time: f64) -> f64 {
        let [first, last] = self.motion.domain();
        match self.law {
            TimeLaw::AsGiven => last - first,
            TimeLaw::ConstantSpeed => self.way() / self.way_speed_at(time),
            TimeLaw::Eased => self.way_by_part(self.fraction_at(time)) / self.way_speed_at(time),
        }
    }

    /// How much of the way is done in a unit of the motion's time.
    pub(super) fn way_speed_at(&self, time: f64) -> f64 {
        way_speed(self.motion.velocities(time, self.point), self.arm)
    }

    /// Of each span that has a way the times at which its cells start and its end, with the speeds of the way there.
    pub(super) fn speeds_of_spans(&self) -> Vec<(usize, Vec<(f64, f64)>)> {
        let Measured { cells, at_rest, .. } = self.measured();
        let (mut rest, mut resting) = (cells.as_slice(), at_rest.iter().peekable());
        let spans = self.motion.times().windows(2).enumerate();
        spans
            .filter(|(span, _)| resting.next_if(|index| **index == *span).is_none())
            .map(|(span, ends)| {
                let of_span;
                (of_span, rest) = rest.split_at(rest.partition_point(|part| part.cell.a < ends[1]));
                let starts = of_span.iter().map(|part| (part.cell.a, part.speeds[0]));
                (span, starts.chain(of_span.last().map(|part| (part.cell.b, part.speeds[1]))).collect())
            })
            .collect()
    }

    /// The whole way.
    #[must_use]
    pub fn way(&self) -> f64 {
        self.measured().total
    }

    /// The time of the motion when the part `fraction`, clamped to `[0, 1]`, of the duration is over.
    #[must_use]
    pub fn time_at(&self, fraction: f64) -> f64 {
        let [first, last] = self.motion.domain();
        let x = fraction.clamp(0.0, 1.0);
        // Both ends to the bit.
        if x <= 0.0 {
            return first;
        }
        if x >= 1.0 {
            return last;
        }
        match self.law {
            TimeLaw::AsGiven => first + (last - first) * x,
            TimeLaw::ConstantSpeed => self.time_of_way(x * self.way()),
            TimeLaw::Eased => self.time_of_way(eased(x) * self.way()),
        }
    }

    /// The part of the duration that is over at a time of the motion, clamped to those of it: the inverse of [`time_at`](Self::time_at), but on a span
    /// without a way under a law that goes by the way, which takes no time.
    #[must_use]
    pub fn fraction_at(&self, time: f64) -> f64 {
        let [first, last] = self.motion.domain();
        let time = time.clamp(first, last);
        let done = || {
            let Measured { cells, total, .. } = self.measured();
            let index = cells.partition_point(|part| part.cell.b <= time);
            let Some(WayCell { cell, end, .. }) = cells.get(index) else { return 1.0 };
            let mut speed = |time: f64| self.way_speed_at(time);
            let rest = if time > cell.a { quadrature::gauss8(&mut speed, cell.a, time) } else { 0.0 };
            ((end - cell.integral + rest) / total).clamp(0.0, 1.0)
        };
        match self.law {
            TimeLaw::AsGiven => (time - first) / (last - first),
            TimeLaw::ConstantSpeed => done(),
            TimeLaw::Eased => part_of_eased(done()),
        }
    }

    /// Where in a span with these ends the parts start over which one quadrature rule gives the way.
    pub(super) fn cell_starts(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        let cells = &self.measured().cells;
        let first = cells.partition_point(|part| part.cell.a < from);
        cells[first..].iter().map(|part| part.cell.a).take_while(move |start| *start < to)
    }

    /// The parts of the duration at which the spans of the motion start, and 1: rising, two of them the same where a law goes by the way and a
    /// span has none.
    #[must_use]
    pub fn joints(&self) -> Vec<f64> {
        let [first, last] = self.motion.domain();
        let of_ways = |part: fn(f64) -> f64| {
            let Measured { ways, total, .. } = self.measured();
            ways.iter().map(|way| part(way / total)).collect::<Vec<_>>()
        };
        let mut ends = match self.law {
            TimeLaw::AsGiven => self.motion.times()[1..].iter().map(|t| (t - first) / (last - first)).collect(),
            TimeLaw::ConstantSpeed => of_ways(|part| part),
            TimeLaw::Eased => of_ways(part_of_eased),
        };
        if let Some(end) = ends.last_mut() {
            *end = 1.0;
        }
        ends.insert(0, 0.0);
        ends
    }

    fn time_of_way(&self, goal: f64) -> f64 {
        let cells = &self.measured().cells;
        let index = cells.partition_point(|part| part.end < goal).min(cells.len() - 1);
        let WayCell { cell, end, speeds } = &cells[index];
        let rest = (goal - (end - cell.integral)).clamp(0.0, cell.integral);
        let mut speed = |time: f64| self.way_speed_at(time);
        // The cubic with the speeds at the ends, no steeper than one that rises all along may be.
        let (x, steepest) = (rest / cell.integral, 3.0);
        let slopes = speeds.map(|speed| (cell.integral / (speed * (cell.b - cell.a))).min(steepest));
        let part = x * (1.0 - x) * ((1.0 - x) * slopes[0] - x * slopes[1]) + x * x * (3.0 - 2.0 * x);
        let start = cell.a + (cell.b - cell.a) * part.clamp(0.0, 1.0);
        quadrature::invert_from(&mut speed, [cell.a, cell.b], rest, start)
    }
}

impl Motion {
    /// The angle by which the body turns in all, radians: `∫|ω|`.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::{Motion, Pose, ScrewMotion, TimedPose}};
    /// let turned = |angle: f64| Pose::new(Quat::from_axis_angle(Vec3::Z, angle), Vec3::ZERO).unwrap();
    /// let at = |time: f64, angle: f64| TimedPose { time, pose: turned(angle) };
    /// let motion = Motion::from(ScrewMotion::new(&[at(0.0, 0.0), at(1.0, 2.0), at(1.5, 1.0)])?);
    /// assert!((motion.turn() - 3.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn turn(&self) -> f64 {
        self.integral(Point3::ORIGIN, |[_, turning]| turning.length())
    }

    /// The length of the way of a point of the body: `∫|v|`.
    ///
    /// ```
    /// use cyclide::{Point3, Quat, Vec3, motion::{Motion, Pose, ScrewMotion, TimedPose}};
    /// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
    /// let motion = Motion::from(ScrewMotion::new(&[at(0.0, 0.0), at(0.1, 5.0), at(7.0, 3.0)])?);
    /// assert!((motion.way(Point3::ORIGIN) - 7.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn way(&self, point: Point3) -> f64 {
        self.integral(point, |[velocity, _]| velocity.length())
    }

    /// The integral of a speed over all spans, each by itself: at joints it may jump.
    fn integral(&self, point: Point3, speed: impl Fn([Vec3; 2]) -> f64) -> f64 {
        let spans = self.times().windows(2).enumerate();
        let of_span = |(span, ends): (usize, &[f64])| {
            quadrature::integrate(&mut in_span(self, span, point, &speed), ends[0], ends[1])
        };
        spans.map(of_span).sum()
    }
}

/// A speed, of velocity and angular velocity, as a function of times in a span: at its end as the body arrives there.
fn in_span<'m, S: Fn([Vec3; 2]) -> f64 + 'm>(
    motion: &'m Motion,
    span: usize,
    point: Point3,
    speed: S,
) -> impl FnMut(f64) -> f64 + use<'m, S> {
    move |time| speed(motion.velocities_in_span(span, time, point))
}

/// The part of the way that is done after a part of the time.
fn eased(x: f64) -> f64 {
    x * x * x * (10.0 - x * (15.0 - 6.0 * x))
}

/// The part of the time after which a part of the way is done: the inverse of [`eased`].
fn part_of_eased(done: f64) -> f64 {
    // The law is the same from both ends, and keeps its digits next to 0.
    if done > 0.5 {
        return 1.0 - part_of_eased(1.0 - done);
    }
    let (mut low, mut high) = (0.0, 0.5);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if eased(middle) < done {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The way of a point and of a turn at an arm, by time.
fn way_speed([velocity, turning]: [Vec3; 2], arm: f64) -> f64 {
    velocity.length().hypot(turning.length() * arm)
}
