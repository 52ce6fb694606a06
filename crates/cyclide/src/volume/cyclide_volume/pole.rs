//! No denominator vanishes: proved by the real weights of sub-volumes.

use super::{CyclideVolume, trilinear};
use crate::base::multilinear::triquadratic;
use crate::base::quat::Quat;
use crate::error::{Result, VolumeError};

/// Cells are halved in all directions this often before their center is called a pole: what is taken goes into so small parts with positive weights.
pub(super) const HALVINGS: u32 = 16;

/// The 27 real weights: Bernstein coefficients of `|D|²`.
pub(super) fn real_weights(w: &[Quat; 8]) -> [f64; 27] {
    triquadratic(|k, l| [w[k].dot(w[l])]).map(|[v]| v)
}

impl CyclideVolume {
    /// Refuses a volume that passes through infinity: `|D|²` is triquadratic and has no zero where all its 27 Bernstein coefficients are
    /// positive; other cells are cut into eight, whose corner weights are values of `D`, exactly.
    ///
    /// # Errors
    /// `volume-through-infinity`.
    pub(in crate::volume) fn check_no_pole(&self) -> Result<()> {
        check_no_pole(&self.weights, usize::MAX)
    }
}

/// Refuses weights of a volume that passes through infinity, or of which so many cells do not prove that it does not.
///
/// # Errors
/// `volume-through-infinity`.
pub(in crate::volume) fn check_no_pole(weights: &[Quat; 8], mut cells: usize) -> Result<()> {
    match pole(weights, [0.0; 3], HALVINGS, &mut cells) {
        None => Ok(()),
        Some(at) => Err(VolumeError::ThroughInfinity { at }.into()),
    }
}

/// A place near which the denominator vanishes, or at which the number of cells to look at is used up.
fn pole(w: &[Quat; 8], from: [f64; 3], depth: u32, cells: &mut usize) -> Option<[f64; 3]> {
    if real_weights(w).iter().all(|&v| v > 0.0) {
        return None;
    }
    let size = 0.5f64.powi((HALVINGS - depth) as i32);
    if depth == 0 || *cells == 0 {
        return Some(from.map(|x| x + 0.5 * size));
    }
    *cells -= 1;
    (0..8).find_map(|octant| pole(&part(w, octant), at_octant(from, 0.5 * size, octant), depth - 1, cells))
}

/// The corner weights of one of the eight parts.
pub(super) fn part(w: &[Quat; 8], octant: usize) -> [Quat; 8] {
    let bit = |k: usize, axis: usize| (k >> axis & 1) as f64;
    std::array::from_fn(|k| trilinear(w, std::array::from_fn(|axis| 0.5 * (bit(octant, axis) + bit(k, axis)))))
}

/// The first corner of one of the eight parts of this size.
pub(super) fn at_octant(from: [f64; 3], size: f64, octant: usize) -> [f64; 3] {
    std::array::from_fn(|axis| from[axis] + size * (octant >> axis & 1) as f64)
}
