//! Binary STL: triangles of surfaces, for printing.
//!
//! 80 bytes of head that do not start with `solid`, the number of triangles, 50 bytes for each: normal and corners in
//! single precision, little-endian. Coordinates are the model's own (readers take them for millimetres), rounded; equal
//! vertices are equal bits. The promised bound is that of the mesh and the rounding, which must not exceed the tolerance.

mod collapsed;
mod reader;
mod triangles;

use crate::check::deviation::{Deviations, MeshForm};
use crate::check::file_content::ReadError;
use crate::check::labels::{FileLabels, FileName, Named};
use crate::check::made::Made;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::mesh::{Single, body_meshes, check_single, single, triangles};
use crate::export::parts::BodyOf;
use crate::formats::entry::{Entry, Kind, Reading};
use crate::formats::mesh_format::{MeshEntry, ReadMesh};
use cyclide::{Point3, Units};

use collapsed::{Triangle, is_whole, reach};

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
    without_normals: "STL has normals of triangles, not of vertices: take \"angle\" or \"sphere\"",
};

/// Length of the head, and of the record of a triangle.
const HEAD: usize = 80;
const RECORD: usize = 50;
/// How the head starts, before the unit, and what stands between the unit and the title.
const UNITS: &str = "cyclide, units ";
const SEPARATOR: &str = ", ";
/// Why a body is refused that is thinner than the steps of single precision at its place.
const NOTHING_LEFT: &str = "single precision leaves nothing of one of its bodies: write OBJ or GLB, which counts from the middle of each object";
const PART_LEFT_OUT: &str = "single precision leaves nothing of a part of one of its bodies: write OBJ or GLB, which counts from the middle of each object";
/// What the name is that of.
const TITLE: &str = "title";

/// Writes the model's surfaces.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    check_single(job, job.bounds.max_abs(), "STL")?;
    let (mut records, mut written) = (Vec::new(), Written::default());
    let mut count = 0_usize;
    for body in body_meshes(job)? {
        let mesh = &body.mesh;
        let mut rounding = Single::new(Point3::ORIGIN);
        let points: Vec<[f32; 3]> = mesh.positions.iter().map(|p| rounding.point(*p)).collect();
        check_rounding(job, body.body, rounding.moved)?;
        let of_face = |face: &cyclide::MeshFace| -> Vec<Triangle> {
            let corners = face.corners();
            triangles(face).iter().map(|t| t.map(|i| points[corners[i].position])).collect()
        };
        let (mut own, mut collapsed, mut counts) = (Vec::new(), Vec::new(), Vec::with_capacity(mesh.faces.len()));
        for face in &mesh.faces {
            let before = own.len();
            for triangle in of_face(face) {
                if is_whole(&triangle) { own.push(triangle) } else { collapsed.push(triangle) }
            }
            counts.push(own.len() - before);
        }
        let moved = rounding.moved + reach(&own, &collapsed);
        if !(moved <= job.mesh_tolerance) {
            let detail = if own.is_empty() { NOTHING_LEFT } else { PART_LEFT_OUT };
            return Err(ExportError::NotInFormat { object: body.body.object.to_owned(), format: "STL", detail });
        }
        let mut counts = counts.into_iter();
        body.plan_triangles(&points, rounding.moved, |_| counts.next().unwrap_or(0), &mut written.mesh);
        own.iter().for_each(|triangle| push_triangle(&mut records, triangle));
        count += own.len();
        written.bodies.push(body.promise(moved));
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
            "STL has no unit and most readers take it for mm; the coordinates are in {}",
            job.units().symbol()
        ));
    }
    Ok(written.exported(bytes, notes))
}

/// Refuses coordinates that single precision rounds by more than the tolerance.
fn check_rounding(job: &Job<'_>, body: &BodyOf<'_>, rounding: f64) -> Result<(), ExportError> {
    if rounding <= job.mesh_tolerance {
        return Ok(());
    }
    let (bounds, half) = (body.body.bounds(), 0.5 * job.size());
    let largest = bounds.max_abs();
    // About the origin coordinates would not be larger than half the size, and rounded by so much less.
    let hint = if rounding * half <= job.mesh_tolerance * largest {
        "move the model to the origin, or write OBJ, or GLB, which counts from the middle of each object"
    } else {
        "allow a larger tolerance or write OBJ"
    };
    let object = body.object.to_owned();
    Err(ExportError::Rounding { object, format: "STL", largest, rounding, tolerance: job.mesh_tolerance, hint })
}

/// The head: program, unit and title as far as they fit, padded with spaces.
fn head(job: &Job<'_>) -> Vec<u8> {
    let mut head = format!("{UNITS}{}{SEPARATOR}{}", job.units().symbol(), printable(job.title())).into_bytes();
    head.resize(HEAD, b' ');
    head
}

/// Printable ASCII, a `?` for every other byte.
fn printable(text: &str) -> String {
    text.bytes().map(|b| if (0x20..0x7F).contains(&b) { char::from(b) } else { '?' }).collect()
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let bodies = made.meshes(&content, MeshForm { has_facet_normals: true, numbers_vertices: false })?;
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
