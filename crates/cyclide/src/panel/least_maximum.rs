//! The bent plane whose largest distance from points is least.

use super::bent_plane::{BentPlane, PARAMETERS};
use crate::base::vector::Vec3;

/// Parameters of a fit at most.
const MOST: usize = 7;
/// Steps of least squares; linearizations towards the least maximum, and weighings of each.
const STEPS: usize = 40;
const LINEARIZATIONS: usize = 24;
const WEIGHINGS: usize = 30;
/// The largest distance is this near to its lower bound, the weighted mean: done.
pub(super) const LEVEL: f64 = 1.003;
/// Distances below this, in units of the size, are rounding.
pub(super) const ROUNDING: f64 = 1e-14;
/// What is added to the diagonal of normal equations, relative to itself and to the largest entry: a sphere may be turned about any axis.
const DAMPING: [f64; 2] = [1e-12, 1e-14];

/// The first damping of a linearization that went too far.
const FIRST: f64 = 1e-3;
/// A mould is given up where the least mean distance to first order is this many times the limit at its start, and the least largest
/// distance this many times after least squares: what is of second order changes them by less.
const GIVEN_UP_AT_START: f64 = 2.0;
const GIVEN_UP: f64 = 1.05;
/// A step is good enough where it is so with something to spare for what is of second order.
const CLEARLY: f64 = 0.995;

/// Distances at points, with their derivatives by the free parameters.
struct Linear {
    rows: Vec<([f64; MOST], f64)>,
    count: usize,
}

impl Linear {
    fn new(shape: &BentPlane, points: &[Vec3], free: &[usize]) -> Self {
        let residual = shape.residuals();
        let row = |p: &Vec3| {
            let residual = residual(*p);
            let mut by = [0.0; MOST];
            for (to, from) in by.iter_mut().zip(free) {
                *to = residual.by[*from];
            }
            (by, residual.value)
        };
        Self { rows: points.iter().map(row).collect(), count: free.len() }
    }

    /// The step of least weighted squares.
    fn step(&self, weights: &[f64], damping: [f64; 2]) -> Option<[f64; MOST]> {
        // Most of the time of all fits is in these sums: loops of a known length are several times as fast.
        match self.count {
            3 => self.step_of::<3>(weights, damping),
            4 => self.step_of::<4>(weights, damping),
            5 => self.step_of::<5>(weights, damping),
            6 => self.step_of::<6>(weights, damping),
            _ => self.step_of::<MOST>(weights, damping),
        }
    }

    /// The same for the first `N` parameters, which are all.
    fn step_of<const N: usize>(&self, weights: &[f64], damping: [f64; 2]) -> Option<[f64; MOST]> {
        let (mut a, mut b) = ([[0.0; N]; N], [0.0; N]);
        for ((by, value), weight) in self.rows.iter().zip(weights) {
            for i in 0..N {
                let scaled = weight * by[i];
                for j in 0..=i {
                    a[i][j] += scaled * by[j];
                }
                b[i] -= scaled * value;
            }
        }
        let largest = (0..N).map(|i| a[i][i]).fold(0.0, f64::max);
        for (i, row) in a.iter_mut().enumerate() {
            row[i] += damping[0] * row[i] + damping[1] * largest;
        }
        let mut step = [0.0; MOST];
        cholesky(&mut a, &mut b).then(|| step[..N].copy_from_slice(&b))?;
        Some(step)
    }

    /// Distances after a step, to first order.
    fn after(&self, step: &[f64; MOST]) -> impl Iterator<Item = f64> {
        self.rows.iter().map(move |(by, value)| value + by.iter().zip(step).map(|(a, b)| a * b).sum::<f64>())
    }

    /// The root of the mean square of the distances that is least to first order.
    fn least_mean(&self, even: &[f64]) -> f64 {
        let Some(step) = self.step(even, DAMPING) else { return 0.0 };
        (self.after(&step).map(|distance| distance * distance).sum::<f64>() / self.rows.len() as f64).sqrt()
    }

    /// The step of the least largest distance, to first order, and a lower bound of that: weights are multiplied by the
    /// distances, again and again (C. L. Lawson's rule), and the weighted mean of distances that are least in the mean is no larger than
    /// the largest of any other ones. Done as soon as the largest is at most `enough`, or the bound above `most`.
    fn level(&self, weights: &mut Vec<f64>, damping: f64, [enough, most]: [f64; 2]) -> Option<([f64; MOST], f64)> {
        let mut best = None;
        let (mut least, mut bound) = (f64::INFINITY, 0.0_f64);
        for _ in 0..WEIGHINGS {
            let step = self.step(weights, [damping, DAMPING[1].max(damping * 1e-2)])?;
            let (mut largest, mut square) = (0.0_f64, 0.0);
            for (distance, weight) in self.after(&step).zip(weights.iter()) {
                largest = largest.max(distance.abs());
                square += weight * distance * distance;
            }
            bound = bound.max(square.sqrt());
            if largest < least {
                (least, best) = (largest, Some(step));
            }
            if least <= LEVEL * bound || least <= ROUNDING.max(CLEARLY * enough) || bound > most {
                break;
            }
            let weighed: Vec<f64> = self.after(&step).zip(weights.iter()).map(|(d, w)| d.abs() * w).collect();
            let sum: f64 = weighed.iter().sum();
            *weights = weighed.into_iter().map(|w| w / sum).collect();
        }
        Some((best?, bound))
    }
}

