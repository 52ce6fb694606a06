//! What makes vertices, edges and faces a shell.

use super::{EdgeCurve, FaceEdge, FaceGeometry as _, FaceSurface, Shell, ShellFace, Side};
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::{Error, ErrorItem, Result, ShellError};

/// Largest relative difference of the weight ratios of a side and of its edge.
const RATIO_LIMIT: f64 = 1e-9;
/// Roundings of the coordinates that points of a side and of its edge may differ by beside that.
const ROUNDINGS: f64 = 32.0;

/// True if two points are one: bit for bit (`exact`), or as near as the quotients of a rational form are.
pub(super) fn same_point(exact: bool, a: Point3, b: Point3) -> bool {
    a == b || !exact && a.distance(b) <= ROUNDINGS * f64::EPSILON * a.to_vec().max_abs().max(b.to_vec().max_abs())
}

/// Whether an arc has this ratio of weights: of points with rounded coordinates it is known as well as the chord.
pub(crate) fn has_ratio(arc: &Arc, ratio: Quat) -> bool {
    let rounding = ROUNDINGS * f64::EPSILON * arc.start().to_vec().max_abs() / arc.chord().length();
    (arc.weight_ratio() - ratio).norm() <= (RATIO_LIMIT + rounding) * arc.weight_ratio().norm()
}

impl Shell {
    pub(super) fn check(&self) -> Result<()> {
        self.check_edges()?;
        for (index, face) in self.faces.iter().enumerate() {
            self.check_face(face)
                .map_err(|detail| Error::Shell(ShellError::NotAShell { item: ErrorItem::Face, index, detail }))?;
        }
        self.check_orientation()?;
        self.check_connected()
    }

    fn check_edges(&self) -> Result<()> {
        for (index, edge) in self.edges.iter().enumerate() {
            let fail = |detail| Err(ShellError::NotAShell { item: ErrorItem::Edge, index, detail }.into());
            let (Some(start), Some(end)) = (self.vertices.get(edge.start), self.vertices.get(edge.end)) else {
                return fail("a vertex of it does not exist");
            };
            if edge.start == edge.end {
                return fail("both ends are the same vertex");
            }
            if matches!(&edge.curve, EdgeCurve::Rational(curve) if !curve.has_positive_weights()) {
                return fail("a weight of its curve is not positive");
            }
            let exact = edge.curve.arc().is_some();
            if !same_point(exact, edge.curve.start(), *start) || !same_point(exact, edge.curve.end(), *end) {
                return fail("the curve does not end at the vertices");
            }
        }
        Ok(())
    }

    fn check_face(&self, face: &ShellFace) -> std::result::Result<(), &'static str> {
        if matches!(&face.surface, FaceSurface::Rational(surface) if !surface.has_positive_weights()) {
            return Err("a weight of its surface is not positive");
        }
        let (exact, corners) = (face.surface.patch().is_some(), face.surface.corners());
        // The vertex at each corner, as the sides say; sides of one point hand it on.
        let mut vertex: [Option<usize>; 4] = [None; 4];
        for side in Side::ALL {
            let [from, to] = side.corners();
            let Some(side) = face.side(side) else {
                if !same_point(exact, corners[from], corners[to]) {
                    return Err("a side without edge is not one point");
                }
                continue;
            };
            let edge = self.edges.get(side.edge).ok_or("an edge of it does not exist")?;
            let ends = if side.forward { (edge.start, edge.end) } else { (edge.end, edge.start) };
            for (corner, end) in [(from, ends.0), (to, ends.1)] {
                if !same_point(exact, corners[corner], self.vertices[end]) {
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
        if face.edges().any(|(side, edge)| !self.same_parameter(&face.surface, side, edge)) {
            return Err("a side has another parameter than its edge");
        }
        Ok(())
    }

    fn same_parameter(&self, surface: &FaceSurface, side: Side, place: FaceEdge) -> bool {
        let edge = &self.edges[place.edge].curve;
        let Ok(line) = side.curve_of(surface) else { return false };
        if let (EdgeCurve::Arc(line), EdgeCurve::Arc(arc)) = (&line, edge) {
            return has_ratio(&if place.forward { *arc } else { arc.reversed() }, line.weight_ratio());
        }
        // Two rational curves are one, with one parameter, if they agree at more places than their degrees together.
        let degree = |curve: &EdgeCurve| match curve {
            EdgeCurve::Arc(_) => 2,
            EdgeCurve::Rational(curve) => curve.degree(),
        };
        let places = degree(&line) + degree(edge) + 1;
        let apart = |k: usize| {
            let x = k as f64 / places as f64;
            line.point(x).distance(edge.point(place.turned(x)))
        };
        let size =
            (1..=places).map(|k| line.point(k as f64 / places as f64).distance(line.start())).fold(0.0, f64::max);
        let rounding = f64::EPSILON * edge.start().to_vec().max_abs();
        (0..=places).all(|k| apart(k) <= RATIO_LIMIT * size + ROUNDINGS * rounding)
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
        let fail = |index, detail| Err(ShellError::NotAShell { item: ErrorItem::Edge, index, detail }.into());
        for (index, &[with, against]) in runs.iter().enumerate() {
            match (with, against) {
                (0, 0) => return fail(index, "no face uses it"),
                (0 | 1, 0 | 1) => {}
                (2, 0) | (0, 2) => return fail(index, "its faces have opposite orientations"),
                _ => return fail(index, "more than two faces use it"),
            }
        }
        Ok(())
    }

    fn check_connected(&self) -> Result<()> {
        if self.faces.is_empty() {
            return Err(ShellError::NotAShell { item: ErrorItem::Face, index: 0, detail: "there is none" }.into());
        }
        match self.parts().get(1).and_then(|part| part.first().copied()) {
            Some(index) => {
                Err(ShellError::NotAShell { item: ErrorItem::Face, index, detail: "it is not connected to face 0" }
                    .into())
            }
            None => Ok(()),
        }
    }
}
