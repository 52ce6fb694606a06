//! JSON of the exact rational B-splines and surfaces, for programs that compute with them.
//!
//! ```text
//! {"cyclide-nurbs": 1, "units": "mm", "objects": {"NAME": {"type": "arc-spline", "contours": [
//!   {"closed": true, "exact": true, "bound": 0, "curves": [
//!     {"degree": 2, "knots": [...], "control_points": [[x, y, z], ...], "weights": [...]}, ...]}, ...]}}}
//! ```
//! Knots are clamped and of length points + degree + 1; control points are affine (not multiplied by their weight),
//! weights positive. A run of arcs and segments is one curve of degree 2: knot `i` to `i + 1` is its `i`-th arc, in
//! equal parts of at most a quarter turn. A smooth rational spline is one curve. The curves of a contour follow each
//! other end to end. `bound` is the largest distance from the object, 0 if exact.
//!
//! An object with surfaces has the list `surfaces` as well, one element per body:
//! ```text
//! {"closed": true, "exact": true, "shells": [{"patches": [
//!   {"outward": true, "degrees": [2, 2], "knots": [[...], [...]], "control_points": [[x, y, z], ...],
//!    "weights": [...]}, ...]}, ...]}
//! ```
//! The second parameter runs fastest in the lists of points and weights. `outward` is true if the outer side of the
//! body is that of `f_s × f_t`. Patches whose weights are not all positive are cut into patches whose weights are.

mod reader;
mod surfaces;

use crate::check::deviation::{Deviations, View};
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::rational_patches::patches_deviation;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, PieceNotes, Promise, Written, WrittenCurve};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::parts::Contour;
use crate::export::ready::ReadyModel;
use crate::formats::entry::{Entry, Reading};
use crate::text::number::push_plain;
use cyclide::{
    Point3,
    curve::{DEFAULT_PIECE_ANGLE, ParamCurve as _},
    model::{ChainPiece, CurveChain, Exactness, Lowered},
    rational::NurbsCurve,
};
use serde_json::Value;

use reader::read;

/// Length of an arc and of a control point with weight and knot, about: a text that grows is twice there while it moves.
const ARC: usize = 260;
const CONTROL_POINT: usize = 110;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "json",
    title: "a file of exact B-splines",
    suffixes: &["json"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::CHAINS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// Writes the model as JSON.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let mut written = Written::default();
    let mut out = format!("{{\n\"cyclide-nurbs\": 1,\n\"units\": \"{}\",\n\"objects\": {{", job.units().symbol());
    for (index, item) in job.model.items.iter().enumerate() {
        let (name, kind) = (quoted(&item.name), quoted(job.provenances.kind(index)));
        out.push_str(if index == 0 { "\n" } else { ",\n" });
        out.push_str(&format!("{name}: {{\"type\": {kind}, \"contours\": ["));
        for contour in job.contours().filter(|contour| contour.item == index) {
            let lowered = job.chain(&contour)?;
            out.push_str(if contour.index == 0 { "\n" } else { ",\n" });
            written.curves.push(push_contour(&mut out, &contour, lowered)?);
        }
        out.push_str(if item.curves().is_empty() { "]" } else { "\n]" });
        for body in job.bodies.iter().filter(|body| body.item == index) {
            out.push_str(if body.index == 0 { ", \"surfaces\": [\n" } else { ",\n" });
            written.shells.push(surfaces::push_body(&mut out, body)?);
            written.bodies.push(Promise::EXACT);
        }
        let has_bodies = job.bodies.iter().any(|body| body.item == index);
        out.push_str(if has_bodies { "\n]}" } else { "}" });
    }
    out.push_str("\n}\n}\n");
    Ok(written.exported(out.into_bytes(), Vec::new()))
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let bodies = &made.ready.bodies;
    let labels = labels(made.ready, &made.file.written);
    let curves = made.curves(&content, View::Space)?;
    let bodies: Vec<_> = bodies.iter().collect();
    let bodies = patches_deviation(&bodies, &made.file.written.shells, &content.patches)?;
    content.labels.check(&labels)?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}

/// The labels of a file of the model with what was promised for its curves.
fn labels(ready: &ReadyModel<'_>, written: &Written) -> FileLabels {
    let ReadyModel { model, provenances, bodies, .. } = ready;
    let mut names = Vec::new();
    let mut curves = written.curves.iter();
    for (index, item) in model.items.iter().enumerate() {
        let own = || bodies.iter().filter(|body| body.item == index);
        names.push(FileName::new("type", provenances.kind(index), 1));
        names.push(FileName::new(reader::CURVES_OF, &item.name, item.curves().len()));
        names.push(FileName::new(reader::SURFACES_OF, &item.name, own().count()));
        let promises = curves.by_ref().take(item.curves().len()).map(|curve| &curve.promise);
        names.extend(promises.map(|promise| promised(promise.is_exact(), promise.distances()[0])));
        names.extend(own().map(|body| body_kind(body.body.is_solid(), true)));
    }
    FileLabels::new(model.units, names)
}

