//! Samples of motions: poses at times, and how fast the body is then.

use cyclide::{
    Quat,
    motion::{MovingBody, Pose, Schedule},
};
use serde_json::json;

use super::sampling::{SamplePlaces, fractions, push_field};
use crate::document::BuiltObject;
use crate::text::number::push_plain;

/// The columns: what a table of poses has, and measures that are passed over when it is read.
const COLUMNS: &str =
    "time,x,y,z,qw,qx,qy,qz,m11,m12,m13,m14,m21,m22,m23,m24,m31,m32,m33,m34,speed,angular_speed,acceleration";

/// A rest up to this part of the duration is no step of its own.
const ROUNDING: f64 = 1e-12;

/// The samples of a motion, both ends included.
///
/// ```
/// use cyclide_io::{Document, report::{MotionSamples, SamplePlaces}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let samples = MotionSamples::new(&document.build()?[0], SamplePlaces::Step(0.375)).expect("it is a motion");
/// let times: Vec<f64> = samples.samples.iter().map(|sample| sample.time).collect();
/// assert_eq!(times, [0.0, 0.375, 0.75, 1.0]);
/// assert!(samples.samples[1].speed.is_some_and(|speed| (speed - 30.0).abs() < 1e-9));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MotionSamples {
    /// In the order of time.
    pub samples: Vec<MotionSample>,
}

/// The state of a body at one time.
///
/// ```
/// use cyclide_io::{Document, report::{MotionSamples, SamplePlaces, Spacing}};
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "motion", "poses": [{"position": [0, 0]}, {"position": [30, 0]}]}}}"#.parse()?;
/// let places = SamplePlaces::Count { count: 3, spacing: Spacing::Parameter };
/// let samples = MotionSamples::new(&document.build()?[0], places).expect("it is a motion");
/// assert!((samples.samples[1].pose.translation().x - 15.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MotionSample {
    /// Seconds from the start.
    pub time: f64,
    /// The pose of the body.
    pub pose: Pose,
    /// Its rotation, with the sign closer to that of the previous sample.
    pub rotation: Quat,
    /// Speed of the tool; at a pose, that of the span that starts there. `None` if the law does not define it.
    pub speed: Option<f64>,
    /// Angular speed, radians per second.
    pub angular_speed: Option<f64>,
    /// Acceleration of the tool.
    pub acceleration: Option<f64>,
}

impl MotionSamples {
    /// Samples at equal time steps, by number or by length in seconds, including the end: the last step is shorter unless the duration is a
    /// multiple. `None` for an object that is not a motion.
    #[must_use]
    pub fn new(built: &BuiltObject, places: SamplePlaces) -> Option<Self> {
        Self::of(built.item.motion()?, places)
    }

    /// Those of a body.
    pub(super) fn of(body: &MovingBody, places: SamplePlaces) -> Option<Self> {
        let (schedule, duration) = (body.schedule().ok()?, body.duration());
        let times: Vec<[f64; 2]> = match places {
            SamplePlaces::Count { count, .. } => fractions(count).map(|part| [part, part * duration]).collect(),
            SamplePlaces::Step(step) => {
                let steps = (duration / step * (1.0 - ROUNDING)).ceil().max(1.0) as usize;
                let at = |i: usize| match i as f64 * step {
                    time if i < steps && time < duration => [time / duration, time],
                    _ => [1.0, duration],
                };
                (0..=steps).map(at).collect()
            }
        };
        let mut before = None;
        let samples = times.into_iter().map(|[part, time]| sample(&schedule, part, time, &mut before)).collect();
        Some(Self { samples })
    }

    /// As a table: columns `time,x,y,z,qw,qx,qy,qz`, the first three rows `m11` to `m34` of the matrix of each pose (the fourth is `0 0 0
    /// 1`), and `speed,angular_speed,acceleration`, empty if the law does not define them. It is a table of poses.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut out = format!("{COLUMNS}\n");
        for MotionSample { time, pose, rotation, speed, angular_speed, acceleration } in &self.samples {
            push_plain(&mut out, *time);
            let matrix = pose.to_matrix();
            let pose = pose.translation().to_array().into_iter().chain(rotation.to_array());
            let numbers = pose.chain(matrix[..3].iter().flatten().copied()).map(Some);
            numbers.chain([*speed, *angular_speed, *acceleration]).for_each(|value| push_field(&mut out, value));
            out.push('\n');
        }
        out
    }

    /// As JSON: `poses`, as a document has them (time, position, quaternion), and beside them `matrices`, 4 × 4 by rows, `speeds`,
    /// `angular_speeds` and `accelerations`, `null` if the law does not define them.
    #[must_use]
    pub fn json(&self) -> String {
        let pose = |s: &MotionSample| {
            let position = s.pose.translation().to_array();
            json!({"time": s.time, "position": position, "quaternion": s.rotation.to_array()})
        };
        let column = |of: fn(&MotionSample) -> Option<f64>| self.samples.iter().map(of).collect::<Vec<_>>();
        let text = json!({
            "poses": self.samples.iter().map(pose).collect::<Vec<_>>(),
            "matrices": self.samples.iter().map(|sample| sample.pose.to_matrix()).collect::<Vec<_>>(),
            "speeds": column(|sample| sample.speed),
            "angular_speeds": column(|sample| sample.angular_speed),
            "accelerations": column(|sample| sample.acceleration),
        });
        text.to_string() + "\n"
    }
}

fn sample(schedule: &Schedule<'_>, part: f64, time: f64, before: &mut Option<Quat>) -> MotionSample {
    let (pose, jet) = (schedule.pose(part), schedule.jet(part));
    let rotation = match pose.rotation() {
        rotation if before.is_some_and(|before| before.dot(rotation) < 0.0) => -rotation,
        rotation => rotation,
    };
    *before = Some(rotation);
    let known = |value: f64| Some(value).filter(|value| value.is_finite());
    let [speed, angular_speed] = [jet.point.speed(), jet.angular_velocity.length()].map(known);
    MotionSample { time, pose, rotation, speed, angular_speed, acceleration: known(jet.point.d2.length()) }
}
