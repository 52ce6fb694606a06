//! The bending energy of a curve.

use super::rest::place_of_curvature;
use crate::base::quadrature::integrate;
use crate::curve::{ParamCurve, PieceForm};

/// Intervals between the places of a piece that may be cusps.
const SCAN: u32 = 16;

/// The bending energy `∫ k² ds` of the smooth pieces, in 1/length: what a thin elastic rod stores. Closed form for arcs and
/// circles, else to about 1e-12 of each piece. Corners, where it has no bound, are not counted; infinite if a piece has a
/// cusp at one of 17 places, its ends among them.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, bending_energy}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
/// assert!((bending_energy(&circle) - std::f64::consts::PI).abs() < 1e-14); // 2 pi/r
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn bending_energy(curve: &dyn ParamCurve) -> f64 {
    (0..curve.piece_count()).map(|piece| energy_of_piece(curve, piece)).sum()
}

fn energy_of_piece(curve: &dyn ParamCurve, piece: usize) -> f64 {
    let of_constant = |curvature: f64| curvature * curvature * curve.piece_length(piece, 0.0, 1.0);
    match curve.piece_form(piece) {
        PieceForm::Arc(arc) => of_constant(arc.curvature()),
        PieceForm::Circle(circle) => of_constant(1.0 / circle.radius()),
        PieceForm::Free => {
            let is_cusp = |s: f64| {
                let jet = curve.piece_jet(piece, s);
                jet.curvature().is_none_or(|k| !k.is_finite()) && jet.bends_from_rest()
            };
            if (0..=SCAN).any(|i| is_cusp(f64::from(i) / f64::from(SCAN))) {
                return f64::INFINITY;
            }
            let density = &mut |s: f64| {
                let jet = curve.piece_jet(piece, place_of_curvature(curve, piece, s));
                let value = jet.curvature().map_or(0.0, |k| k * k * jet.speed());
                if value.is_finite() { value } else { 0.0 }
            };
            integrate(density, 0.0, 1.0)
        }
    }
}
