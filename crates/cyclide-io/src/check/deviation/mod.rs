//! The distance between the curves of a file and the curves of the model, part by part.
//!
//! Who writes a file knows which part of the object each of its pieces stands for, and hands that on: a
//! [`Correspondence`], places and counts, never geometry. Here it is held against object and file (it begins at the start,
//! runs forward, ends at the end, and counts every piece once), and then each part of the original object, not of the
//! form it was written in, is measured against its own pieces of the file as read from the bytes, both ways
//! (`matching`). So a swapped, doubled or lost piece cannot hide behind another one, nothing has to be searched, and
//! the work grows with the number of pieces. It is an upper bound of the distance of the point sets, close to the
//! Fréchet distance.
//!
//! What the parts are: STEP and JSON, of an arc path its arcs, of a circle spline its segments, each with the spans of the
//! B-spline that came of it, of a full circle its halves. DXF and SVG, the arcs, or pairs of arcs for the stretch of curve
//! between two places at which a biarc meets it, whatever number of pieces each was cut into. Polylines (CSV, OBJ,
//! GLB, curves in space in SVG), the curve between two vertices. Pieces that vanish on the way (in the plan, in single
//! precision) leave a part with no piece, which is measured against the point that is left of it.

mod cover;
mod drawn;
mod facing;
mod limits;
mod matching;
mod mesh;
mod mesh_edges;
mod nearest;
mod polygon;
mod samples;
mod track;
mod triangle;
mod triangle_surface;

use crate::check::read_error::ReadError;
use crate::export::exported::{WrittenCurve, knots_of};
use crate::export::parts::contours;
use cyclide::{
    Vec3,
    curve::{Correspondence, CurvePlace, ParamCurve},
    model::{CurveChain, Model},
};
pub(crate) use drawn::lines_deviation;
pub(crate) use limits::{Beyond, Deviations, READ_BACK_ROUNDING};
use matching::apart;
pub(crate) use matching::larger;
pub(crate) use mesh::mesh_deviation;
pub(crate) use mesh_edges::check_mesh_edges;
pub(crate) use polygon::{MeshForm, Normals};
pub(crate) use samples::SampleCheck;

/// Samples on each piece of a curve that is a point in the plan.
const PLAN_SAMPLES: usize = 64;

/// How much of the curves a format holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    /// All of it.
    Space,
    /// What is seen along the third axis.
    Plan,
    /// All of it, but whether a curve is closed is told by its ends alone: they are compared with the others.
    Points,
}

/// The distance between each curve read from a file and the model's curve, both ways, in the model's order: 0 up to
/// rounding for an exact file. What was written tells which pieces of the file stand for which part of each curve.
///
/// # Errors
/// [`ReadError::CurveCount`], [`ReadError::Closedness`], [`ReadError::PieceCount`], [`ReadError::CurveParts`],
/// [`ReadError::Knot`].
pub(crate) fn curves_deviation(
    model: &Model,
    read: &[CurveChain],
    written: &[WrittenCurve],
    view: View,
) -> Result<Vec<f64>, ReadError> {
    let left_out = |curve: &WrittenCurve| view == View::Plan && curve.is_left_out();
    let expected = written.iter().filter(|curve| !left_out(curve)).count();
    if expected != read.len() || contours(model).count() != written.len() {
        return Err(ReadError::CurveCount { found: read.len(), expected });
    }
    let mut deviations = Vec::with_capacity(written.len());
    let mut read = read.iter().enumerate();
    for (contour, made) in contours(model).zip(written) {
        let object = contour.curve.as_curve();
        if left_out(made) {
            // It is a point there, to its tolerance, which is all that a drawing may leave out.
            deviations.push(from_start_in_plan(object));
            continue;
        }
        let Some((curve, chain)) = read.next() else { break };
        let WrittenCurve { parts, knots, .. } = made;
        if object.is_closed() != chain.is_closed() && view != View::Points {
            return Err(ReadError::Closedness { curve, found: chain.is_closed() });
        }
        check_parts(object, chain, parts, curve)?;
        check_knots(chain, knots, curve)?;
        deviations.push(apart(object, chain, parts, view == View::Plan));
    }
    Ok(deviations)
}

/// How far a curve is from its start as seen along the third axis, by samples.
fn from_start_in_plan(curve: &dyn ParamCurve) -> f64 {
    let start = curve.piece_point(0, 0.0);
    let away = |piece: usize, k: usize| {
        let Vec3 { x, y, .. } = curve.piece_point(piece, k as f64 / PLAN_SAMPLES as f64) - start;
        x.hypot(y)
    };
    let places = (0..curve.piece_count()).flat_map(|piece| (1..=PLAN_SAMPLES).map(move |k| (piece, k)));
    places.map(|(piece, k)| away(piece, k)).fold(0.0, larger)
}

/// Refuses splines whose knots are not those that were made: where pieces meet without being smooth, they say nothing of
/// the points.
fn check_knots(chain: &CurveChain, made: &[f64], curve: usize) -> Result<(), ReadError> {
    let mut read = chain.pieces().iter().flat_map(knots_of);
    let mut made = made.iter();
    loop {
        let (found, expected) = (read.next().copied(), made.next().copied());
        if !samples::same(found, expected) {
            return Err(ReadError::Knot { curve, found, expected });
        }
        if found.is_none() {
            return Ok(());
        }
    }
}

/// Refuses parts that are not all of the object, once and in order, or not all pieces of the file.
fn check_parts(
    object: &dyn ParamCurve,
    chain: &CurveChain,
    parts: &Correspondence,
    curve: usize,
) -> Result<(), ReadError> {
    let (n, Correspondence { start, spans }) = (object.piece_count(), parts);
    let on_piece = |place: CurvePlace| (0.0..=1.0).contains(&place.s);
    let at_start = if object.is_closed() { start.piece < n } else { *start == CurvePlace::new(0, 0.0) };
    let ends = || std::iter::once(*start).chain(spans.iter().map(|span| span.end));
    let forward = ends().zip(ends().skip(1)).all(|(from, to)| on_piece(to) && to.is_from(from));
    let all = CurvePlace::new(start.piece + n, start.s);
    let whole = ends().last().is_some_and(|last| last.is_from(all) && all.is_from(last));
    if !(on_piece(*start) && at_start && forward && whole) {
        return Err(ReadError::CurveParts { curve });
    }
    let (found, expected) = (chain.piece_count(), parts.piece_count());
    if found == expected { Ok(()) } else { Err(ReadError::PieceCount { curve, found, expected }) }
}
