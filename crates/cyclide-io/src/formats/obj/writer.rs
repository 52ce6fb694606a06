//! Writes OBJ: one `o` per object, one `g` per surface or curve.
//!
//! Vertices and normals in full doubles, faces `f vertex//normal …` counted from 1, quads kept. A curve is a
//! polyline `l` within the tolerance; a closed one ends with its first vertex. The unit stands in a comment: the
//! format has none.

use crate::check::labels::{FileLabels, FileName};
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::mesh::{BodyMesh, between, body_meshes, polyline};
use crate::export::parts::{BodyOf, contours_of};
use crate::text::lines::on_a_line;
use crate::text::number::push_plain;
use cyclide::{Point3, curve::CurvePlace, mesh::SurfaceMesh, model::Model};
use std::fmt::Write as _;

/// How the comment with the unit starts.
pub(super) const UNITS: &str = "# cyclide, units ";
/// What the names are those of.
pub(super) const OBJECT: &str = "object";
pub(super) const GROUP: &str = "group";

/// Writes the model as OBJ.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut written = Written::default();
    let mut file = File { text: format!("{UNITS}{}\n", job.units().symbol()), positions: 0, normals: 0 };
    let meshes = body_meshes(job)?;
    for (index, item) in job.model.items.iter().enumerate() {
        file.name("o", &item.name);
        for body in meshes.iter().filter(|mesh| mesh.body.item == index) {
            let BodyMesh { mesh, .. } = body;
            file.name("g", &body.body.label());
            file.mesh(mesh);
            body.plan_whole(&mut written.mesh);
            written.bodies.push(body.promise(0.0));
        }
        for contour in job.contours().filter(|contour| contour.item == index) {
            file.name("g", &contour.label());
            let vertices = polyline(job, &contour)?;
            written.curves.push(Promise::of_polyline(contour.curve.as_curve(), job.tolerance).of(between(&vertices)));
            file.polyline(&vertices, contour.curve.as_curve().is_closed());
        }
    }
    Ok(written.exported(file.text.into_bytes(), Vec::new()))
}

/// The labels of a file of the model.
pub(crate) fn labels(model: &Model, bodies: &[BodyOf<'_>]) -> FileLabels {
    let mut names = Vec::new();
    for (index, item) in model.items.iter().enumerate() {
        names.push(FileName::new(OBJECT, on_a_line(&item.name), 0));
        let of_bodies = bodies.iter().filter(|body| body.item == index).map(BodyOf::label);
        let of_contours = contours_of(index, item).map(|contour| contour.label());
        names.extend(of_bodies.chain(of_contours).map(|label| FileName::new(GROUP, on_a_line(&label), 1)));
    }
    FileLabels::new(model.units, names)
}

/// The text with the numbers of vertices and normals so far.
struct File {
    text: String,
    positions: usize,
    normals: usize,
}

impl File {
    /// A line with a name; it ends at the end of the line.
    fn name(&mut self, keyword: &str, name: &str) {
        let _ = writeln!(self.text, "{keyword} {}", on_a_line(name));
    }

    fn numbers(&mut self, keyword: &str, numbers: [f64; 3]) {
        self.text.push_str(keyword);
        for v in numbers {
            self.text.push(' ');
            push_plain(&mut self.text, v);
        }
        self.text.push('\n');
    }

    fn mesh(&mut self, mesh: &SurfaceMesh) {
        for p in &mesh.positions {
            self.numbers("v", p.to_array());
        }
        for n in &mesh.normals {
            self.numbers("vn", n.to_array());
        }
        for face in &mesh.faces {
            self.text.push('f');
            for corner in face.corners() {
                let (position, normal) = (self.positions + corner.position + 1, self.normals + corner.normal + 1);
                let _ = write!(self.text, " {position}//{normal}");
            }
            self.text.push('\n');
        }
        self.positions += mesh.positions.len();
        self.normals += mesh.normals.len();
    }

    /// A polyline; the last vertex of a closed one is its first again.
    fn polyline(&mut self, vertices: &[(CurvePlace, Point3)], closed: bool) {
        let points = if closed { vertices.split_last().map_or(vertices, |(_, rest)| rest) } else { vertices };
        for (_, p) in points {
            self.numbers("v", p.to_array());
        }
        self.text.push('l');
        for i in (0..points.len()).chain(closed.then_some(0)) {
            let _ = write!(self.text, " {}", self.positions + i + 1);
        }
        self.text.push('\n');
        self.positions += points.len();
    }
}
