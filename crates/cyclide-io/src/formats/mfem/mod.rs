//! MFEM NURBS meshes: patches of B-splines with weights, for finite elements on the exact geometry.
//!
//! A mesh has one dimension: the blocks of a model, else its faces, else its curves. Patches that share a side share its corners, and with them its
//! control points; parallel edges share a knot vector. The attribute of an element is its object, from 1; that of a side of the boundary says object and
//! side. Names, the unit and what each patch belongs to stand in comments.

mod reader;
mod topology;

use crate::check::deviation::{Deviations, View};
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::rational_cells::bodies_deviation;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::rational_cells::Tags;
use crate::export::ready::ReadyModel;
use crate::export::spline_patches::{SplinePatch, push_curves, push_surfaces_and_volumes};
use crate::formats::entry::{Entry, Reading};
use crate::text::lines::on_a_line;
use crate::text::number::push_spaced;
use cyclide::model::{Geometry, Item, Model};
use reader::read;
use std::fmt::Write as _;
use topology::Topology;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "mfem",
    title: "MFEM",
    suffixes: &["mesh"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::CHAINS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// First line of a file.
const HEAD: &str = "MFEM NURBS mesh v1.0";
/// What stands before the unit, and between the number of an attribute and its name.
const UNITS: &str = "# cyclide, units ";
const ATTRIBUTE: &str = "# attribute ";
/// Degrees beyond it MFEM 4.10 reads wrongly, without a word.
const MOST_DEGREE: usize = 10;
const DEGREE_TOO_HIGH: &str = "a degree above 10, which MFEM silently misreads: write G+Smo XML, VTU or STEP";
/// Nodes of VTK's and MFEM's elements in binary order, and MFEM's numbers for their kinds.
const ORDERS: [&[usize]; 3] = [&[0, 1], &[0, 1, 3, 2], &[0, 1, 3, 2, 4, 5, 7, 6]];
const KINDS: [usize; 4] = [0, 1, 3, 5];
/// A patch and a control point in the file, about: a text that grows is twice there while it moves.
const PATCH: usize = 300;
const CONTROL_POINT: usize = 80;

/// Writes the model.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let dimension = dimension_of(job.model);
    let (mut written, mut patches) = (Written::default(), Vec::new());
    if dimension == 1 {
        push_curves(job, &mut patches, &mut written)?;
    }
    push_surfaces_and_volumes(job, Some(dimension), &mut patches, &mut written)?;
    for patch in &patches {
        if patch.knots.iter().any(|knots| knots.degree > MOST_DEGREE) {
            let object = job.model.items.get(patch.net.tags.object).map_or_else(String::new, |item| item.name.clone());
            return Err(ExportError::NotInFormat { object, format: ENTRY.title, detail: DEGREE_TOO_HIGH });
        }
    }
    let topology = Topology::of(&patches);
    let mut notes = Vec::new();
    notes.extend(left_out(job.model, dimension));
    // Curves often begin where others do.
    if topology.apart > 0 && dimension > 1 {
        notes.push(format!(
            "{} patch sides touch others without being joined to them: weights or parameters differ there, or more than two sides meet",
            topology.apart
        ));
    }
    let names: Vec<&str> = job.model.items.iter().map(|item| item.name.as_str()).collect();
    Ok(written.exported(text(&patches, &topology, dimension, job.units().symbol(), &names).into_bytes(), notes))
}

/// Blocks are 3, faces 2, curves 1: what there is with most.
fn dimension_of(model: &Model) -> usize {
    model.items.iter().map(dimension_of_item).max().unwrap_or(1).max(1)
}

/// 0 of an object without any.
fn dimension_of_item(item: &Item) -> usize {
    match &item.geometry {
        Geometry::Volumes(volumes) if !volumes.is_empty() => 3,
        Geometry::Surfaces(surfaces) if !surfaces.is_empty() => 2,
        Geometry::Curves(curves) if !curves.is_empty() => 1,
        Geometry::Grids(_) => 1,
        _ => 0,
    }
}

