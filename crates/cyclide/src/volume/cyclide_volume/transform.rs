//! Möbius maps of volumes: the homogeneous pairs map linearly, so the image is a volume with the same parameters.

use super::CyclideVolume;
use crate::base::range;
use crate::conformal::mapped_pairs::MappedPairs;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{ErrorItem, Result};

impl Conformal for CyclideVolume {
    /// The image under a Möbius map, with the same parameters: corners by the map, weights `(c a_k + d) w_k` up to a common factor. The
    /// speeds keep their signs; a map that reverses orientation turns all three directions of the constant frame round.
    ///
    /// # Errors
    /// `point-at-infinity` if a corner goes to infinity, `volume-through-infinity` if an inner point does, `parameter-out-of-range`,
    /// `below-rounding-of-place`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let MappedPairs { corners, weights, .. } = map.map_pairs(self.corners, self.weights, self.scale)?;
        range::check_place(ErrorItem::Volume, &corners)?;
        let sign = 1.0_f64.copysign(map.determinant());
        let image = Self::from_weights_unchecked(corners, weights, self.v.map(|v| v * sign));
        image.check_no_pole()?;
        Ok(image)
    }
}
