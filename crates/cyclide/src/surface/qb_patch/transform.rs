//! Möbius maps of patches, and parts of them: the homogeneous pairs map linearly.

use super::QbPatch;
use crate::base::range;
use crate::conformal::mapped_pairs::MappedPairs;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{ErrorItem, NumberError, PointError, Result};

impl Conformal for QbPatch {
    /// The image under a Möbius map `y -> (a y + b)(c y + d)^-1`, with the same parameters: corners by the map, weights `(c a_k + d) w_k`.
    ///
    /// # Errors
    /// `point-at-infinity`, `patch-through-infinity`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points`,
    /// `not-in-space` if rounding destroyed the result.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let MappedPairs { corners, weights, .. } = map.map_pairs(self.corners, self.weights, self.scale)?;
        range::check_place(ErrorItem::Surface, &corners)?;
        let image = Self::finite(corners, weights)?;
        if image.scale == 0.0 {
            return Err(PointError::CoincidentPoints { first: 0, second: 3, distance: 0.0, limit: 0.0 }.into());
        }
        image.check_in_space(self.corner_rounding() + image.corner_rounding())?;
        Ok(image)
    }
}

impl QbPatch {
    /// The part over `[s0, s1] × [t0, t1]` as a patch of its own: exact, with parameters from 0 to 1.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the ranges are rising, within `[0, 1]`.
    pub fn restricted(&self, s: [f64; 2], t: [f64; 2]) -> Result<Self> {
        for (name, [from, to]) in [(ErrorItem::S, s), (ErrorItem::T, t)] {
            if !(0.0 <= from && from < to && to <= 1.0) {
                let (min, max) = (from.max(0.0), 1.0);
                return Err(NumberError::ParameterOutOfRange { name, value: to, min, max }.into());
            }
        }
        let places = [(s[0], t[0]), (s[1], t[0]), (s[0], t[1]), (s[1], t[1])];
        let weights = places.map(|(s, t)| self.denominator(s, t));
        let corner = |(s, t): (f64, f64), d| match (s, t) {
            (0.0, 0.0) => self.corners[0],
            (1.0, 0.0) => self.corners[1],
            (0.0, 1.0) => self.corners[2],
            (1.0, 1.0) => self.corners[3],
            // A side that is one point is that, bit for bit.
            (1.0, _) if self.corners[1] == self.corners[3] => self.corners[3],
            (_, 1.0) if self.corners[2] == self.corners[3] => self.corners[3],
            _ => self.quotient(s, t, d),
        };
        let corners = std::array::from_fn(|k| corner(places[k], weights[k]));
        Ok(Self::from_weights_unchecked(corners, weights))
    }
}
