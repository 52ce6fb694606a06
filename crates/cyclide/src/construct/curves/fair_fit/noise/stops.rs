//! Stops: runs of points that were measured while nothing moved, scattered about one place
//! (`docs/math/fair-fits.md#stops`).

use super::chords::median;
use crate::base::vector::{Point3, Vec3};

/// Points of a stop, at least.
const FEWEST: usize = 10;
/// Elsewhere as many points go this many times as far as a stop is wide.
const GOING: f64 = 4.0;
/// The means of its quarters are within this part of its width of its middle.
const STEADY: f64 = 0.25;
/// Neighboring steps inside it have less than this correlation: they do not go round.
const ALIKE: f64 = 0.25;
/// And their directions on average less than this one: points on a dense bend go on in one direction.
const TURNED: f64 = 0.7;
/// Part of the data that may stand still for the speed of the others to be known.
const MOVING: f64 = 0.6;
/// Points this many times the scatter away from the middle are on their way.
const REACH: f64 = 2.2;

/// A run of points that is one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Stop {
    /// The first and the last point.
    pub first: usize,
    pub last: usize,
    /// Their mean, and how far the farthest is from it.
    pub middle: Point3,
    pub radius: f64,
}

/// The stops among points, in their order.
pub(in super::super) fn stops(points: &[Point3]) -> Vec<Stop> {
    let n = points.len();
    let mut standing = vec![false; n];
    let mut size = FEWEST;
    while size <= n / 2 {
        let far = reach(points, size);
        // Windows overlap by three quarters.
        let step = (size / 4).max(1);
        for from in (0..=n - size).step_by(step) {
            if is_still(&points[from..from + size], far) {
                standing[from..from + size].fill(true);
            }
        }
        size *= 2;
    }
    let mut found = Vec::new();
    let mut i = 0;
    while i < n {
        if !standing[i] {
            i += 1;
            continue;
        }
        let end = (i..n).find(|k| !standing[*k]).unwrap_or(n);
        found.extend(grown(points, i, end, found.last().map_or(0, |s: &Stop| s.last + 1)));
        i = end.max(found.last().map_or(0, |s| s.last + 1));
    }
    found
}

/// How far so many points usually go.
fn reach(points: &[Point3], size: usize) -> f64 {
    let mut lengths: Vec<f64> = points.windows(size).map(|w| w[0].distance(w[size - 1])).collect();
    let k = ((lengths.len() as f64 * MOVING) as usize).min(lengths.len() - 1);
    *lengths.select_nth_unstable_by(k, f64::total_cmp).1
}

fn is_still(points: &[Point3], far: f64) -> bool {
    let centre = mean(points);
    let width = 2.0 * points.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
    if far < GOING * width || width == 0.0 {
        return false;
    }
    let quarters = points.chunks(points.len().div_ceil(4));
    if quarters.map(|q| mean(q).distance(centre)).any(|d| d > STEADY * width) {
        return false;
    }
    let steps: Vec<Vec3> = points.windows(2).map(|w| w[1] - w[0]).collect();
    let squares: f64 = steps.iter().map(|s| s.length_squared()).sum();
    let directions: Vec<Vec3> = steps.iter().filter_map(|s| s.unit()).collect();
    let alike = directions.windows(2).map(|w| w[0].dot(w[1])).sum::<f64>();
    steps.windows(2).map(|w| w[0].dot(w[1])).sum::<f64>() < ALIKE * squares && alike < TURNED * directions.len() as f64
}

fn mean(points: &[Point3]) -> Point3 {
    let first = points[0];
    first + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - first)) / points.len() as f64
}

/// The run of points about the middle of some that stand still: those at its ends that are on their way are none.
fn grown(points: &[Point3], from: usize, end: usize, least: usize) -> Option<Stop> {
    let axis = |get: fn(&Point3) -> f64| median(&mut points[from..end].iter().map(get).collect::<Vec<_>>());
    let centre = Point3::new(axis(|p| p.x), axis(|p| p.y), axis(|p| p.z));
    let scatter = median(&mut points[from..end].iter().map(|p| p.distance(centre)).collect::<Vec<_>>());
    let near = |i: usize| points[i].distance(centre) <= REACH * scatter;
    let (mut first, mut last) = ((from..end).find(|i| near(*i))?, (from..end).rfind(|i| near(*i))?);
    while first > least && near(first - 1) {
        first -= 1;
    }
    while last + 1 < points.len() && near(last + 1) {
        last += 1;
    }
    let inside = &points[first..=last];
    let middle = mean(inside);
    let radius = inside.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
    (last - first + 1 >= FEWEST).then_some(Stop { first, last, middle, radius })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jitter(i: usize) -> Vec3 {
        let a = (i * i) as f64 * 2.399;
        Vec3::new(a.cos(), a.sin(), 0.0) * (1.0 + (i as f64 * 1.7).sin())
    }

    #[test]
    fn a_stop_is_found_and_going_round_is_none() {
        let mut points: Vec<Point3> = (0..200).map(|i| Point3::new(4.0 * i as f64, 0.0, 0.0) + jitter(i)).collect();
        assert_eq!(stops(&points), []);
        let place = points[100];
        let standing: Vec<Point3> = (0..60).map(|i| place + jitter(3 * i + 1)).collect();
        points.splice(100..100, standing);
        let found = stops(&points);
        assert_eq!(found.len(), 1);
        assert!(found[0].first.abs_diff(100) <= 1 && found[0].last.abs_diff(159) <= 1, "{found:?}");
        assert!(found[0].middle.distance(place) < 0.5);
        // A roundabout, three times, and slowly.
        let round =
            |i: i32| Point3::new(800.0 + 6.0 * (0.3 * f64::from(i)).sin(), 6.0 - 6.0 * (0.3 * f64::from(i)).cos(), 0.0);
        let mut points: Vec<Point3> = (0..200).map(|i| Point3::new(4.0 * f64::from(i), 0.0, 0.0)).collect();
        points.extend((0..63).map(round));
        points.extend((0..200).map(|i| Point3::new(800.0 + 4.0 * f64::from(i), 0.0, 0.0)));
        assert_eq!(stops(&points), []);
    }
}
