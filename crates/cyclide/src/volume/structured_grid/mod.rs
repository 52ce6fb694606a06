//! Structured grids over blocks: nodes at given parameters, cells with eight of them.
//!
//! All blocks have the same parameters. Nodes are points of the blocks, so that at each of them the three parameter lines cross at right angles; cells
//! are hexahedra with straight sides between them, as solvers take them (`docs/math/volumes.md#structured-grids`).

mod quality;
mod resolved;
mod shared_nodes;
mod turn;

use super::cyclide_volume::CyclideVolume;
use super::grading::Grading;
use crate::base::vector::Point3;
use crate::error::{ErrorItem, NumberError, PointError, PoseError, Result};
use shared_nodes::SharedNodes;

pub use quality::{CellQuality, GridQuality};

/// Most cells of a structured grid: with their nodes some gigabytes.
pub const MOST_CELLS: usize = 1 << 24;

/// Nodes and cells of blocks at given parameters. Neighboring blocks share the nodes of a face whose corners they have in common, bit for bit, if their
/// parameters there are the same, also with its sides in other directions; blocks that close share them too.
///
/// ```
/// use cyclide::{surface::DupinCyclide, volume::{CyclideGrid, FineEnd, Grading, StructuredGrid}};
/// let ring = DupinCyclide::new(4.0, 1.0, 2.0)?.nets([4, 4])?.remove(0);
/// let wall: Vec<_> = CyclideGrid::layers(&ring, &[-0.5, 0.0])?.blocks().collect();
/// let toward_the_skin = Grading::Geometric { ratio: 1.5, fine: FineEnd::End }.places(6)?;
/// let eighths = Grading::Uniform.places(8)?;
/// let grid = StructuredGrid::new(&wall, [eighths.clone(), eighths, toward_the_skin])?;
/// assert_eq!((grid.cell_count(), grid.nodes().len()), (16 * 8 * 8 * 6, 32 * 32 * 7));
/// let quality = grid.quality();
/// assert!(quality.orthogonality < 1e-13 && quality.scaled_jacobian > 0.9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct StructuredGrid {
    blocks: Vec<CyclideVolume>,
    places: [Vec<f64>; 3],
    nodes: Vec<Point3>,
    /// The nodes of each block, s fastest, as indices of the nodes.
    index: Vec<u32>,
    /// The exact Jacobians of the blocks at their nodes, in the same order.
    jacobians: Vec<f64>,
    faces_apart: usize,
}

impl StructuredGrid {
    /// The grid of blocks with their nodes at these parameters along s, t and u: rising, from 0 to 1 ([`Grading::places`]).
    ///
    /// # Errors
    /// `too-few-points` (no block, or fewer than two parameters), `parameter-out-of-range` (parameters that do not run from 0 to 1),
    /// `parameters-not-increasing`, `too-many-pieces` (more than [`MOST_CELLS`] cells).
    pub fn new(blocks: &[CyclideVolume], places: [Vec<f64>; 3]) -> Result<Self> {
        if blocks.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        Self::check_size(blocks.len(), &places)?;
        let mut shared = SharedNodes::new(&places);
        let mut grid = Self {
            blocks: blocks.to_vec(),
            places,
            nodes: Vec::new(),
            index: Vec::new(),
            jacobians: Vec::new(),
            faces_apart: 0,
        };
        for block in blocks {
            let first = grid.jacobians.len();
            let points = grid.add_rows(block);
            debug_assert_eq!(grid.jacobians.len() - first, points.len());
            shared.add(block, &points, &mut grid.nodes, &mut grid.index);
        }
        grid.faces_apart = shared.faces_apart;
        Ok(grid)
    }

