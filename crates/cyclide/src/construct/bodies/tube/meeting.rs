//! Whether a tube runs into itself: balls along it, looked up by cubes as wide as the balls of a size are, so that time is linear in
//! their number (`docs/math/tubes.md#meeting`).

use super::ball::Ball;
use super::ball_arc::{BallArc, Station};
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, Result};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Balls along a tube, at most.
const MOST_BALLS: f64 = 2e5;
/// Tubes may touch: distances that are short of the sum of radii by less than this part do.
const TOUCHING: f64 = 1e-6;

/// The arcs of a tube, and what becomes of its ends.
pub(super) struct Course<'a> {
    pub(super) arcs: &'a [BallArc],
    pub(super) closed: bool,
    /// The ends are the rest of the balls there; else the tube ends with the circles of contact.
    pub(super) round: bool,
}

/// A ball on a tube, with the way of the centre before it.
#[derive(Clone, Copy)]
struct Place {
    ball: Ball,
    way: f64,
    tube: usize,
    source: usize,
    section: Section,
    /// So near to an end that is not round that the tube has the section only, not the whole ball.
    cut: bool,
}

/// The disk in which a tube has the ball: its rim is the circle of contact.
#[derive(Clone, Copy)]
struct Section {
    center: Point3,
    axis: Vec3,
    radius: f64,
}

impl Section {
    fn of(Station { ball, tangent }: Station) -> Self {
        let size = tangent.v.length();
        let axis = tangent.v / size;
        Self { center: ball.center + axis * (-ball.radius * tangent.r / size), axis, radius: ball.radius / size }
    }

    /// Distance from a point.
    fn distance(self, p: Point3) -> f64 {
        let v = p - self.center;
        let height = v.dot(self.axis);
        height.hypot(((v - self.axis * height).length() - self.radius).max(0.0))
    }

    /// True if two disks share a point: their parts of the line in which their planes meet do.
    fn meets(self, other: Self) -> bool {
        let Some(line) = self.axis.cross(other.axis).unit() else { return false };
        // From the first centre in its plane to the other plane.
        let to_plane = line.cross(self.axis);
        let lean = to_plane.dot(other.axis);
        let foot = self.center + to_plane * ((other.center - self.center).dot(other.axis) / lean);
        let part = |disk: Self| {
            let along = (disk.center - foot).dot(line);
            let off = (disk.center - foot).length_squared() - along * along;
            let half = (disk.radius * disk.radius * (1.0 - TOUCHING) - off).max(0.0).sqrt();
            (along, half)
        };
        let ((a, half_a), (b, half_b)) = (part(self), part(other));
        half_a > 0.0 && half_b > 0.0 && (a - b).abs() < half_a + half_b
    }
}

/// Two balls that are where only one tube may be.
pub(super) struct Meeting {
    pub(super) tubes: [usize; 2],
    sources: [usize; 2],
    pub(super) distance: f64,
    limit: f64,
}

/// Refuses a tube of which parts that are half a turn of their radius or more apart along it run into each other, at balls half their radius apart.
///
/// # Errors
/// `pipe-meets-itself`.
pub(super) fn check(course: Course<'_>) -> Result<()> {
    match first(&[course], false) {
        None => Ok(()),
        Some(Meeting { sources: [first, second], distance, limit, .. }) => {
            Err(Error::PipeMeetsItself { first: first.min(second), second: first.max(second), distance, limit })
        }
    }
}

