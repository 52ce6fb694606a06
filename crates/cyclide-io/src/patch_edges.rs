//! The edges of patches in a mesh of triangles.

use std::collections::HashMap;
use std::hash::Hash;

/// Sides of triangles that have no other triangle of the same patch beside them, each once, in the order of the
/// triangles: the triangle, and the corner where the side begins. A triangle comes with its patch and the keys of its
/// corners; corners with equal keys are one vertex, and a side from a vertex to itself is none.
pub(crate) fn patch_edges<P: PartialEq + Copy, K: Eq + Hash>(
    triangles: impl Iterator<Item = (P, [K; 3])>,
) -> Vec<(usize, usize)> {
    // Sides by their two vertices: the patch they belong to, and whether another one of it was met.
    let mut vertices: HashMap<K, usize> = HashMap::new();
    let mut sides: HashMap<[usize; 2], usize> = HashMap::new();
    let mut found: Vec<((usize, usize), P, bool)> = Vec::new();
    for (number, (patch, keys)) in triangles.enumerate() {
        let corners = keys.map(|key| {
            let next = vertices.len();
            *vertices.entry(key).or_insert(next)
        });
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let [a, b] = [corners[from], corners[to]];
            if a == b {
                continue;
            }
            let index = *sides.entry([a.min(b), a.max(b)]).or_insert(found.len());
            match found.get_mut(index) {
                Some((_, first, inner)) => *inner = *first == patch,
                None => found.push(((number, from), patch, false)),
            }
        }
    }
    found.into_iter().filter(|(_, _, inner)| !inner).map(|(side, _, _)| side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_two_patches() {
        // A square of two triangles and a triangle of another patch at one of its sides; a sliver has one side only.
        let triangles = [(0, [0, 1, 2]), (0, [0, 2, 3]), (1, [2, 1, 4]), (1, [4, 4, 2])];
        assert_eq!(patch_edges(triangles.into_iter()), [(0, 0), (0, 1), (1, 1), (1, 2), (2, 1)]);
    }
}
