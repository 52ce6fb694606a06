//! A skin of pipes being sewn, and the rings at its ends.

use crate::base::vector::Vec3;
use crate::rational::{Polynomial, RationalBezierSurface};
use crate::topology::{EdgeCurve, FaceEdge, Sewing};

/// Edges one after the other round a pipe, each from one vertex to the next; an open part of that has a vertex more than edges.
#[derive(Debug, Clone, Default)]
pub(in crate::construct::bodies) struct Ring {
    pub(in crate::construct::bodies) vertices: Vec<usize>,
    pub(in crate::construct::bodies) edges: Vec<usize>,
    /// Half directions at the vertices, in the axes of the main pipe; none round a branch.
    pub(in crate::construct::bodies) halves: Vec<[f64; 2]>,
    /// Half directions along the edges.
    pub(in crate::construct::bodies) along: Vec<[Polynomial; 2]>,
}

/// A skin being sewn: how far below the outer one it lies, and whether it bounds the material from inside.
pub(in crate::construct::bodies) struct Skin<'a> {
    pub(in crate::construct::bodies) sewing: &'a mut Sewing,
    pub(in crate::construct::bodies) depth: f64,
    pub(in crate::construct::bodies) inner: bool,
}

impl Skin<'_> {
    /// Adds an edge along a rational curve.
    pub(in crate::construct::bodies) fn edge(&mut self, ends: [usize; 2], curve: EdgeCurve) -> usize {
        let [start, end] = ends.map(|v| self.sewing.vertices[v]);
        self.sewing.edge(ends[0], ends[1], curve.with_ends(Some(start), Some(end)))
    }

    /// Adds a face with the vertices at which its sides start, outside on the side of a direction in its middle, of the inner skin on the other.
    pub(in crate::construct::bodies) fn face(
        &mut self,
        surface: RationalBezierSurface,
        edges: [usize; 4],
        starts: [usize; 4],
        outwards: Vec3,
    ) {
        let outwards = if self.inner { -outwards } else { outwards };
        self.plane_face(surface, [0, 1, 2, 3].map(|k: usize| Some((edges[k], starts[k]))), outwards);
    }

    /// Adds a face with its sides, edges and the vertices at which they start, outside on the side of a direction in its middle.
    pub(in crate::construct::bodies) fn plane_face(
        &mut self,
        surface: RationalBezierSurface,
        sides: [Option<(usize, usize)>; 4],
        outwards: Vec3,
    ) {
        let edges = &self.sewing.edges;
        let sides = sides.map(|side| side.map(|(edge, start)| FaceEdge { edge, forward: edges[edge].start == start }));
        let ahead = surface.unit_normal(0.5, 0.5).dot(outwards) > 0.0;
        self.sewing.face_along(surface, sides, ahead);
    }
}
