//! The exact rational biquadratic form.

use super::QbPatch;
use crate::rational::RationalBezierSurface;
use crate::surface::patch::{biquadratic_form, real_weights};

impl QbPatch {
    /// Bernstein coefficients `[i][j]` (i along s) of `|D|²`, the weights of the biquadratic form. They may be zero or negative, though the
    /// surface is finite; sub-patches that are small enough have them positive.
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
