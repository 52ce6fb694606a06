//! 3MF: watertight meshes of solids with their unit, for 3D printing.
//!
//! A ZIP container of three parts: the types, the relation that names the model, and the model. Its dates are those of the beginning of its calendar, so
//! that the same model gives the same bytes. One object per body, triangles counter-clockwise from outside, vertices in single precision, as
//! printing programs take them, each once. What is open has no inside to be printed and is refused.

mod package;
mod reader;

use crate::check::deviation::{Deviations, MeshForm, Normals};
use crate::check::labels::{FileLabels, FileName, Named};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::mesh::{body_meshes, check_single};
use crate::export::parts::BodyOf;
use crate::export::side_use::side_use;
use crate::export::single_mesh::SingleMesh;
use crate::formats::entry::{Entry, Kind, Reading};
use crate::text::xml::escaped_in_quotes;
use cyclide::model::Units;
use reader::read;
use std::collections::HashMap;
use std::fmt::Write as _;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "3mf",
    title: "3MF",
    suffixes: &["3mf"],
    lacks: Some(Kind::Curves),
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

const OPEN: &str = "an open surface has no interior to print: make it a solid (nets and patches with `offset` and \
                    `\"thick\": true`, pipes with a `wall`), leave it out with `\"construction\": true`, or write STL, PLY, OBJ or GLB";
const TORN: &str =
    "rounding to single precision leaves holes in it: move the model to the origin or use a smaller tolerance";
const NO_UNIT: &str =
    "US survey feet, which are 2 parts per million longer than feet: use `ft` if that does not matter, or another unit";
const TOO_LARGE: &str = "a file of more than 4 GiB: use a larger tolerance";
/// What the names are those of.
const OBJECT: &str = "object";
const TITLE: &str = "title";
/// The units and their words.
const UNITS: [(Units, &str); 5] = [
    (Units::Millimetre, "millimeter"),
    (Units::Centimetre, "centimeter"),
    (Units::Metre, "meter"),
    (Units::Inch, "inch"),
    (Units::Foot, "foot"),
];
/// A triangle with half a vertex in the file, about: a text that grows is twice there while it moves.
const TRIANGLE: usize = 75;
/// Numbers in this range are written without an exponent.
const PLAIN: std::ops::Range<f32> = 1e-5..1e9;

/// Writes the model's solids.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    check_single(job, job.bounds.max_abs(), ENTRY.title)?;
    let refused =
        |body: &BodyOf<'_>, detail| ExportError::NotInFormat { object: body.label(), format: ENTRY.title, detail };
    if let Some(open) = job.bodies.iter().find(|body| !body.body.is_solid()) {
        return Err(refused(open, OPEN));
    }
    if let Some(first) = job.bodies.first().filter(|_| UNITS.iter().all(|(units, _)| *units != job.units())) {
        return Err(refused(first, NO_UNIT));
    }
    let (mut written, mut notes) = (Written::default(), Vec::new());
    let mut resources = String::new();
    for body in body_meshes(job)? {
        let own = SingleMesh::of(job, &body, ENTRY.title)?;
        own.plan(&body, &mut written.mesh);
        written.bodies.push(body.promise(own.moved));
        let mut vertices = Vertices::default();
        let triangles: Vec<[usize; 3]> = own.triangles.iter().map(|t| t.map(|p| vertices.index(p))).collect();
        let sides = side_use(triangles.iter().copied());
        if sides.free > 0 {
            return Err(refused(body.body, TORN));
        }
        if sides.repeated > 0 {
            notes.push(format!(
                "{}: {} triangle edges belong to more than two triangles, where surfaces touch or rounding closes a gap: slicers may offer to repair them",
                body.body.label(),
                sides.repeated
            ));
        }
        push_object(&mut resources, body.index + 1, &body.body.label(), &vertices.places, &triangles);
    }
    let model = model(job, &resources);
    let Some(bytes) = package::pack(&model) else {
        let object = job.bodies.first().map(BodyOf::label).unwrap_or_default();
        return Err(ExportError::NotInFormat { object, format: ENTRY.title, detail: TOO_LARGE });
    };
    Ok(written.exported(bytes, notes))
}

/// Vertices, each once, by the bits of their places.
#[derive(Default)]
struct Vertices {
    places: Vec<[f32; 3]>,
    index: HashMap<[u32; 3], usize>,
}

impl Vertices {
    fn index(&mut self, place: [f32; 3]) -> usize {
        *self.index.entry(place.map(f32::to_bits)).or_insert_with(|| {
            self.places.push(place);
            self.places.len() - 1
        })
    }
}

/// The whole model with its objects.
fn model(job: &Job<'_>, resources: &str) -> String {
    let mut out = String::with_capacity(resources.len() + 1000);
    // Writing to a string cannot fail.
    let _ = write!(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"{}\" xml:lang=\"en-US\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
         <metadata name=\"Title\">{}</metadata>\n<metadata name=\"Application\">cyclide</metadata>\n<resources>\n",
        word_of(job.units()),
        escaped_in_quotes(job.title())
    );
    out.push_str(resources);
    out.push_str("</resources>\n<build>\n");
    for number in 1..=job.bodies.len() {
        let _ = writeln!(out, "<item objectid=\"{number}\"/>");
    }
    out.push_str("</build>\n</model>\n");
    out
}

fn word_of(units: Units) -> &'static str {
    UNITS.iter().find(|(own, _)| *own == units).map_or("millimeter", |(_, word)| word)
}

fn push_object(out: &mut String, number: usize, name: &str, vertices: &[[f32; 3]], triangles: &[[usize; 3]]) {
    out.reserve(triangles.len() * TRIANGLE);
    let name = escaped_in_quotes(name);
    let _ = write!(out, "<object id=\"{number}\" type=\"model\" name=\"{name}\">\n<mesh>\n<vertices>\n");
    for place in vertices {
        let [x, y, z] = place.map(digits);
        let _ = writeln!(out, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    }
    out.push_str("</vertices>\n<triangles>\n");
    for [a, b, c] in triangles {
        let _ = writeln!(out, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>");
    }
    out.push_str("</triangles>\n</mesh>\n</object>\n");
}

/// The shortest digits that are read as this number of single precision.
fn digits(v: f32) -> String {
    if v.abs() <= 0.0 || PLAIN.contains(&v.abs()) { format!("{v}") } else { format!("{v:e}") }
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let bodies = made.meshes(&content, MeshForm { normals: Normals::None, numbers_vertices: true })?;
    content.labels.check(&labels(made.named(), &made.ready.bodies))?;
    Ok(Deviations { bodies, ..Deviations::default() })
}

/// The labels of a file of the model.
fn labels(named: Named<'_>, bodies: &[BodyOf<'_>]) -> FileLabels {
    let mut names = vec![FileName::new(TITLE, escaped_in_quotes(named.title), 1)];
    names.extend(bodies.iter().map(|body| FileName::new(OBJECT, escaped_in_quotes(&body.label()), 1)));
    FileLabels::new(named.model.units, names)
}
