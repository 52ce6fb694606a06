//! Whether a tube runs into itself: balls along it, looked up by cubes as wide as the balls of a size are, so that time is linear in
//! their number (`docs/math/tubes.md#meeting`).

use super::ball::Ball;
use super::ball_arc::BallArc;
use crate::base::vector::Point3;
use crate::error::{Error, Result};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Balls along a tube, at most.
const MOST_BALLS: f64 = 2e5;
/// Tubes may touch: distances that are short of the sum of radii by less than this part do.
const TOUCHING: f64 = 1e-6;

/// A ball on a tube, with the way of the centre before it.
#[derive(Clone, Copy)]
struct Place {
    ball: Ball,
    way: f64,
    tube: usize,
    source: usize,
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
pub(super) fn check(arcs: &[BallArc], closed: bool) -> Result<()> {
    match first(&[(arcs, closed)], false) {
        None => Ok(()),
        Some(Meeting { sources: [first, second], distance, limit, .. }) => {
            Err(Error::PipeMeetsItself { first: first.min(second), second: first.max(second), distance, limit })
        }
    }
}

/// The first balls that meet, of one tube or of different ones.
pub(super) fn first(tubes: &[(&[BallArc], bool)], different: bool) -> Option<Meeting> {
    let mut places = Vec::new();
    let mut round = Vec::new();
    for (tube, (arcs, closed)) in tubes.iter().enumerate() {
        let length = add_places(arcs, tube, &mut places);
        round.push(closed.then_some(length));
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
    if distance >= limit * (1.0 - TOUCHING) {
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
    for arc in arcs {
        let count = (steps(arc) / coarser).ceil().max(1.0);
        let mut last = arc.ball(0.0);
        for k in 1..=count as usize {
            let ball = arc.ball((k as f64 - 0.5) / count);
            way += last.center.distance(ball.center);
            places.push(Place { ball, way, tube, source: arc.source });
            last = ball;
        }
        way += last.center.distance(arc.centers()[1]);
    }
    way
}
