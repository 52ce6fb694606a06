//! The parts of a shell: what hangs together through edges, and what hangs together in single points only.

use super::{FaceGeometry as _, Shell, ShellEdge, ShellFace};
use crate::error::Result;

impl Shell {
    /// The faces by parts that hang together through edges: each ascending, in the order of their first faces. A shell
    /// has one; after [`with_regular_faces`](Self::with_regular_faces) it may have more.
    #[must_use]
    pub fn parts(&self) -> Vec<Vec<usize>> {
        let along = self.faces_along_edges();
        let mut seen = vec![false; self.faces.len()];
        let mut parts = Vec::new();
        for first in 0..self.faces.len() {
            if std::mem::replace(&mut seen[first], true) {
                continue;
            }
            let mut part = vec![first];
            let mut next = 0;
            while let Some(&face) = part.get(next) {
                next += 1;
                for side in self.faces[face].sides.iter().flatten() {
                    let others = along[side.edge].iter().map(|&(other, _)| other);
                    part.extend(others.filter(|&other| !std::mem::replace(&mut seen[other], true)));
                }
            }
            part.sort_unstable();
            parts.push(part);
        }
        parts
    }

    /// Some of the faces with their edges and vertices, all in the same order.
    pub(crate) fn part(&self, faces: &[usize]) -> Self {
        let mut faces: Vec<ShellFace> = faces.iter().map(|&face| self.faces[face].clone()).collect();
        let mut is_used = vec![false; self.edges.len()];
        for side in faces.iter().flat_map(|face| &face.sides).flatten() {
            is_used[side.edge] = true;
        }
        let new_edges = numbered(&is_used);
        let mut edges: Vec<ShellEdge> = kept(&self.edges, &is_used);
        for side in faces.iter_mut().flat_map(|face| &mut face.sides).flatten() {
            side.edge = new_edges[side.edge];
        }
        let mut is_used = vec![false; self.vertices.len()];
        for edge in &edges {
            (is_used[edge.start], is_used[edge.end]) = (true, true);
        }
        let new_vertices = numbered(&is_used);
        for edge in &mut edges {
            (edge.start, edge.end) = (new_vertices[edge.start], new_vertices[edge.end]);
        }
        Self { vertices: kept(&self.vertices, &is_used), edges, faces }
    }

    /// The closed surfaces that a closed shell consists of, outside outwards: where a parameter line shrinks to a point
    /// inside its faces (a node), a ring falls apart into lobes that touch there, which bound solids each for itself.
    /// A shell of one lobe, and an open one, is returned as it is.
    ///
    /// # Errors
    /// As [`with_regular_faces`](Self::with_regular_faces).
    pub fn lobes(&self) -> Result<Vec<Self>> {
        self.clone().into_lobes()
    }

    /// As [`lobes`](Self::lobes), without a copy of a shell that is one.
    pub(crate) fn into_lobes(self) -> Result<Vec<Self>> {
        if !self.is_closed() || self.faces.iter().all(|face| face.surface.is_regular()) {
            return Ok(vec![self]);
        }
        let cut = self.with_regular_faces()?;
        let parts = cut.parts();
        if parts.len() == 1 {
            return Ok(vec![self]);
        }
        Ok(parts.iter().map(|part| cut.part(part).outside_out()).collect())
    }

    /// The closed shell with its outer side outside.
    pub(crate) fn outside_out(self) -> Self {
        if self.is_inside_out() { self.flipped() } else { self }
    }
}

/// The items that are used.
fn kept<T: Clone>(items: &[T], is_used: &[bool]) -> Vec<T> {
    items.iter().zip(is_used).filter(|(_, used)| **used).map(|(item, _)| item.clone()).collect()
}

/// The numbers of the items that are used among these.
fn numbered(is_used: &[bool]) -> Vec<usize> {
    let before = is_used.iter().scan(0, |count, &used| {
        let number = *count;
        *count += usize::from(used);
        Some(number)
    });
    before.collect()
}
