//! Faces of blocks and inside them, sewn: blocks are cut at parameters, the same in all of them, into parts with six faces each.
//!
//! Places are told by the nodes of a [structured grid](StructuredGrid) at the cuts and half-way between them, which blocks share: the middle of a face
//! or of a side says which it is. Corners of faces are these nodes, so that neighbors agree on them bit for bit.

use super::{FaceEdge, Sewing, Side};
use crate::curve::Arc;
use crate::error::{ArcError, Result};
use crate::surface::CyclidePatch;
use crate::volume::{CyclideVolume, StructuredGrid};
use std::collections::HashMap;

/// Where a face of a [part of a block](CyclideVolume::boundary_of_parts) is.
///
/// ```
/// use cyclide::{Point3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
/// let block = CyclideVolume::new(&SphericalCube::from_barycentric(corners, [1.0; 3], 0.5)?, VolumeFrame::Auto)?;
/// let halves = [vec![0.0, 0.5, 1.0], vec![0.0, 1.0], vec![0.0, 1.0]];
/// let lower = CyclideVolume::boundary_of_parts(&[block], halves, |_, [s, ..]| s == 0)?.remove(0);
/// let inner = lower.faces.iter().find(|face| face.axis == 0 && face.place > 0.0);
/// assert!(lower.shell.is_closed() && inner.is_some_and(|face| face.place == 0.5));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlockFace {
    /// Which of the blocks.
    pub block: usize,
    /// The direction across it: 0, 1, 2 for s, t, u.
    pub axis: usize,
    /// The parameter in this direction.
    pub place: f64,
    /// The ranges of the two other parameters, in order: of the face's own two.
    pub ranges: [[f64; 2]; 2],
}

/// A face by its place among the cuts.
#[derive(Clone, Copy)]
pub(super) struct FaceAt {
    pub(super) block: usize,
    pub(super) axis: usize,
    /// Which of the cuts in this direction.
    pub(super) cut: usize,
    /// The part in the two other directions, in order.
    pub(super) part: [usize; 2],
    /// Its outer side is that of the growing parameter.
    pub(super) along: bool,
}

/// A side of a face: its direction, the part in it, and the cuts in the two other directions, in order.
#[derive(Clone, Copy)]
struct SideAt {
    axis: usize,
    part: usize,
    at: [usize; 2],
}

/// What becomes of edges at which more than two faces meet, or two that are oriented against each other.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Meeting {
    /// All have one edge, which is refused.
    Refused,
    /// Faces that go on in each other have one edge, the others edges of their own.
    Apart,
}

/// Blocks with their cuts.
pub(super) struct BlockFaces<'a> {
    blocks: &'a [CyclideVolume],
    cuts: [Vec<f64>; 3],
    grid: StructuredGrid,
    /// The nodes of each block, at cuts and between them.
    nodes: Vec<Vec<usize>>,
}

