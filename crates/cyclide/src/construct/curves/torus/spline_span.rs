//! Spans: data of two ends that one type of quartic joins, and how well (`docs/math/torus-splines.md#the-general-problem`).

use super::quartic_biarc::LocalData;
use crate::base::planar::{Point2, Vec2};
use crate::error::Result;
use crate::surface::{QuarticType, TorusChain};

/// Largest step of a coordinate in one span, radians.
const LARGEST_STEP: f64 = 1.5;

/// A coordinate whose step and speeds are below this part of the largest speed stands still: rounding of an arc of a circle.
const STILL: f64 = 1e-14;

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
            Self { start: self.start + first, step: self.step - first, rates: [rate, v1 * 0.5] },
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
    /// Appends its two pieces; `knot` tells the knot of a part of the segment.
    pub(super) fn append(&self, chain: &mut TorusChain, knot: impl Fn(f64) -> f64) -> Result<()> {
        let (data, speed) = (self.data, fastest(self.data.step, self.data.rates));
        let mut local = LocalData::new(self.kind, data.step, data.rates);
        for i in 0..2 {
            if is_still(local.steps[i], local.slopes[i], speed) {
                (local.steps[i], local.slopes[i]) = (0.0, [0.0; 2]);
            }
        }
        let [first, second] = local.pieces(self.kind, data.start, [0.5; 2])?;
        chain.push(first, knot(0.5 * (self.part[0] + self.part[1])));
        chain.push(second, knot(self.part[1]));
        Ok(())
    }
}

/// Quality of a type for data over a length of the parameter: over both coordinates that run, the smallest of the mean speed and the
/// speeds at the ends, relative to the largest speed of the data; 0 if they do not run in one direction, or too far.
pub(super) fn quality(kind: QuarticType, step: Vec2, rates: [Vec2; 2], length: f64) -> f64 {
    let rates = rates.map(|rate| rate * length);
    let (local, speed) = (LocalData::new(kind, step, rates), fastest(step, rates));
    let of = |i: usize| {
        let (d, [m0, m1]) = (local.steps[i], local.slopes[i]);
        let one_way = (d > 0.0 && m0 > 0.0 && m1 > 0.0) || (d < 0.0 && m0 < 0.0 && m1 < 0.0);
        if is_still(d, [m0, m1], speed) {
            1.0
        } else if one_way && d.abs() <= LARGEST_STEP {
            m0.abs().min(m1.abs()).min(d.abs()) / speed
        } else {
            0.0
        }
    };
    of(0).min(of(1))
}

/// The type of the best quality for data over a parameter of length 1; `None` if none has any.
pub(super) fn best_type(step: Vec2, rates: [Vec2; 2]) -> Option<(QuarticType, f64)> {
    let all = QuarticType::ALL.into_iter().map(|kind| (kind, quality(kind, step, rates, 1.0)));
    all.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, quality)| *quality > 0.0)
}

fn fastest(step: Vec2, [v0, v1]: [Vec2; 2]) -> f64 {
    v0.length().max(v1.length()).max(step.length())
}

fn is_still(step: f64, slopes: [f64; 2], speed: f64) -> bool {
    step.abs().max(slopes[0].abs()).max(slopes[1].abs()) <= STILL * speed
}