    /// Refuses parameters, and with so many blocks more cells than are made, as [`new`](Self::new) does.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn check_size(blocks: usize, places: &[Vec<f64>; 3]) -> Result<()> {
        for (places, name) in places.iter().zip([ErrorItem::S, ErrorItem::T, ErrorItem::U]) {
            check_places(places, name)?;
        }
        let cells = places.iter().map(|places| (places.len() - 1) as f64).product::<f64>() * blocks as f64;
        if cells <= MOST_CELLS as f64 {
            return Ok(());
        }
        Err(NumberError::TooManyPieces {
            what: "the grid of cells",
            segment: None,
            needed: cells,
            cap: MOST_CELLS,
            remedy: "divide it less often",
        }
        .into())
    }

    /// The points of a block at its nodes; its Jacobians are kept.
    fn add_rows(&mut self, block: &CyclideVolume) -> Vec<Point3> {
        let [s, t, u] = &self.places;
        let mut points = Vec::with_capacity(s.len() * t.len() * u.len());
        let mut lanes = vec![0.0; 4 * s.len()];
        let sense = if block.is_right_handed() { 1.0 } else { -1.0 };
        for u in u {
            for t in t {
                let (x, rest) = lanes.split_at_mut(s.len());
                let (y, rest) = rest.split_at_mut(s.len());
                let (z, jacobians) = rest.split_at_mut(s.len());
                block.row([*t, *u]).points_and_jacobians(s, [&mut *x, &mut *y, &mut *z], jacobians);
                // What is zero but for rounding, as at sides of one point, is no fold.
                for (s, jacobian) in s.iter().zip(&mut *jacobians) {
                    if !(*jacobian * sense > 0.0) && block.standing_lines([*s, *t, *u]).contains(&true) {
                        *jacobian = 0.0;
                    }
                }
                points.extend((0..s.len()).map(|k| Point3::new(x[k], y[k], z[k])));
                self.jacobians.extend_from_slice(jacobians);
            }
        }
        points
    }

    /// The share of the range of direction `axis` within which no side of a block is longer than `height`, from its start or from its end: where the
    /// first cell ends that is nowhere higher on these sides. Sides of one point are none of them.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the height is above 0 and below the length of the shortest side.
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn share_of_height(blocks: &[CyclideVolume], axis: usize, at_end: bool, height: f64) -> Result<f64> {
        let sides = || blocks.iter().flat_map(|block| block.sides(axis).into_iter().flatten());
        let shortest = sides().map(|side| side.length()).fold(f64::INFINITY, f64::min);
        if !(height > 0.0 && height < shortest) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::FirstCell,
                value: height,
                min: 0.0,
                max: shortest,
            }
            .into());
        }
        let share = |side: crate::curve::Arc| {
            let side = if at_end { side.reversed() } else { side };
            side.parameter_at_length(height / side.length())
        };
        Ok(sides().map(share).fold(1.0, f64::min))
    }

    /// The blocks.
    #[must_use]
    pub fn blocks(&self) -> &[CyclideVolume] {
        &self.blocks
    }

    /// The parameters of the nodes along s, t and u, in every block.
    #[must_use]
    pub fn places(&self) -> &[Vec<f64>; 3] {
        &self.places
    }

    /// The nodes, each once.
    #[must_use]
    pub fn nodes(&self) -> &[Point3] {
        &self.nodes
    }

    /// Faces that two blocks have in common with nodes of their own on either side: where one is turned against the other, and the parameters along
    /// the two directions that meet differ, or are not the same seen from both ends.
    #[must_use]
    pub fn faces_apart(&self) -> usize {
        self.faces_apart
    }

    /// Cells of one block along s, t and u.
    #[must_use]
    pub fn divisions(&self) -> [usize; 3] {
        self.places.each_ref().map(|places| places.len() - 1)
    }

    /// Cells of all blocks.
    #[must_use]
    pub fn cell_count(&self) -> usize {
        self.divisions().into_iter().product::<usize>() * self.blocks.len()
    }

    /// The eight nodes of every cell as indices of [`nodes`](Self::nodes), block by block, s fastest: in binary order as the corners of a block, and such
    /// that the cell is right-handed (of a left-handed block s and t are exchanged). At sides of one point nodes occur more than once.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 8]> {
        (0..self.cell_count()).map(|cell| self.cell(cell))
    }

    /// Block and place of a cell in it, by its number.
    #[must_use]
    pub fn cell_place(&self, cell: usize) -> (usize, [usize; 3]) {
        let [m, n, l] = self.divisions();
        (cell / (m * n * l), [cell % m, cell / m % n, cell / (m * n) % l])
    }

    /// The exact Jacobian of a block by its parameters at its nodes, s fastest: negative where the block is left-handed or folds; what is of the other sign
    /// by rounding only is 0.
    ///
    /// # Panics
    /// If there is no such block.
    #[must_use]
    pub fn jacobians(&self, block: usize) -> &[f64] {
        let nodes = self.nodes_of_block();
        &self.jacobians[block * nodes..(block + 1) * nodes]
    }

    /// The nodes of a block as indices of [`nodes`](Self::nodes), s fastest, as they are, also of a left-handed one.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn block_nodes(&self, block: usize) -> impl Iterator<Item = usize> {
        let nodes = self.nodes_of_block();
        self.index[block * nodes..(block + 1) * nodes].iter().map(|&node| node as usize)
    }

    fn nodes_of_block(&self) -> usize {
        self.places.iter().map(Vec::len).product()
    }

    /// Where the eight corners of a cell are among the nodes of all blocks, binary order.
    fn corners(&self, cell: usize) -> [usize; 8] {
        let (block, at) = self.cell_place(cell);
        let [m, n, _] = self.places.each_ref().map(Vec::len);
        let first = block * self.nodes_of_block() + at[0] + m * (at[1] + n * at[2]);
        std::array::from_fn(|k| first + (k & 1) + m * ((k >> 1 & 1) + n * (k >> 2)))
    }

    /// The eight nodes of the cell with this number, as of [`cells`](Self::cells).
    ///
    /// # Panics
    /// If there is no such cell.
    #[must_use]
    pub fn cell(&self, cell: usize) -> [usize; 8] {
        let corners = self.corners(cell);
        let exchanged = [0, 2, 1, 3, 4, 6, 5, 7];
        let right = self.blocks[self.cell_place(cell).0].is_right_handed();
        std::array::from_fn(|k| self.index[corners[if right { k } else { exchanged[k] }]] as usize)
    }
}

/// Refuses parameters that do not run from 0 to 1.
fn check_places(places: &[f64], name: ErrorItem) -> Result<()> {
    let [first, .., last] = *places else {
        return Err(PointError::TooFewPoints { given: places.len(), needed: 2 }.into());
    };
    for (value, wanted) in [(first, 0.0), (last, 1.0)] {
        // Exactly: neighbors share what is at the ends.
        if value.to_bits() != f64::to_bits(wanted) {
            return Err(NumberError::ParameterOutOfRange { name, value, min: wanted, max: wanted }.into());
        }
    }
    match (1..places.len()).find(|&k| !(places[k] > places[k - 1])) {
        Some(k) => Err(PoseError::ParametersNotIncreasing { index: k, value: places[k], before: places[k - 1] }.into()),
        None => Ok(()),
    }
}

impl StructuredGrid {
    /// As [`new`](Self::new), with so many cells along s, t and u by a law each.
    ///
    /// # Errors
    /// As [`Grading::places`] and [`new`](Self::new).
    pub fn graded(blocks: &[CyclideVolume], cells: [usize; 3], laws: [Grading; 3]) -> Result<Self> {
        let along = |axis: usize| laws[axis].places(cells[axis]);
        Self::new(blocks, [along(0)?, along(1)?, along(2)?])
    }
}
