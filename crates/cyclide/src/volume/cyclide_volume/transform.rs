//! Möbius maps of volumes: the homogeneous pairs map linearly, so the image is a volume with the same parameters.

use super::CyclideVolume;
use crate::base::range;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, Result};

/// Rounding of the real weights of a rational form, relative to the largest.
const WEIGHT_ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Conformal for CyclideVolume {
    /// The image under a Möbius map, with the same parameters: corners by the map, weights `(c a_k + d) w_k` up to a common factor. The
    /// speeds keep their signs; a map that reverses orientation turns all three directions of the constant frame round.
    ///
    /// # Errors
    /// `point-at-infinity` if a corner goes to infinity, `volume-through-infinity` if an inner point does, `parameter-out-of-range`,
    /// `below-rounding-of-place`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let (mut corners, mut weights) = (self.corners, self.weights);
        let mut size = 1.0;
        let lost = |corner| Error::at_infinity(ErrorItem::Corner, corner);
        for k in 0..8 {
            let (image, factor) = map.map_weighted(self.corners[k]).ok_or_else(|| lost(k))?;
            // The factor is c times the distance from the point that goes to infinity.
            let nearest = map.matrix()[2].norm() * self.scale;
            if factor.norm_squared() <= WEIGHT_ROUNDING * nearest * nearest {
                return Err(lost(k));
            }
            range::check_point(k, image.to_vec())?;
            if k == 0 {
                size = factor.norm();
            }
            corners[k] = image;
            // Lengths near those before: a gauge, the same for all corners.
            weights[k] = factor * (1.0 / size) * self.weights[k];
        }
        range::check_place(ErrorItem::Volume, &corners)?;
        let sign = 1.0_f64.copysign(map.determinant());
        let image = Self::from_weights_unchecked(corners, weights, self.v.map(|v| v * sign));
        image.check_no_pole()?;
        Ok(image)
    }
}
