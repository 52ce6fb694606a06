//! Time laws: how a body runs along its motion.

use super::any_motion::Motion;
use super::motion_jet::MotionJet;
use crate::base::quadrature;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, Result};

/// A way up to this part of what it is measured in is no way: rounding.
const AT_REST: f64 = 1e-12;

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
    cells: Vec<(quadrature::Cell, f64)>,
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
        let (mut cells, mut total) = (Vec::new(), 0.0);
        for ends in motion.times().windows(2) {
            // Inside the span: at its end a jet is that of the next one.
            let end = ends[1].next_down().max(ends[0]);
            let mut speed = |time: f64| way_speed(&motion.jet(time.min(end), point), arm);
            for cell in quadrature::cells(&mut speed, ends[0], ends[1]) {
                total += cell.integral;
                cells.push((cell, total));
            }
        }
        let size = motion.times().iter().map(|t| motion.pose(*t).apply(point).to_vec().max_abs()).fold(arm, f64::max);
        let limit = AT_REST * size;
        if law != TimeLaw::AsGiven && !(total > limit) {
            return Err(Error::MotionAtRest { length: total, limit });
        }
        Ok(Self { motion, law, point, arm, cells, total })
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
            TimeLaw::Eased => self.time_of_way(x * x * x * (10.0 - x * (15.0 - 6.0 * x)) * self.total),
        }
    }

    fn time_of_way(&self, goal: f64) -> f64 {
        let index = self.cells.partition_point(|(_, end)| *end < goal).min(self.cells.len() - 1);
        let (cell, end) = &self.cells[index];
        let rest = (goal - (end - cell.integral)).clamp(0.0, cell.integral);
        let mut speed = |time: f64| way_speed(&self.motion.jet(time, self.point), self.arm);
        quadrature::invert(&mut speed, [cell.a, cell.b], cell.integral, rest)
    }
}

/// The way of a point and of a turn at an arm, by time.
fn way_speed(jet: &MotionJet, arm: f64) -> f64 {
    jet.point.d1.length().hypot(jet.angular_velocity.length() * arm)
}
