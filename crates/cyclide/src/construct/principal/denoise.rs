//! Noise: how much there is, and vertices moved along their normals onto what is smooth.

use super::jets::{QUADRATIC, VertexJet, jets};
use super::mesh_table::MeshTable;
use crate::error::Result;

/// Residuals of the fits above this part of an edge of the grid count as noise.
pub(super) const NOISE_LIMIT: f64 = 1e-3;
/// Vertices of the smoothing fits.
const SMOOTHING_COUNT: usize = 80;

/// The median distance of vertices from the fit to their neighbours: of noise, not of a crease here and there.
pub(super) fn noise(jets: &[VertexJet]) -> f64 {
    let mut residuals: Vec<f64> = jets.iter().map(|jet| jet.residual).collect();
    residuals.sort_by(f64::total_cmp);
    residuals.get(residuals.len() / 2).copied().unwrap_or(0.0)
}

/// The mesh with every vertex moved once by the constant term of a quadratic fit to many neighbours.
///
/// # Errors
/// `not-a-surface`: a triangle lost its area.
pub(super) fn denoised(table: &MeshTable) -> Result<MeshTable> {
    let points: Vec<_> = jets(table, SMOOTHING_COUNT, QUADRATIC).iter().map(VertexJet::smoothed).collect();
    table.moved(&points)
}
