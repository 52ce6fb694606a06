//! Binary STL: triangles of surfaces, for printing.
//!
//! 80 bytes of head that do not start with `solid`, the number of triangles, 50 bytes for each: normal and corners in
//! single precision, little-endian. Coordinates are the model's own (readers take them for millimeters), rounded; equal
//! vertices are equal bits. The promised bound is that of the mesh and the rounding, which must not exceed the tolerance.

mod reader;
mod triangles;

use crate::check::deviation::{Deviations, MeshForm, Normals};
use crate::check::labels::{FileLabels, FileName, Named};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::collapsed::Triangle;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::mesh::{body_meshes, check_single, single};
use crate::export::single_mesh::SingleMesh;
use crate::formats::entry::{Entry, Kind, Reading};
use crate::formats::mesh_entry::{MeshEntry, ReadMesh};
use crate::text::lines::printable;
use cyclide::{Point3, model::Units};

use reader::read;
use triangles::read_triangles;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "stl",
    title: "STL",
    suffixes: &["stl"],
    lacks: Some(Kind::Curves),
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// What there is to know of meshes in it.
pub(super) const MESH_ENTRY: MeshEntry = MeshEntry {
    word: "stl",
    field: "Path of an STL file, binary or text, relative to the document.",
    is_start: |text| text.starts_with("solid") && text.contains("facet"),
    read: |name, bytes| read_triangles(name, bytes).map(ReadMesh::of_triangles),
    has_quads: false,
    is_single: true,
    shares_vertices: false,
    without_normals: "STL has normals of triangles, not of vertices: use \"angle\" or \"sphere\"",
};

/// Length of the head, and of the record of a triangle.
const HEAD: usize = 80;
const RECORD: usize = 50;
/// How the head starts, before the unit, and what stands between the unit and the title.
const UNITS: &str = "cyclide, units ";
const SEPARATOR: &str = ", ";
/// What the name is that of.
const TITLE: &str = "title";

/// Writes the model's surfaces.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    check_single(job, job.bounds.max_abs(), "STL")?;
    let (mut records, mut written) = (Vec::new(), Written::default());
    let mut count = 0_usize;
    for body in body_meshes(job)? {
        let own = SingleMesh::of(job, &body, "STL")?;
        own.plan(&body, &mut written.mesh);
        own.triangles.iter().for_each(|triangle| push_triangle(&mut records, triangle));
        count += own.triangles.len();
        written.bodies.push(body.promise(own.moved));
    }
    let Ok(count) = u32::try_from(count) else {
        let object = job.bodies.first().map(|b| b.object.to_owned()).unwrap_or_default();
        return Err(ExportError::NotInFormat { object, format: "STL", detail: "more than 4294967295 triangles" });
    };
    let mut bytes = head(job);
    bytes.extend(count.to_le_bytes());
    bytes.append(&mut records);
    let mut notes = Vec::new();
    if job.units() != Units::Millimetre {
        notes.push(format!(
            "STL has no unit, and most readers assume mm; the coordinates are in {}",
            job.units().symbol()
        ));
    }
    Ok(written.exported(bytes, notes))
}

/// The head: program, unit and title as far as they fit, padded with spaces.
fn head(job: &Job<'_>) -> Vec<u8> {
    let mut head = format!("{UNITS}{}{SEPARATOR}{}", job.units().symbol(), printable(job.title())).into_bytes();
    head.resize(HEAD, b' ');
    head
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let bodies = made.meshes(&content, MeshForm { normals: Normals::OfTriangles, numbers_vertices: false })?;
    content.labels.check(&labels(made.named()))?;
    Ok(Deviations { bodies, ..Deviations::default() })
}

/// The labels of a file of the model.
fn labels(named: Named<'_>) -> FileLabels {
    let room = HEAD - UNITS.len() - named.model.units.symbol().len() - SEPARATOR.len();
    let mut title = printable(named.title);
    title.truncate(room);
    FileLabels::new(named.model.units, vec![FileName::new(TITLE, title.trim_end(), 1)])
}

fn push_triangle(out: &mut Vec<u8>, corners: &Triangle) {
    let [a, b, c] = corners.map(|p| Point3::from(p.map(f64::from)));
    // A sliver on a line has no normal; readers then find their own.
    let normal = (b - a).unit().zip((c - a).unit()).and_then(|(u, v)| u.cross(v).unit()).unwrap_or_default();
    for v in normal.to_array().map(single).iter().chain(corners.as_flattened()) {
        out.extend(v.to_le_bytes());
    }
    out.extend([0; 2]);
}
