//! The patch over four given arcs (`docs/math/bilinear-patches.md#four-arcs`).

use super::QbPatch;
use super::construct::{check_corners, check_distinct, unit_directions};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{PatchError, Result};

/// Largest angle, radians, by which the turns both ways round may differ.
const CLOSING: f64 = 1e-9;
/// A quotient whose both parts are below this is not known.
const UNDETERMINED: f64 = 1e-12;

/// The sides of a patch, from and to which corner: along s at t = 0, along t at s = 0, along t at s = 1, along s at t = 1.
const SIDES: [[usize; 2]; 4] = [[0, 1], [0, 2], [1, 3], [2, 3]];

impl QbPatch {
    /// The patch over four arcs, from their tangents where they start: those from `a0` to `a1`, from `a0` to `a2`, from `a1` to `a3` and from
    /// `a2` to `a3`, of any length. Four arcs bound a bilinear patch of circles if and only if carrying a frame along them gives the same
    /// both ways round ([`PatchError::ArcsDoNotClose`] says by which angle they miss) and the weight that follows is positive.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points`, `zero-tangent`, `arcs-do-not-close`,
    /// `arcs-need-complement`, `undetermined-weight`, `weight-not-positive`, `patch-through-infinity`.
    pub fn from_arcs(corners: [Point3; 4], tangents: [Vec3; 4]) -> Result<Self> {
        let scale = check_corners(&corners)?;
        check_distinct(&corners, scale, &SIDES)?;
        let tangents = unit_directions(tangents)?;
        // The ratio of the weights at the ends of a side: chord^-1 times tangent, of length 1.
        let mut ratios = [Quat::ONE; 4];
        for ((ratio, [from, to]), tangent) in ratios.iter_mut().zip(SIDES).zip(tangents) {
            let chord = (corners[to] - corners[from]) / scale;
            *ratio = Quat::from(chord / -chord.length()) * Quat::from(tangent);
        }
        let [w01, w02, w13, w23] = ratios;
        let (first, second) = (w13 * w01, w23 * w02);
        let turn = second.conj() * first;
        let holonomy = turn.vector().length().atan2(turn.w);
        if std::f64::consts::PI - holonomy <= CLOSING {
            return Err(PatchError::ArcsNeedComplement { holonomy }.into());
        }
        if holonomy > CLOSING {
            return Err(PatchError::ArcsDoNotClose { holonomy, limit: CLOSING }.into());
        }
        // The middle coefficient of the real part vanishes.
        let real =
            |i: usize, j: usize, a: Quat, b: Quat| (Quat::from((corners[i] - corners[j]) / scale) * a * b.conj()).w;
        let (above, below) = (-real(1, 2, w01, w02), real(0, 3, Quat::ONE, first));
        if above.abs().max(below.abs()) <= UNDETERMINED {
            return Err(
                PatchError::UndeterminedWeight { measured: above.abs().max(below.abs()), limit: UNDETERMINED }.into()
            );
        }
        let ratio = above / below;
        if !(ratio > 0.0 && ratio.is_finite()) {
            return Err(PatchError::WeightNotPositive { ratio }.into());
        }
        let patch = Self::finite(corners, [Quat::ONE, w01, w02, first * ratio])?;
        patch.check_in_space(patch.corner_rounding() + CLOSING)?;
        Ok(patch)
    }
}
