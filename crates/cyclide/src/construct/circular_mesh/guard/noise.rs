//! Is what bends in a grid noise?
//!
//! Neighbouring second differences (along both directions and mixed) of a smooth surface agree, those of independent
//! errors of the vertices oppose each other: they share a vertex or two with opposite signs, which makes the cosine -2/3
//! along a line and -1/2 across. A grid is noise if its second differences oppose each other over single edges
//! and over the stride of the global numbers: smooth shapes fail the first (ripples as short as that stride too), noise on a
//! curved base the second. (Own derivation.)

use crate::base::vector::{Point3, Vec3};
use crate::construct::circular_mesh::neighbours::{along, around, clamped, vertices};
use crate::surface::QuadGrid;

/// Second differences that agree by less than this are noise: smooth shapes of four quads to a wave have 0.
const OPPOSED: f64 = -0.25;

pub(super) fn is_noise(grid: &QuadGrid, points: &[Point3], coarse: [usize; 2]) -> bool {
    [[1; 2], coarse].into_iter().all(|stride| agreement(grid, points, stride).is_some_and(|a| a < OPPOSED))
}

/// The cosine between neighbouring second differences, weighted by their sizes; `None` if there are none.
fn agreement(grid: &QuadGrid, points: &[Point3], stride: [usize; 2]) -> Option<f64> {
    let (mut agreement, mut size) = (0.0, 0.0);
    let mut compare = |[a, b]: [Option<Vec3>; 2]| {
        if let (Some(a), Some(b)) = (a, b) {
            agreement += a.dot(b);
            size += a.length() * b.length();
        }
    };
    for at in vertices(grid) {
        for d in 0..2 {
            let Some(next) = next(grid, at, d, stride) else { continue };
            compare([at, next].map(|at| bend(grid, points, at, d, stride)));
            compare([at, next].map(|at| twist(grid, points, at, stride)));
        }
    }
    (size > 0.0).then(|| agreement / size)
}

/// The vertex a stride on.
fn next(grid: &QuadGrid, at: [usize; 2], d: usize, stride: [usize; 2]) -> Option<[usize; 2]> {
    let exists = grid.closed()[d] || at[d] + stride[d] < grid.size()[d];
    exists.then(|| {
        let mut next = at;
        next[d] = clamped(grid, at[d], d, stride[d])[1];
        next
    })
}

/// The second difference along a direction.
fn bend(grid: &QuadGrid, points: &[Point3], at: [usize; 2], d: usize, stride: [usize; 2]) -> Option<Vec3> {
    let [before, after] = around(grid, at[d], d, stride[d])?.map(|k| points[along(grid, at, d, k)]);
    let centre = points[grid.index(at[0], at[1])];
    Some((after - centre) - (centre - before))
}

/// The mixed second difference over the cell that starts at a vertex.
fn twist(grid: &QuadGrid, points: &[Point3], at: [usize; 2], stride: [usize; 2]) -> Option<Vec3> {
    let (s, t) = (next(grid, at, 0, stride)?, next(grid, at, 1, stride)?);
    let point = |[i, j]: [usize; 2]| points[grid.index(i, j)];
    Some((point([s[0], t[1]]) - point(t)) - (point(s) - point(at)))
}
