//! Time laws: how a body runs along its motion.

use super::any_motion::Motion;
use crate::base::quadrature;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, Result};

/// A way, also that of a span, up to this part of what it is measured in is no way: rounding.
const AT_REST: f64 = 1e-12;

/// Halvings of half the duration until a place in it is known to rounding.
const BISECTIONS: u32 = 56;

/// How a body runs along its motion in the time from first to last.
///
/// ```
/// use cyclide::{Motion, Point3, Pose, Quat, RationalMotion, TimeLaw, TimedPose, Timing, Vec3};
/// let at = |time: f64, x: f64| TimedPose { time, pose: Pose::new(Quat::ONE, Vec3::X * x).unwrap() };
/// let motion = Motion::from(RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 3.0), at(2.0, 4.0)])?);
/// let steady = Timing::new(&motion, TimeLaw::ConstantSpeed, Point3::ORIGIN, 0.0)?;
/// assert!((motion.pose(steady.time_at(0.5)).translation().x - 2.0).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
pub enum TimeLaw {
    /// By the times of the poses.
    #[default]
    AsGiven,
    /// At constant speed.
    ConstantSpeed,
    /// From rest to rest: the part of the way after the part x of the time is `10x³ − 15x⁴ + 6x⁵`, so that velocity and acceleration
    /// vanish at both ends.
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
/// use cyclide::{Motion, Point3, Pose, Quat, RationalMotion, TimeLaw, TimedPose, Timing, Vec3};
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
    /// Parts of the motion over which one quadrature rule gives the way, each with the way up to its end.
    cells: Vec<WayCell>,
    /// The way up to the end of each span.
    ways: Vec<f64>,
    total: f64,
}

impl<'a> Timing<'a> {
    /// Measures a motion by the way of a point of the body and an arm.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (an arm below 0); `motion-at-rest` for a law that goes by the way, where there is none.
    pub fn new(motion: &'a Motion, law: TimeLaw, point: Point3, arm: f64) -> Result<Self> {
        if !point.is_finite() {
            return Err(Error::NotFinite { what: ErrorItem::Point, index: 0 });
        }
        if !(arm >= 0.0 && arm.is_finite()) {
            return Err(Error::ParameterOutOfRange { name: ErrorItem::Arm, value: arm, min: 0.0, max: f64::MAX });
        }
        let size = motion.times().iter().map(|t| motion.pose(*t).apply(point).to_vec().max_abs()).fold(arm, f64::max);
        let limit = AT_REST * size;
        let (mut cells, mut ways, mut total) = (Vec::new(), Vec::new(), 0.0);
        for ends in motion.times().windows(2) {
            let mut speed = in_span(motion, ends, point, |velocities| way_speed(velocities, arm));
            let of_span = quadrature::cells(&mut speed, ends[0], ends[1]);
            // A span at rest has no way, and a law that goes by the way no time for it.
            if of_span.iter().map(|cell| cell.integral).sum::<f64>() > limit {
                for cell in of_span {
                    total += cell.integral;
                    let speeds = [speed(cell.a), speed(cell.b)];
                    cells.push(WayCell { cell, end: total, speeds });
                }
            }
            ways.push(total);
        }
        if law != TimeLaw::AsGiven && !(total > limit) {
            return Err(Error::MotionAtRest { length: total, limit });
        }
        Ok(Self { motion, law, point, arm, cells, ways, total })
    }

    /// The whole way.
    #[must_use]
    pub fn way(&self) -> f64 {
        self.total
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
            TimeLaw::ConstantSpeed => self.time_of_way(x * self.total),
            TimeLaw::Eased => self.time_of_way(eased(x) * self.total),
        }
    }

    /// The part of the duration that is over at a time of the motion, clamped to those of it: the inverse of [`time_at`](Self::time_at), but on a span
    /// without a way under a law that goes by the way, which takes no time.
    #[must_use]
    pub fn fraction_at(&self, time: f64) -> f64 {
        let [first, last] = self.motion.domain();
        let time = time.clamp(first, last);
        let done = || {
            let index = self.cells.partition_point(|part| part.cell.b <= time);
            let Some(WayCell { cell, end, .. }) = self.cells.get(index) else { return 1.0 };
            let mut speed = |time: f64| way_speed(self.motion.velocities(time, self.point), self.arm);
            let rest = if time > cell.a { quadrature::gauss8(&mut speed, cell.a, time) } else { 0.0 };
            ((end - cell.integral + rest) / self.total).clamp(0.0, 1.0)
        };
        match self.law {
            TimeLaw::AsGiven => (time - first) / (last - first),
            TimeLaw::ConstantSpeed => done(),
            TimeLaw::Eased => part_of_eased(done()),
        }
    }

    /// Where in a span with these ends the parts start over which one quadrature rule gives the way.
    pub(super) fn cell_starts(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        let first = self.cells.partition_point(|part| part.cell.a < from);
        self.cells[first..].iter().map(|part| part.cell.a).take_while(move |start| *start < to)
    }

    /// The parts of the duration at which the spans of the motion start, and 1: rising, two of them the same where a law goes by the way and a
    /// span has none.
    #[must_use]
    pub fn joints(&self) -> Vec<f64> {
        let [first, last] = self.motion.domain();
        let of_ways = |part: fn(f64) -> f64| self.ways.iter().map(|way| part(way / self.total)).collect::<Vec<_>>();
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
        let index = self.cells.partition_point(|part| part.end < goal).min(self.cells.len() - 1);
        let WayCell { cell, end, speeds } = &self.cells[index];
        let rest = (goal - (end - cell.integral)).clamp(0.0, cell.integral);
        let mut speed = |time: f64| way_speed(self.motion.velocities(time, self.point), self.arm);
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
    /// use cyclide::{Motion, Pose, Quat, ScrewMotion, TimedPose, Vec3};
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
    /// use cyclide::{Motion, Point3, Pose, Quat, ScrewMotion, TimedPose, Vec3};
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
        let of_span = |ends: &[f64]| quadrature::integrate(&mut in_span(self, ends, point, &speed), ends[0], ends[1]);
        self.times().windows(2).map(of_span).sum()
    }
}

/// A speed, of velocity and angular velocity, as a function of times in a span with these ends: at its end they are those of the next one.
fn in_span(motion: &Motion, ends: &[f64], point: Point3, speed: impl Fn([Vec3; 2]) -> f64) -> impl FnMut(f64) -> f64 {
    let end = ends[1].next_down().max(ends[0]);
    move |time| speed(motion.velocities(time.min(end), point))
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
