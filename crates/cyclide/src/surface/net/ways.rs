//! The order in which frames are carried from vertex to vertex of a grid.

use crate::surface::quad_grid::QuadGrid;
use std::collections::VecDeque;

/// A step along an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Way {
    /// The vertex where it starts, and that to which it leads.
    pub(super) before: usize,
    pub(super) to: usize,
    /// 0 along s, 1 along t.
    pub(super) direction: usize,
    /// Whether it leads to the growing side.
    pub(super) forward: bool,
}

impl Way {
    /// One step to each vertex but the first: of a whole grid along the first row and from it along the columns, else from the
    /// first vertex of a quad along the fewest edges.
    pub(super) fn all(grid: &QuadGrid) -> Vec<Self> {
        if grid.is_whole() { along_columns(grid) } else { along_edges(grid) }
    }
}

fn along_columns(grid: &QuadGrid) -> Vec<Way> {
    let [m, n] = grid.size();
    let step = |(i, j): (usize, usize)| {
        let (before, direction) = if j == 0 { (grid.index(i - 1, 0), 0) } else { (grid.index(i, j - 1), 1) };
        Way { before, to: grid.index(i, j), direction, forward: true }
    };
    (0..n).flat_map(|j| (0..m).map(move |i| (i, j))).skip(1).map(step).collect()
}

fn along_edges(grid: &QuadGrid) -> Vec<Way> {
    let [m, n] = grid.size();
    let used = grid.used_vertices();
    let Some(first) = used.iter().position(|used| *used) else { return Vec::new() };
    let mut reached = vec![false; m * n];
    reached[first] = true;
    let (mut ways, mut open) = (Vec::new(), VecDeque::from([first]));
    while let Some(before) = open.pop_front() {
        let at = [before % m, before / m];
        for (direction, forward) in [(0, true), (1, true), (0, false), (1, false)] {
            let mut next = at;
            if forward {
                next[direction] += 1;
            } else if at[direction] > 0 {
                next[direction] -= 1;
            } else {
                continue;
            }
            if !grid.has_edge(if forward { at } else { next }, direction) {
                continue;
            }
            let to = grid.index(next[0], next[1]);
            if !std::mem::replace(&mut reached[to], true) {
                ways.push(Way { before, to, direction, forward });
                open.push_back(to);
            }
        }
    }
    ways
}
