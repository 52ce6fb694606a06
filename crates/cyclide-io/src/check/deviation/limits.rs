//! What each part of a file may be off: its own promise and the rounding of its own coordinates, no other part's.

use super::matching::larger;
use crate::export::exported::{Promise, Written};
use crate::export::parts::contours;
use crate::export::ready::ReadyModel;

/// Part of the size and place of a part that reading numbers back and comparing points may cost: what foreign readers are
/// held to.
pub(crate) const READ_BACK_ROUNDING: f64 = 1e-9;
/// The same of the whole model, where parts are written by it: DXF takes what is flat by 1e-12 of its size for plane,
/// and the radii of analytic surfaces in STEP are up to 1e4 times as large as it.
const MODEL_ROUNDING: f64 = 1e-11;

/// How far the parts of a file are off, in file order.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Deviations {
    pub(crate) curves: Vec<f64>,
    /// One for each body of the model.
    pub(crate) bodies: Vec<f64>,
    /// Of the lines of surfaces in a drawing.
    pub(crate) lines: Vec<f64>,
    /// Of the motions of a file that animates.
    pub(crate) motions: Vec<f64>,
}

/// A part of a file that is farther from the model than promised.
pub(crate) struct Beyond {
    /// The name of the part.
    pub(crate) part: String,
    pub(crate) deviation: f64,
    /// Distance that was promised for it.
    pub(crate) bound: f64,
    /// The largest distance accepted.
    pub(crate) limit: f64,
    /// True if the digits of the format's numbers account for it: they cost more than the tolerance.
    pub(crate) by_digits: bool,
    /// True of a surface over triangles, for which what is promised was found by sampling.
    pub(crate) sampled: bool,
}

impl Deviations {
    /// The largest of all.
    pub(crate) fn largest(&self) -> f64 {
        self.curves.iter().chain(&self.bodies).chain(&self.lines).chain(&self.motions).copied().fold(0.0, larger)
    }

    /// The first part that is farther from the model than was promised for it, in a format whose parts are rounded by
    /// the size of the whole model or only by their own.
    pub(crate) fn beyond(&self, ready: &ReadyModel<'_>, rounds_by_model: bool, written: &Written) -> Option<Beyond> {
        let whole = if rounds_by_model { MODEL_ROUNDING * ready.extent() } else { 0.0 };
        let check = |promise: &Promise, extent: f64, deviation: f64| {
            let [bound, digits] = promise.distances();
            // Digits that cost more than the tolerance leave too little of the curve.
            let limit = bound + (READ_BACK_ROUNDING * extent + whole).max(digits.min(written.tolerance));
            if deviation <= limit { None } else { Some((deviation, bound, limit, deviation <= limit + digits)) }
        };
        let named = |part: String| {
            move |(deviation, bound, limit, by_digits)| Beyond {
                part,
                deviation,
                bound,
                limit,
                by_digits,
                sampled: false,
            }
        };
        let extents = &ready.extents;
        let parts = || written.curves.iter().zip(&extents.curves).zip(&self.curves).zip(contours(ready.model));
        let curve = || {
            parts().find_map(|(((curve, extent), deviation), contour)| {
                check(&curve.promise, *extent, *deviation).map(named(contour.label()))
            })
        };
        let parts = || ready.bodies.iter().zip(&extents.bodies).zip(&self.bodies).enumerate();
        let body = || {
            parts().find_map(|(index, ((body, extent), deviation))| {
                // What nothing was promised for is exact.
                let promise = written.bodies.get(index).unwrap_or(&Promise::EXACT);
                let beyond = check(promise, *extent, *deviation).map(named(body.label()))?;
                Some(Beyond { sampled: body.body.triangles().is_some(), ..beyond })
            })
        };
        let line = || {
            written.lines.iter().zip(&self.lines).find_map(|(line, deviation)| {
                let body = ready.bodies.get(line.place.body)?;
                let extent = extents.bodies.get(line.place.body)?;
                check(&line.promise, *extent, *deviation).map(named(format!("a line of {}", body.label())))
            })
        };
        let motion =
            || {
                let names =
                    ready.model.items.iter().filter(|item| item.motion().is_some()).map(|item| item.name.clone());
                written.motions.iter().zip(&self.motions).zip(names).find_map(|((promise, deviation), name)| {
                    check(promise, ready.extent(), *deviation).map(named(name))
                })
            };
        curve().or_else(body).or_else(line).or_else(motion)
    }
}
