//! Is what bends in a grid noise?
//!
//! Neighboring second differences (along both directions and mixed) of a smooth surface agree, those of independent
//! errors of the vertices oppose each other: they share a vertex or two with opposite signs, which makes the cosine -2/3
//! along a line and -1/2 across. A grid is noise if its second differences along the normals, of each kind by itself,
//! oppose each other over single edges and over the stride of the global numbers: smooth shapes fail the first (ripples as
//! short as that stride too), noise on a base that is curved in any direction the second. (Own derivation.)

use crate::circular_mesh::neighbors::{along, around, clamped, pair, place, vertices};
use cyclide::surface::QuadGrid;
use cyclide::{Point3, Vec3};

/// Second differences that agree by less than this are noise: smooth shapes of four quads to a wave have 0.
const OPPOSED: f64 = -0.25;

/// The normals are those over the coarse stride.
pub(super) fn is_noise(grid: &QuadGrid, points: &[Point3], normals: &[Vec3], coarse: [usize; 2]) -> bool {
    [[1; 2], coarse].into_iter().all(|stride| {
        let mut found = agreements(grid, points, normals, stride).into_iter().flatten().peekable();
        found.peek().is_some() && found.all(|agreement| agreement < OPPOSED)
    })
}

/// The cosines between neighboring second differences along the normals, weighted by their sizes: along each direction,
/// and mixed; `None` where there are none.
fn agreements(grid: &QuadGrid, points: &[Point3], normals: &[Vec3], stride: [usize; 2]) -> [Option<f64>; 3] {
    let mut sums = [[0.0; 2]; 3];
    for at in vertices(grid) {
        let normal = normals[grid.index(at[0], at[1])];
        let mut compare = |kind: usize, [a, b]: [Option<Vec3>; 2]| {
            if let (Some(a), Some(b)) = (a, b) {
                let product = a.dot(normal) * b.dot(normal);
                sums[kind] = [sums[kind][0] + product, sums[kind][1] + product.abs()];
            }
        };
        for d in 0..2 {
            let Some(next) = next(grid, at, d, stride) else { continue };
            compare(d, [at, next].map(|at| bend(grid, points, at, d, stride)));
            compare(2, [at, next].map(|at| twist(grid, points, at, stride)));
        }
    }
    sums.map(|[agreement, size]| (size > 0.0).then(|| agreement / size))
}

/// The vertex a stride on.
fn next(grid: &QuadGrid, at: [usize; 2], d: usize, stride: [usize; 2]) -> Option<[usize; 2]> {
    let mut next = at;
    next[d] = if grid.closed()[d] {
        clamped(grid, at[d], d, stride[d])[1]
    } else {
        let after = pair(grid, at, d, stride[d])[1];
        place(grid, after)[d]
    };
    (grid.closed()[d] || next[d] == at[d] + stride[d]).then_some(next)
}

/// The second difference along a direction.
fn bend(grid: &QuadGrid, points: &[Point3], at: [usize; 2], d: usize, stride: [usize; 2]) -> Option<Vec3> {
    let [before, after] = around(grid, at, d, stride[d])?.map(|k| points[along(grid, at, d, k)]);
    let centre = points[grid.index(at[0], at[1])];
    Some((after - centre) - (centre - before))
}

/// The mixed second difference over the cell that starts at a vertex.
fn twist(grid: &QuadGrid, points: &[Point3], at: [usize; 2], stride: [usize; 2]) -> Option<Vec3> {
    let (s, t) = (next(grid, at, 0, stride)?, next(grid, at, 1, stride)?);
    next(grid, t, 0, stride)?;
    let point = |[i, j]: [usize; 2]| points[grid.index(i, j)];
    Some((point([s[0], t[1]]) - point(t)) - (point(s) - point(at)))
}
