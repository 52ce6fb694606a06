//! The exact rational biquadratic form (`docs/math/patches.md#exact-rational-form`).

use super::CyclidePatch;
use crate::base::quat::Quat;
use crate::rational::{ExactRational, RationalBezierSurface};

/// Corners as bits of s and t.
const BITS: [(usize, usize); 4] = [(0, 0), (1, 0), (0, 1), (1, 1)];

/// Binomials of degree 2.
const CHOOSE: [f64; 3] = [1.0, 2.0, 1.0];

/// The Bernstein coefficients `[i][j]`, i along s, of a biquadratic given by its sixteen products of corners.
fn symmetrised<const D: usize>(product: impl Fn(usize, usize) -> [f64; D]) -> [[[f64; D]; 3]; 3] {
    let mut sum = [[[0.0; D]; 3]; 3];
    for (k, (si, ti)) in BITS.into_iter().enumerate() {
        for (l, (sj, tj)) in BITS.into_iter().enumerate() {
            let value = product(k, l);
            for (sum, value) in sum[si + sj][ti + tj].iter_mut().zip(value) {
                *sum += value;
            }
        }
    }
    for (i, row) in sum.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            for v in entry {
                *v /= CHOOSE[i] * CHOOSE[j];
            }
        }
    }
    sum
}

/// The nine real weights: Bernstein coefficients of `|D|²`.
pub(super) fn real_weights(w: &[Quat; 4]) -> [[f64; 3]; 3] {
    symmetrised(|k, l| [w[k].dot(w[l])]).map(|row| row.map(|[v]| v))
}

impl CyclidePatch {
    /// Bernstein coefficients `[i][j]` (i along s) of `|D|²`, the weights of the biquadratic form. They may be zero or
    /// negative for edges of half a circle and more; sub-patches that are small enough have them positive.
    #[must_use]
    pub fn real_weights(&self) -> [[f64; 3]; 3] {
        real_weights(&self.weights)
    }
}

impl ExactRational for CyclidePatch {
    type Form = RationalBezierSurface;

    /// The rational biquadratic with the same parameters, homogeneous rows `[wx, wy, wz, w]`.
    fn to_rational(&self) -> RationalBezierSurface {
        let w = self.real_weights();
        let origin = self.corners[0];
        // Numerators are relative to the first corner, whose multiple of the weight is added at the end.
        let x = symmetrised(|k, l| {
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
