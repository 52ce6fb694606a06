//! How far a motion leaves the straight lines between its poses.

use super::any_motion::Motion;
use super::leaves_chords::distance_to_segment;
use super::rational_motion::RationalMotion;
use crate::base::bernstein;
use crate::base::golden_section::GoldenSection;
use crate::base::vector::Vec3;
use crate::rational::RationalBezier;

/// Even parts of a span that are looked at.
const PARTS: usize = 16;
/// Places that may be farthest are searched for between their neighbors, so many at most.
const SEARCHED: usize = 1024;
/// Sections of a bracket: 1e-8 of it, of which a smooth peak knows nothing.
const SECTIONS: u32 = 40;
/// Parts of a rational path that can be farther than the farthest place by no more than this part of its distance are done with.
const CLOSE: f64 = 1e-8;
/// Halvings of a span of a rational motion: its parts are then next to roundings of the time.
const HALVINGS: u32 = 48;
/// Parts that are looked at, for each span and besides: on a path round a pose all places are as far.
const LOOKED_AT: [usize; 2] = [64, 100_000];
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
    ///
    /// On a rational motion no peak is missed, however narrow: the hulls of its path bound it. Others are searched between even places.
    #[must_use]
    pub fn off_chords(&self) -> Option<OffChords> {
        let times = self.pose_times();
        let points = self.pose_places();
        if times.len() < 2 || points.len() != times.len() {
            return None;
        }
        let size = points.iter().map(|point| point.max_abs()).fold(0.0, f64::max);
        let chords = Chords::new(points, size);
        let found = match self {
            Self::Rational(motion) => motion.farthest(&chords),
            Self::Screw(_) | Self::Decoupled(_) => self.farthest_sampled(&chords),
        };
        if found.distance <= NO_DISTANCE * size {
            return Some(OffChords { distance: 0.0, time: times[0] });
        }
        Some(found)
    }

    /// The farthest place next to the farthest of even ones. Between its joints a motion is smooth: a blend, however short, has its own.
    fn farthest_sampled(&self, chords: &Chords) -> OffChords {
        let times = self.pose_times();
        let distance = |span: usize, time: f64| chords.distance(span, self.pose(time).translation());
        let mut found = OffChords { distance: 0.0, time: times[0] };
        let mut brackets: Vec<(f64, usize, [f64; 2])> = Vec::new();
        let joints = self.times();
        for (span, ends) in times.windows(2).enumerate() {
            let inside = joints[joints.partition_point(|joint| *joint <= ends[0])..].iter();
            let inside = inside.copied().take_while(|joint| *joint < ends[1]);
            let cuts: Vec<f64> = std::iter::once(ends[0]).chain(inside).chain([ends[1]]).collect();
            for ends in cuts.windows(2) {
                let place = |k: usize| ends[0] + (ends[1] - ends[0]) * (k as f64 / PARTS as f64);
                // At the ends the joint belongs to the span that starts there: the place is the same.
                let values: Vec<f64> = (0..=PARTS).map(|k| distance(span, place(k))).collect();
                for (k, value) in values.iter().enumerate() {
                    found.raise(*value, place(k));
                    let (before, after) = (k.saturating_sub(1), (k + 1).min(PARTS));
                    if *value > 0.0 && *value >= values[before] && *value >= values[after] {
                        let may_be = 2.0 * value - values[before].min(values[after]);
                        brackets.push((may_be, span, [place(before), place(after)]));
                    }
                }
            }
        }
        brackets.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (may_be, span, ends) in brackets.into_iter().take(SEARCHED) {
            if may_be <= found.distance {
                break;
            }
            let time = GoldenSection::lowest(|time| -distance(span, time), ends, SECTIONS);
            found.raise(distance(span, time), time);
        }
        found
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

/// The straight lines between poses, by the places of these.
struct Chords {
    points: Vec<Vec3>,
    /// The first line comes after the last one where the motion comes back: which pose it starts with is of no matter.
    is_back: bool,
}

impl Chords {
    fn new(points: Vec<Vec3>, size: f64) -> Self {
        let spans = points.len() - 1;
        let is_back = spans > 1 && (points[spans] - points[0]).length() <= NO_DISTANCE * size;
        Self { points, is_back }
    }

    /// The line between the poses at the ends of a span, and those beside it.
    fn near(&self, span: usize) -> impl Iterator<Item = [Vec3; 2]> + '_ {
        let spans = self.points.len() - 1;
        let beside = [span.checked_sub(1), Some(span), (span + 1 < spans).then_some(span + 1)];
        let around = self.is_back.then(|| [(span + spans - 1) % spans, (span + 1) % spans]);
        let numbers = beside.into_iter().flatten().chain(around.into_iter().flatten());
        numbers.map(|k| [self.points[k], self.points[k + 1]])
    }

    /// How far a place on a span is from the nearest of its lines.
    fn distance(&self, span: usize, place: Vec3) -> f64 {
        self.near(span).map(|chord| distance_to_segment(place, chord)).fold(f64::INFINITY, f64::min)
    }

    /// No place in the hull of some is farther: the distance from a line is convex, so that the farthest one is a corner.
    fn bound(&self, span: usize, hull: &[Vec3]) -> f64 {
        let farthest = |chord| hull.iter().map(|place| distance_to_segment(*place, chord)).fold(0.0, f64::max);
        self.near(span).map(farthest).fold(f64::INFINITY, f64::min)
    }
}

