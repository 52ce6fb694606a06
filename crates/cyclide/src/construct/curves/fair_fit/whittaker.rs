//! The start of a fair fit: the data themselves, smoothed as far as part of the tolerance allows
//! (`docs/math/fair-fits.md#nodes`).
//!
//! `z` minimizes `sum |z - p|² + lambda sum h (z''')²` (Whittaker's smoother, third divided differences over the chord
//! lengths). What is solved for is `w = p - z`, so that parabolas lose nothing to rounding:
//! `(I + lambda K) w = lambda K p`. Feasible by construction, and no tangent or normal of noisy data is needed.

use super::bordered_band::BorderedBand;
use crate::base::vector::{Point3, Vec3};

/// Part of the tolerance the smoothed points may be away from the data.
pub(super) const ROOM: f64 = 0.7;
/// Largest weight, in fifth powers of the mean chord: above it rounding would show.
const STIFFEST: f64 = 1e12;
const SOFTEST: f64 = 1e-6;
/// Halvings of the exponent between the two.
const BISECTIONS: usize = 14;
/// Weight of data that must stay where they are.
const FIXED: f64 = 1e8;

/// Smoothed points, and what they were smoothed with.
pub(super) struct Smoothed {
    pub points: Vec<Point3>,
    /// They could be stiffer still.
    pub stiffest: bool,
    /// Waves shorter than `2 pi` times this length are gone: the smoother passes `1/(1 + (length frequency)^6)`.
    pub length: f64,
}

/// Smooths points until one of them is `ROOM` of the tolerance away; ends of open data may be fixed.
pub(super) fn smooth(points: &[Point3], chords: &[f64], closed: bool, fixed: [bool; 2], tolerance: f64) -> Smoothed {
    let n = points.len();
    if n < 4 {
        return Smoothed { points: points.to_vec(), stiffest: false, length: 0.0 };
    }
    let mut weights = vec![1.0; n];
    for (end, fixed) in [0, n - 1].into_iter().zip(fixed) {
        if fixed {
            weights[end] = FIXED;
        }
    }
    let smoother = Smoother::new(points, chords, closed, weights, &[]);
    let h = chords.iter().sum::<f64>() / chords.len() as f64;
    let unit = h * h * h * h * h;
    let limit = ROOM * tolerance;
    let mut best = None;
    let (mut soft, mut stiff) = (SOFTEST.log10(), STIFFEST.log10());
    let mut exponent = stiff;
    for _ in 0..=BISECTIONS {
        let residuals = smoother.residuals(unit * 10_f64.powf(exponent));
        let feasible = residuals.as_ref().is_some_and(|w| w.iter().all(|w| w.length_squared() <= limit * limit));
        if feasible {
            best = residuals;
            soft = exponent;
            if exponent >= stiff {
                break;
            }
        } else {
            stiff = exponent;
        }
        exponent = 0.5 * (soft + stiff);
    }
    let stiffest = soft >= STIFFEST.log10();
    let mut smoothed = points.to_vec();
    for (z, w) in smoothed.iter_mut().zip(best.unwrap_or_default()) {
        *z -= w;
    }
    if fixed[0] {
        smoothed[0] = points[0];
    }
    if fixed[1] {
        smoothed[n - 1] = points[n - 1];
    }
    let length = (unit * 10_f64.powf(soft) * h).powf(1.0 / 6.0);
    Smoothed { points: smoothed, stiffest, length }
}

/// Whittaker's smoother of some data, for every strength.
pub(super) struct Smoother {
    /// `K`, and `K p` by coordinates.
    penalty: BorderedBand<4>,
    pull: [Vec<f64>; 3],
    weights: Vec<f64>,
    /// The third differences: first datum and coefficients.
    differences: Vec<(usize, [f64; 4])>,
}

impl Smoother {
    /// `stiffness` of each third difference; empty: 1 of all.
    pub fn new(points: &[Point3], chords: &[f64], closed: bool, weights: Vec<f64>, stiffness: &[f64]) -> Self {
        let n = points.len();
        let mut penalty = BorderedBand::zero(n, closed);
        let mut pull = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
        let mut differences = Vec::with_capacity(n);
        for i in 0..if closed { n } else { n - 3 } {
            let at: [usize; 4] = std::array::from_fn(|k| (i + k) % n);
            let row = third_difference([chords[i], chords[(i + 1) % n], chords[(i + 2) % n]]);
            let stiff = stiffness.get(i).copied().unwrap_or(1.0);
            // Differences to the first point lose no digits far from the origin.
            let difference = (1..4).fold(Vec3::ZERO, |sum, k| sum + (points[at[k]] - points[at[0]]) * row[k]);
            for a in 0..4 {
                for (axis, d) in pull.iter_mut().zip(difference.to_array()) {
                    axis[at[a]] += stiff * row[a] * d;
                }
                for b in 0..=a {
                    *penalty.entry(at[a], at[b]) += stiff * row[a] * row[b];
                }
            }
            differences.push((i, row));
        }
        Self { penalty, pull, weights, differences }
    }

