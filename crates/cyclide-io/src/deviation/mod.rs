//! The distance between the curves of a file and the curves of the model, matched along both.
//!
//! Nearest points alone would forgive a file whose pieces are swapped or doubled. Here each curve is sampled in
//! order and the samples are matched with places on the other curve that advance along it: an upper bound of the
//! distance of the point sets, close to the Fréchet distance.

mod facing;
mod matching;
mod mesh;
mod side_use;
mod step_faces;
mod track;
mod triangle;

use crate::file_content::ReadError;
use crate::job::contours;
use cyclide::{Arc, CurveChain, Model, ParamCurve as _};
use matching::one_way;
pub(crate) use mesh::{BodyPlan, Cell, MeshPlan, mesh_deviation};
pub(crate) use side_use::side_use;
pub(crate) use step_faces::bodies_deviation;
use track::Track;

/// The largest distance between the curves read from a file and the model's curves, both ways, in the model's
/// order: 0 up to rounding for an exact file.
///
/// # Errors
/// [`ReadError::CurveCount`], [`ReadError::Closedness`].
pub fn deviation(model: &Model, read: &[CurveChain]) -> Result<f64, ReadError> {
    deviation_within(model, read, View::Space)
}

/// How much of the curves a format holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    /// All of it.
    Space,
    /// What is seen along the third axis.
    Plan,
    /// All of it, but whether a curve is closed is told by its ends alone.
    Points,
}

/// As [`deviation`], of what the format holds.
pub(crate) fn deviation_within(model: &Model, read: &[CurveChain], view: View) -> Result<f64, ReadError> {
    let expected = contours(model).count();
    if expected != read.len() {
        return Err(ReadError::CurveCount { found: read.len(), expected });
    }
    let mut largest = 0.0_f64;
    let plan = view == View::Plan;
    for (curve, (contour, chain)) in contours(model).zip(read).enumerate() {
        let object = contour.curve.as_curve();
        let ends_meet = object.eval(0.0) == object.eval(1.0);
        if object.is_closed() != chain.is_closed() && !(view == View::Points && ends_meet) {
            return Err(ReadError::Closedness { curve, found: chain.is_closed() });
        }
        let (mut a, b) = (Track::new(object, plan), Track::new(chain, plan));
        // A closed curve may start elsewhere in the file (at a corner).
        let starts = if object.is_closed() { a.starts_near(b.windows[0].start.point) } else { vec![0] };
        let mut best = f64::INFINITY;
        let mut rotated = 0;
        for start in starts {
            a.rotate(start - rotated);
            rotated = start;
            best = best.min(one_way(&a, &b).max(one_way(&b, &a)));
        }
        largest = largest.max(best);
    }
    Ok(largest)
}

/// The largest distance in the plan, both ways, between the lines of a drawing and the arcs that they stand for.
///
/// # Errors
/// [`ReadError::LineCount`].
pub(crate) fn lines_deviation(expected: &[Arc], read: &[CurveChain]) -> Result<f64, ReadError> {
    if expected.len() != read.len() {
        return Err(ReadError::LineCount { found: read.len(), expected: expected.len() });
    }
    let apart = expected.iter().zip(read).map(|(arc, line)| {
        let (a, b) = (Track::new(arc, true), Track::new(line, true));
        one_way(&a, &b).max(one_way(&b, &a))
    });
    Ok(apart.fold(0.0, f64::max))
}
