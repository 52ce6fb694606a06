//! Vertices, edges and faces on their way to a shell: whatever is sewn, each vertex and each edge is added once.

use super::{Body, EdgeCurve, FaceEdge, FaceSurface, Shell, ShellEdge, ShellFace};
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::Result;

/// A shell in the making. What is added is counted from 0, and told by its number from then on.
#[derive(Debug, Default)]
pub(crate) struct Sewing {
    pub(crate) vertices: Vec<Point3>,
    pub(crate) edges: Vec<ShellEdge>,
    pub(crate) faces: Vec<ShellFace>,
}

impl Sewing {
    /// Adds a vertex.
    pub(crate) fn vertex(&mut self, p: Point3) -> usize {
        self.vertices.push(p);
        self.vertices.len() - 1
    }

    /// Adds an edge along a curve whose ends are the two vertices.
    pub(crate) fn edge(&mut self, start: usize, end: usize, curve: impl Into<EdgeCurve>) -> usize {
        self.edges.push(ShellEdge { start, end, curve: curve.into() });
        self.edges.len() - 1
    }

    /// Adds a straight edge between two vertices.
    ///
    /// # Errors
    /// As [`Arc::segment`].
    pub(crate) fn segment(&mut self, start: usize, end: usize) -> Result<usize> {
        let segment = Arc::segment(self.vertices[start], self.vertices[end])?;
        Ok(self.edge(start, end, segment))
    }

    /// Adds an arc between two vertices with this weight ratio, of which any part along the chord is rounding.
    ///
    /// # Errors
    /// As [`Arc::from_weight_ratio`].
    pub(crate) fn arc(&mut self, start: usize, end: usize, ratio: Quat) -> Result<usize> {
        let arc = Arc::from_ratio_across(self.vertices[start], self.vertices[end], ratio)?;
        Ok(self.edge(start, end, arc))
    }

    /// Adds a face whose sides at t = 0, t = 1, s = 0 and s = 1 all run along these edges; none where a side is one point.
    pub(crate) fn face(&mut self, surface: impl Into<FaceSurface>, edges: [Option<usize>; 4], same_sense: bool) {
        let sides = edges.map(|edge| edge.map(|edge| FaceEdge { edge, forward: true }));
        self.face_along(surface, sides, same_sense);
    }

    /// Adds a face whose sides run along edges or against them.
    pub(crate) fn face_along(
        &mut self,
        surface: impl Into<FaceSurface>,
        sides: [Option<FaceEdge>; 4],
        same_sense: bool,
    ) {
        self.faces.push(ShellFace { surface: surface.into(), sides, same_sense });
    }

    /// The shell, checked.
    ///
    /// # Errors
    /// As [`Shell::new`].
    pub(crate) fn finish(self) -> Result<Shell> {
        Shell::new(self.vertices, self.edges, self.faces)
    }

    /// The body of the shell, outside outwards where it is closed.
    ///
    /// # Errors
    /// As [`Shell::new`].
    pub(crate) fn finish_body(self) -> Result<Body> {
        let shell = self.finish()?;
        Ok(Body { outer: if shell.is_closed() { shell.outside_out() } else { shell }, voids: Vec::new() })
    }

    /// The shells of what hangs together through edges, checked, each with the numbers of its faces.
    ///
    /// # Errors
    /// As [`Shell::new`].
    pub(super) fn finish_apart(self) -> Result<Vec<(Shell, Vec<usize>)>> {
        let checked = |Shell { vertices, edges, faces }| Shell::new(vertices, edges, faces);
        let Self { vertices, edges, faces } = self;
        let all = Shell { vertices, edges, faces };
        let mut parts = all.parts();
        if parts.len() <= 1 {
            return Ok(vec![(checked(all)?, parts.pop().unwrap_or_default())]);
        }
        parts.into_iter().map(|part| Ok((checked(all.part(&part))?, part))).collect()
    }
}
