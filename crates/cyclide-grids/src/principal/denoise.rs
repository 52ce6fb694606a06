//! Noise: how much there is, and vertices moved along their normals onto what is smooth.

use super::jets::{QUADRATIC, VertexJet, jets};
use super::mesh_table::MeshTable;
use super::shape_tensors::median;
use cyclide::Point3;
use cyclide::Result;

/// Residuals of the fits above this part of an edge of the grid count as noise.
const NOISE_LIMIT: f64 = 1e-3;
/// Smoothing noise away moves vertices by about the residuals of the fits, at the middle by 0.9 of them. What a cubic misses of a curved
/// surface under a coarse mesh grows so fast with the radius that smoothing it would move them by 6 to 22 residuals.
const MOST_MOVE: f64 = 3.0;
/// Vertices of the smoothing fits.
const SMOOTHING_COUNT: usize = 80;

/// By how much noise alone makes the principal curvatures differ, in the median, times half as much again: in residuals of the fits over
/// the square of the distance of neighbors. The first of noise as it is, in fits to 24, which makes 0.5 to 0.6; the second of noise
/// smoothed away, in fits to 40, which makes 0.06 to 0.085.
const DIFFERENCE: [f64; 2] = [0.9, 0.13];

/// The difference of the principal curvatures that noise alone may make.
pub(super) fn difference(table: &MeshTable, noise: f64, smoothed_away: bool) -> f64 {
    let of_vertex = table.areas.iter().sum::<f64>() / table.points.len() as f64;
    DIFFERENCE[usize::from(smoothed_away)] * noise / of_vertex
}

/// The median distance of vertices from the fit to their neighbors: of noise, not of a crease here and there.
pub(super) fn noise(jets: &[VertexJet]) -> f64 {
    median(&jets.iter().map(|jet| jet.residual).collect::<Vec<_>>())
}

/// The mesh with every vertex moved once by the constant term of a quadratic fit to many neighbors: if `wanted`, or if nothing is said
/// and there is noise beside this edge.
///
/// # Errors
/// `not-a-surface`: a triangle lost its area.
pub(super) fn denoised(table: &MeshTable, noise: f64, edge: f64, wanted: Option<bool>) -> Result<Option<MeshTable>> {
    if !wanted.unwrap_or(noise > NOISE_LIMIT * edge) {
        return Ok(None);
    }
    let points = smoothed(table);
    if wanted.is_none() && !explains(noise, table, &points) {
        return Ok(None);
    }
    table.moved(&points).map(Some)
}

/// Whether the residuals of the fits are noise, not shape.
pub(super) fn is_noise(table: &MeshTable, noise: f64) -> bool {
    explains(noise, table, &smoothed(table))
}

fn smoothed(table: &MeshTable) -> Vec<Point3> {
    jets(table, SMOOTHING_COUNT, QUADRATIC).iter().map(VertexJet::smoothed).collect()
}

fn explains(noise: f64, table: &MeshTable, smoothed: &[Point3]) -> bool {
    let moves: Vec<f64> = smoothed.iter().zip(&table.points).map(|(p, q)| p.distance(*q)).collect();
    median(&moves) <= MOST_MOVE * noise
}