/// The first balls that meet, of one tube or of different ones.
pub(super) fn first(tubes: &[Course<'_>], different: bool) -> Option<Meeting> {
    let mut places = Vec::new();
    let mut round = Vec::new();
    for (tube, course) in tubes.iter().enumerate() {
        let start = places.len();
        let length = add_places(course.arcs, tube, &mut places);
        round.push(course.closed.then_some(length));
        if !(course.closed || course.round) {
            for place in &mut places[start..] {
                place.cut = place.way.min(length - place.way) < place.ball.radius;
            }
        }
    }
    let octave = |radius: f64| radius.log2().ceil() as i32;
    let mut octaves: Vec<i32> = places.iter().map(|place| octave(place.ball.radius)).collect();
    octaves.sort_unstable();
    octaves.dedup();
    let mut cubes: HashMap<(i32, [i64; 3]), Vec<usize>> = HashMap::new();
    for (k, place) in places.iter().enumerate() {
        let own = octave(place.ball.radius);
        cubes.entry((own, cube(place.ball.center, own))).or_default().push(k);
    }
    for place in &places {
        // Each pair is found from its smaller ball.
        for &size in octaves.iter().filter(|size| **size >= octave(place.ball.radius)) {
            let [x, y, z] = cube(place.ball.center, size);
            let near = (0..27).map(|k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
            let others = near.filter_map(|at| cubes.get(&(size, at))).flatten().map(|&k| &places[k]);
            let others = others.filter(|other| (other.tube != place.tube) == different);
            if let Some(found) = others.filter_map(|other| meeting(place, other, round[place.tube])).next() {
                return Some(found);
            }
        }
    }
    None
}

fn meeting(a: &Place, b: &Place, round: Option<f64>) -> Option<Meeting> {
    let (distance, limit) = (a.ball.center.distance(b.ball.center), a.ball.radius + b.ball.radius);
    let apart = match (a.cut, b.cut) {
        (false, false) => distance >= limit * (1.0 - TOUCHING),
        (true, false) => a.section.distance(b.ball.center) >= b.ball.radius * (1.0 - TOUCHING),
        (false, true) => b.section.distance(a.ball.center) >= a.ball.radius * (1.0 - TOUCHING),
        (true, true) => !a.section.meets(b.section),
    };
    if apart {
        return None;
    }
    let straight = (a.way - b.way).abs();
    let way = round.map_or(straight, |length| straight.min(length - straight));
    if a.tube == b.tube && way < PI * a.ball.radius.max(b.ball.radius) {
        return None;
    }
    let mut pair = [a, b];
    pair.sort_by_key(|place| (place.tube, place.source));
    Some(Meeting { tubes: pair.map(|place| place.tube), sources: pair.map(|place| place.source), distance, limit })
}

/// The cube of the balls of an octave that a point lies in: twice as wide as they are.
fn cube(p: Point3, octave: i32) -> [i64; 3] {
    let width = 2.0 * f64::from(octave).exp2();
    p.to_array().map(|v| (v / width).floor() as i64)
}

/// Adds balls half a radius apart, or farther where they would be too many, and tells the length of the way.
fn add_places(arcs: &[BallArc], tube: usize, places: &mut Vec<Place>) -> f64 {
    let chord = |arc: &BallArc| {
        arc.centers()[0].distance(arc.ball(0.5).center) + arc.ball(0.5).center.distance(arc.centers()[1])
    };
    // Where a radius is none, the body is refused before.
    let steps = |arc: &BallArc| 2.0 * chord(arc) / arc.radii()[0].max(1e-3 * chord(arc));
    let coarser = (arcs.iter().map(steps).sum::<f64>() / MOST_BALLS).max(1.0);
    let mut way = 0.0;
    // The ends themselves: a disk there reaches farther than those before it.
    let end = |arc: &BallArc, s: f64, way: f64| {
        let station = arc.station(s);
        Place { ball: station.ball, way, tube, source: arc.source, section: Section::of(station), cut: false }
    };
    places.extend(arcs.first().map(|arc| end(arc, 0.0, 0.0)));
    for arc in arcs {
        let count = (steps(arc) / coarser).ceil().max(1.0);
        let mut last = arc.ball(0.0);
        for k in 1..=count as usize {
            let station = arc.station((k as f64 - 0.5) / count);
            let (ball, section) = (station.ball, Section::of(station));
            way += last.center.distance(ball.center);
            places.push(Place { ball, way, tube, source: arc.source, section, cut: false });
            last = ball;
        }
        way += last.center.distance(arc.centers()[1]);
    }
    places.extend(arcs.last().map(|arc| end(arc, 1.0, way)));
    way
}
