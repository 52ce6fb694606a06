//! The fairness metric of a step: how much it bends the grid lines, slides on the surface and leaves it.
//!
//! ```text
//! M = (L^T L (x) I3 + blockdiag(wt (I - n n^T) + wn n n^T)) / h²     wt = 1e-3, wn = 0.1
//! ```
//! with the second differences L along both grid directions, the vertex normals n of the input and its median edge h
//! (`docs/math/circular-meshes.md#metric`). Without the first term the steps crumple steep or fine grids and the search
//! diverges.

use super::block::Block;
use super::neighbors::place;
use super::normal_equations::{BlockMatrix, Pattern};
use cyclide::Vec3;
use cyclide::surface::QuadGrid;

/// Weight of a move along the surface.
const SLIDE: f64 = 1e-3;
/// Weight of a move off the surface: a hundredth of it flattens the surface, ten times it makes quads cross.
const LEAVE: f64 = 0.1;

/// Vertices next to each other along each grid line, three by three.
pub(super) fn triples(grid: &QuadGrid) -> Vec<[usize; 3]> {
    let [m, n] = grid.size();
    let inner = |d: usize| if grid.closed()[d] { grid.size()[d] } else { grid.size()[d].saturating_sub(2) };
    let along_s = (0..n).flat_map(|j| (0..inner(0)).map(move |i| [0, 1, 2].map(|k| grid.index(i + k, j))));
    let along_t = (0..inner(1)).flat_map(|j| (0..m).map(move |i| [0, 1, 2].map(|k| grid.index(i, j + k))));
    let is_line = |t: &[usize; 3], d: usize| t[..2].iter().all(|k| grid.has_edge(place(grid, *k), d));
    along_s.filter(|t| is_line(t, 0)).chain(along_t.filter(|t| is_line(t, 1))).collect()
}

/// The metric M; a vertex without a normal slides in every direction.
pub(super) fn metric(pattern: &Pattern, triples: &[[usize; 3]], normals: &[Option<Vec3>], edge: f64) -> BlockMatrix {
    let mut metric = pattern.zero();
    let scale = 1.0 / (edge * edge);
    let second_difference = [1.0, -2.0, 1.0];
    for triple in triples {
        for i in 0..3 {
            for j in 0..=i {
                let weight = scale * second_difference[i] * second_difference[j];
                pattern.add(&mut metric, triple[i], triple[j], Block::IDENTITY * weight);
            }
        }
    }
    for (v, normal) in normals.iter().enumerate() {
        let off = normal.map_or(Block::ZERO, Block::square);
        pattern.add(&mut metric, v, v, (Block::IDENTITY * SLIDE + off * (LEAVE - SLIDE)) * scale);
    }
    metric
}
