//! Cyclidic nets: circular nets of points with one frame, filled by principal patches of Dupin cyclides.
//!
//! A vertex with point `a` and weight `w` stands for the pair `(a w, w)`; with the constant frame `V1, V2, V3` of the
//! net its orthonormal frame is `w V w^-1`. The patch of a quad is that of its four pairs, so patches that share an
//! edge read the same two pairs: they have the same boundary arc with the same parameter, and the same tangent plane
//! all along it. The surface is G1, its parameter lines are C1 up to their speed
//! (`docs/math/cyclides-and-nets.md#frames-and-weights-of-a-net`).

mod build;
mod closing;
mod frame;
mod offset;
mod same_vertices;
mod singular;
mod transform;
mod ways;

pub use build::closing_limit;
pub(in crate::surface) use build::stretches;
pub use closing::{GridClosing, RingClosing, StripClosing};
pub use frame::NetFrame;
pub(in crate::surface) use frame::{apply, carried_back, first_vertex, preferred, signs};
pub(crate) use same_vertices::SameVertices;
pub use singular::SingularPatch;

use super::grid_cells::GridCell;
use super::patch::CyclidePatch;
use super::quad_grid::QuadGrid;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};

/// A regular net of principal patches that join with a common tangent plane.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::surface_joints};
/// let net = DupinCyclide::new(4.0, 1.0, 2.0)?.nets([6, 6])?.remove(0);
/// assert_eq!(net.size(), [6, 6]);
/// assert!(surface_joints(&net.to_shell()?).iter().all(|joint| joint.angle < 1e-7)); // no creases
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CyclidicNet {
    grid: QuadGrid,
    /// One weight per vertex.
    weights: Vec<Quat>,
    /// The constant frame `V1, V2`.
    v: [Vec3; 2],
    /// Factor of the weights after one turn in each closed direction: 1 or -1.
    turn: [f64; 2],
}

impl CyclidicNet {
    /// The vertices.
    #[must_use]
    pub fn grid(&self) -> &QuadGrid {
        &self.grid
    }

    /// Patches along s and along t, of the whole rectangle: see [`QuadGrid::cell`].
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.grid.quads()
    }

    /// Weight of vertex `(i, j)`, counted round in closed directions, where a full turn may change its sign.
    ///
    /// # Panics
    /// If the vertex is outside an open direction.
    #[must_use]
    pub fn weight(&self, i: usize, j: usize) -> Quat {
        let [m, n] = self.grid.size();
        let sign = |k: usize, n: usize, d: usize| if (k / n) % 2 == 1 { self.turn[d] } else { 1.0 };
        self.weights[self.grid.index(i, j)] * (sign(i, m, 0) * sign(j, n, 1))
    }

    /// The constant frame `V1, V2, V3`: the frame of a vertex with weight `w` is `w V w^-1`.
    #[must_use]
    pub fn frame(&self) -> [Vec3; 3] {
        [self.v[0], self.v[1], self.v[0].cross(self.v[1])]
    }

    /// The orthonormal frame at vertex `(i, j)`: directions of growing s and t, and the normal.
    ///
    /// # Panics
    /// If the vertex is outside an open direction.
    #[must_use]
    pub fn vertex_frame(&self, i: usize, j: usize) -> [Vec3; 3] {
        let w = self.weight(i, j);
        let unit = w * (1.0 / w.norm());
        self.frame().map(|v| unit.rotate(v))
    }

    /// The patch of quad `(i, j)`.
    ///
    /// # Panics
    /// If there is no such quad, or it is outside.
    #[must_use]
    pub fn patch(&self, i: usize, j: usize) -> CyclidePatch {
        assert!(self.grid.has_quad(i, j), "quad ({i}, {j}) is outside the net");
        let (corners, weights) = self.pairs(i, j);
        CyclidePatch::from_weights_unchecked(corners, weights, self.v[0], self.v[1])
    }

    /// All patches, s fastest; none of openings and of what is outside.
    pub fn patches(&self) -> impl Iterator<Item = CyclidePatch> {
        self.patches_with_quads().map(|(_, patch)| patch)
    }

    /// The quads that have patches, along s and along t, with these, s fastest.
    pub fn patches_with_quads(&self) -> impl Iterator<Item = ([usize; 2], CyclidePatch)> {
        let with_patch = self.grid.all_quads().filter(|[i, j]| self.grid.cell(*i, *j) == GridCell::Patch);
        with_patch.map(|[i, j]| ([i, j], self.patch(i, j)))
    }

    /// The number of a quad in the rectangle, s fastest.
    pub(crate) fn number(&self, [i, j]: [usize; 2]) -> usize {
        i + j * self.size()[0]
    }

    /// Corners and weights of quad `(i, j)`, binary order.
    fn pairs(&self, i: usize, j: usize) -> ([Point3; 4], [Quat; 4]) {
        let places = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)];
        (places.map(|(i, j)| self.grid.point(i, j)), places.map(|(i, j)| self.weight(i, j)))
    }
}
