//! How far a motion leaves the straight lines between its poses.

use super::any_motion::Motion;
use super::leaves_chords::distance_to_segment;
use crate::base::golden_section::GoldenSection;
use crate::base::vector::Vec3;

/// Even parts of a span that are looked at.
const PARTS: usize = 16;
/// The places that may be farthest, which are searched for between their neighbors.
const SEARCHED: usize = 16;
/// Sections of a bracket: 1e-8 of it, of which a smooth peak knows nothing.
const SECTIONS: u32 = 40;
/// Distances up to so many roundings of the coordinates are none.
const NO_DISTANCE: f64 = 64.0 * f64::EPSILON;

/// The largest distance of the origin of a moving body from the straight lines between its poses.
///
/// ```
/// use cyclide::{Quat, Vec3, motion::{Motion, Pose, RationalMotion, TimedPose}};
/// let at = |time: f64, x: f64, turn: f64| TimedPose {
///     time,
///     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, turn), Vec3::X * x).unwrap(),
/// };
/// let half_turn = Motion::from(RationalMotion::spline(&[at(0.0, 0.0, 0.0), at(1.0, 10.0, 3.0)])?);
/// let off = half_turn.off_chords().unwrap();
/// assert!((off.time - 0.5).abs() < 1e-6 && (off.distance - 5.0 * (0.75_f64).tan()).abs() < 1e-9); // the arc of a circle
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OffChords {
    /// The distance.
    pub distance: f64,
    /// The time of the motion at which it is farthest.
    pub time: f64,
}

impl Motion {
    /// How far, and when, the origin of the body is farthest from the straight lines between its poses: from the nearest one of that between the pose
    /// before and the pose after, and those beside it, which are the last and the first one too where the motion comes back. `None` of a motion along a curve, which has no poses.
    #[must_use]
    pub fn off_chords(&self) -> Option<OffChords> {
        let times = self.pose_times();
        let points = self.pose_places();
        if times.len() < 2 || points.len() != times.len() {
            return None;
        }
        let size = points.iter().map(|point| point.max_abs()).fold(0.0, f64::max);
        let spans = points.len() - 1;
        // The first chord comes after the last one where the motion comes back: which pose it starts with is of no matter.
        let is_back = spans > 1 && (points[spans] - points[0]).length() <= NO_DISTANCE * size;
        let distance = |span: usize, time: f64| {
            let place = self.pose(time).translation();
            let beside = [span.checked_sub(1), Some(span), (span + 1 < spans).then_some(span + 1)];
            let around = is_back.then(|| [(span + spans - 1) % spans, (span + 1) % spans]);
            let chords = beside.into_iter().flatten().chain(around.into_iter().flatten());
            chords.map(|k| distance_to_segment(place, [points[k], points[k + 1]])).fold(f64::INFINITY, f64::min)
        };
        let mut found = OffChords { distance: 0.0, time: times[0] };
        let mut brackets: Vec<(f64, usize, [f64; 2])> = Vec::new();
        for (span, ends) in times.windows(2).enumerate() {
            let place = |k: usize| ends[0] + (ends[1] - ends[0]) * (k as f64 / PARTS as f64);
            // At the ends the joint belongs to the span that starts there: the place is the same.
            let values: Vec<f64> = (0..=PARTS).map(|k| distance(span, place(k))).collect();
            for (k, value) in values.iter().enumerate() {
                found.raise(*value, place(k));
                let (before, after) = (k.saturating_sub(1), (k + 1).min(PARTS));
                if *value > 0.0 && *value >= values[before] && *value >= values[after] {
                    brackets.push((
                        2.0 * value - values[before].min(values[after]),
                        span,
                        [place(before), place(after)],
                    ));
                }
            }
        }
        brackets.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (may_be, span, ends) in brackets.into_iter().take(SEARCHED) {
            if may_be > found.distance {
                let time = GoldenSection::lowest(|time| -distance(span, time), ends, SECTIONS);
                found.raise(distance(span, time), time);
            }
        }
        if found.distance <= NO_DISTANCE * size {
            return Some(OffChords { distance: 0.0, time: times[0] });
        }
        Some(found)
    }

    /// Where the origin of the body is in the poses that it was made through.
    fn pose_places(&self) -> Vec<Vec3> {
        if let Self::Decoupled(motion) = self {
            return motion.pose_places().to_vec();
        }
        self.pose_times().iter().map(|time| self.pose(*time).translation()).collect()
    }
}

impl OffChords {
    fn raise(&mut self, distance: f64, time: f64) {
        if distance > self.distance {
            *self = Self { distance, time };
        }
    }
}
