//! What the polygons of a file stand for: told by who writes them, held against the file by the check.

use crate::export::side_use::SideUse;
use cyclide::mesh::MeshSource;

/// What the polygons of a file stand for and how they hang together, known from the meshes that were written.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct MeshPlan {
    /// The cells in file order, those of a body one after the other.
    pub(crate) cells: Vec<Cell>,
    /// One entry per body, in the same order.
    pub(crate) bodies: Vec<BodyPlan>,
}

/// A cell of a patch and the number of polygons that the file has for it, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// Index of the body in the model.
    pub(crate) body: usize,
    pub(crate) source: MeshSource,
    pub(crate) polygons: usize,
}

/// What holds for all polygons of a body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BodyPlan {
    pub(crate) sides: SideUse,
    /// True if several places of the mesh are one vertex.
    pub(crate) merged: bool,
    /// How far rounding has moved a vertex at most.
    pub(crate) moved: f64,
}
