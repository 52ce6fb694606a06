//! Parameter lines as exact arcs, edges, sub-patches.

use super::{CyclidePatch, bilinear};
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::{ArcError, ErrorItem, NumberError, Result};
use crate::surface::ParamSurface as _;

impl CyclidePatch {
    /// The s-line at `t` as an arc with the same parameter s.
    ///
    /// # Errors
    /// `pole-on-segment`, `parameter-out-of-range`: only beyond the range of the kernel's numbers.
    pub fn s_line(&self, t: f64) -> Result<Arc> {
        self.line((0.0, t), (1.0, t))
    }

    /// The t-line at `s` as an arc with the same parameter t.
    ///
    /// # Errors
    /// As [`s_line`](Self::s_line).
    pub fn t_line(&self, s: f64) -> Result<Arc> {
        self.line((s, 0.0), (s, 1.0))
    }

    fn line(&self, from: (f64, f64), to: (f64, f64)) -> Result<Arc> {
        let (d0, d1) = (self.denominator(from.0, from.1), self.denominator(to.0, to.1));
        let inverse = d0.inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
        Arc::from_ratio_across(self.corner_point(from), self.corner_point(to), d1 * inverse)
    }

    /// The point, and at a corner the corner itself.
    fn corner_point(&self, (s, t): (f64, f64)) -> Point3 {
        let corner = |x: f64| match x {
            0.0 => Some(0),
            1.0 => Some(1),
            _ => None,
        };
        match (corner(s), corner(t)) {
            (Some(i), Some(j)) => self.corners[i + 2 * j],
            _ => self.point(s, t),
        }
    }

    /// The part over `[s0, s1] × [t0, t1]` as a patch of its own (`docs/math/patches.md#weights`): exact.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `0 <= s0 < s1 <= 1` and the same for t.
    pub fn sub_patch(&self, [s0, s1]: [f64; 2], [t0, t1]: [f64; 2]) -> Result<Self> {
        for (name, a, b) in [(ErrorItem::S, s0, s1), (ErrorItem::T, t0, t1)] {
            if !(a >= 0.0 && a < b && b <= 1.0) {
                return Err(NumberError::ParameterOutOfRange {
                    name,
                    value: if a >= 0.0 { b } else { a },
                    min: 0.0,
                    max: 1.0,
                }
                .into());
            }
        }
        let places = [(s0, t0), (s1, t0), (s0, t1), (s1, t1)];
        let corners = places.map(|p| self.corner_point(p));
        let mut part = self.part_between([s0, s1], [t0, t1], corners);
        // Sides of one point stay so: their speed is zero, not rounding.
        for (t, value) in [(t0, 0), (t1, 2)] {
            if self.polar.q1_at(t) == 0.0 {
                part.polar.q1[value] = 0.0;
            }
        }
        for (s, value) in [(s0, 0), (s1, 2)] {
            if self.polar.q2_at(s) == 0.0 {
                part.polar.q2[value] = 0.0;
            }
        }
        Ok(part)
    }

    /// The part over `[s0, s1] × [t0, t1]` with corners that are known better than by evaluation: vertices shared
    /// with other patches, or a side of one point.
    pub(crate) fn part_between(&self, [s0, s1]: [f64; 2], [t0, t1]: [f64; 2], corners: [Point3; 4]) -> Self {
        let places = [(s0, t0), (s1, t0), (s0, t1), (s1, t1)];
        let weights: [Quat; 4] = places.map(|(s, t)| bilinear(&self.weights, s, t));
        Self::from_weights_unchecked(corners, weights, self.v[0], self.v[1])
    }
}
