//! Corners that were rounded off with the noise: where the curve bends sharply points are off it by more than their noise
//! (`docs/math/fair-fits.md#noise`).

use super::chords::median;
use super::neighbors::most_noise;
use crate::base::vector::{Point3, Vec3};

/// Points off by so many deviations, and by this part of the edges beside them, at least so many of them, are more than noise.
const OFF: f64 = 4.5;
const OF_EDGES: f64 = 0.1;
const FEWEST: usize = 3;
/// The smoothed polyline turns by more than this there: ten degrees.
const SHARP: f64 = std::f64::consts::PI / 18.0;
/// The median of the absolute values of normal errors, and of their lengths in two directions, as parts of the deviation.
const MEDIAN: [f64; 2] = [0.6745, 1.1774];

/// What was found.
pub(in crate::construct::curves::fair_fit) struct Rounded {
    /// The position of the point that is off by most, how far, and how many there are.
    pub point: usize,
    pub distance: f64,
    pub count: usize,
    /// Deviation of the noise of most points, by the median: a few large distances do not count.
    pub noise: f64,
}

/// Whether corners are gone between the measured points and the places they were smoothed to.
pub(in crate::construct::curves::fair_fit) fn rounded(
    measured: &[Point3],
    places: &[Point3],
    closed: bool,
    directions: usize,
) -> Option<Rounded> {
    let n = places.len();
    let inside = |i: &usize| closed || (*i > 0 && i + 1 < n);
    let edges = |i: usize| [places[i] - places[(i + n - 1) % n], places[(i + 1) % n] - places[i]];
    let across = |i: usize| {
        let [before, after] = edges(i);
        let along = (before + after).unit().unwrap_or(Vec3::ZERO);
        let off = measured[i] - places[i];
        (off - along * off.dot(along)).length()
    };
    let offs: Vec<(usize, f64)> = (0..n).filter(inside).map(|i| (i, across(i))).collect();
    let directions = directions.clamp(1, 2);
    let median = median(&mut offs.iter().map(|o| o.1).collect::<Vec<_>>()) / MEDIAN[directions - 1];
    // Where corners are everywhere most points are off by the cut; their neighbors tell less.
    let noise = most_noise(measured, closed, directions).map_or(median, |most| most.min(median));
    let is_rounded = |(i, off): &&(usize, f64)| {
        let [before, after] = edges(*i);
        let edge = 0.5 * (before.length() + after.length());
        *off > (OFF * noise).max(OF_EDGES * edge) && before.angle(after) > SHARP
    };
    let off = || offs.iter().filter(is_rounded);
    let (point, distance) = off().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let count = off().count();
    (noise > 0.0 && count >= FEWEST).then_some(Rounded { point, distance, count, noise })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with edges of ten points each, and its points with noise of 0.02.
    fn square() -> [Vec<Point3>; 2] {
        let corner = |k: usize| [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]][k % 4];
        let at = |i: usize| {
            let ([a, b], [c, d], t) = (corner(i / 10), corner(i / 10 + 1), (i % 10) as f64 / 10.0);
            Point3::new(a + (c - a) * t, b + (d - b) * t, 0.0)
        };
        let places: Vec<Point3> = (0..40).map(at).collect();
        let noise = |i: usize| 0.02 * ((i * i) as f64 * 0.7).sin();
        let measured = (0..40).map(|i| at(i) + Vec3::new(noise(i), noise(i + 7), 0.0)).collect();
        [measured, places]
    }

    #[test]
    fn corners_that_are_cut_are_found() {
        let [measured, mut places] = square();
        assert!(rounded(&measured, &places, true, 1).is_none());
        let middle = Vec3::new(1.5, 1.5, 0.0);
        for i in [0, 10, 20, 30] {
            let inward = (middle - places[i].to_vec()) * 0.06;
            places[i] += inward;
        }
        let found = rounded(&measured, &places, true, 1).unwrap();
        assert!(
            found.count == 4 && found.point.is_multiple_of(10) && (0.09..0.2).contains(&found.distance),
            "{}",
            found.count
        );
        assert!((0.005..0.04).contains(&found.noise), "{}", found.noise);
        // Two may be noise.
        let [_, whole] = square();
        places[0] = whole[0];
        places[10] = whole[10];
        assert!(rounded(&measured, &places, true, 1).is_none());
    }
}
