//! Möbius maps of arcs: the homogeneous pairs map linearly, so the image is an arc with the same parameter.

use super::Arc;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{ArcError, Error, ErrorItem, Result};

/// Largest part of the image's weight along its chord, relative to the weight, that counts as rounding.
const DEFECT_LIMIT: f64 = 1e-9;

/// Rounding of a mapped end, relative to its coordinates.
const END_ROUNDING: f64 = 32.0 * f64::EPSILON;

impl Conformal for Arc {
    /// The image under a Möbius map, with the same parameter (`docs/math/arcs.md#images-under-maps`).
    ///
    /// # Errors
    /// `pole-on-segment` if the arc passes through the point that goes to infinity, `point-at-infinity` if an end
    /// does, `not-in-im-h` if rounding destroyed the result.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let lost = |index| Error::at_infinity(ErrorItem::Point, index);
        let image = |p, index| map.map_weighted(p).ok_or_else(|| lost(index));
        let ((a0, f0), (a1, f1)) = (image(self.p0, 0)?, image(self.p1, 1)?);
        let inverse = f0.inverse().ok_or_else(|| lost(0))?;
        let ratio = f1 * self.weight_ratio() * inverse;
        // The image of an arc is an arc: what is left along the chord is rounding, of the map and of the ends, which
        // turn a chord that is short against its distance from the origin. Beyond this the image means nothing.
        let chord = a1 - a0;
        let size = a0.to_vec().max_abs().max(a1.to_vec().max_abs());
        let limit = DEFECT_LIMIT + END_ROUNDING * size / chord.max_abs();
        let cosine = chord.unit().map_or(0.0, |c| c.dot(ratio.vector()) / ratio.norm());
        if cosine.abs() > limit {
            return Err(ArcError::NotInImH { cosine, limit }.into());
        }
        // However near to a full circle: a right arc is not refused for where its image lies.
        Ok(Self::from_ratio_across(a0, a1, ratio)?.without_lost_circle())
    }
}
