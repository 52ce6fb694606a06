//! What makes vertices, edges and faces a shell.

use super::{FaceEdge, Shell, ShellFace, Side};
use crate::error::{Error, Result};
use crate::surface::CyclidePatch;

/// Largest relative difference of the weight ratios of a side and of its edge.
const RATIO_LIMIT: f64 = 1e-9;

impl Shell {
    pub(super) fn check(&self) -> Result<()> {
        self.check_edges()?;
        for (index, face) in self.faces.iter().enumerate() {
            self.check_face(face).map_err(|detail| Error::NotAShell { item: "face", index, detail })?;
        }
        self.check_orientation()?;
        self.check_connected()
    }

    fn check_edges(&self) -> Result<()> {
        for (index, edge) in self.edges.iter().enumerate() {
            let fail = |detail| Err(Error::NotAShell { item: "edge", index, detail });
            let (Some(start), Some(end)) = (self.vertices.get(edge.start), self.vertices.get(edge.end)) else {
                return fail("a vertex of it does not exist");
            };
            if edge.start == edge.end {
                return fail("both ends are the same vertex");
            }
            if edge.arc.start() != *start || edge.arc.end() != *end {
                return fail("the arc does not end at the vertices");
            }
        }
        Ok(())
    }

    fn check_face(&self, face: &ShellFace) -> std::result::Result<(), &'static str> {
        let corners = face.patch.corners();
        // The vertex at each corner, as the sides say; sides of one point hand it on.
        let mut vertex: [Option<usize>; 4] = [None; 4];
        for side in Side::ALL {
            let [from, to] = side.corners();
            let Some(side) = face.side(side) else {
                if corners[from] != corners[to] {
                    return Err("a side without edge is not one point");
                }
                continue;
            };
            let edge = self.edges.get(side.edge).ok_or("an edge of it does not exist")?;
            let ends = if side.forward { (edge.start, edge.end) } else { (edge.end, edge.start) };
            for (corner, end) in [(from, ends.0), (to, ends.1)] {
                if corners[corner] != self.vertices[end] {
                    return Err("a corner is not the vertex of its edge");
                }
                if *vertex[corner].get_or_insert(end) != end {
                    return Err("its sides meet at a corner in different vertices");
                }
            }
        }
        for side in Side::ALL {
            let [from, to] = side.corners();
            if face.side(side).is_none() && vertex[from] != vertex[to] {
                return Err("a side of one point has two vertices");
            }
        }
        if face.edges().any(|(side, edge)| !self.same_parameter(&face.patch, side, edge)) {
            return Err("a side has another parameter than its edge");
        }
        Ok(())
    }

    fn same_parameter(&self, patch: &CyclidePatch, side: Side, place: FaceEdge) -> bool {
        let arc = self.edges[place.edge].arc;
        let want = if place.forward { arc } else { arc.reversed() }.weight_ratio();
        side.arc_of(patch).is_ok_and(|line| (line.weight_ratio() - want).norm() <= RATIO_LIMIT * want.norm())
    }

    /// Every edge has at most two faces, which run along it in opposite directions.
    fn check_orientation(&self) -> Result<()> {
        // Faces that run along the edge, and against it.
        let mut runs = vec![[0_u32; 2]; self.edges.len()];
        for face in &self.faces {
            for (_, edge, forward) in face.edge_loop(face.same_sense) {
                runs[edge.edge][usize::from(forward)] += 1;
            }
        }
        let fail = |index, detail| Err(Error::NotAShell { item: "edge", index, detail });
        for (index, &[with, against]) in runs.iter().enumerate() {
            match (with, against) {
                (0, 0) => return fail(index, "no face has it"),
                (0 | 1, 0 | 1) => {}
                (2, 0) | (0, 2) => return fail(index, "its faces are oriented against each other"),
                _ => return fail(index, "more than two faces have it"),
            }
        }
        Ok(())
    }

    fn check_connected(&self) -> Result<()> {
        if self.faces.is_empty() {
            return Err(Error::NotAShell { item: "face", index: 0, detail: "there is none" });
        }
        match self.parts().get(1).and_then(|part| part.first().copied()) {
            Some(index) => {
                Err(Error::NotAShell { item: "face", index, detail: "no chain of edges joins it to face 0" })
            }
            None => Ok(()),
        }
    }
}