    /// Squares of the third differences of points in place of the data.
    pub fn variations(&self, points: &[Point3]) -> Vec<f64> {
        let n = points.len();
        let square = |(i, row): &(usize, [f64; 4])| {
            let from = points[*i];
            (1..4).fold(Vec3::ZERO, |sum, k| sum + (points[(i + k) % n] - from) * row[k]).length_squared()
        };
        self.differences.iter().map(square).collect()
    }

    /// What is smoothed away with this weight.
    fn residuals(&self, weight: f64) -> Option<Vec<Vec3>> {
        Some(self.rest(&self.factor(weight)?, weight))
    }

    /// What is smoothed away with this weight, and the degrees of freedom that are left: the trace of the matrix that takes
    /// the data to the smoothed ones.
    pub fn fitted(&self, weight: f64) -> Option<(Vec<Vec3>, f64)> {
        let factor = self.factor(weight)?;
        let freedom = factor.inverse_diagonal().iter().zip(&self.weights).map(|(d, w)| d * w).sum::<f64>();
        let rest = self.rest(&factor, weight);
        (freedom.is_finite() && rest.iter().all(|w| w.is_finite())).then_some((rest, freedom))
    }

    fn factor(&self, weight: f64) -> Option<BorderedBand<4>> {
        let mut matrix = self.penalty.clone();
        matrix.scale(weight);
        for (i, w) in self.weights.iter().enumerate() {
            *matrix.entry(i, i) += w;
        }
        matrix.factor().then_some(matrix)
    }

    fn rest(&self, factor: &BorderedBand<4>, weight: f64) -> Vec<Vec3> {
        let axes = self.pull.each_ref().map(|pull| {
            let mut w: Vec<f64> = pull.iter().map(|p| weight * p).collect();
            factor.solve(&mut w);
            w
        });
        (0..self.weights.len()).map(|i| Vec3::new(axes[0][i], axes[1][i], axes[2][i])).collect()
    }
}

/// Coefficients of the third derivative of the cubic through four points, times the root of a third of their span.
fn third_difference(h: [f64; 3]) -> [f64; 4] {
    let s = [0.0, h[0], h[0] + h[1], h[0] + h[1] + h[2]];
    let weight = 6.0 * (s[3] / 3.0).sqrt();
    std::array::from_fn(|k| weight / (0..4).filter(|l| *l != k).map(|l| s[k] - s[l]).product::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chords(p: &[Point3], closed: bool) -> Vec<f64> {
        let n = p.len();
        (0..if closed { n } else { n - 1 }).map(|i| (p[(i + 1) % n] - p[i]).length()).collect()
    }

    fn noise(i: usize) -> f64 {
        ((i * i) as f64 * 0.77).sin()
    }

    #[test]
    fn noise_goes_and_every_point_stays_near() {
        for closed in [false, true] {
            let at = |i: usize| {
                let a = std::f64::consts::TAU * i as f64 / 200.0;
                Point3::new(10.0 * a.cos() + 0.02 * noise(i), 10.0 * a.sin() + 0.02 * noise(i + 1), 0.0)
            };
            let points: Vec<_> = (0..200).map(at).collect();
            let smoothed = smooth(&points, &chords(&points, closed), closed, [false; 2], 0.1);
            let radius = |p: &Point3| (p.to_vec().length() - 10.0).abs();
            let spread = |p: &[Point3]| p.iter().map(radius).fold(0.0, f64::max);
            for (z, p) in smoothed.points.iter().zip(&points) {
                assert!(z.distance(*p) <= ROOM * 0.1 * (1.0 + 1e-12));
            }
            // Turns of the polygon, which noise rules: a fiftieth of a turn without it. (Spacing stays uneven.)
            let turn = |p: &[Point3]| p.windows(3).map(|w| (w[1] - w[0]).angle(w[2] - w[1])).fold(0.0, f64::max);
            let [smooth, raw] = [turn(&smoothed.points), turn(&points)];
            assert!(smooth < 0.06 && raw > 0.15, "{closed}: {smooth} {raw}");
            assert!(spread(&smoothed.points) < 0.1);
        }
    }

    #[test]
    fn parabolas_are_kept_at_the_largest_weight_far_from_the_origin() {
        let at = |i: usize| Point3::new(1e6 + i as f64, 1e6 + 0.01 * (i * i) as f64, 0.0);
        let points: Vec<_> = (0..50).map(at).collect();
        let chords: Vec<f64> = vec![1.0; 49];
        let smoothed = smooth(&points, &chords, false, [false; 2], 1.0);
        assert!(smoothed.stiffest);
        for (z, p) in smoothed.points.iter().zip(&points) {
            // Third differences of coordinates near 1e6 are roundings of 1e-10, and w follows them.
            assert!(z.distance(*p) < 1e-8);
        }
    }

    #[test]
    fn fixed_ends_stay() {
        let points: Vec<_> = (0..40).map(|i| Point3::new(i as f64, noise(i), 0.0)).collect();
        let smoothed = smooth(&points, &chords(&points, false), false, [true; 2], 2.0).points;
        assert_eq!((smoothed[0], smoothed[39]), (points[0], points[39]));
        // The neighbors follow their ends: no jump beside them.
        assert!((smoothed[1].y - smoothed[0].y).abs() < 0.5);
    }
}
