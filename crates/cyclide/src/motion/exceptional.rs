//! Where a motion comes near the exceptional generator of the quadric: `p = 0`, where a dual quaternion is no displacement.
//!
//! On a part of a span `W = |p|²` and `Z = |r|²` (in units of the size) have the Bernstein coefficients `W_k`, `Z_k`. If all
//! `W_k − limit (W_k + Z_k)` are positive, the share `W/(W + Z)` is above the limit there: a proof. Else the part is halved
//! (`docs/math/motions.md#the-exceptional-generator`).
//!
//! Where both vanish together there is no share. `W + Z` then is the square of a sum that cancels, and is held against that of the lengths of
//! its terms, `m = Σ B_i |D_i|`: neither a factor nor a projective change of the parameter changes what they say of each other.

use super::rational_motion::MotionSpan;
use crate::base::bernstein;
use crate::error::{MotionError, Result};

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
        let share = |m: &Measures| if m.sum() > 0.0 { m.w / m.sum() } else { 0.0 };
        let remainder = |m: &Measures| if m.terms > 0.0 { m.sum() / (m.terms * m.terms) } else { 0.0 };
        let good = |m: &Measures| m.w > LEAST_SHARE * m.sum() && m.sum() > LEAST_SHARE * m.terms * m.terms;
        match uncertified(&self.measured(), [0.0, 1.0], &good, HALVINGS) {
            None => Ok(()),
            Some((s, found)) => {
                let time = domain[0] + (domain[1] - domain[0]) * s;
                let (share, remainder) = (share(&found), remainder(&found));
                Err(MotionError::ThroughExceptionalPoint { time, share, remainder, limit: LEAST_SHARE }.into())
            }
        }
    }

    /// Refuses a span whose real part gets shorter than a millionth.
    ///
    /// # Errors
    /// `rotation-too-large`.
    pub(super) fn check_length(&self, span: usize) -> Result<()> {
        match uncertified(&self.measured(), [0.0, 1.0], &|m| m.w > LEAST_LENGTH * LEAST_LENGTH, HALVINGS) {
            None => Ok(()),
            Some((_, found)) => {
                Err(MotionError::RotationTooLarge { span, length: found.w.sqrt(), limit: LEAST_LENGTH }.into())
            }
        }
    }

    /// The coefficients, each with its length.
    fn measured(&self) -> Vec<[f64; 9]> {
        let length = |row: &[f64; 8]| (squared(&row[..4]) + squared(&row[4..])).sqrt();
        self.0.iter().map(|row| std::array::from_fn(|d| if d < 8 { row[d] } else { length(row) })).collect()
    }
}

/// What is looked at of a place, or of a coefficient.
struct Measures {
    /// `|p|²`.
    w: f64,
    /// `|r|²`.
    z: f64,
    /// The sum of the lengths of the terms that `p` and `r` are summed of.
    terms: f64,
}

impl Measures {
    fn at(row: &[f64; 9]) -> Self {
        Self { w: squared(&row[..4]), z: squared(&row[4..8]), terms: row[8] }
    }

    fn sum(&self) -> f64 {
        self.w + self.z
    }
}

/// The squared length of some of the coefficients.
fn squared(part: &[f64]) -> f64 {
    part.iter().map(|v| v * v).sum()
}

/// A parameter next to which the coefficients of `W` and `Z` prove nothing, and what is there; `None` if every part is proved.
fn uncertified(
    rows: &[[f64; 9]],
    [a, b]: [f64; 2],
    good: &impl Fn(&Measures) -> bool,
    halvings: u32,
) -> Option<(f64, Measures)> {
    let terms = rows.iter().map(|row| row[8]).fold(0.0, f64::max);
    let (w, z) = (coefficients(rows, 0), coefficients(rows, 4));
    if w.into_iter().zip(z).all(|(w, z)| good(&Measures { w, z, terms })) {
        return None;
    }
    // An end that is bad itself needs no search.
    for (row, at) in [(&rows[0], a), (&rows[rows.len() - 1], b)] {
        let found = Measures::at(row);
        if !good(&found) {
            return Some((at, found));
        }
    }
    let middle = 0.5 * (a + b);
    if halvings == 0 {
        return Some((middle, Measures::at(&bernstein::eval(rows, 0.5))));
    }
    let (left, right) = bernstein::split(rows, 0.5);
    uncertified(&left, [a, middle], good, halvings - 1).or_else(|| uncertified(&right, [middle, b], good, halvings - 1))
}

/// The Bernstein coefficients of the squared length of four of the coefficients.
fn coefficients(rows: &[[f64; 9]], from: usize) -> Vec<f64> {
    let mut sum = vec![0.0; 2 * rows.len() - 1];
    for d in from..from + 4 {
        let column: Vec<f64> = rows.iter().map(|row| row[d]).collect();
        sum.iter_mut().zip(bernstein::product(&column, &column)).for_each(|(s, v)| *s += v);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    /// The coefficients of a span times `c^i`: the same motion at a projective parameter.
    fn reweighted(rows: &[[f64; 8]], c: f64) -> MotionSpan {
        MotionSpan(rows.iter().enumerate().map(|(i, row)| row.map(|v| v * c.powi(i as i32))).collect())
    }

    /// A span of degree 1 times the linear factor that vanishes at a parameter.
    fn with_base_point(at: f64) -> Vec<[f64; 8]> {
        let rows = [[1.0, 0.2, -0.1, 0.3, 0.0, 0.4, 0.2, 0.1], [0.5, 0.8, 0.1, -0.3, 0.3, -0.2, 0.6, 0.1]];
        let columns: Vec<Vec<f64>> =
            (0..8).map(|d| bernstein::product(&[rows[0][d], rows[1][d]], &[-at, 1.0 - at])).collect();
        (0..3).map(|i| std::array::from_fn(|d| columns[d][i])).collect()
    }

    #[test]
    fn base_points_are_found_at_every_scale_and_uneven_spans_are_none() {
        for at in [0.0, 0.3, 0.5, 1.0] {
            let rows = with_base_point(at);
            for c in [1e-9, 1.0, 1e9] {
                let span = reweighted(&rows.iter().map(|row| row.map(|v| v * 1e-60)).collect::<Vec<_>>(), c);
                let Err(error) = span.check_share([0.0, 1.0]) else { panic!("{at} {c:e}") };
                let Error::Motion(MotionError::ThroughExceptionalPoint { time, share, remainder, limit }) = error
                else {
                    panic!()
                };
                // What is at t is now at t/(t + c(1 − t)).
                assert!((time - at / (at + c * (1.0 - at))).abs() < 1e-7, "{at} {c:e}: {time}");
                assert!(remainder <= limit && (share > limit || remainder == 0.0), "{at} {c:e}: {share:e}");
                assert!(share <= limit || error.to_string().contains("cancel"), "{error}");
            }
        }
        // Without the factor there is nothing to find.
        let rows = with_base_point(-1.0);
        for c in [1e-12, 1e-6, 1.0, 1e6, 1e12] {
            assert!(reweighted(&rows, c).check_share([0.0, 1.0]).is_ok(), "{c:e}");
        }
    }
}
