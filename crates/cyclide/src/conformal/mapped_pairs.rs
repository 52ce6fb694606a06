//! Images of points with quaternion weights: what patches and volumes are made of.

use super::mobius::Mobius;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, Result};

/// Rounding of the real weights of a rational form, relative to the largest: they are products of two weights, which are
/// in the image as the distances of the corners from the point that goes to infinity.
const WEIGHT_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The images of corners with their weights `(c a + d) w`, over the length of the first factor.
pub(crate) struct MappedPairs<const N: usize> {
    pub(crate) corners: [Point3; N],
    pub(crate) weights: [Quat; N],
    /// The length of the factor of the first corner.
    pub(crate) size: f64,
}

impl Mobius {
    /// The images of corners that are `extent` apart at most (`docs/math/conformal.md#pairs-and-maps`).
    ///
    /// # Errors
    /// `point-at-infinity` if a corner goes to infinity, or is nearer than 6e-8 of the extent to the point that does (then nothing of the image's
    /// size is known, nor the sign of its weights); `parameter-out-of-range` (coordinates above 1e150).
    pub(crate) fn map_pairs<const N: usize>(
        &self,
        mut corners: [Point3; N],
        mut weights: [Quat; N],
        extent: f64,
    ) -> Result<MappedPairs<N>> {
        let mut size = 1.0;
        // The factor is c times the distance from the point that goes to infinity.
        let nearest = self.matrix()[2].norm() * extent;
        for k in 0..N {
            let lost = || Error::at_infinity(ErrorItem::Corner, k);
            let (image, factor) = self.map_weighted(corners[k]).ok_or_else(lost)?;
            if factor.norm_squared() <= WEIGHT_ROUNDING * nearest * nearest {
                return Err(lost());
            }
            range::check_point(k, image.to_vec())?;
            if k == 0 {
                size = factor.norm();
            }
            corners[k] = image;
            // Lengths near those before: a gauge, the same for all corners.
            weights[k] = factor * (1.0 / size) * weights[k];
        }
        Ok(MappedPairs { corners, weights, size })
    }
}
