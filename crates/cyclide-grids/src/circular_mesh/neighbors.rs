//! Vertices next to each other in a grid, at any stride; counted round in closed directions.

use cyclide::surface::QuadGrid;

/// Indices of all vertices, s fastest.
pub(super) fn vertices(grid: &QuadGrid) -> impl Iterator<Item = [usize; 2]> + use<> {
    let [m, n] = grid.size();
    (0..n).flat_map(move |j| (0..m).map(move |i| [i, j]))
}

/// Position and count of a vertex by its index.
pub(super) fn place(grid: &QuadGrid, vertex: usize) -> [usize; 2] {
    [vertex % grid.size()[0], vertex / grid.size()[0]]
}

/// The places before and after place `k` of a direction of the whole rectangle, a stride away; the last ones of an open direction
/// where it ends sooner.
pub(super) fn clamped(grid: &QuadGrid, k: usize, direction: usize, stride: usize) -> [usize; 2] {
    let size = grid.size()[direction];
    if grid.closed()[direction] {
        return [(k + size - stride % size) % size, (k + stride) % size];
    }
    [k.saturating_sub(stride), (k + stride).min(size - 1)]
}

/// As [`clamped`], of a vertex, and no farther than the edges of the grid's quads lead.
fn reached(grid: &QuadGrid, at: [usize; 2], direction: usize, stride: usize) -> [usize; 2] {
    let whole = clamped(grid, at[direction], direction, stride);
    if grid.is_whole() {
        return whole;
    }
    let edge = |k: usize| {
        let mut start = at;
        start[direction] = k;
        grid.has_edge(start, direction)
    };
    let here = at[direction];
    let before = (whole[0]..here).rev().take_while(|k| edge(*k)).last().unwrap_or(here);
    let after = (here..whole[1]).take_while(|k| edge(*k)).last().map_or(here, |k| k + 1);
    [before, after]
}

/// The same, if the grid does not end sooner.
pub(super) fn around(grid: &QuadGrid, at: [usize; 2], direction: usize, stride: usize) -> Option<[usize; 2]> {
    let k = at[direction];
    if grid.closed()[direction] {
        return Some(clamped(grid, k, direction, stride));
    }
    let found = reached(grid, at, direction, stride);
    (k >= stride && found == [k - stride, k + stride]).then_some(found)
}

/// The index of a vertex one or more places from `[i, j]` along a direction.
pub(super) fn along(grid: &QuadGrid, [i, j]: [usize; 2], direction: usize, k: usize) -> usize {
    if direction == 0 { grid.index(k, j) } else { grid.index(i, k) }
}

/// The vertices before and after `at` along a direction, at the border those where the grid ends.
pub(super) fn pair(grid: &QuadGrid, at: [usize; 2], direction: usize, stride: usize) -> [usize; 2] {
    reached(grid, at, direction, stride).map(|k| along(grid, at, direction, k))
}
