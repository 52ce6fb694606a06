//! Vertices next to each other in a grid, at any stride; counted round in closed directions.

use crate::surface::QuadGrid;

/// Indices of all vertices, s fastest.
pub(super) fn vertices(grid: &QuadGrid) -> impl Iterator<Item = [usize; 2]> + use<> {
    let [m, n] = grid.size();
    (0..n).flat_map(move |j| (0..m).map(move |i| [i, j]))
}

/// Position and count of a vertex by its index.
pub(super) fn place(grid: &QuadGrid, vertex: usize) -> [usize; 2] {
    [vertex % grid.size()[0], vertex / grid.size()[0]]
}

/// The places before and after place `k` of a direction, a stride away; the last ones of an open direction where
/// it ends sooner.
pub(super) fn clamped(grid: &QuadGrid, k: usize, direction: usize, stride: usize) -> [usize; 2] {
    let size = grid.size()[direction];
    if grid.closed()[direction] {
        return [(k + size - stride % size) % size, (k + stride) % size];
    }
    [k.saturating_sub(stride), (k + stride).min(size - 1)]
}

/// The same, if the direction does not end sooner.
pub(super) fn around(grid: &QuadGrid, k: usize, direction: usize, stride: usize) -> Option<[usize; 2]> {
    let inside = grid.closed()[direction] || (k >= stride && k + stride < grid.size()[direction]);
    inside.then(|| clamped(grid, k, direction, stride))
}

/// The index of a vertex one or more places from `[i, j]` along a direction.
pub(super) fn along(grid: &QuadGrid, [i, j]: [usize; 2], direction: usize, k: usize) -> usize {
    if direction == 0 { grid.index(k, j) } else { grid.index(i, k) }
}

/// The vertices before and after `at` along a direction, as [`clamped`].
pub(super) fn pair(grid: &QuadGrid, at: [usize; 2], direction: usize, stride: usize) -> [usize; 2] {
    clamped(grid, at[direction], direction, stride).map(|k| along(grid, at, direction, k))
}
