//! Where the turns of a spline carry the origin of the body away from the straight lines between its poses.
//!
//! Between two poses that differ by a turn the origin of a spline runs on an arc about the axis of the turn, however straight its poses lie: half a turn
//! over a distance is a half circle. The circles through three places each say how far from the chords they lead by themselves.

use super::rational_motion::MotionSpan;
use super::swings::{Ground, place};
use crate::base::vector::Vec3;
use crate::warning::{MotionWarning, Warning};

/// It is reported of spans that are left by more than this part of the longest chord beside them,
const LEAVES: f64 = 0.05;
/// besides so many times what the circles through the places beside leave them by,
const BY_PLACES: f64 = 2.0;
/// and by more than this part of the extent of all poses: beside it a short chord counts for nothing.
const LEAST: f64 = 1e-3;
/// Even parts of a span that are looked at.
const PARTS: u32 = 16;

/// Spans over which turns carry the origin away from the chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LeavesChords {
    /// The span where it is most so, by the length of its chord.
    span: usize,
    count: usize,
    distance: f64,
    chord: f64,
}

impl LeavesChords {
    /// Those of the spans of a spline; `closed` if the last span leads to the first.
    pub(super) fn of(spans: &[MotionSpan], closed: bool, ground: Ground) -> Option<Self> {
        let start = |span: &MotionSpan| place(span, ground.unit, 0.0);
        let ends = spans.last().map(|last| place(last, ground.unit, 1.0));
        let points: Vec<Vec3> = spans.iter().map(start).chain(ends).collect();
        let chord = |i: usize| points.get(i + 1).map_or(0.0, |next| (*next - points[i]).length());
        let last = spans.len();
        let extent = points.iter().map(|point| (*point - points[0]).length()).fold(0.0, f64::max);
        let at = |i: isize| match (usize::try_from(i), closed) {
            (Ok(i), _) if i <= last => Some(points[i]),
            (_, true) => points.get(i.rem_euclid(last as isize) as usize).copied(),
            _ => None,
        };
        let mut found: Option<Self> = None;
        for (i, span) in spans.iter().enumerate() {
            let [a, b] = [points[i], points[i + 1]];
            let farthest = |at: &dyn Fn(f64) -> Vec3| {
                let places = (1..PARTS).map(|k| at(f64::from(k) / f64::from(PARTS)));
                places.map(|p| distance_to_segment(p, [a, b])).fold(0.0, f64::max)
            };
            let distance = farthest(&|s| place(span, ground.unit, s));
            let beside = if closed { [(i + last - 1) % last, (i + 1) % last] } else { [i.saturating_sub(1), i + 1] };
            let longest = beside.into_iter().map(chord).fold(chord(i), f64::max);
            // Beside a short chord places swing, which is looked at elsewhere.
            if chord(i) < LEAVES * longest || !(distance > (LEAVES * longest).max(LEAST * extent)) {
                continue;
            }
            let [before, after] = [-1, 2].map(|by| at(i as isize + by));
            let by_places = [before, after].into_iter().flatten().map(|third| rise([a, b], third)).fold(0.0, f64::max);
            if distance > LEAVES * longest + BY_PLACES * by_places {
                let count = found.map_or(0, |found| found.count) + 1;
                let own = Self { span: i, count, distance, chord: chord(i) };
                let most = found.filter(|found| found.distance >= distance).unwrap_or(own);
                found = Some(Self { count, ..most });
            }
        }
        found
    }

    pub(super) fn warning(self) -> Warning {
        let Self { span, count, distance, chord } = self;
        Warning::Motion(MotionWarning::LeavesChords { span, count, distance, chord, limit: LEAVES })
    }
}

/// How far the circle through both ends of a chord and a third point rises above the chord.
fn rise([a, b]: [Vec3; 2], third: Vec3) -> f64 {
    let [chord, to_a, to_b] = [b - a, a - third, b - third];
    let product = to_a.length() * to_b.length();
    // Half the arc over the chord has the sine of the angle at the third point.
    let sine = if product > 0.0 { (to_a.cross(to_b).length() / product).min(1.0) } else { 0.0 };
    0.5 * chord.length() * (0.5 * sine.asin()).tan()
}

/// How far a place is from the straight line between two others.
pub(super) fn distance_to_segment(p: Vec3, [a, b]: [Vec3; 2]) -> f64 {
    let chord = b - a;
    let squared = chord.dot(chord);
    let part = if squared > 0.0 { ((p - a).dot(chord) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p - a - chord * part).length()
}
