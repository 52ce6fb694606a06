//! The block of a volume as a solid: six patches with shared edges; the outer boundary of many.

use super::{Body, Sewing, Shell};
use crate::error::{Error, ErrorItem, Result};
use crate::volume::{CyclideVolume, FoldVerdict, StructuredGrid};
use std::collections::HashMap;

/// Halves in every direction: the middles of sides and faces are nodes, by which these are told.
const HALVES: [f64; 3] = [0.0, 0.5, 1.0];

impl CyclideVolume {
    /// The block as a solid of its six [faces](Self::faces): s = 0, s = 1, t = 0, t = 1, u = 0, u = 1, outside outwards. Faces that are a line, of a wedge,
    /// are none of it.
    ///
    /// # Errors
    /// As [`Shell::new`](super::Shell::new).
    pub fn to_body(&self) -> Result<Body> {
        sewn(std::slice::from_ref(self), false)?.finish_body()
    }

    /// The outer boundary of blocks that share faces, as bodies: the faces that belong to one block only, sewn along their sides. A solid for everything
    /// that hangs together, with the hollows inside it.
    ///
    /// ```
    /// use cyclide::{CyclideGrid, CyclideVolume, DupinCyclide};
    /// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?;
    /// let wall: Vec<_> = CyclideGrid::of_cyclide(&torus, [4, 4], &[-0.5, -0.2, 0.0])?.blocks().collect();
    /// let skin = CyclideVolume::outer_bodies(&wall)?.remove(0);
    /// assert_eq!((skin.outer.faces().len(), skin.voids.len()), (16, 1)); // of 192 faces
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shell::new`]; `too-few-points` if there is no block, `folded-volume` with the block if one [folds](Self::folds).
    pub fn outer_bodies(blocks: &[Self]) -> Result<Vec<Body>> {
        for (index, block) in blocks.iter().enumerate() {
            if let FoldVerdict::Folded { at } = block.folds() {
                return Err(Error::FoldedVolume { at }.in_block(index));
            }
        }
        solids(sewn(blocks, true)?.finish_apart()?)
    }
}

/// The faces of blocks with their sides, each once; or only those faces that one block has alone.
fn sewn(blocks: &[CyclideVolume], alone: bool) -> Result<Sewing> {
    let grid = StructuredGrid::new(blocks, [HALVES.to_vec(), HALVES.to_vec(), HALVES.to_vec()])?;
    let nodes: Vec<Vec<usize>> = (0..blocks.len()).map(|block| grid.block_nodes(block).collect()).collect();
    let mut count: HashMap<usize, usize> = HashMap::new();
    for middle in nodes.iter().flat_map(|nodes| (0..6).map(|face| nodes[middle_of_face(face)])) {
        *count.entry(middle).or_default() += 1;
    }
    let mut sewing = Sewing::default();
    let (mut vertices, mut edges) = (HashMap::new(), HashMap::new());
    for (block, nodes) in blocks.iter().zip(&nodes) {
        for (face, patch) in block.faces().into_iter().enumerate() {
            let (axis, end) = (face / 2, face % 2);
            let (middle, around) = (nodes[middle_of_face(face)], sides_of_face(axis, end));
            // The middle of a face that is a line is that of a side.
            let is_line = around.iter().any(|side| nodes[side.middle()] == middle);
            if is_line || alone && count.get(&middle) != Some(&1) {
                continue;
            }
            let mut sides = [None; 4];
            for (side, edge) in sides.iter_mut().zip(around) {
                let [from, to] = edge.ends().map(|at| nodes[at]);
                let middle = nodes[edge.middle()];
                if from == to && middle == from {
                    continue;
                }
                let place = |node: usize, sewing: &mut Sewing| sewing.vertex(grid.nodes()[node]);
                let from = *vertices.entry(from).or_insert_with(|| place(from, &mut sewing));
                let to = *vertices.entry(to).or_insert_with(|| place(to, &mut sewing));
                *side = Some(match edges.get(&middle) {
                    Some(&edge) => edge,
                    None => {
                        let made = sewing.edge(from, to, block.line(edge.axis, edge.at.map(|x| 0.5 * x as f64))?);
                        edges.insert(middle, made);
                        made
                    }
                });
            }
            let along = (axis != 1) == block.is_right_handed();
            sewing.face(patch, sides, along == (end == 1));
        }
    }
    Ok(sewing)
}

/// A side of a block: its direction, and its places in the two other ones, in order, as nodes 0 or 2 of three.
#[derive(Clone, Copy)]
struct Edge {
    axis: usize,
    at: [usize; 2],
}

impl Edge {
    fn node(self, along: usize) -> usize {
        let [x, y] = self.at;
        let at = match self.axis {
            0 => [along, x, y],
            1 => [x, along, y],
            _ => [x, y, along],
        };
        at[0] + 3 * at[1] + 9 * at[2]
    }

    fn ends(self) -> [usize; 2] {
        [self.node(0), self.node(2)]
    }

    fn middle(self) -> usize {
        self.node(1)
    }
}

/// The sides at t = 0, t = 1, s = 0, s = 1 of a face across a direction, with its own two parameters.
fn sides_of_face(axis: usize, end: usize) -> [Edge; 4] {
    let [i, j] = [[1, 2], [0, 2], [0, 1]][axis];
    let side = |along: usize, other: usize, place: usize| {
        // The two directions across the side, in order: that across the face and the other one of the face.
        let at = if axis < other { [2 * end, 2 * place] } else { [2 * place, 2 * end] };
        Edge { axis: along, at }
    };
    [side(i, j, 0), side(i, j, 1), side(j, i, 0), side(j, i, 1)]
}

/// The node in the middle of a face, of 3 x 3 x 3.
fn middle_of_face(face: usize) -> usize {
    let mut at = [1; 3];
    at[face / 2] = 2 * (face % 2);
    at[0] + 3 * at[1] + 9 * at[2]
}

/// Shells as bodies: faces are outward of the blocks, so those with a negative volume are hollows, each of the smallest solid around it.
fn solids(shells: Vec<Shell>) -> Result<Vec<Body>> {
    let (hollows, outers): (Vec<Shell>, Vec<Shell>) =
        shells.into_iter().partition(|shell| shell.is_closed() && shell.volume() < 0.0);
    let mut bodies: Vec<Body> = outers.into_iter().map(|outer| Body { outer, voids: Vec::new() }).collect();
    for hollow in hollows {
        let inside = hollow.bounds();
        let around = bodies
            .iter_mut()
            .filter(|body| body.outer.bounds().contains(inside))
            .min_by(|a, b| a.outer.volume().total_cmp(&b.outer.volume()));
        let detail = "its faces look inwards, and no shell is around it";
        let body = around.ok_or(Error::NotAShell { item: ErrorItem::Face, index: 0, detail })?;
        body.voids.push(hollow);
    }
    Ok(bodies)
}
