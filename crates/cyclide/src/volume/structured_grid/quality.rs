//! How good the cells of a structured grid are for solvers.

use super::StructuredGrid;
use crate::base::vector::{Point3, Vec3};
use crate::volume::ParamVolume as _;

/// The three neighbors of each corner in binary order, so that the sides to them are right-handed.
const NEIGHBORS: [[usize; 3]; 8] =
    [[1, 2, 4], [3, 0, 5], [0, 3, 6], [2, 1, 7], [6, 5, 0], [4, 7, 1], [7, 4, 2], [5, 6, 3]];

/// The twelve sides.
const SIDES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Quality of one cell.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, Grading, SphericalCube, StructuredGrid, VolumeFrame}};
/// let box_ = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X * 4.0, Vec3::Y, Vec3::Z])?;
/// let blocks = [CyclideVolume::new(&box_, VolumeFrame::Auto)?];
/// let grid = StructuredGrid::graded(&blocks, [2, 1, 1], [Grading::Uniform; 3])?;
/// let cell = grid.cell_quality(0);
/// assert!((cell.scaled_jacobian - 1.0).abs() < 1e-15 && (cell.aspect_ratio - 2.0).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellQuality {
    /// Largest cosine between two parameter lines of the block at the eight nodes: zero, up to rounding.
    pub orthogonality: f64,
    /// Least determinant of the unit vectors along the three sides at a corner, as of VTK and Verdict, without the center: 1 for a box, not positive for a cell
    /// that is inverted. Corners at which a side is one point are left out; 0 if all are.
    pub scaled_jacobian: f64,
    /// The longest side over the shortest that is no point.
    pub aspect_ratio: f64,
    /// The shortest side that is no point; 0 if all are.
    pub shortest_side: f64,
    /// Least exact Jacobian of the block at the eight nodes, negative where it folds; 0 where it is zero up to rounding.
    pub jacobian: f64,
}

/// Quality of a grid: the worst of its cells.
///
/// ```
/// use cyclide::{Point3, volume::{CyclideVolume, Grading, SphericalCube, StructuredGrid, VolumeFrame}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
/// let blocks = [CyclideVolume::new(&SphericalCube::from_barycentric(corners, [1.0; 3], 0.5)?, VolumeFrame::Auto)?];
/// let quality = StructuredGrid::graded(&blocks, [16; 3], [Grading::Uniform; 3])?.quality();
/// assert!(quality.orthogonality < 1e-14 && quality.scaled_jacobian > 0.99 && quality.inverted == 0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridQuality {
    /// Largest cosine between two parameter lines at a node.
    pub orthogonality: f64,
    /// Least scaled Jacobian, and the cell that has it.
    pub scaled_jacobian: f64,
    /// The cell of the least scaled Jacobian.
    pub worst_cell: usize,
    /// Largest aspect ratio of a cell.
    pub aspect_ratio: f64,
    /// The shortest side of a cell that is no point.
    pub shortest_side: f64,
    /// Cells whose scaled Jacobian is not positive, or whose exact Jacobian is negative at a node, beyond rounding. At sides of one point it is zero, and at
    /// a center of curvature.
    pub inverted: usize,
    /// The first of these.
    pub first_inverted: Option<usize>,
    /// Cells with a side of one point.
    pub collapsed: usize,
    /// All cells.
    pub cells: usize,
    /// Nodes, each once.
    pub nodes: usize,
}

impl StructuredGrid {
    /// Quality of the cell with this number.
    ///
    /// # Panics
    /// If there is no such cell.
    #[must_use]
    pub fn cell_quality(&self, cell: usize) -> CellQuality {
        let (block, at) = self.cell_place(cell);
        let of = |k: usize| {
            let place = std::array::from_fn(|axis| self.places[axis][at[axis] + (k >> axis & 1)]);
            self.blocks[block].jet(place).orthogonality()
        };
        let orthogonality = (0..8).map(of).fold(0.0, f64::max);
        self.quality_with(cell, orthogonality)
    }

    /// Quality of all cells, in order.
    pub fn cell_qualities(&self) -> impl Iterator<Item = CellQuality> {
        let cosines = self.cosines();
        (0..self.cell_count()).map(move |cell| {
            let worst = self.corners(cell).iter().map(|&k| cosines[k]).fold(0.0, f64::max);
            self.quality_with(cell, worst)
        })
    }

    /// The worst of all cells.
    #[must_use]
    pub fn quality(&self) -> GridQuality {
        let mut all = GridQuality {
            orthogonality: 0.0,
            scaled_jacobian: f64::INFINITY,
            worst_cell: 0,
            aspect_ratio: 1.0,
            shortest_side: f64::INFINITY,
            inverted: 0,
            first_inverted: None,
            collapsed: 0,
            cells: self.cell_count(),
            nodes: self.nodes().len(),
        };
        for (number, cell) in self.cell_qualities().enumerate() {
            all.orthogonality = all.orthogonality.max(cell.orthogonality);
            if cell.scaled_jacobian < all.scaled_jacobian {
                (all.scaled_jacobian, all.worst_cell) = (cell.scaled_jacobian, number);
            }
            all.aspect_ratio = all.aspect_ratio.max(cell.aspect_ratio);
            all.shortest_side = all.shortest_side.min(cell.shortest_side);
            let nodes = self.cell(number);
            let collapsed = SIDES.iter().any(|&[a, b]| nodes[a] == nodes[b]);
            all.collapsed += usize::from(collapsed);
            if cell.scaled_jacobian <= 0.0 || cell.jacobian < 0.0 {
                all.inverted += 1;
                all.first_inverted = all.first_inverted.or(Some(number));
            }
        }
        all
    }

    /// The largest cosine between two parameter lines at every node of every block.
    fn cosines(&self) -> Vec<f64> {
        let [s, t, u] = &self.places;
        let mut cosines = Vec::with_capacity(self.index.len());
        for block in &self.blocks {
            for &u in u {
                for &t in t {
                    cosines.extend(s.iter().map(|&s| block.jet([s, t, u]).orthogonality()));
                }
            }
        }
        cosines
    }

    fn quality_with(&self, cell: usize, orthogonality: f64) -> CellQuality {
        let nodes = self.cell(cell);
        let p: [Point3; 8] = nodes.map(|k| self.nodes[k]);
        let block = self.cell_place(cell).0;
        let sense = if self.blocks[block].is_right_handed() { 1.0 } else { -1.0 };
        let jacobian = self.corners(cell).iter().map(|&k| sense * self.jacobians[k]).fold(f64::INFINITY, f64::min);
        let (mut shortest, mut longest) = (f64::INFINITY, 0.0_f64);
        for [a, b] in SIDES {
            let length = p[a].distance(p[b]);
            longest = longest.max(length);
            if nodes[a] != nodes[b] && length > 0.0 {
                shortest = shortest.min(length);
            }
        }
        let scaled = |corner: usize| {
            let way = |k: usize| (p[NEIGHBORS[corner][k]] - p[corner]).unit();
            let [a, b, c]: [Vec3; 3] = [way(0)?, way(1)?, way(2)?];
            Some(a.cross(b).dot(c))
        };
        let least = (0..8).filter_map(scaled).fold(f64::INFINITY, f64::min);
        let known = |x: f64| if x.is_finite() { x } else { 0.0 };
        CellQuality {
            orthogonality,
            scaled_jacobian: known(least),
            aspect_ratio: if longest > 0.0 { longest / shortest } else { 1.0 },
            shortest_side: known(shortest),
            jacobian,
        }
    }
}
