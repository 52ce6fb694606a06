//! The Study form between poses, and the numbers that are made of it.

use super::dual_quat::DualQuat;

/// Forms up to this part of the size of the poses are zero: all relative displacements are rotations or translations.
const VANISHED: f64 = 1e-12;
/// Forms up to this are zero of poses that are written with six decimals: each of the eight products of a form is off by half a unit of the last one.
pub(super) const ROUNDED: f64 = 5e-6;
/// Roundings of the largest coordinate that a form may consist of: its translations are rounded when given and when taken about the centroid.
const ROUNDINGS: f64 = 8.0;

/// Forms up to this are zero where they may be off by a [rounding]: far from the origin coordinates have lost digits that no change of frame
/// brings back.
pub(super) fn vanished(rounding: f64) -> f64 {
    VANISHED.max(rounding)
}

/// What a form may be off by between poses in this unit, the largest coordinate of whose translations is `farthest`.
pub(super) fn rounding(farthest: f64, unit: f64) -> f64 {
    ROUNDINGS * f64::EPSILON * (farthest / unit)
}

/// `B_ij = p_i·r_j + r_i·p_j` of all pairs; zero on the diagonal.
pub(super) fn forms<const N: usize>(poses: &[DualQuat; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 0.0 } else { poses[i].study_form(poses[j]) }))
}

/// The largest entry by size.
pub(super) fn largest<const N: usize>(matrix: &[[f64; N]; N]) -> f64 {
    matrix.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// `B_ij/(t_i − t_j)`, antisymmetric.
pub(super) fn over_times<const N: usize>(forms: &[[f64; N]; N], times: &[f64; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 0.0 } else { forms[i][j] / (times[i] - times[j]) }))
}

/// The Pfaffian of four rows and columns of an antisymmetric matrix.
pub(super) fn pfaffian<const N: usize>(m: &[[f64; N]; N], [a, b, c, d]: [usize; 4]) -> f64 {
    m[a][b] * m[c][d] - m[a][c] * m[b][d] + m[a][d] * m[b][c]
}
