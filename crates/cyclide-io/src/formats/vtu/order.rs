//! The order of the nodes of VTK's Bézier cells, as index triples of control points.
//!
//! Corners first, then the insides of edges, of faces, and the inside; compared entry by entry with VTK's own index functions.

use crate::export::rational_cells::Degrees;

/// VTK's number for plain hexahedra, and their corners in binary order.
pub(super) const KIND: u8 = 12;
pub(super) const ORDER: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

/// The indices `[i, j, k]` of the control points of a cell in the order of its nodes.
pub(super) fn nodes([p, q, r]: Degrees) -> Vec<[usize; 3]> {
    match (q, r) {
        (0, _) => {
            let inside = (1..p).map(|i| [i, 0, 0]);
            [[0, 0, 0], [p, 0, 0]].into_iter().chain(inside).collect()
        }
        (_, 0) => {
            let mut nodes = corners(p, q, 0).to_vec();
            push_edges(&mut nodes, p, q, 0);
            nodes.extend((1..q).flat_map(|j| (1..p).map(move |i| [i, j, 0])));
            nodes
        }
        _ => hexahedron(p, q, r),
    }
}

fn hexahedron(p: usize, q: usize, r: usize) -> Vec<[usize; 3]> {
    let mut nodes = [corners(p, q, 0), corners(p, q, r)].concat();
    push_edges(&mut nodes, p, q, 0);
    push_edges(&mut nodes, p, q, r);
    for [i, j, _] in corners(p, q, 0) {
        nodes.extend((1..r).map(|k| [i, j, k]));
    }
    for i in [0, p] {
        nodes.extend((1..r).flat_map(|k| (1..q).map(move |j| [i, j, k])));
    }
    for j in [0, q] {
        nodes.extend((1..r).flat_map(|k| (1..p).map(move |i| [i, j, k])));
    }
    for k in [0, r] {
        nodes.extend((1..q).flat_map(|j| (1..p).map(move |i| [i, j, k])));
    }
    nodes.extend((1..r).flat_map(|k| (1..q).flat_map(move |j| (1..p).map(move |i| [i, j, k]))));
    nodes
}

/// The corners of a sheet, round.
fn corners(p: usize, q: usize, k: usize) -> [[usize; 3]; 4] {
    [[0, 0, k], [p, 0, k], [p, q, k], [0, q, k]]
}

/// The insides of the four edges of a sheet; opposite ones run the same way.
fn push_edges(nodes: &mut Vec<[usize; 3]>, p: usize, q: usize, k: usize) {
    nodes.extend((1..p).map(|i| [i, 0, k]));
    nodes.extend((1..q).map(|j| [p, j, k]));
    nodes.extend((1..p).map(|i| [i, q, k]));
    nodes.extend((1..q).map(|j| [0, j, k]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_in_the_order_of_vtk() {
        // Rows j = 0, 1, 2 of a biquadratic: 0 4 1 / 7 8 5 / 3 6 2.
        let rows = [[0, 4, 1], [7, 8, 5], [3, 6, 2]];
        for (node, [i, j, _]) in nodes([2, 2, 0]).into_iter().enumerate() {
            assert_eq!(rows[j][i], node);
        }
        assert_eq!(nodes([3, 0, 0]), [[0, 0, 0], [3, 0, 0], [1, 0, 0], [2, 0, 0]]);
        for degrees in [[4, 2, 0], [12, 2, 0], [2, 2, 2], [4, 3, 2]] {
            let mut all = nodes(degrees);
            assert_eq!(all.len(), degrees.iter().map(|d| d + 1).product::<usize>());
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), degrees.iter().map(|d| d + 1).product::<usize>(), "{degrees:?}");
        }
        assert_eq!(
            nodes([2, 2, 2])[20..],
            [[0, 1, 1], [2, 1, 1], [1, 0, 1], [1, 2, 1], [1, 1, 0], [1, 1, 2], [1, 1, 1]]
        );
    }
}
