//! Normals over strides: bending and spread.

use crate::circular_mesh::neighbors::{along, vertices};
use cyclide::Vec3;
use cyclide::surface::QuadGrid;

/// Parts of the shorter direction over which bending is measured.
const PARTS: usize = 5;

/// The stride of the global numbers: a fifth of the shorter direction, at least two vertices. Over single edges noise of
/// a twentieth of an edge takes four fifths of the bending with it although the shape stays.
pub(super) fn coarse(grid: &QuadGrid) -> [usize; 2] {
    let [m, n] = grid.size();
    lowered(grid, (m.min(n) / PARTS).max(2))
}

/// A stride in both directions, shorter in those with few vertices.
pub(super) fn lowered(grid: &QuadGrid, stride: usize) -> [usize; 2] {
    grid.size().map(|size| stride.min((size - 1) / 2).max(1))
}

/// The sum of `|N(i+s) - N(i)|²` over both directions.
pub(super) fn bending(grid: &QuadGrid, normals: &[Vec3], stride: [usize; 2]) -> f64 {
    let mut sum = 0.0;
    let used = grid.used_vertices();
    for at in vertices(grid).filter(|at| used[grid.index(at[0], at[1])]) {
        for d in 0..2 {
            let on = at[d] + stride[d];
            if (grid.closed()[d] || on < grid.size()[d]) && used[along(grid, at, d, on)] {
                sum += (normals[along(grid, at, d, on)] - normals[grid.index(at[0], at[1])]).length_squared();
            }
        }
    }
    sum
}

/// How far the normals spread along the grid lines: for each direction the rms of `|N - mean of N on the line|`, the
/// larger of both.
pub(super) fn spread(grid: &QuadGrid, normals: &[Vec3]) -> f64 {
    let [m, n] = grid.size();
    let used = grid.used_vertices();
    let vertices = used.iter().filter(|used| **used).count();
    let of_lines = |lines: usize, count: usize, at: &dyn Fn(usize, usize) -> usize| {
        let mut sum = 0.0;
        for line in 0..lines {
            let on_line = || (0..count).map(|k| at(line, k)).filter(|k| used[*k]).map(|k| normals[k]);
            let mean = on_line().fold(Vec3::ZERO, |sum, normal| sum + normal) / on_line().count().max(1) as f64;
            sum += on_line().map(|normal| (normal - mean).length_squared()).sum::<f64>();
        }
        (sum / vertices as f64).sqrt()
    };
    let (rows, columns) = (of_lines(n, m, &|j, i| grid.index(i, j)), of_lines(m, n, &|i, j| grid.index(i, j)));
    rows.max(columns)
}
