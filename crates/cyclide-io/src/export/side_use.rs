//! How the polygons of a mesh hang together: the sides that two of them share, and those that one has alone.

use std::collections::HashMap;
use std::hash::Hash;

/// The sides of a mesh that are not used once in each direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct SideUse {
    /// Uses of a side without another one the other way: the border.
    pub(crate) free: usize,
    /// Uses of a side beyond the first in one direction.
    pub(crate) repeated: usize,
}

/// The lower and the higher vertex of a side, and in the last bit whether the polygon runs up: one number, as there are
/// millions to be sorted. Vertices are counted far below 2^31, which would not fit into memory.
type Side = u64;

fn side(a: usize, b: usize) -> Side {
    ((a.min(b) as Side) << 32) | ((a.max(b) as Side) << 1) | Side::from(a < b)
}

/// Counts the sides of polygons; corners with equal keys are one vertex. Sides of no length are none, and a polygon of
/// fewer than three vertices has no sides.
pub(crate) fn side_use<P, K>(polygons: impl Iterator<Item = P>) -> SideUse
where
    P: IntoIterator<Item = K>,
    K: Eq + Hash,
{
    let mut vertices: HashMap<K, usize> = HashMap::new();
    let mut corners: Vec<usize> = Vec::with_capacity(4);
    let mut sides: Vec<Side> = Vec::new();
    for polygon in polygons {
        corners.clear();
        for key in polygon {
            let next = vertices.len();
            corners.push(*vertices.entry(key).or_insert(next));
        }
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        if let ([first, .., last], 3..) = (corners.as_slice(), corners.len()) {
            let closing = std::iter::once((*last, *first));
            let pairs = corners.windows(2).map(|w| (w[0], w[1])).chain(closing);
            sides.extend(pairs.map(|(a, b)| side(a, b)));
        }
    }
    sides.sort_unstable();
    let mut found = SideUse::default();
    for uses in sides.chunk_by(|a, b| a >> 1 == b >> 1) {
        let up = uses.iter().filter(|side| **side & 1 == 1).count();
        let down = uses.len() - up;
        found.free += up.abs_diff(down);
        found.repeated += up.saturating_sub(1) + down.saturating_sub(1);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_of_two_triangles() {
        let count = |polygons: [[u8; 3]; 2]| {
            let SideUse { free, repeated } = side_use(polygons.into_iter());
            [free, repeated]
        };
        assert_eq!(count([[0, 1, 2], [2, 1, 3]]), [4, 0]);
        // Of one reversed the common side runs twice the same way, and neither use has its other.
        assert_eq!(count([[0, 1, 2], [1, 2, 3]]), [6, 1]);
        assert_eq!(count([[0, 1, 2], [4, 5, 6]]), [6, 0]);
        assert_eq!(count([[0, 1, 2], [1, 0, 2]]), [0, 0]);
        // A flat one has no sides.
        assert_eq!(count([[0, 1, 2], [1, 1, 3]]), [3, 0]);
        assert_eq!(count([[0, 1, 2], [1, 3, 1]]), [3, 0]);
    }
}
