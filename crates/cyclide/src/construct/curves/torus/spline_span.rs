//! Spans: data of two ends that one type of quartic joins, and how well (`docs/math/torus-splines.md#the-general-problem`).

use super::local_data::LocalData;
use crate::base::planar::{Point2, Vec2};
use crate::error::Result;
use crate::surface::{QuarticType, TorusChain, within_a_turn};

/// Largest step of a coordinate in one span, radians.
const LARGEST_STEP: f64 = 1.5;

/// A coordinate stands still whose step and speeds are below this part of those of the place, each of its own, or below the
/// rounding of angles: data on an arc of a circle.
const STILL: f64 = 1e-14;

/// Rounding of angles of a few radians.
const ANGLE_ROUNDING: f64 = 1e-15;

/// Qualities within this factor tie.
const TIE: f64 = 1.0 + 1e-9;

/// Data over a parameter of length 1: a place, a step, the speeds at both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hermite {
    pub(super) start: Point2,
    pub(super) step: Vec2,
    pub(super) rates: [Vec2; 2],
}

impl Hermite {
    /// The halves of the cubic interpolant, each over a parameter of length 1. Places are kept as steps, so that short ones keep
    /// their digits.
    pub(super) fn halves(&self) -> [Self; 2] {
        let [v0, v1] = self.rates;
        let first = self.step * 0.5 + (v0 - v1) * 0.125;
        let rate = (self.step * 1.5 - (v0 + v1) * 0.25) * 0.5;
        [
            Self { start: self.start, step: first, rates: [v0 * 0.5, rate] },
            Self { start: within_a_turn(self.start + first), step: self.step - first, rates: [rate, v1 * 0.5] },
        ]
    }

    /// The best type with its quality; `None` if no type joins the data.
    pub(super) fn best(&self) -> Option<(QuarticType, f64)> {
        best_type(self.step, self.rates)
    }
}

/// Data with the type that joins them, up to a part of the segment.
#[derive(Debug, Clone, Copy)]
pub(super) struct TypedSpan {
    pub(super) data: Hermite,
    pub(super) kind: QuarticType,
    pub(super) quality: f64,
    /// Start and end as parts of the segment.
    pub(super) part: [f64; 2],
}

impl TypedSpan {
    /// Appends its two pieces; `knot` tells the knot of a part of the segment, which has the length `whole`.
    pub(super) fn append(&self, chain: &mut TorusChain, knot: impl Fn(f64) -> f64, whole: f64) -> Result<()> {
        let [from, to] = self.part;
        let knots = [from, 0.5 * (from + to), to].map(knot);
        // Knots are rounded: speeds belong to their differences, not to those of the parts, or the derivative would jump by the
        // rounding of the knots over the length of a piece.
        let length = knots[2] - knots[0];
        let lengths = [(knots[1] - knots[0]) / length, (knots[2] - knots[1]) / length];
        let stretch = length / ((to - from) * whole);
        let data = self.data;
        let mut local = LocalData::new(self.kind, data.step, data.rates.map(|rate| rate * stretch));
        if let Some(i) = standing(self.kind, data.step, data.rates) {
            (local.steps[i], local.slopes[i]) = (0.0, [0.0; 2]);
        }
        let [first, second] = local.pieces(self.kind, data.start, lengths)?;
        chain.push(first, knots[1]);
        chain.push(second, knots[2]);
        Ok(())
    }
}

/// Quality of a type for data over a length of the parameter: over both coordinates that run, the smallest of the mean speed and the
/// speeds at the ends, relative to the largest speed of the data; 0 if they do not run in one direction, or too far.
pub(super) fn quality(kind: QuarticType, step: Vec2, rates: [Vec2; 2], length: f64) -> f64 {
    let rates = rates.map(|rate| rate * length);
    let (local, speed) = (LocalData::new(kind, step, rates), fastest(step, rates));
    let still = standing(kind, step, rates);
    let of = |i: usize| {
        let (d, [m0, m1]) = (local.steps[i], local.slopes[i]);
        let one_way = (d > 0.0 && m0 > 0.0 && m1 > 0.0) || (d < 0.0 && m0 < 0.0 && m1 < 0.0);
        if still == Some(i) {
            1.0
        } else if one_way && d.abs() <= LARGEST_STEP {
            m0.abs().min(m1.abs()).min(d.abs()) / speed
        } else {
            0.0
        }
    };
    of(0).min(of(1))
}

/// The type of the best quality for data over a parameter of length 1, of those with a coordinate that stands still if there is one:
/// data on a circle give its arc. `None` if none has any quality.
pub(super) fn best_type(step: Vec2, rates: [Vec2; 2]) -> Option<(QuarticType, f64)> {
    let on_circle = |kind: QuarticType| standing(kind, step, rates).is_some();
    let rated = QuarticType::ALL.into_iter().map(|kind| (on_circle(kind), quality(kind, step, rates, 1.0), kind));
    // The first of types that differ by rounding only: the choice does not depend on where the torus stands or begins.
    let better = |a: &(bool, f64, QuarticType), b: &(bool, f64, QuarticType)| {
        if a.0 == b.0 { a.1 > TIE * b.1 } else { a.0 }
    };
    let usable = rated.filter(|(_, quality, _)| *quality > 0.0);
    let best = usable.reduce(|best, next| if better(&next, &best) { next } else { best });
    best.map(|(_, quality, kind)| (kind, quality))
}

fn fastest(step: Vec2, [v0, v1]: [Vec2; 2]) -> f64 {
    v0.length().max(v1.length()).max(step.length())
}

/// The coordinate that stands still, if one does and the other runs; rates are by a parameter of length 1.
fn standing(kind: QuarticType, step: Vec2, rates: [Vec2; 2]) -> Option<usize> {
    let local = LocalData::new(kind, step, rates);
    let sizes = [step.length(), rates[0].length(), rates[1].length()];
    let stands = |i: usize| {
        let all = [local.steps[i], local.slopes[i][0], local.slopes[i][1]];
        all.iter().zip(sizes).all(|(x, size)| x.abs() <= STILL * size + ANGLE_ROUNDING)
    };
    match (stands(0), stands(1)) {
        (true, false) => Some(0),
        (false, true) => Some(1),
        _ => None,
    }
}
