//! No denominator vanishes: proved by the real weights of sub-patches.

use super::bilinear;
use super::rational::real_weights;
use crate::base::quat::Quat;
use crate::error::{PatchError, Result};

/// Cells are halved this often before their center is called a pole.
const HALVINGS: u32 = 20;

/// Refuses weights of a patch that passes through infinity: `|D|²` is biquadratic and has no zero where all its nine Bernstein
/// coefficients are positive; other cells are quartered, whose corner weights are values of `D`, exactly.
///
/// # Errors
/// `patch-through-infinity`.
pub(crate) fn check_no_pole(weights: &[Quat; 4]) -> Result<()> {
    // Relative to the weights a cell of depth 20 has coefficients of 1e-12 at most beside a zero.
    match pole(weights, 0.0, 0.0, HALVINGS) {
        None => Ok(()),
        Some((s, t)) => Err(PatchError::ThroughInfinity { s, t }.into()),
    }
}

/// A parameter pair near which the denominator vanishes.
fn pole(w: &[Quat; 4], s: f64, t: f64, depth: u32) -> Option<(f64, f64)> {
    if real_weights(w).iter().flatten().all(|&v| v > 0.0) {
        return None;
    }
    let size = 0.5f64.powi((HALVINGS - depth) as i32);
    if depth == 0 {
        return Some((s + 0.5 * size, t + 0.5 * size));
    }
    let quarter = |i: usize, j: usize| {
        let at = |k: usize| 0.5 * k as f64;
        let corner = |a: usize, b: usize| bilinear(w, at(i + a), at(j + b));
        [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)]
    };
    [(0, 0), (1, 0), (0, 1), (1, 1)]
        .into_iter()
        .find_map(|(i, j)| pole(&quarter(i, j), s + 0.5 * size * i as f64, t + 0.5 * size * j as f64, depth - 1))
}