/// A note on the objects of other dimensions.
fn left_out(model: &Model, dimension: usize) -> Option<String> {
    let others = model.items.iter().filter(|item| ![0, dimension].contains(&dimension_of_item(item)));
    let names: Vec<&str> = others.map(|item| item.name.as_str()).collect();
    let kept = ["curves", "surfaces", "volumes"][dimension - 1];
    (!names.is_empty()).then(|| {
        format!("only {kept} are written, since an MFEM mesh has one dimension; left out: {}", names.join(", "))
    })
}

/// The file.
fn text(patches: &[SplinePatch], topology: &Topology, dimension: usize, units: &str, names: &[&str]) -> String {
    let points: usize = patches.iter().map(|patch| patch.net.nodes.len()).sum();
    let mut out = String::with_capacity(patches.len() * PATCH + points * CONTROL_POINT);
    // Writing to a string cannot fail.
    let _ = write!(out, "{HEAD}\n\n{UNITS}{units}\n");
    for (number, name) in names.iter().enumerate() {
        let _ = writeln!(out, "{ATTRIBUTE}{}: {}", number + 1, on_a_line(name));
    }
    let _ = write!(out, "\ndimension\n{dimension}\n\nelements\n{}\n", patches.len());
    for (patch, corners) in patches.iter().zip(&topology.elements) {
        push_element(&mut out, patch.net.tags.object + 1, dimension, corners);
    }
    let _ = write!(out, "\nboundary\n{}\n", topology.boundary.len());
    for (side, corners) in &topology.boundary {
        let attribute = 2 * dimension * patches[side.0].net.tags.object + side.1 + 1;
        push_element(&mut out, attribute, dimension - 1, corners);
    }
    let _ = write!(out, "\nedges\n{}\n", topology.edges.len());
    for [knots, from, to] in &topology.edges {
        let _ = writeln!(out, "{knots} {from} {to}");
    }
    let _ = write!(out, "\nvertices\n{}\n\npatches\n", topology.vertices);
    for SplinePatch { knots, net } in patches {
        let Tags { object, part, shell, flag } = net.tags;
        let _ = write!(out, "\n# object {object}, part {part}, shell {shell}, flag {flag}\nknotvectors\n{dimension}\n");
        for (axis, knots) in knots.iter().enumerate() {
            let _ = write!(out, "{} {} ", knots.degree, net.degrees[axis] + 1);
            push_spaced(&mut out, knots.knots.iter().copied());
            out.push('\n');
        }
        out.push_str("dimension\n3\ncontrolpoints_cartesian\n");
        for index in net.first_fastest() {
            let ([x, y, z], w) = net.node(index);
            push_spaced(&mut out, [x, y, z, w]);
            out.push('\n');
        }
    }
    out
}

/// An element of the boundary or the mesh: its attribute, its kind, and its corners, which are in binary order here.
fn push_element(out: &mut String, attribute: usize, dimension: usize, corners: &[usize]) {
    let _ = write!(out, "{attribute} {}", KINDS[dimension]);
    let order = if dimension == 0 { &[0][..] } else { ORDERS[dimension - 1] };
    for &corner in order {
        let _ = write!(out, " {}", corners[corner]);
    }
    out.push('\n');
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let ReadyModel { model, .. } = made.ready;
    let names = model.items.iter().map(|item| FileName::new(reader::NAME, on_a_line(&item.name), 1)).collect();
    content.labels.check(&FileLabels::new(model.units, names))?;
    let dimension = dimension_of(model);
    let curves = if dimension == 1 { made.curves(&content, View::Space)? } else { Vec::new() };
    if dimension != 1 && !content.curves.is_empty() {
        return Err(ReadError::CurveCount { found: content.curves.len(), expected: 0 });
    }
    let bodies = bodies_deviation(made, &content, Some(dimension))?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}
