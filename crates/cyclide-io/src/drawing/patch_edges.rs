//! The edges of patches in a mesh of triangles.

use std::collections::{HashMap, HashSet};
use std::hash::Hash;

/// Sides of triangles that have no other triangle of the same patch beside them, each once, in the order of the
/// triangles: the triangle, and the corner where the side begins. A triangle comes with its patch and the keys of its
/// corners; corners with equal keys are one vertex, and a triangle with two of these is none.
pub(crate) fn patch_edges<P: Eq + Hash + Copy, K: Eq + Hash>(
    triangles: impl Iterator<Item = (P, [K; 3])>,
) -> Vec<(usize, usize)> {
    let mut vertices: HashMap<K, usize> = HashMap::new();
    // Sides by their patch and their two vertices, with the number of triangles that have them.
    let mut sides: HashMap<(P, [usize; 2]), usize> = HashMap::new();
    let mut found: Vec<((usize, usize), [usize; 2], usize)> = Vec::new();
    for (number, (patch, keys)) in triangles.enumerate() {
        let corners = keys.map(|key| {
            let next = vertices.len();
            *vertices.entry(key).or_insert(next)
        });
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            continue;
        }
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let [a, b] = [corners[from], corners[to]];
            let ends = [a.min(b), a.max(b)];
            let index = *sides.entry((patch, ends)).or_insert(found.len());
            match found.get_mut(index) {
                Some((_, _, count)) => *count += 1,
                None => found.push(((number, from), ends, 1)),
            }
        }
    }
    // A line between two patches is one.
    let mut drawn = HashSet::new();
    found.into_iter().filter(|(_, ends, count)| count % 2 == 1 && drawn.insert(*ends)).map(|(side, ..)| side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_two_patches() {
        // A square of two triangles and a triangle of another patch at one of its sides.
        let triangles = [(0, [0, 1, 2]), (0, [0, 2, 3]), (1, [2, 1, 4])];
        assert_eq!(patch_edges(triangles.into_iter()), [(0, 0), (0, 1), (1, 1), (1, 2), (2, 1), (2, 2)]);
    }

    /// A triangle that has become a line is beside nothing: the border there is that of its neighbor.
    #[test]
    fn triangles_without_area_have_no_sides() {
        let around = [(0, [0, 1, 2]), (0, [0, 2, 2]), (0, [2, 1, 1])];
        assert_eq!(patch_edges(around.into_iter()), [(0, 0), (0, 1), (0, 2)]);
        // Between two triangles it closes the gap.
        let between = [(0, [0, 1, 2]), (0, [0, 2, 2]), (0, [0, 2, 3])];
        assert_eq!(patch_edges(between.into_iter()), [(0, 0), (0, 1), (2, 1), (2, 2)]);
    }
}
