//! What noise measured points can have at most: how far they are off the polynomials through their neighbors. Noise moves them
//! off by a known multiple of its deviation, and a bend that the polynomial misses only adds to that
//! (`docs/math/fair-fits.md#noise`).

use super::chords::median;
use crate::base::vector::Point3;
use crate::construct::curves::off_neighbors::off_neighbors;

/// Neighbors on either side, at most.
const MOST: usize = 4;
/// The median of the absolute values of a normal variable, and of the lengths of pairs of them, in deviations.
const MEDIAN: [f64; 2] = [0.6745, 1.1774];

/// A bound on the deviation of the noise across the curve, in one direction; `None` of too few points.
pub(in crate::construct::curves::fair_fit) fn most_noise(
    points: &[Point3],
    closed: bool,
    directions: usize,
) -> Option<f64> {
    let found = (1..=MOST).filter_map(|k| {
        let mut off = offs(points, closed, k);
        (off.len() >= points.len().div_ceil(2) && off.len() > 2).then(|| median(&mut off) / MEDIAN[directions - 1])
    });
    found.reduce(f64::min)
}

/// How far each point is across from the polynomial through `k` neighbors on either side, in units of what noise of
/// deviation 1 makes of that.
pub(super) fn offs(points: &[Point3], closed: bool, k: usize) -> Vec<f64> {
    let n = points.len();
    let range = if closed { 0..n } else { k..n.saturating_sub(k) };
    if n < 2 * k + 2 {
        return Vec::new();
    }
    let others: Vec<usize> = (0..=2 * k).filter(|j| *j != k).collect();
    let off = |i: usize| {
        let window: Vec<Point3> = (0..=2 * k).map(|j| points[(i + n + j - k) % n]).collect();
        let (off, spread) = off_neighbors(&window, &others);
        off / spread
    };
    range.map(off).filter(|off| off.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_points_have_none_and_noise_is_found() {
        let ellipse = |i: usize, noise: f64| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / 60.0).sin_cos();
            let wave = ((i * i) as f64 * 0.77).sin();
            Point3::new(50.0 * cos * (1.0 + noise * wave), 30.0 * sin * (1.0 + noise * wave), 0.0)
        };
        let most = |noise: f64| {
            let points: Vec<Point3> = (0..60).map(|i| ellipse(i, noise)).collect();
            most_noise(&points, true, 1).unwrap()
        };
        assert!(most(0.0) < 1e-3, "{}", most(0.0));
        // Of the wave the deviation is 0.7, across an ellipse of 30 to 50.
        assert!((0.15..0.5).contains(&most(0.01)), "{}", most(0.01));
        assert!(most_noise(&[Point3::ORIGIN; 3], false, 1).is_none());
    }
}
