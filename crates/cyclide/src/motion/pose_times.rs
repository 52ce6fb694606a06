//! Times for poses that have none: one after the other, or by how far the body has to go, as the parameters of curves through points are chosen.

use super::pose::Pose;
use super::timed_pose::TimedPose;
use crate::base::vector::Point3;
use crate::error::{ErrorItem, MotionError, NumberError, Result};

/// Chords up to this part of the coordinates are rounding.
const NO_CHORD: f64 = 1e-12;

/// How poses without times follow each other. The average step is one unit of time.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::{Pose, PoseTimes}};
/// let poses = [0.0, 1.0, 10.0].map(|x| Pose::new(Quat::ONE, Vec3::X * x).unwrap());
/// let times = |rule: PoseTimes| rule.of(&poses, Point3::ORIGIN, 0.0).map(|timed| timed.into_iter().map(|pose| pose.time).collect::<Vec<_>>());
/// assert_eq!(times(PoseTimes::Uniform)?, [0.0, 1.0, 2.0]);
/// assert_eq!(times(PoseTimes::Chord)?, [0.0, 0.2, 2.0]);
/// assert_eq!(times(PoseTimes::Centripetal)?, [0.0, 0.5, 2.0]); // 1 to 3, the roots
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
pub enum PoseTimes {
    /// 0, 1, 2, ….
    #[default]
    Uniform,
    /// In proportion to the length from pose to pose: the straight distance of the tool, with rotation weighted by
    /// `arm`. A motion through uneven poses is then about equally fast everywhere.
    Chord,
    /// In proportion to the square root of that length.
    Centripetal,
}

impl PoseTimes {
    /// The poses with times, by the way of a point of the body and an arm at which turns count beside it.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (an arm below 0); `span-without-way` of two poses between which the point stays where it is, but for
    /// uniform times.
    pub fn of(self, poses: &[Pose], point: Point3, arm: f64) -> Result<Vec<TimedPose>> {
        if !point.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index: 0 }.into());
        }
        if !(arm >= 0.0 && arm.is_finite()) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Arm, value: arm, min: 0.0, max: f64::MAX }.into()
            );
        }
        let steps = self.steps(poses, point, arm)?;
        let scale = steps.len() as f64 / steps.iter().sum::<f64>();
        let mut done = 0.0;
        let times = steps.iter().map(|step| {
            done += step;
            done * scale
        });
        let times: Vec<f64> = [0.0].into_iter().chain(times).collect();
        let last = steps.len();
        // The last one to the bit.
        let timed = poses.iter().enumerate().map(|(i, pose)| {
            let time = if i == last { last as f64 } else { times[i] };
            TimedPose { time, pose: *pose }
        });
        Ok(timed.collect())
    }

    fn steps(self, poses: &[Pose], point: Point3, arm: f64) -> Result<Vec<f64>> {
        let size = poses.iter().map(|pose| pose.apply(point).to_vec().max_abs()).fold(arm, f64::max);
        let limit = NO_CHORD * size;
        let step = |(span, pair): (usize, &[Pose])| {
            let turn = pair[0].angle_to(pair[1]);
            let length = pair[0].apply(point).distance(pair[1].apply(point)).hypot(arm * turn);
            match self {
                Self::Uniform => Ok(1.0),
                _ if !(length > limit) => Err(MotionError::SpanWithoutWay { span, turn, length, limit }.into()),
                Self::Chord => Ok(length),
                Self::Centripetal => Ok(length.sqrt()),
            }
        };
        poses.windows(2).enumerate().map(step).collect()
    }
}
