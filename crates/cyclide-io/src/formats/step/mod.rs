//! STEP AP214 (ISO 10303-21): curves without faces, and bodies.
//!
//! One `GEOMETRIC_CURVE_SET` per object, in it one `COMPOSITE_CURVE` per connected curve, so that a reader gets one
//! wire per connected curve, closed where it is closed. Full circles are `CIRCLE`s, arcs trimmed ones, segments
//! trimmed `LINE`s, rational splines B-splines; nothing is approximated that is exact in the kernel. Coordinates are written as they
//! are and the file says their unit. The time stamp is fixed: the same model gives the same bytes.
//!
//! Bodies are `SHELL_BASED_SURFACE_MODEL`s of open shells, or `MANIFOLD_SOLID_BREP`s. Every shared edge is one
//! `EDGE_CURVE`, every shared corner one `VERTEX_POINT`; a side that is one point is left out of its loop. Circles and
//! lines on rational faces carry their curves in the faces' parameters, which readers cannot find exactly, as rational edges
//! on cylinders and cones do; with rational edges there are none, and all faces but planes are rational. All weights are positive: faces are halved until they
//! are.
//!
//! Every object has its colors and its layer, and is a product of its own if not asked otherwise.

mod body_check;
mod curves;
mod data;
mod integration;
mod labels;
mod layout;
mod parameter_curves;
mod part;
mod part21;
mod polar_curves;
mod reader;
mod structure;
mod styles;
mod surfaces;
mod topology;

use crate::check::deviation::{Deviations, View};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, PieceNotes, Promise, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::{StepFaces, StepProducts};
use crate::export::parts::Contour;
use crate::formats::entry::{Entry, Reading};
use cyclide::{
    ShortNumber,
    model::{ChainPiece, CurveChain, CurveObject, Lowered, Units},
    topology::Shell,
};
use data::Data;
use part::Part;
use topology::Entity;

use body_check::bodies_deviation;
use labels::labels;
use reader::read;

/// OpenCASCADE takes points nearer than this for one, whatever the unit of the file, in millimeters: faces with shorter edges come out of it
/// invalid.
const ONE_POINT: f64 = 1e-7;
/// Shorter edges are noted, in millimeters.
const SHORTEST_EDGE: f64 = 1e-6;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "step",
    title: "STEP",
    suffixes: &["step", "stp"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::CHAINS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: true }),
};

/// Writes the model as STEP.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut data = Data::default();
    let mut written = Written::default();
    let mut notes = Vec::new();
    let mut shortest = f64::INFINITY;
    let mut parts: Vec<Part> =
        job.model.items.iter().enumerate().map(|(index, item)| Part::new(&item.name, index)).collect();
    let mut curves = Vec::new();
    for contour in job.contours() {
        curves.push(if let CurveObject::Circle(circle) = contour.curve {
            written.curves.push(Promise::EXACT.of(job.chain(&contour)?.correspondence));
            curves::full_circle(&mut data, &contour.label(), circle)
        } else {
            let lowered = job.chain(&contour)?;
            let promise = Promise::of_chain(&lowered);
            let Lowered { form: chain, correspondence, .. } = lowered;
            shortest = shortest.min(shortest_piece(&chain));
            let mut pieces = PieceNotes::default();
            let composite = curves::composite(&mut data, &contour.label(), chain, job.size(), &mut pieces);
            written.curves.push(pieces.of(promise, correspondence));
            composite
        });
        if contour.index + 1 == contour.count {
            parts[contour.item].curve_sets.push(curve_set(&mut data, &contour, &std::mem::take(&mut curves)));
        }
    }
    for body in job.bodies {
        let lowered = |source| body.unfit(source);
        // What has none was refused.
        let Some(faces) = body.body.faces() else { continue };
        written.bodies.push(Promise::EXACT);
        let too_short = |length: f64| {
            let (object, length) = (body.label(), length * job.units().in_millimetres());
            ExportError::EdgeTooShort { object, format: ENTRY.name, length, limit: ONE_POINT }
        };
        // Before faces are cut, which beside an edge that is next to nothing they are into many.
        let edges = faces.shells().flat_map(Shell::edges).map(|edge| edge.curve.length());
        let least = edges.fold(f64::INFINITY, f64::min);
        if least * job.units().in_millimetres() < ONE_POINT {
            return Err(too_short(least));
        }
        let faces_of = match job.options.step_faces {
            StepFaces::Auto if job.provenances.has_panels(body.item) => StepFaces::Split,
            StepFaces::Auto => StepFaces::Merged,
            typed => typed,
        };
        let forms = (job.options.step_edges, faces_of);
        let as_written = topology::body(&mut data, &body.label(), faces, job.size(), forms).map_err(lowered)?;
        if as_written.shortest * job.units().in_millimetres() < ONE_POINT {
            return Err(too_short(as_written.shortest));
        }
        shortest = shortest.min(as_written.shortest);
        if as_written.touches_itself {
            notes.push(format!(
                "{} touches itself at isolated points: written as closed shells, not as a solid",
                body.label()
            ));
        }
        written.shells.push(as_written.shells);
        match as_written.entity {
            Entity::Solid(number) => parts[body.item].solids.push(number),
            Entity::Surface(number) => parts[body.item].surfaces.push(number),
        }
    }
    let shortest = shortest * job.units().in_millimetres();
    if shortest < SHORTEST_EDGE {
        notes.push(format!(
            "an edge is only {} mm long: STEP readers merge points closer than {ONE_POINT:e} mm",
            ShortNumber(shortest)
        ));
    }
    parts.retain(|part| !part.items().is_empty());
    let mixed = parts.iter().any(|p| !p.curve_sets.is_empty()) && parts.iter().any(Part::has_faces);
    let one = parts.len() == 1
        || match job.options.step_products {
            StepProducts::Auto => mixed,
            StepProducts::Assembly => false,
            StepProducts::One => true,
        };
    if one && parts.len() > 1 && job.options.step_products == StepProducts::Auto {
        notes.push(
            "curves and surfaces are written as one product, which more readers support; --step-products assembly \
             writes a product per object"
                .to_owned(),
        );
    }
    structure::products(&mut data, job.title(), &parts, one, job.units());
    let text = structure::file(data, job.title());
    Ok(written.exported(text.into_bytes(), notes))
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let curves = made.curves(&content, View::Space)?;
    let bodies = bodies_deviation(made, &content.bodies)?;
    content.labels.check(&labels(made.named(), &made.ready.bodies, &content.labels))?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}

fn curve_set(data: &mut Data, contour: &Contour<'_>, curves: &[usize]) -> usize {
    let (name, list) = (data::string(contour.object), data::references(curves));
    data.add(&format!("GEOMETRIC_CURVE_SET({name},{list})"))
}

/// Shortest chord of an arc, or extent of a spline.
fn shortest_piece(chain: &CurveChain) -> f64 {
    let extent = |piece: &ChainPiece| match piece {
        ChainPiece::Arc(arc) => arc.length(),
        ChainPiece::Spline(curve) => cyclide::curve::bounds(curve).diagonal(),
    };
    chain.pieces().iter().map(extent).fold(f64::INFINITY, f64::min)
}

/// Name of a unit that is no metric one, with its length in millimeters; `None` for metric units.
fn conversion(units: Units) -> Option<&'static str> {
    match units {
        Units::Inch => Some("INCH"),
        Units::Foot => Some("FOOT"),
        Units::UsSurveyFoot => Some("US_SURVEY_FOOT"),
        Units::Millimetre | Units::Centimetre | Units::Metre => None,
    }
}