/// What a file says of how far a curve is from the object.
fn promised(exact: bool, bound: f64) -> FileName {
    let mut text = if exact { "exact, " } else { "" }.to_owned();
    push_plain(&mut text, bound);
    FileName::new("bound of curve", text, 1)
}

/// What a file says of a body.
fn body_kind(closed: bool, exact: bool) -> FileName {
    let text = [if closed { "closed" } else { "open" }, if exact { "" } else { ", not exact" }].concat();
    FileName::new("body", text, 1)
}

/// Writes a contour; gives what its splines are checked against.
fn push_contour(
    out: &mut String,
    contour: &Contour<'_>,
    lowered: Lowered<CurveChain>,
) -> Result<WrittenCurve, ExportError> {
    let promise = Promise::of_chain(&lowered);
    let Lowered { form: chain, exactness, correspondence } = lowered;
    let is_exact = exactness == Exactness::Exact;
    out.push_str(&format!("{{\"closed\": {}, \"exact\": {is_exact}, \"bound\": ", chain.is_closed()));
    push_plain(out, exactness.bound());
    out.push_str(", \"curves\": [");
    let mut notes = PieceNotes::default();
    let mut separator = "\n";
    // Splines are given up as they are written.
    let mut pieces = chain.into_pieces().into_iter();
    loop {
        // All arcs that follow each other are one curve.
        let arcs = pieces.as_slice().iter().take_while(|piece| matches!(piece, ChainPiece::Arc(_))).count();
        if arcs > 0 {
            out.push_str(std::mem::replace(&mut separator, ",\n"));
            contour.lowered(push_arcs(out, &pieces.as_slice()[..arcs], &mut notes))?;
            pieces.nth(arcs - 1);
        }
        let Some(ChainPiece::Spline(curve)) = pieces.next() else { break };
        notes.spline(&curve);
        out.push_str(std::mem::replace(&mut separator, ",\n"));
        push_curve(out, &curve.with_c1_knots().unwrap_or(curve));
    }
    out.push_str("]}");
    Ok(notes.of(promise, correspondence))
}

fn push_curve(out: &mut String, curve: &NurbsCurve) {
    out.reserve(curve.control_points().len() * CONTROL_POINT);
    out.push_str(&format!("{{\"degree\": {}, \"knots\": ", curve.degree()));
    push_numbers(out, curve.knots());
    out.push_str(", \"control_points\": [");
    push_points(out, curve.control_points().iter());
    out.push_str("], \"weights\": ");
    push_numbers(out, curve.weights());
    out.push('}');
}

fn push_points<'a>(out: &mut String, points: impl Iterator<Item = &'a Point3>) {
    for (i, p) in points.enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        push_numbers(out, &p.to_array());
    }
}

fn push_numbers(out: &mut String, numbers: &[f64]) {
    out.push('[');
    push_listed(out, numbers);
    out.push(']');
}

fn push_listed(out: &mut String, numbers: &[f64]) {
    for (i, &v) in numbers.iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        push_plain(out, v);
    }
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// Writes arcs that meet as one rational quadratic: arc `i` over `[i, i+1]`, double knots at every joint. Notes what they
/// have become. Its lists are written one after the other, arc by arc: as a curve it would be larger than the
/// file.
fn push_arcs(out: &mut String, arcs: &[ChainPiece], notes: &mut PieceNotes) -> cyclide::Result<()> {
    let curves = || {
        let arcs = arcs.iter().filter_map(|piece| if let ChainPiece::Arc(arc) = piece { Some(arc) } else { None });
        arcs.map(|arc| arc.to_nurbs(DEFAULT_PIECE_ANGLE)).enumerate()
    };
    out.reserve(arcs.len() * ARC);
    // Ends of arcs that meet are the same doubles, with weight 1 on both sides.
    let skipped = |i: usize| usize::from(i > 0);
    out.push_str("{\"degree\": 2, \"knots\": [0");
    for (i, curve) in curves() {
        let curve = curve?;
        for u in &curve.breaks()[..curve.piece_count()] {
            out.push_str(", ");
            let knot = i as f64 + u;
            push_listed(out, &[knot; 2]);
            notes.knots.push(knot);
        }
        notes.counts.push(curve.piece_count());
    }
    out.push_str(", ");
    let end = arcs.len() as f64;
    notes.knots.push(end);
    push_listed(out, &[end; 3]);
    out.push_str("], \"control_points\": [");
    for (i, curve) in curves() {
        out.push_str(if i > 0 { ", " } else { "" });
        push_points(out, curve?.control_points()[skipped(i)..].iter());
    }
    out.push_str("], \"weights\": [");
    for (i, curve) in curves() {
        out.push_str(if i > 0 { ", " } else { "" });
        push_listed(out, &curve?.weights()[skipped(i)..]);
    }
    out.push_str("]}");
    Ok(())
}
