//! How blocks of an object lie beside each other: in rows along s, t and u, open or closed.

use cyclide::volume::{CyclideVolume, StructuredGrid};
use std::collections::{BTreeMap, HashMap};

/// Blocks that hang together through faces, each with its place among them.
#[derive(Debug)]
pub(crate) struct Lattice {
    /// Blocks by their place.
    pub(crate) blocks: BTreeMap<[usize; 3], usize>,
    /// How many there are in each direction, at most.
    pub(crate) size: [usize; 3],
    /// Whether a direction comes back to where it starts.
    pub(crate) closed: [bool; 3],
}

/// The neighbors of a block: before and behind it along each direction.
type Neighbors = [[Option<usize>; 2]; 3];

impl Lattice {
    /// The lattices that blocks lie in, in the order of their first blocks; `None` for those that have no places in rows.
    ///
    /// # Errors
    /// As [`StructuredGrid::new`].
    pub(crate) fn all(blocks: &[CyclideVolume]) -> cyclide::Result<Vec<Option<Self>>> {
        let neighbors = neighbors(blocks)?;
        let mut lattices = Vec::new();
        let mut seen = vec![false; blocks.len()];
        for first in 0..blocks.len() {
            if !seen[first] {
                lattices.push(Self::from_block(first, &neighbors, &mut seen));
            }
        }
        Ok(lattices)
    }

    fn from_block(first: usize, neighbors: &[Neighbors], seen: &mut [bool]) -> Option<Self> {
        // Blocks along a closed direction; 0 along an open one.
        let period: [i64; 3] = std::array::from_fn(|axis| {
            let next = |block: &usize| neighbors[*block][axis][1];
            let row = std::iter::successors(next(&first), next).take(neighbors.len());
            row.zip(1..).find(|(block, _)| *block == first).map_or(0, |(_, count)| count)
        });
        let wrapped = |at: [i64; 3]| -> [i64; 3] {
            std::array::from_fn(|axis| if period[axis] > 0 { at[axis].rem_euclid(period[axis]) } else { at[axis] })
        };
        let mut places: HashMap<usize, [i64; 3]> = HashMap::from([(first, [0; 3])]);
        let mut row = vec![first];
        seen[first] = true;
        let mut in_rows = true;
        let mut next = 0;
        while let Some(&block) = row.get(next) {
            next += 1;
            for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]) {
                let Some(other) = neighbors[block][axis][end] else { continue };
                let mut at = places[&block];
                at[axis] += if end == 1 { 1 } else { -1 };
                let at = wrapped(at);
                if let Some(known) = places.get(&other) {
                    in_rows &= *known == at;
                } else {
                    seen[other] = true;
                    places.insert(other, at);
                    row.push(other);
                }
            }
        }
        let range = |axis: usize| {
            let along = || places.values().map(|at| at[axis]);
            (along().min().unwrap_or(0), along().max().unwrap_or(0))
        };
        let ranges = [range(0), range(1), range(2)];
        let place = |at: &[i64; 3]| std::array::from_fn(|axis| (at[axis] - ranges[axis].0) as usize);
        let blocks: BTreeMap<[usize; 3], usize> = places.iter().map(|(block, at)| (place(at), *block)).collect();
        in_rows &= blocks.len() == places.len();
        let size = ranges.map(|(first, last)| (last - first + 1) as usize);
        in_rows.then(|| Self { blocks, size, closed: period.map(|count| count > 0) })
    }

    /// The place of an index along a direction, which is beyond the last one only where it comes back.
    pub(crate) fn wrapped(&self, axis: usize, index: usize) -> usize {
        if self.closed[axis] { index % self.size[axis] } else { index.min(self.size[axis] - 1) }
    }
}

/// The neighbors of each block: those that have its face at the other end of the same direction.
fn neighbors(blocks: &[CyclideVolume]) -> cyclide::Result<Vec<Neighbors>> {
    // The node in the middle of a face is that of its neighbor.
    let halves = || vec![0.0, 0.5, 1.0];
    let grid = StructuredGrid::new(blocks, [halves(), halves(), halves()])?;
    let middle = |axis: usize, end: usize| 13 + [1, 3, 9][axis] * 2 * end - [1, 3, 9][axis];
    let mut faces: HashMap<(usize, usize), [Option<usize>; 2]> = HashMap::new();
    let middles: Vec<[[usize; 2]; 3]> = (0..blocks.len())
        .map(|block| {
            let nodes: Vec<usize> = grid.block_nodes(block).collect();
            std::array::from_fn(|axis| [0, 1].map(|end| nodes[middle(axis, end)]))
        })
        .collect();
    for (block, middles) in middles.iter().enumerate() {
        for (axis, ends) in middles.iter().enumerate() {
            for (end, node) in ends.iter().enumerate() {
                faces.entry((axis, *node)).or_default()[end] = Some(block);
            }
        }
    }
    let of_face = |axis: usize, node: usize, end: usize| faces.get(&(axis, node)).and_then(|blocks| blocks[1 - end]);
    let of_block = |middles: &[[usize; 2]; 3]| {
        std::array::from_fn(|axis| std::array::from_fn(|end| of_face(axis, middles[axis][end], end)))
    };
    Ok(middles.iter().map(of_block).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{surface::DupinCyclide, volume::CyclideGrid};

    #[test]
    fn rings_close_and_walls_do_not() {
        let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
        let grid = CyclideGrid::of_cyclide(&ring, [6, 4], &[-0.5, -0.2, 0.0]).unwrap();
        let blocks: Vec<CyclideVolume> = grid.blocks().collect();
        let [Some(lattice)] = &Lattice::all(&blocks).unwrap()[..] else { panic!("not in rows") };
        assert_eq!((lattice.size, lattice.closed), ([6, 4, 2], [true, true, false]));
        // Places follow the order of the grid, s fastest.
        assert!(lattice.blocks.iter().all(|([i, j, k], block)| *block == i + 6 * (j + 4 * k)));
        // Every second block along s is alone in its row.
        let apart: Vec<CyclideVolume> = blocks.iter().step_by(2).copied().collect();
        let lattices = Lattice::all(&apart).unwrap();
        assert_eq!(lattices.len(), 3);
        for lattice in lattices {
            let lattice = lattice.unwrap();
            assert_eq!((lattice.size, lattice.closed), ([1, 4, 2], [false, true, false]));
        }
    }
}