/// Solves in place; false if the matrix, of which the lower half is given, is not positive definite.
fn cholesky<const N: usize>(a: &mut [[f64; N]; N], b: &mut [f64; N]) -> bool {
    for i in 0..N {
        for j in 0..=i {
            let sum: f64 = a[i][j] - (0..j).map(|k| a[i][k] * a[j][k]).sum::<f64>();
            if i != j {
                a[i][j] = sum / a[j][j];
            } else if sum > 0.0 && sum.is_finite() {
                a[i][i] = sum.sqrt();
            } else {
                return false;
            }
        }
    }
    for i in 0..N {
        b[i] = (b[i] - (0..i).map(|k| a[i][k] * b[k]).sum::<f64>()) / a[i][i];
    }
    for i in (0..N).rev() {
        b[i] = (b[i] - (i + 1..N).map(|k| a[k][i] * b[k]).sum::<f64>()) / a[i][i];
    }
    true
}

impl BentPlane {
    /// The surface near this one whose largest distance from the points is least, to about half a percent, with that distance: by least squares,
    /// then by linearized problems of the least maximum. What no surface near this one brings within `limit` is left wherever that is seen, and nothing
    /// is done any more once the largest distance is at most `enough`.
    pub(super) fn least_maximum(self, points: &[Vec3], free: &[usize], [enough, limit]: [f64; 2]) -> (Self, f64) {
        let (shape, mean) = self.least_squares(points, free, f64::INFINITY);
        let best = (shape, shape.largest(points));
        if mean > limit { best } else { best.0.leveled(points, free, [enough, GIVEN_UP * limit]) }
    }

    /// As [`least_maximum`](Self::least_maximum) for a surface that is only placed: one that no placing near this one brings within
    /// `limit` is left wherever that is seen.
    pub(super) fn placed(self, points: &[Vec3], free: &[usize], [enough, limit]: [f64; 2]) -> (Self, f64) {
        let (shape, mean) = self.least_squares(points, free, GIVEN_UP_AT_START * limit);
        let best = (shape, shape.largest(points));
        if mean > limit { best } else { best.0.leveled(points, free, [enough, GIVEN_UP * limit]) }
    }

    /// As [`least_maximum`](Self::least_maximum), from a surface that is near already; given up where the bound is above `most`.
    pub(super) fn leveled(self, points: &[Vec3], free: &[usize], [enough, most]: [f64; 2]) -> (Self, f64) {
        let mut best = (self, self.largest(points));
        let even = vec![1.0 / points.len() as f64; points.len()];
        let (mut weights, mut damping) = (even.clone(), DAMPING[0]);
        for _ in 0..LINEARIZATIONS {
            if best.1 <= enough.max(ROUNDING) {
                break;
            }
            let linear = Linear::new(&best.0, points, free);
            // What is damped says nothing of what can be reached.
            let given_up = if damping <= DAMPING[0] { most } else { f64::INFINITY };
            let Some((step, bound)) = linear.level(&mut weights, damping, [enough, given_up]) else { break };
            if damping <= DAMPING[0] && (best.1 <= LEVEL * bound || bound > most) {
                break;
            }
            let trial = best.0.stepped(&step, 1.0, free);
            let largest = trial.largest(points);
            if largest < best.1 {
                let little = largest > best.1 * (1.0 - 1e-3);
                best = (trial, largest);
                if little && damping <= DAMPING[0] {
                    break;
                }
                damping = if damping <= FIRST { DAMPING[0] } else { damping * 0.1 };
            } else if damping > 1.0 {
                break;
            } else {
                // Too far for what is linear.
                damping = FIRST.max(8.0 * damping);
                weights.clone_from(&even);
            }
        }
        best
    }

    /// The surface of least squares near this one, by Levenberg-Marquardt steps; with the mean distance. Given up where that is above
    /// `most` to first order.
    fn least_squares(self, points: &[Vec3], free: &[usize], most: f64) -> (Self, f64) {
        let even = vec![1.0 / points.len() as f64; points.len()];
        let (mut shape, mut damping) = (self, 1e-6);
        let mut cost = shape.mean_square(points);
        for _ in 0..STEPS {
            let linear = Linear::new(&shape, points, free);
            let before = cost;
            if most < f64::INFINITY && linear.least_mean(&even) > most {
                break;
            }
            while damping < 1e6 {
                let step = linear.step(&even, [damping, DAMPING[1].max(1e-6 * damping)]);
                let trial = step.map(|step| shape.stepped(&step, 1.0, free));
                let lower = trial.map(|trial| (trial, trial.mean_square(points))).filter(|(_, c)| *c < cost);
                if let Some((trial, lower)) = lower {
                    (shape, cost, damping) = (trial, lower, (damping * 0.1).max(1e-15));
                    break;
                }
                if cost.sqrt() <= ROUNDING {
                    break;
                }
                damping *= 10.0;
            }
            if !(before - cost > 1e-6 * before) || cost.sqrt() <= 0.1 * ROUNDING {
                break;
            }
        }
        (shape, cost.sqrt())
    }

    fn stepped(&self, step: &[f64; MOST], part: f64, free: &[usize]) -> Self {
        let mut all = [0.0; PARAMETERS];
        for (x, to) in step.iter().zip(free) {
            all[*to] = part * x;
        }
        self.moved(&all)
    }

    fn mean_square(&self, points: &[Vec3]) -> f64 {
        let squares = points.iter().copied().map(self.distances()).map(|distance| distance * distance);
        squares.sum::<f64>() / points.len() as f64
    }

    fn largest(&self, points: &[Vec3]) -> f64 {
        points.iter().copied().map(self.distances()).map(f64::abs).fold(0.0, f64::max)
    }
}
