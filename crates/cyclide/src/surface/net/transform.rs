//! Möbius maps of nets: the pairs of the vertices map linearly.

use super::CyclidicNet;
use crate::base::quat::Quat;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, Result};

impl Conformal for CyclidicNet {
    /// The image under `y -> (a y + b)(c y + d)^-1`, with the same parameters: vertices by the map, weights
    /// `(c y + d) w` up to a common real factor (`docs/math/patches.md#offsets-and-images`). A map that reverses
    /// orientation turns the normals to the other side, as [`CyclidePatch::transformed`](crate::surface::CyclidePatch).
    ///
    /// # Errors
    /// Those of patches, with the quad: `point-at-infinity`, `patch-through-infinity`, `parameter-out-of-range`,
    /// `coincident-points`, `not-in-space`; `below-rounding-of-place`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        for [i, j] in self.grid.all_quads() {
            self.patch(i, j).image(map).map_err(|e| e.in_quad(self.number([i, j])))?;
        }
        let lost = |index| Error::at_infinity(ErrorItem::Vertex, index);
        let places = self.grid.points().iter().enumerate();
        let images = places.map(|(k, a)| map.map_weighted(*a).ok_or_else(|| lost(k)));
        let (points, factors): (Vec<_>, Vec<_>) = images.collect::<Result<Vec<_>>>()?.into_iter().unzip();
        let grid = self.grid.with_points(points)?;
        grid.check_place()?;
        let weights: Vec<Quat> = factors.iter().zip(&self.weights).map(|(f, w)| *f * *w).collect();
        // A common factor changes nothing: lengths around 1.
        let mean = weights.iter().map(|w| w.norm().ln()).sum::<f64>() / weights.len() as f64;
        let weights = weights.into_iter().map(|w| w * (-mean).exp()).collect();
        let sign = 1.0_f64.copysign(map.determinant());
        Ok(Self::from_weights_unchecked(grid, weights, self.v.map(|v| v * sign), self.turn))
    }
}
