//! Writes PLY: binary, little-endian, one mesh of all surfaces.
//!
//! Vertices have double precision and a normal in single precision; where surfaces meet in a crease their vertices stand there once for each normal. Quads are kept
//! where all faces are quads: else all are triangles, since some readers know one number of corners only. Each vertex says which object it belongs to (some readers take no
//! numbers of faces). The format has no unit: it stands in a comment, as the names do.

use super::{OBJECT, UNITS};
use crate::check::labels::{FileLabels, FileName};
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::mesh::{MeshVertices, body_meshes, polygons, single};
use crate::export::parts::BodyOf;
use crate::text::lines::printable;
use cyclide::model::{Model, Units};
use std::fmt::Write as _;

/// Bytes of a vertex and of a quad.
const VERTEX: usize = 40;
const QUAD: usize = 17;

/// Writes the model's surfaces.
pub(super) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let (mut vertices, mut faces, mut written) = (Vec::new(), Vec::new(), Written::default());
    let (mut vertex_count, mut face_count) = (0, 0);
    let meshes = body_meshes(job)?;
    // Some readers know faces of one number of corners only.
    let all_quads = meshes.iter().flat_map(|body| &body.mesh.faces).all(|face| face.corners().len() == 4);
    for body in meshes {
        let mesh = &body.mesh;
        let mut own = MeshVertices::default();
        faces.reserve(mesh.faces.len() * QUAD);
        for polygon in mesh.faces.iter().flat_map(|face| polygons(face, !all_quads)) {
            faces.push(polygon.len() as u8);
            for corner in polygon {
                let Ok(index) = i32::try_from(vertex_count + own.index(corner)) else {
                    let (object, detail) = (body.body.object.to_owned(), "more than 2147483647 vertices");
                    return Err(ExportError::NotInFormat { object, format: "PLY", detail });
                };
                faces.extend(index.to_le_bytes());
            }
            face_count += 1;
        }
        vertices.reserve(own.corners.len() * VERTEX);
        for corner in &own.corners {
            mesh.positions[corner.position].to_array().iter().for_each(|x| vertices.extend((x + 0.0).to_le_bytes()));
            mesh.normals[corner.normal].to_array().iter().for_each(|x| vertices.extend(single(*x).to_le_bytes()));
            vertices.extend((body.body.item as i32).to_le_bytes());
        }
        vertex_count += own.corners.len();
        body.plan_places(!all_quads, &mut written.mesh);
        written.bodies.push(body.promise(0.0));
    }
    let mut bytes = head(job, vertex_count, face_count).into_bytes();
    bytes.append(&mut vertices);
    bytes.append(&mut faces);
    let mut notes = Vec::new();
    if job.units() != Units::Millimetre {
        let symbol = job.units().symbol();
        notes.push(format!(
            "PLY has no unit, and most readers assume mm or m; the coordinates are in {symbol}, as a comment in the file states"
        ));
    }
    Ok(written.exported(bytes, notes))
}

fn head(job: &Job<'_>, vertices: usize, faces: usize) -> String {
    let mut out = format!("ply\nformat binary_little_endian 1.0\ncomment {UNITS}{}\n", job.units().symbol());
    // Writing to a string cannot fail.
    for (number, item) in job.model.items.iter().enumerate() {
        let _ = writeln!(out, "comment {OBJECT} {number}: {}", printable(&item.name));
    }
    let _ = writeln!(out, "element vertex {vertices}");
    ["x", "y", "z"].iter().for_each(|name| out.push_str(&format!("property double {name}\n")));
    ["nx", "ny", "nz"].iter().for_each(|name| out.push_str(&format!("property float {name}\n")));
    let _ = write!(
        out,
        "property int {OBJECT}\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    );
    out
}

/// The labels of a file of the model: each object with its name, and where its vertices stand.
pub(super) fn labels(model: &Model, bodies: &[BodyOf<'_>]) -> FileLabels {
    let mut names: Vec<FileName> =
        model.items.iter().map(|item| FileName::new(OBJECT, printable(&item.name).trim(), 1)).collect();
    let mut objects: Vec<usize> = bodies.iter().map(|body| body.item).collect();
    objects.dedup();
    names.extend(objects.into_iter().map(|object| FileName::new("vertices of", object.to_string(), 1)));
    FileLabels::new(model.units, names)
}
