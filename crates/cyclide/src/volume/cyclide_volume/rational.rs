//! The exact rational triquadratic form (`docs/math/volumes.md#exact-rational-form`).

use super::CyclideVolume;
use super::pole::{self, HALVINGS, real_weights};
use crate::base::multilinear::triquadratic;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::error::{Result, VolumeError};
use crate::rational::RationalBezierVolume;

impl CyclideVolume {
    /// The rational triquadratic with the same parameters, homogeneous rows `[wx, wy, wz, w]`. Weights are zero or negative beside sides of
    /// half a circle and more: see [`to_rational_parts`](Self::to_rational_parts).
    #[must_use]
    pub fn to_rational(&self) -> RationalBezierVolume {
        rational_form(self.corners[0], self.scale, &self.n, &self.weights)
    }

    /// The volume as parts with positive weights only, each with its place `[from, to]` in the three parameters: one where that is
    /// possible, otherwise those of halves in all directions.
    ///
    /// # Errors
    /// `volume-through-infinity` where parts of a 65536th of the range are not small enough: only of what is [`unbounded`](Self::unbounded).
    pub fn to_rational_parts(&self) -> Result<Vec<([[f64; 2]; 3], RationalBezierVolume)>> {
        let mut parts = Vec::new();
        self.add_positive(&self.weights, [0.0; 3], HALVINGS, &mut parts)?;
        parts.into_iter().map(|place| Ok((place, self.restricted(place)?.to_rational()))).collect()
    }

    fn add_positive(&self, w: &[Quat; 8], from: [f64; 3], depth: u32, parts: &mut Vec<[[f64; 2]; 3]>) -> Result<()> {
        let size = 0.5f64.powi((HALVINGS - depth) as i32);
        if real_weights(w).iter().all(|&v| v > 0.0) {
            parts.push(from.map(|x| [x, x + size]));
            return Ok(());
        }
        if depth == 0 {
            return Err(VolumeError::ThroughInfinity { at: from.map(|x| x + 0.5 * size) }.into());
        }
        for octant in 0..8 {
            let at = pole::at_octant(from, 0.5 * size, octant);
            self.add_positive(&pole::part(w, octant), at, depth - 1, parts)?;
        }
        Ok(())
    }
}

/// The triquadratic of eight pairs, whose numerators are seen from an origin, in units of `scale`.
pub(in crate::volume) fn rational_form(
    origin: Point3,
    scale: f64,
    n: &[Quat; 8],
    weights: &[Quat; 8],
) -> RationalBezierVolume {
    // Numerators are relative to the origin, whose multiple of the weight is added at the end.
    let x = triquadratic(|k, l| ((n[k] * weights[l].conj()).vector() * scale).to_array());
    let row = |(v, w): ([f64; 3], f64)| [v[0] + w * origin.x, v[1] + w * origin.y, v[2] + w * origin.z, w];
    RationalBezierVolume::from_rows_unchecked([2; 3], x.into_iter().zip(real_weights(weights)).map(row).collect())
}
