//! The span between two points with given end velocities that Möbius maps keep: a quadratic QB curve
//! (`docs/math/qb-curves.md#invariant-span`).
//!
//! ```text
//! d = a1 - a0,  alpha = d^-1 v0,  beta = d^-1 v1,  P = (beta alpha)^(1/2)
//! den: 1, (P + alpha)/2, alpha P^-1      num: a0, a0 d_1 + v0/2, a1 d_2
//! ```
//! With unit tangents `t1`, `t2` at `a0` (the second reflected there from `a1`), `u` the unit chord and `h` halfway from `t1` to `t2`,
//! `P` is `sqrt(|alpha||beta|) (h·t1, -h × t1)`: the halfway tangent of the [blend of two circles](super::super::blend) of
//! order 1, which is this span with end speeds of the length of its chord.

use super::QbCurve;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::blend::{BlendLaw, BlendSegment};
use crate::error::{ErrorItem, NumberError, Result};

/// What the span is made from: ends, unit chord and its length, tangent at the start, `(h·t1, -h × t1)`, and end speeds in chords.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpanData {
    pub(crate) ends: [Point3; 2],
    pub(crate) unit: Vec3,
    pub(crate) length: f64,
    pub(crate) tangent: Vec3,
    pub(crate) root: Quat,
    pub(crate) speeds: [f64; 2],
}

/// End speeds accepted, in chords: third derivatives hold powers of them.
const SPEEDS: [f64; 2] = [1e-30, 1e30];

impl SpanData {
    /// Refuses end speeds out of range.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub(crate) fn check(&self) -> Result<()> {
        let [min, max] = SPEEDS;
        match self.speeds.into_iter().find(|speed| !(min..=max).contains(speed)) {
            Some(value) => {
                Err(NumberError::ParameterOutOfRange { name: ErrorItem::TangentOverSpan, value, min, max }.into())
            }
            None => Ok(()),
        }
    }
}

impl QbCurve {
    /// The invariant span, measured from its start.
    pub(crate) fn from_span(data: &SpanData) -> Self {
        let SpanData { ends, unit, length, tangent, root, speeds: [s0, s1] } = *data;
        // u^-1 t = (u·t, -u × t) of unit vectors.
        let alpha = Quat::from_parts(unit.dot(tangent), -unit.cross(tangent)) * s0;
        let size = (s0 * s1).sqrt();
        let middle = (root * size + alpha) * 0.5;
        let last = alpha * root.conj() * (1.0 / size);
        let pairs = [
            (Quat::ZERO, Quat::ONE),
            (Quat::from(tangent * (0.5 * s0 * length)), middle),
            (Quat::from(unit * length) * last, last),
        ];
        Self::from_local_between(ends, ends[0], pairs)
    }

    /// The blend of two circles as a QB curve, with the speeds at its ends in chords: its own are 1 and 1. `None` if it is not of the
    /// rational order 1.
    pub(crate) fn from_blend(segment: &BlendSegment, speeds: [f64; 2]) -> Option<Self> {
        match segment.law() {
            BlendLaw::Rational { order: 1 } => {}
            BlendLaw::Fair { blend } if blend >= 1.0 => {}
            _ => return None,
        }
        let whole = Self::from_span(&segment.span_data(speeds));
        let [from, to] = segment.range();
        if from <= 0.0 && to >= 1.0 { Some(whole) } else { whole.restricted(from, to).ok() }
    }
}