impl<'a> BlockFaces<'a> {
    /// # Errors
    /// As [`StructuredGrid::new`].
    pub(super) fn new(blocks: &'a [CyclideVolume], cuts: [Vec<f64>; 3]) -> Result<Self> {
        let places = cuts.each_ref().map(|cuts| {
            let halves = cuts.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]);
            halves.chain(cuts.last().copied()).collect::<Vec<f64>>()
        });
        let grid = StructuredGrid::new(blocks, places)?;
        let nodes = (0..blocks.len()).map(|block| grid.block_nodes(block).collect()).collect();
        Ok(Self { blocks, cuts, grid, nodes })
    }

    /// How many parts blocks are cut into, along each direction.
    pub(super) fn parts(&self) -> [usize; 3] {
        self.cuts.each_ref().map(|cuts| cuts.len() - 1)
    }

    /// All parts of a block, s fastest.
    pub(super) fn all_parts(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [m, n, l] = self.parts();
        (0..m * n * l).map(move |k| [k % m, k / m % n, k / (m * n)])
    }

    /// The node of a block by its place among cuts and halves.
    fn node(&self, block: usize, at: [usize; 3]) -> usize {
        let [m, n, _] = self.cuts.each_ref().map(|cuts| 2 * cuts.len() - 1);
        self.nodes[block][at[0] + m * (at[1] + n * at[2])]
    }

    /// The node in the middle of a face, by which it is known.
    pub(super) fn middle(&self, face: &FaceAt) -> usize {
        self.node(face.block, face.at([1, 1]))
    }

    /// True if the face is a line, of a wedge: its middle is that of a side.
    pub(super) fn is_line(&self, face: &FaceAt) -> bool {
        let middle = self.middle(face);
        face.sides().iter().any(|side| self.node(face.block, side.node(1)) == middle)
    }

    /// Where a face is.
    pub(super) fn place(&self, face: &FaceAt) -> BlockFace {
        let [i, j] = others(face.axis);
        let range = |axis: usize, part: usize| [self.cuts[axis][part], self.cuts[axis][part + 1]];
        let ranges = [range(i, face.part[0]), range(j, face.part[1])];
        BlockFace { block: face.block, axis: face.axis, place: self.cuts[face.axis][face.cut], ranges }
    }

    /// The parameters of a node at cuts.
    fn parameters(&self, at: [usize; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| self.cuts[axis][at[axis] / 2])
    }

    /// The faces with their sides; those that are lines are none and must not be among them.
    ///
    /// # Errors
    /// Of sides that are no arcs, as [`Arc::from_weight_ratio`].
    pub(super) fn sewn(&self, faces: &[FaceAt], meeting: Meeting) -> Result<Sewing> {
        let mut sewing = Sewing::default();
        let mut vertices = HashMap::new();
        // Edges by their middle, each with the directions in which faces run along it.
        let mut edges: HashMap<usize, Vec<(usize, [bool; 2])>> = HashMap::new();
        for face in faces {
            let block = &self.blocks[face.block];
            let same_sense = ((face.axis != 1) == block.is_right_handed()) == face.along;
            let mut sides = [None; 4];
            for ((made, at), side) in sides.iter_mut().zip(face.sides()).zip(Side::ALL) {
                let [from, middle, to] = [0, 1, 2].map(|k| self.node(face.block, at.node(k)));
                if from == to && middle == from {
                    continue;
                }
                let [from, to] = [from, to]
                    .map(|node| *vertices.entry(node).or_insert_with(|| sewing.vertex(self.grid.nodes()[node])));
                let with_loop = side.runs_with_loop() == same_sense;
                // Blocks that are turned run along a side the other way.
                let forward = |edge: usize| sewing.edges[edge].start == from;
                let met = edges.entry(middle).or_default();
                let direction = |edge: usize| usize::from(with_loop == forward(edge));
                let free = |(edge, runs): &(usize, [bool; 2])| meeting == Meeting::Refused || !runs[direction(*edge)];
                *made = Some(match met.iter().position(free) {
                    Some(known) => {
                        let (edge, runs) = &mut met[known];
                        runs[direction(*edge)] = true;
                        FaceEdge { edge: *edge, forward: forward(*edge) }
                    }
                    None => {
                        let edge = self.edge(&mut sewing, face.block, at, [from, to])?;
                        met.push((edge, [!with_loop, with_loop]));
                        FaceEdge { edge, forward: true }
                    }
                });
            }
            sewing.face_along(self.patch(face), sides, same_sense);
        }
        Ok(sewing)
    }

    fn edge(&self, sewing: &mut Sewing, block: usize, at: SideAt, ends: [usize; 2]) -> Result<usize> {
        let volume = &self.blocks[block];
        let others = others(at.axis);
        let is_end = |k: usize| at.at[k] == 0 || at.at[k] == self.parts()[others[k]];
        let curve = if is_end(0) && is_end(1) && self.parts()[at.axis] == 1 {
            volume.line(at.axis, at.at.map(|cut| if cut == 0 { 0.0 } else { 1.0 }))?
        } else {
            let [from, to] = [0, 2].map(|k| volume.denominator(self.parameters(at.node(k))));
            let inverse = from.inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
            Arc::from_ratio_across(sewing.vertices[ends[0]], sewing.vertices[ends[1]], to * inverse)?
        };
        Ok(sewing.edge(ends[0], ends[1], curve))
    }

    fn patch(&self, face: &FaceAt) -> CyclidePatch {
        let volume = &self.blocks[face.block];
        let parts = self.parts();
        let [i, j] = others(face.axis);
        if (face.cut == 0 || face.cut == parts[face.axis]) && parts[i] == 1 && parts[j] == 1 {
            return volume.faces()[2 * face.axis + usize::from(face.cut > 0)];
        }
        let places: [[usize; 3]; 4] = std::array::from_fn(|k| face.at([2 * (k & 1), 2 * (k >> 1)]));
        let corners = places.map(|at| self.grid.nodes()[self.node(face.block, at)]);
        let weights = places.map(|at| volume.denominator(self.parameters(at)));
        let v = volume.frame();
        CyclidePatch::from_weights_unchecked(corners, weights, v[i], v[j])
    }
}

impl FaceAt {
    /// A place on the face among cuts and halves: 0 to 2 along its two directions.
    fn at(&self, [x, y]: [usize; 2]) -> [usize; 3] {
        let [i, j] = others(self.axis);
        let mut at = [2 * self.cut; 3];
        (at[i], at[j]) = (2 * self.part[0] + x, 2 * self.part[1] + y);
        at
    }

    /// The sides at t = 0, t = 1, s = 0, s = 1 of the face with its own two parameters.
    fn sides(&self) -> [SideAt; 4] {
        let directions = others(self.axis);
        let side = |along: usize, end: usize| {
            let (axis, other, across) = (directions[along], directions[1 - along], self.part[1 - along] + end);
            // The two directions across the side, in order: that across the face and the other one of the face.
            let at = if self.axis < other { [self.cut, across] } else { [across, self.cut] };
            SideAt { axis, part: self.part[along], at }
        };
        [side(0, 0), side(0, 1), side(1, 0), side(1, 1)]
    }
}

impl SideAt {
    /// Its start, middle and end among cuts and halves.
    fn node(self, k: usize) -> [usize; 3] {
        let [i, j] = others(self.axis);
        let mut at = [2 * self.part + k; 3];
        (at[i], at[j]) = (2 * self.at[0], 2 * self.at[1]);
        at
    }
}

/// The other two directions, in order.
const fn others(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}
