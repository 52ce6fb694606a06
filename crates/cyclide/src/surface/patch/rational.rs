//! The exact rational biquadratic form (`docs/math/patches.md#exact-rational-form`).

use super::CyclidePatch;
use crate::base::multilinear::biquadratic;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::rational::RationalBezierSurface;

/// The nine real weights: Bernstein coefficients of `|D|²`.
pub(in crate::surface) fn real_weights(w: &[Quat; 4]) -> [[f64; 3]; 3] {
    biquadratic(|k, l| [w[k].dot(w[l])]).map(|row| row.map(|[v]| v))
}

impl CyclidePatch {
    /// Bernstein coefficients `[i][j]` (i along s) of `|D|²`, the weights of the biquadratic form. They may be zero or
    /// negative for edges of half a circle and more; sub-patches that are small enough have them positive.
    #[must_use]
    pub fn real_weights(&self) -> [[f64; 3]; 3] {
        real_weights(&self.weights)
    }

    /// The rational biquadratic with the same parameters, homogeneous rows `[wx, wy, wz, w]`.
    #[must_use]
    pub fn to_rational(&self) -> RationalBezierSurface {
        biquadratic_form(self.corners[0], self.scale, &self.n, &self.weights)
    }
}

/// The biquadratic of four pairs, whose numerators are seen from an origin, in units of `scale`.
pub(in crate::surface) fn biquadratic_form(
    origin: Point3,
    scale: f64,
    n: &[Quat; 4],
    weights: &[Quat; 4],
) -> RationalBezierSurface {
    let w = real_weights(weights);
    // Numerators are relative to the origin, whose multiple of the weight is added at the end.
    let x = biquadratic(|k, l| ((n[k] * weights[l].conj()).vector() * scale).to_array());
    let row = |i: usize, j: usize| {
        let (v, w) = (x[i][j], w[i][j]);
        [v[0] + w * origin.x, v[1] + w * origin.y, v[2] + w * origin.z, w]
    };
    let rows = (0..9).map(|k| row(k / 3, k % 3)).collect();
    RationalBezierSurface::from_rows_unchecked([2, 2], rows)
}
