//! An order of the vertices in which the equations of a grid fill in little: nested dissection (George 1973).
//!
//! Two neighbouring grid lines separate the rest, because no equation reaches over them: quads reach one vertex far,
//! second differences two. The halves come first, each ordered in the same way, the separator last.

use crate::surface::QuadGrid;

/// Pieces of at most so many vertices along each direction are not cut further.
const LEAF: usize = 4;
/// Grid lines of a separator.
const WIDTH: usize = 2;

/// A rectangle of vertices: first and past the last one in each direction.
type Piece = [[usize; 2]; 2];

/// All vertices, in the order of elimination.
pub(super) fn order(grid: &QuadGrid) -> Vec<usize> {
    let [m, n] = grid.size();
    let mut piece: Piece = [[0, m], [0, n]];
    let mut rings = Vec::new();
    for d in 0..2 {
        // A ring is opened by its last two lines.
        if grid.closed()[d] {
            let cut = piece[d][1].saturating_sub(WIDTH);
            let mut separator = piece;
            (separator[d][0], piece[d][1]) = (cut, cut);
            rings.push(separator);
        }
    }
    let mut order = Vec::with_capacity(m * n);
    dissect(grid, piece, &mut order);
    rings.into_iter().rev().for_each(|separator| append(grid, separator, &mut order));
    order
}

fn dissect(grid: &QuadGrid, piece: Piece, order: &mut Vec<usize>) {
    let length = piece.map(|[from, to]| to - from);
    let d = usize::from(length[1] > length[0]);
    if length[d] <= LEAF {
        return append(grid, piece, order);
    }
    let cut = piece[d][0] + (length[d] - WIDTH) / 2;
    let part = |from: usize, to: usize| {
        let mut part = piece;
        part[d] = [from, to];
        part
    };
    dissect(grid, part(piece[d][0], cut), order);
    dissect(grid, part(cut + WIDTH, piece[d][1]), order);
    append(grid, part(cut, cut + WIDTH), order);
}

fn append(grid: &QuadGrid, [[i0, i1], [j0, j1]]: Piece, order: &mut Vec<usize>) {
    order.extend((j0..j1).flat_map(|j| (i0..i1).map(move |i| grid.index(i, j))));
}
