//! Straight from pose to pose: what controllers of robots call a linear move.
//!
//! The origin goes straight, in proportion to the time, and the body turns about one axis at constant speed (K. Shoemake, *Animating rotation with
//! quaternion curves*, SIGGRAPH 1985). With a blend radius it leaves the line before a pose and takes the next one after it on a parabola, at constant
//! acceleration (R. P. Paul, *Robot Manipulators*, 1981, chapter 5).

use super::span::{PlaceSpan, TurnSpan, rotation_vector};
use super::turns::smooth_turns;
use super::{DecoupledMotion, Given};
use crate::base::bernstein;
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::error::{ErrorItem, NumberError, Result};
use crate::motion::timed_pose::TimedPose;
use crate::warning::{MotionWarning, Warning};

/// Parts of a span up to this are none: two blends meet.
const NO_PART: f64 = 1e-9;

/// Blends that do not fit between the poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShortBlends {
    /// The pose where the blend is the shortest.
    pose: usize,
    count: usize,
    radius: f64,
    asked: f64,
}

impl ShortBlends {
    pub(super) fn warning(self) -> Warning {
        let Self { pose, count, radius, asked } = self;
        Warning::Motion(MotionWarning::BlendsShortened { pose, count, radius, asked })
    }
}

impl DecoupledMotion {
    /// Straight from pose to pose at rising times, turned by slerp, the shorter way round; at half a turn the sign of the second rotation decides.
    /// `closing` is the time at which a closed motion is back at its first pose, which is not repeated. With a `blend` radius above 0 it does not stop at the
    /// poses between but passes them within the radius, C1; at the first pose of a closed motion likewise. Blends take half of a span at most.
    ///
    /// # Errors
    /// `wrong-pose-count`, `not-finite`, `parameters-not-increasing`, `parameter-out-of-range` (a coordinate, or the radius).
    pub fn linear(poses: &[TimedPose], closing: Option<f64>, blend: f64) -> Result<Self> {
        if !(blend >= 0.0 && blend.is_finite()) {
            let (value, min, max) = (blend, 0.0, f64::MAX);
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Radius, value, min, max }.into());
        }
        let given = Given::new(poses, closing)?;
        if blend > 0.0 {
            return Ok(blended(given, blend));
        }
        let places = (0..given.spans()).map(|i| given.line(i)).collect();
        let turns = (0..given.spans()).map(|i| TurnSpan::slerp([given.rotations[i], given.rotations[i + 1]])).collect();
        Ok(given.into_motion(places, turns))
    }

    /// Straight from pose to pose as [`linear`](Self::linear), and turned on a C1 spline of rotations that runs beyond no pose.
    ///
    /// # Errors
    /// As [`linear`](Self::linear).
    pub fn polyline(poses: &[TimedPose], closing: Option<f64>) -> Result<Self> {
        let given = Given::new(poses, closing)?;
        let places = (0..given.spans()).map(|i| given.line(i)).collect();
        let turns = smooth_turns(&given);
        Ok(given.into_motion(places, turns))
    }
}

/// The spans of a motion with blends.
#[derive(Default)]
struct Parts {
    times: Vec<f64>,
    places: Vec<PlaceSpan>,
    turns: Vec<TurnSpan>,
}

impl Parts {
    fn push(&mut self, end: f64, (place, turn): (PlaceSpan, TurnSpan)) {
        self.times.push(end);
        self.places.push(place);
        self.turns.push(turn);
    }
}

