//! The exact rational biquadratic form (`docs/math/patches.md#exact-rational-form`).

use super::CyclidePatch;
use crate::base::multilinear::biquadratic;
use crate::base::quat::Quat;
use crate::rational::RationalBezierSurface;

/// The nine real weights: Bernstein coefficients of `|D|²`.
pub(super) fn real_weights(w: &[Quat; 4]) -> [[f64; 3]; 3] {
    biquadratic(|k, l| [w[k].dot(w[l])]).map(|row| row.map(|[v]| v))
}

impl CyclidePatch {
    /// Bernstein coefficients `[i][j]` (i along s) of `|D|²`, the weights of the biquadratic form. They may be zero or
    /// negative for edges of half a circle and more; sub-patches that are small enough have them positive.
    #[must_use]
    pub fn real_weights(&self) -> [[f64; 3]; 3] {
        real_weights(&self.weights)
    }
}

impl CyclidePatch {
    /// The rational biquadratic with the same parameters, homogeneous rows `[wx, wy, wz, w]`.
    #[must_use]
    pub fn to_rational(&self) -> RationalBezierSurface {
        let w = self.real_weights();
        let origin = self.corners[0];
        // Numerators are relative to the first corner, whose multiple of the weight is added at the end.
        let x = biquadratic(|k, l| {
            let v = (self.n[k] * self.weights[l].conj()).vector() * self.scale;
            v.to_array()
        });
        let row = |i: usize, j: usize| {
            let (v, w) = (x[i][j], w[i][j]);
            [v[0] + w * origin.x, v[1] + w * origin.y, v[2] + w * origin.z, w]
        };
        let rows = (0..9).map(|k| row(k / 3, k % 3)).collect();
        RationalBezierSurface::from_rows_unchecked([2, 2], rows)
    }
}
