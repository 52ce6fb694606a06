//! The largest curvature of a curve.

use super::cusps::{may_have_cusp, place_of_cusp};
use super::maximum::maximum;
use super::rest::place_of_curvature;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::curve::{ParamCurve, PieceForm};

/// The largest curvature and where it is.
///
/// ```
/// use cyclide::{Point3, curve::{ArcPath, extreme_curvature}};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&corner, false, &[0.0, 0.5, 0.0])?;
/// assert!((extreme_curvature(&path).max - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ExtremeCurvature {
    /// Largest curvature, in 1/length; 0 on straight curves, also where they turn back, infinite at a cusp of others.
    pub max: f64,
    /// Global parameter in `[0, 1]`, the first such place; at a joint the side of the larger curvature counts.
    pub t: f64,
    /// The point there.
    pub point: Point3,
}

/// The largest curvature over all pieces: exact for arcs and circles; elsewhere maxima are bracketed by an adaptive
/// scan of each piece and refined to rounding.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!((cyclide::curve::extreme_curvature(&arc).max - 1.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn extreme_curvature(curve: &dyn ParamCurve) -> ExtremeCurvature {
    let n = curve.piece_count();
    let mut best = (0, 0.0, -1.0);
    for piece in 0..n {
        let (s, max) = match curve.piece_form(piece) {
            PieceForm::Arc(arc) => (0.0, arc.curvature()),
            PieceForm::Circle(circle) => (0.0, 1.0 / circle.radius()),
            PieceForm::Free => {
                let (mut cusp, mut speeds) = (None, Vec::new());
                let found = maximum(&mut |s| {
                    let jet = curve.piece_jet(piece, place_of_curvature(curve, piece, s));
                    speeds.push(jet.speed());
                    let (value, slope) = curvature_and_slope(&jet);
                    if value.is_finite() {
                        return (value, slope);
                    }
                    cusp = cusp.or(Some(s));
                    (0.0, 0.0)
                });
                // A line turns back without a bend.
                let bends = found.1 > 0.0 && may_have_cusp(speeds.into_iter());
                let cusp = cusp.or_else(|| if bends { place_of_cusp(curve, piece) } else { None });
                cusp.map_or(found, |s| (s, f64::INFINITY))
            }
        };
        if max > best.2 {
            best = (piece, s, max);
        }
    }
    let (piece, s, max) = best;
    ExtremeCurvature { max, t: (piece as f64 + s) / n as f64, point: curve.piece_point(piece, s) }
}

/// Curvature and its derivative by the parameter; infinite at a cusp, 0 on a piece without extent.
///
/// With `C = x' × x''`: `k = |C|/|x'|³`, `k' = k (C·(x' × x''')/|C|² - 3 x'·x''/|x'|²)`.
pub(super) fn curvature_and_slope(jet: &CurveJet) -> (f64, f64) {
    let Some(curvature) = jet.curvature() else {
        return (if jet.bends_from_rest() { f64::INFINITY } else { 0.0 }, 0.0);
    };
    // Scaled so that the squares neither overflow nor vanish.
    let scale = jet.d1.max_abs();
    let (d1, d2, d3) = (jet.d1 / scale, jet.d2 / scale, jet.d3 / scale);
    let c = d1.cross(d2);
    let c2 = c.length_squared();
    let slope = curvature * (c.dot(d1.cross(d3)) / c2 - 3.0 * d1.dot(d2) / d1.length_squared());
    (curvature, if slope.is_finite() { slope } else { 0.0 })
}