/// A part of the path of the origin, between two times on one span between poses.
struct Part {
    span: usize,
    times: [f64; 2],
    /// The homogeneous Bézier points, from the center of the motion.
    rows: Vec<[f64; 4]>,
}

impl Part {
    fn bound(&self, chords: &Chords, centre: Vec3) -> f64 {
        // Without positive weights the path need not be in the hull of its points.
        if !self.rows.iter().all(|row| row[3] > 0.0) {
            return f64::INFINITY;
        }
        let hull: Vec<Vec3> = self.rows.iter().map(|row| place_of(row) + centre).collect();
        chords.bound(self.span, &hull)
    }
}

fn place_of([x, y, z, w]: &[f64; 4]) -> Vec3 {
    Vec3::new(x / w, y / w, z / w)
}

impl RationalMotion {
    /// The place that is farthest from the straight lines between the poses, by halving what may hold a farther one.
    fn farthest(&self, chords: &Chords) -> OffChords {
        let mut parts = self.parts_between_poses();
        let mut left = LOOKED_AT[0] * parts.len() + LOOKED_AT[1];
        let start = self.times()[0];
        let mut best = (OffChords { distance: 0.0, time: start }, 0, [start; 2]);
        for _ in 0..HALVINGS {
            for part in &parts {
                let place = place_of(&bernstein::eval(&part.rows, 0.5)) + self.centre();
                let distance = chords.distance(part.span, place);
                if distance > best.0.distance {
                    let time = 0.5 * (part.times[0] + part.times[1]);
                    best = (OffChords { distance, time }, part.span, part.times);
                }
            }
            let most = best.0.distance * (1.0 + CLOSE);
            parts.retain(|part| part.bound(chords, self.centre()) > most);
            let halved = 2 * parts.len();
            if parts.is_empty() || halved > left {
                break;
            }
            left -= halved;
            parts = parts.iter().flat_map(halves).collect();
        }
        let (mut found, span, ends) = best;
        let distance = |time: f64| chords.distance(span, self.pose(time).translation());
        found.distance = distance(found.time);
        let time = GoldenSection::lowest(|time| -distance(time), ends, SECTIONS);
        found.raise(distance(time), time);
        found
    }

    /// The path of the origin, cut at joints and poses.
    fn parts_between_poses(&self) -> Vec<Part> {
        let poses = self.pose_times();
        let mut span = 0;
        let mut parts = Vec::new();
        let paths = self.homogeneous_paths_about_centre([0.0, 0.0, 0.0, 1.0]);
        for (path, ends) in paths.zip(self.times().windows(2)) {
            let [from, to] = [ends[0], ends[1]];
            let rows = RationalBezier::from_polynomial_row(&path).rows().to_vec();
            let mut start = from;
            while start < to {
                while span + 2 < poses.len() && poses[span + 1] <= start {
                    span += 1;
                }
                let end = if span + 2 < poses.len() { poses[span + 1].min(to) } else { to };
                let mut own = rows.clone();
                bernstein::restrict(&mut own, [start, end].map(|time| ((time - from) / (to - from)).clamp(0.0, 1.0)));
                parts.push(Part { span, times: [start, end], rows: own });
                start = end;
            }
        }
        parts
    }
}

fn halves(part: &Part) -> [Part; 2] {
    let [from, to] = part.times;
    let middle = 0.5 * (from + to);
    let (left, right) = bernstein::split(&part.rows, 0.5);
    [([from, middle], left), ([middle, to], right)].map(|(times, rows)| Part { span: part.span, times, rows })
}
