//! CSV of points along the curves, with tangent and curvature, for plotting and for programs that take polylines.
//!
//! One row per vertex of the polyline within the tolerance: object, contour (from 0), global parameter, point, unit
//! tangent, curvature. A closed curve's last row repeats its first point. Where the tangent or the curvature does
//! not exist, its fields are empty.

use crate::check::deviation::{Deviations, SampleCheck, View};
use crate::check::file_content::FileContent;
use crate::check::file_sample::FileSample;
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::polyline::Polyline;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::mesh::between;
use crate::export::parts::{Contour, contours};
use crate::formats::entry::{Entry, Kind, Reading};
use crate::text::number::push_plain;
use cyclide::{
    Point3,
    model::{CurveChain, Model},
};

const HEADER: &str = "object,contour,t,x,y,z,tangent_x,tangent_y,tangent_z,curvature";
const COLUMNS: usize = 10;
/// Length of the numbers of a row, about. What is reserved and not used costs nothing; a text that grows is twice there
/// while it moves.
const NUMBERS: usize = 180;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "csv",
    title: "CSV",
    suffixes: &["csv"],
    lacks: Some(Kind::Surfaces),
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read: read_whole, compare, rounds_by_model: false }),
};

/// Writes the model as CSV.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut out = format!("{HEADER}\n");
    let mut written = Written::default();
    for contour in job.contours() {
        let vertices = contour.lowered(job.pieces.flatten(contour.curve.as_curve(), job.tolerance))?;
        let head = format!("{},{},", field(contour.object), contour.index);
        out.reserve(vertices.len() * (head.len() + NUMBERS));
        for (place, point) in &vertices {
            out.push_str(&head);
            push_sample(&mut out, *point, &FileSample::at(contour.curve.as_curve(), *place));
        }
        let promise = Promise::of_polyline(contour.curve.as_curve(), job.tolerance);
        written.curves.push(promise.of(between(&vertices)));
    }
    Ok(written.exported(out.into_bytes(), Vec::new()))
}

/// The fields parameter, point, unit tangent, curvature, and the end of the line.
pub(crate) fn push_sample(out: &mut String, point: Point3, &FileSample { t, tangent, curvature }: &FileSample) {
    push_plain(out, t);
    for v in point.to_array() {
        out.push(',');
        push_plain(out, v);
    }
    for i in 0..3 {
        out.push(',');
        if let Some(tangent) = tangent {
            push_plain(out, tangent[i]);
        }
    }
    out.push(',');
    if let Some(curvature) = curvature {
        push_plain(out, curvature);
    }
    out.push('\n');
}

/// A name as a field: quoted where it has to be (RFC 4180); line breaks become spaces, one row stays one line.
fn field(name: &str) -> String {
    let name = name.replace(['\n', '\r'], " ");
    if name.contains([',', '"']) || name.starts_with('#') || name.trim() != name {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name
    }
}

/// Reads the polylines and what is said of each of their points.
fn read_whole(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let mut samples: Vec<Vec<FileSample>> = Vec::new();
    let content = read(bytes, |curve, sample| {
        samples.resize_with(samples.len().max(curve + 1), Vec::new);
        samples[curve].push(sample);
        Ok(())
    })?;
    Ok(FileContent { samples, ..content })
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let model = made.ready.model;
    let mut check = SampleCheck::new(model, &made.file.written.curves);
    let content = read(&made.file.bytes, |curve, sample| check.row(curve, &sample))?;
    check.finish()?;
    let curves = made.curves(&content, View::Points)?;
    content.labels.check(&labels(model))?;
    Ok(Deviations { curves, ..Deviations::default() })
}

/// Reads the polylines: rows of one object and contour that follow each other. What is said of their points is handed on,
/// with the number of the curve.
fn read(
    bytes: &[u8],
    mut found: impl FnMut(usize, FileSample) -> Result<(), ReadError>,
) -> Result<FileContent, ReadError> {
    let text = std::str::from_utf8(bytes).map_err(|e| ReadError::syntax("the text", e.to_string()))?;
    let mut lines = text.lines().enumerate().map(|(i, l)| (i + 1, l));
    // No row is shorter than two letters for each of its fields.
    let mut left = text.lines().count().min(text.len() / (2 * COLUMNS));
    if lines.next().is_none_or(|(_, l)| l != HEADER) {
        return Err(ReadError::syntax("line 1", format!("expected {HEADER}")));
    }
    let mut chains = Vec::new();
    let mut names = Vec::new();
    let mut key = None;
    // Segments as they come: a list of the points beside them would be a third of the file.
    let mut polyline = Polyline::with_capacity(0);
    for (number, line) in lines {
        let place = || format!("line {number}");
        let (name, rest) = split_name(line).ok_or_else(|| ReadError::syntax(place(), "unterminated quote"))?;
        let fields: Vec<&str> = rest.split(',').collect();
        if fields.len() != COLUMNS - 1 {
            return Err(ReadError::syntax(place(), format!("expected {COLUMNS} fields")));
        }
        let number = |i: usize| {
            let v: Result<f64, _> = fields[i].parse();
            v.map_err(|_| ReadError::syntax(place(), format!("'{}' is not a number", fields[i])))
        };
        let optional = |i: usize| if fields[i].is_empty() { Ok(None) } else { number(i).map(Some) };
        let tangent = match [optional(5)?, optional(6)?, optional(7)?] {
            [None, None, None] => None,
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => return Err(ReadError::syntax(place(), "a component of the tangent is missing")),
        };
        let sample = FileSample { t: number(1)?, tangent, curvature: optional(8)? };
        let here = Some((name, fields[0]));
        if key != here {
            finish(&mut polyline, &mut chains, place)?;
            key = here;
            names.extend(names_of(name, fields[0]));
            // The first curve is mostly the only one.
            polyline = Polyline::with_capacity(if chains.is_empty() { left } else { 0 });
        }
        left = left.saturating_sub(1);
        // The chain of this curve is still to come.
        found(chains.len(), sample)?;
        polyline.push(Point3::new(number(2)?, number(3)?, number(4)?), place)?;
    }
    finish(&mut polyline, &mut chains, || "the end".to_owned())?;
    let labels = FileLabels { unit: None, names };
    Ok(FileContent { curves: chains, labels, ..FileContent::default() })
}

/// The labels of a file of the model.
fn labels(model: &Model) -> FileLabels {
    let of_contour = |contour: Contour<'_>| names_of(&field(contour.object), &contour.index.to_string());
    FileLabels { unit: None, names: contours(model).flat_map(of_contour).collect() }
}

/// What one polyline is called.
fn names_of(object: &str, contour: &str) -> [FileName; 2] {
    [FileName::new("object", object, 1), FileName::new("contour", contour, 1)]
}

/// The first field as it stands, and the text behind its comma.
fn split_name(line: &str) -> Option<(&str, &str)> {
    if !line.starts_with('"') {
        return line.split_once(',');
    }
    // An even number of quotes before the comma ends the field.
    let mut open = false;
    let end = line.char_indices().find(|&(_, c)| {
        open ^= c == '"';
        !open && c == ','
    })?;
    Some((&line[..end.0], &line[end.0 + 1..]))
}

fn finish(polyline: &mut Polyline, chains: &mut Vec<CurveChain>, place: impl Fn() -> String) -> Result<(), ReadError> {
    if !polyline.is_empty() {
        chains.push(std::mem::replace(polyline, Polyline::with_capacity(0)).finish(place)?);
    }
    Ok(())
}
