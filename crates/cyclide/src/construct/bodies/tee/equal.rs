//! Pipes of one radius whose axes meet: the centers of balls of one radius are two half ellipses, in the planes that halve the angles between the axes,
//! and everything is exact (`docs/math/pipe-tees.md#equal-pipes`).

use super::blend::TeeBlend;
use super::crossing::Crossing;
use super::loop_piece::{Loop, LoopPiece};
use crate::construct::bodies::angle_law::check_radius;
use crate::error::{PointError, Result, TeeError, check_tolerance};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A node whose angle is off that of a flank by less than this is there.
const FLANK: f64 = 1e-9;

/// The loop of balls, both half ellipses from flank to flank: in the crotch towards the end of the main pipe first. The factor of its pieces is the distance of the
/// centers from the axes.
///
/// # Errors
/// `radius-not-positive`, `not-finite`, `tolerance-not-positive`, `tee-law-on-equal-pipes`.
pub(super) fn pieces(crossing: &Crossing, blend: &TeeBlend) -> Result<Loop> {
    let (radius, tolerance) = match blend {
        TeeBlend::Radius { radius, tolerance } => (*radius, *tolerance),
        TeeBlend::Least(radius) => (*radius, None),
        TeeBlend::Angles { values, tolerance } => {
            let [_, first] = values.first().copied().ok_or(PointError::TooFewPoints { given: 0, needed: 1 })?;
            for (index, &[_, radius]) in values.iter().enumerate() {
                check_radius(radius, index)?;
                #[expect(clippy::float_cmp, reason = "one radius is the same double at all angles")]
                if radius != first {
                    return Err(TeeError::LawOnEqualPipes { branch: crossing.branch, radii: [first, radius] }.into());
                }
            }
            (first, *tolerance)
        }
    };
    check_radius(radius, 0)?;
    tolerance.map_or(Ok(()), check_tolerance)?;
    let at = |k: u32| f64::from(k) * FRAC_PI_4 - FRAC_PI_2;
    let factor = crossing.radii[0] + radius;
    let pieces = (0..8).map(|k| LoopPiece::constant(at(k), at(k + 1), factor)).collect();
    Ok(Loop { pieces, deviation: 0.0 })
}

/// Whether a piece begins at a flank, where both pipes touch each other and the blend is one point.
pub(super) fn begins_in_a_point(crossing: &Crossing, piece: &LoopPiece) -> bool {
    crossing.equal && piece.from.cos().abs() < FLANK
}
