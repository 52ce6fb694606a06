//! Where a motion comes near the exceptional generator of the quadric: `p = 0`, where a dual quaternion is no displacement.
//!
//! On a part of a span `W = |p|²` and `Z = |r|²` (in units of the size) have the Bernstein coefficients `W_k`, `Z_k`. If all
//! `W_k − limit (W_k + Z_k)` are positive, the share `W/(W + Z)` is above the limit there: a proof. Else the part is halved
//! (`docs/math/motions.md#the-exceptional-generator`).

use super::rational_motion::MotionSpan;
use crate::base::bernstein;
use crate::error::{Error, Result};

/// Smallest share `|p|²/(|p|² + |r|²)` of a motion.
const LEAST_SHARE: f64 = 1e-14;
/// Smallest length of the real part of a spline whose poses have length 1.
const LEAST_LENGTH: f64 = 1e-6;
/// Halvings after which a part is as good as a point.
const HALVINGS: u32 = 50;

impl MotionSpan {
    /// Refuses a span that goes through the exceptional generator, or as near as rounding tells; `domain` are the times of its ends.
    ///
    /// # Errors
    /// `motion-through-exceptional-point`.
    pub(super) fn check_share(&self, domain: [f64; 2]) -> Result<()> {
        // A span on which both parts vanish together is a pose of which nothing is left.
        let most = self.0.iter().map(|row| squared(row, 0) + squared(row, 4)).fold(0.0, f64::max);
        let good = |w: f64, z: f64| w > LEAST_SHARE * (w + z) && w + z > LEAST_SHARE * most;
        match uncertified(&self.0, [0.0, 1.0], &good, HALVINGS) {
            None => Ok(()),
            Some(s) => {
                let row = bernstein::eval(&self.0, s);
                let (w, z) = (squared(&row, 0), squared(&row, 4));
                let share = if w + z > 0.0 { w / (w + z) } else { 0.0 };
                let time = domain[0] + (domain[1] - domain[0]) * s;
                Err(Error::MotionThroughExceptionalPoint { time, share, limit: LEAST_SHARE })
            }
        }
    }

    /// Refuses a span whose real part gets shorter than a millionth.
    ///
    /// # Errors
    /// `rotation-too-large`.
    pub(super) fn check_length(&self, span: usize) -> Result<()> {
        match uncertified(&self.0, [0.0, 1.0], &|w, _| w > LEAST_LENGTH * LEAST_LENGTH, HALVINGS) {
            None => Ok(()),
            Some(s) => {
                let length = squared(&bernstein::eval(&self.0, s), 0).sqrt();
                Err(Error::RotationTooLarge { span, length, limit: LEAST_LENGTH })
            }
        }
    }
}

/// The squared length of four of the coefficients.
fn squared(row: &[f64; 8], from: usize) -> f64 {
    row[from..from + 4].iter().map(|v| v * v).sum()
}

/// A parameter next to which the coefficients of `W` and `Z` prove nothing; `None` if every part is proved.
fn uncertified(rows: &[[f64; 8]], [a, b]: [f64; 2], good: &impl Fn(f64, f64) -> bool, halvings: u32) -> Option<f64> {
    let w = coefficients(rows, 0);
    let z = coefficients(rows, 4);
    if w.iter().zip(&z).all(|(w, z)| good(*w, *z)) {
        return None;
    }
    let middle = 0.5 * (a + b);
    let ends = [&rows[0], &rows[rows.len() - 1]];
    // An end that is bad itself needs no search.
    for (row, at) in ends.into_iter().zip([a, b]) {
        if !good(squared(row, 0), squared(row, 4)) {
            return Some(at);
        }
    }
    if halvings == 0 {
        return Some(middle);
    }
    let (left, right) = bernstein::split(rows, 0.5);
    uncertified(&left, [a, middle], good, halvings - 1).or_else(|| uncertified(&right, [middle, b], good, halvings - 1))
}

/// The Bernstein coefficients of the squared length of four of the coefficients.
fn coefficients(rows: &[[f64; 8]], from: usize) -> Vec<f64> {
    let mut sum = vec![0.0; 2 * rows.len() - 1];
    for d in from..from + 4 {
        let column: Vec<f64> = rows.iter().map(|row| row[d]).collect();
        sum.iter_mut().zip(bernstein::product(&column, &column)).for_each(|(s, v)| *s += v);
    }
    sum
}