fn blended(given: Given, blend: f64) -> DecoupledMotion {
    let last = given.spans();
    let lines: Vec<Line> = (0..last).map(|i| Line::new(&given, i)).collect();
    // Half of the time that the blend at each pose takes.
    let mut windows = vec![0.0; last + 1];
    let mut short: Option<ShortBlends> = None;
    for (pose, window) in windows.iter_mut().enumerate() {
        let (before, after) = match pose {
            _ if pose > 0 && pose < last => (pose - 1, pose),
            _ if given.closed => (last - 1, 0),
            _ => continue,
        };
        let [before, after] = [before, after].map(|i| &lines[i]);
        let speed = before.velocity.length().max(after.velocity.length());
        if !(speed > 0.0) {
            continue;
        }
        let longest = 0.5 * before.duration.min(after.duration);
        *window = (blend / speed).min(longest);
        // The first pose of a closed motion is the last one, too.
        if blend / speed > longest && pose < last {
            let radius = longest * speed;
            let count = short.map_or(0, |found| found.count) + 1;
            let most = short.filter(|found| found.radius <= radius);
            let most = most.unwrap_or(ShortBlends { pose, count, radius, asked: blend });
            short = Some(ShortBlends { count, ..most });
        }
    }
    let mut parts = Parts { times: vec![given.times[0]], ..Parts::default() };
    if given.closed && windows[0] > 0.0 {
        let [_, second] = halves(&lines[last - 1], &lines[0], windows[0], given.places[0]);
        parts.push(given.times[0] + windows[0], second);
    }
    for (i, line) in lines.iter().enumerate() {
        let [from, to] = [windows[i], line.duration - windows[i + 1]];
        let end = given.times[i + 1];
        if to - from > NO_PART * line.duration {
            let time = if windows[i + 1] > 0.0 { given.times[i] + to } else { end };
            parts.push(time, line.part([from, to]));
        }
        if windows[i + 1] > 0.0 {
            let next = &lines[(i + 1) % last];
            let [first, second] = halves(line, next, windows[i + 1], given.places[i + 1]);
            parts.push(end, first);
            if i + 1 < last {
                parts.push(end + windows[i + 1], second);
            }
        }
    }
    let motion = given.into_motion(parts.places, parts.turns);
    DecoupledMotion { times: parts.times, short_blends: short, ..motion }
}

/// The way from a pose to the next without blends.
struct Line {
    duration: f64,
    ends: [Vec3; 2],
    velocity: Vec3,
    rotations: [Quat; 2],
    /// Angular velocity.
    turning: Vec3,
}

impl Line {
    fn new(given: &Given, i: usize) -> Self {
        let duration = given.step(i);
        let ends = [given.places[i], given.places[i + 1]];
        let rotations = [given.rotations[i], given.rotations[i + 1]];
        let [velocity, turning] = [ends[1] - ends[0], rotation_vector(rotations)].map(|v| v / duration);
        Self { duration, ends, velocity, rotations, turning }
    }

    fn rotation(&self, time: f64) -> Quat {
        TurnSpan::slerp(self.rotations).rotation(time / self.duration)
    }

    /// Between two times from its start.
    fn part(&self, times: [f64; 2]) -> (PlaceSpan, TurnSpan) {
        let place = |time: f64| self.ends[0] + (self.ends[1] - self.ends[0]) * (time / self.duration);
        (PlaceSpan::line(times.map(place)), TurnSpan::slerp(times.map(|time| self.rotation(time))))
    }
}

/// The blend from one line to the next, about the pose between them, in two halves of that time each: before and after the time of the pose.
fn halves(before: &Line, after: &Line, window: f64, pose: Vec3) -> [(PlaceSpan, TurnSpan); 2] {
    let parabola = [pose - before.velocity * window, pose, pose + after.velocity * window].map(Vec3::to_array);
    let (first, second) = bernstein::split(&parabola, 0.5);
    let mut rotations = [before.rotation(before.duration - window), after.rotation(window)];
    // The closing pose of a closed motion may be on the other side.
    if rotations[0].dot(rotations[1]) < 0.0 {
        rotations[1] = -rotations[1];
    }
    let turns = match TurnSpan::hermite(rotations, [before.turning, after.turning].map(|v| v * (2.0 * window))) {
        TurnSpan::Cubic(points) => {
            let (first, second) = bernstein::split(&points, 0.5);
            [first, second].map(|half| TurnSpan::Cubic(std::array::from_fn(|k| half[k])))
        }
        turn @ TurnSpan::Slerp { .. } => [turn.clone(), turn],
    };
    let [one, two] = turns;
    [(PlaceSpan::Polynomial(first), one), (PlaceSpan::Polynomial(second), two)]
}
