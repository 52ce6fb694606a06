//! What curves are compared by.

use cyclide::{
    curve::{ArcPath, CurveIndex, ParamCurve, bending_energy, extreme_curvature, fairness, farthest_point, length},
    model::{CurveObject, Exactness, Lower as _},
};
use serde::Serialize;

use crate::document::BuiltObject;

/// The measures of one kind of curve, over all contours.
///
/// ```
/// use cyclide_io::{Document, compare::Comparison};
/// let text = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [4, 0], [4, 3]]}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let kinds = vec![("polyline".to_owned(), Ok(built[0].clone()))];
/// let measures = Comparison::new("points.csv", document.units, &built[0], kinds, 0.01).kinds[0].measures.clone();
/// let measures = measures.expect("it was made");
/// assert_eq!((measures.length, measures.overshoot, measures.corners, measures.exact_in_step), (7.0, 0.0, 1, true));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveMeasures {
    /// Length.
    pub length: f64,
    /// The excess of its length over that of the polygon of the points, relative to the latter.
    pub longer: f64,
    /// Bending energy `∫ k² ds`, in 1/length; corners are not counted.
    pub bending_energy: f64,
    /// `L³ ∫ k'² ds`, dimensionless; `None` if the curvature jumps or is unbounded.
    pub variation: Option<f64>,
    /// `∫ |k'| ds` plus the jumps of the curvature, in 1/length.
    pub total_variation: f64,
    /// Changes between turning left and right; `None` in space.
    pub sign_changes: Option<usize>,
    /// Extrema of the curvature.
    pub extrema: usize,
    /// Joints at which the curvature jumps.
    pub jumps: usize,
    /// Joints where the direction changes, and cusps.
    pub corners: usize,
    /// Largest curvature, in 1/length.
    pub max_curvature: f64,
    /// Where it is.
    pub max_curvature_point: [f64; 3],
    /// Overshoot: the largest distance of the curve from the polygon of the points.
    pub overshoot: f64,
    /// Where it is.
    pub overshoot_point: [f64; 3],
    /// The largest distance of a point from the curve: rounding for curves through the points.
    pub off_points: f64,
    /// Smooth pieces.
    pub pieces: usize,
    /// True if STEP and JSON hold it exactly.
    pub exact_in_step: bool,
    /// Number of arcs and segments in DXF and SVG: its own if it consists of them, otherwise as many as the tolerance
    /// requires.
    pub arcs: Option<usize>,
    /// True if these are the curve.
    pub exact_in_dxf: bool,
}

impl CurveMeasures {
    /// Measures the curves of an object against the sides of the polygon of each.
    pub(super) fn new(built: &BuiltObject, polygon: &[CurveObject], tolerance: f64) -> Self {
        let curves = built.item.curves();
        let each = || curves.iter().map(CurveObject::as_curve);
        let fair: Vec<_> = each().map(fairness).collect();
        let tightest = each().map(extreme_curvature).max_by(|a, b| a.max.total_cmp(&b.max));
        let far = curves.iter().zip(polygon).map(|(curve, sides)| farthest_point(curve.as_curve(), sides.as_curve()));
        let far = far.max_by(|a, b| a.distance.total_cmp(&b.distance));
        let own = each().map(length).sum::<f64>();
        let sides = polygon.iter().map(|side| length(side.as_curve())).sum::<f64>();
        let arcs: Option<Vec<(ArcPath, Exactness)>> =
            curves.iter().map(|curve| curve.to_arcs(tolerance).ok()).collect();
        let is_exact = |curve: &CurveObject| matches!(curve.to_chain(tolerance), Ok((_, Exactness::Exact)));
        Self {
            length: own,
            longer: own / sides - 1.0,
            bending_energy: each().map(bending_energy).sum(),
            variation: fair.iter().map(|f| f.variation).sum::<Option<f64>>().map(|sum| sum + 0.0),
            total_variation: 0.0 + fair.iter().map(|f| f.total_variation).sum::<f64>(),
            sign_changes: fair.iter().map(|f| f.sign_changes).sum(),
            extrema: fair.iter().map(|f| f.extrema).sum(),
            jumps: fair.iter().map(|f| f.jumps).sum(),
            corners: fair.iter().map(|f| f.corners + f.cusps).sum(),
            max_curvature: tightest.map_or(0.0, |t| t.max),
            max_curvature_point: tightest.map_or([0.0; 3], |t| t.point.to_array()),
            overshoot: far.map_or(0.0, |far| far.distance),
            overshoot_point: far.map_or([0.0; 3], |far| far.point.to_array()),
            off_points: curves
                .iter()
                .zip(polygon)
                .map(|(c, p)| off_points(c.as_curve(), p.as_curve()))
                .fold(0.0, f64::max),
            pieces: each().map(ParamCurve::piece_count).sum(),
            exact_in_step: curves.iter().all(is_exact),
            exact_in_dxf: arcs.as_ref().is_some_and(|all| all.iter().all(|(_, e)| *e == Exactness::Exact)),
            arcs: arcs.map(|all| all.iter().map(|(path, _)| path.arcs().len()).sum()),
        }
    }
}

/// The largest distance of a vertex of the polygon from a curve.
fn off_points(curve: &dyn ParamCurve, polygon: &dyn ParamCurve) -> f64 {
    let index = CurveIndex::new(curve);
    let vertices = (0..polygon.piece_count()).flat_map(|piece| [0.0, 1.0].map(|s| polygon.piece_point(piece, s)));
    vertices.map(|p| index.closest_point(p).distance).fold(0.0, f64::max)
}
