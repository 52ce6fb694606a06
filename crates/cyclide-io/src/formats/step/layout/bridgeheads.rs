//! Where seams across faces end.

use cyclide::{Point3, topology::Shell};
use std::collections::{HashMap, HashSet};

/// Where seams across faces end.
#[derive(Default)]
pub(super) struct Bridgeheads {
    /// How many vertices the shell has.
    pub(super) count: usize,
    /// Vertices that are none of the shell.
    pub(super) points: Vec<Point3>,
    /// All their vertices.
    pub(super) vertices: HashSet<usize>,
    /// Of edges of whole circles the vertex that such a circle has.
    pub(super) on_edge: HashMap<usize, usize>,
}

impl Bridgeheads {
    pub(super) fn new(shell: &Shell) -> Self {
        Self { count: shell.vertices().len(), ..Self::default() }
    }

    /// A vertex that is none of the shell.
    pub(super) fn point(&self, vertex: usize) -> Point3 {
        self.points.get(vertex.wrapping_sub(self.count)).copied().unwrap_or(Point3::ORIGIN)
    }
}
