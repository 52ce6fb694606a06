//! The largest curvature of a curve.

use super::maximum::maximum;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::curve::{ParamCurve, PieceForm};

/// A cusp is told from so far beside it, in the parameter of its piece: there is this part less of the speed at it, and so many times as much curvature.
const BESIDE: f64 = 1e-3;
const NO_SPEED: f64 = 1e-6;
const LARGER: f64 = 1e3;

/// The largest curvature and where it is.
///
/// ```
/// use cyclide::{ArcPath, Point3, extreme_curvature};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&corner, false, &[0.0, 0.5, 0.0])?;
/// assert!((extreme_curvature(&path).max - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ExtremeCurvature {
    /// Largest curvature, in 1/length; 0 on straight curves, infinite at a cusp.
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
/// use cyclide::{Arc, Point3};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!((cyclide::extreme_curvature(&arc).max - 1.0).abs() < 1e-12);
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
                let mut cusp = None;
                let found = maximum(&mut |s| {
                    let (value, slope) = curvature_and_slope(&curve.piece_jet(piece, s));
                    if value.is_finite() {
                        return (value, slope);
                    }
                    cusp = cusp.or(Some(s));
                    (0.0, 0.0)
                });
                let cusp = cusp.or_else(|| is_cusp(curve, piece, found).then_some(found.0));
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

/// True if the largest curvature of a piece grows beyond every bound: the curve hardly moves there, and bends far less a little beside it.
fn is_cusp(curve: &dyn ParamCurve, piece: usize, (s, curvature): (f64, f64)) -> bool {
    let speed = |s: f64| curve.piece_speed(piece, s);
    let beside = [(s - BESIDE).max(0.0), (s + BESIDE).min(1.0)];
    speed(s) <= NO_SPEED * beside.map(speed).into_iter().fold(0.0, f64::max)
        && beside.iter().all(|at| {
            // At the end of a piece one of both is the place itself.
            let there = curve.piece_jet(piece, *at).curvature();
            (at - s).abs() <= 0.0 || there.is_none_or(|there| curvature > LARGER * there)
        })
}

/// Curvature and its derivative by the parameter; infinite at a cusp, 0 on a piece without extent.
///
/// With `C = x' × x''`: `k = |C|/|x'|³`, `k' = k (C·(x' × x''')/|C|² - 3 x'·x''/|x'|²)`.
pub(super) fn curvature_and_slope(jet: &CurveJet) -> (f64, f64) {
    let Some(curvature) = jet.curvature() else {
        return (if jet.d2.cross(jet.d3).max_abs() > 0.0 { f64::INFINITY } else { 0.0 }, 0.0);
    };
    // Scaled so that the squares neither overflow nor vanish.
    let scale = jet.d1.max_abs();
    let (d1, d2, d3) = (jet.d1 / scale, jet.d2 / scale, jet.d3 / scale);
    let c = d1.cross(d2);
    let c2 = c.length_squared();
    let slope = curvature * (c.dot(d1.cross(d3)) / c2 - 3.0 * d1.dot(d2) / d1.length_squared());
    (curvature, if slope.is_finite() { slope } else { 0.0 })
}
