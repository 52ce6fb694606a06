//! How evenly the curves of an object bend.

use cyclide::curve::{Fairness, fairness};
use serde::Serialize;

use crate::document::BuiltObject;

/// How evenly the curves of an object bend, summed over its contours; each is cut at its corners.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!(found.fairness.jumps, 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FairnessReport {
    /// Changes between turning left and turning right; `None` for a curve in space.
    pub sign_changes: Option<usize>,
    /// Extrema of the curvature (in space of its size), the ends of runs not counted.
    pub extrema: usize,
    /// `L³ ∫ k'² ds` with the length `L` of each contour, dimensionless. `None` if the curvature jumps or is
    /// unbounded.
    pub variation: Option<f64>,
    /// `∫ |k'| ds`, jumps included, in 1/length; `None` if the curvature is unbounded.
    pub total_variation: Option<f64>,
    /// Joints, corners excepted, at which the curvature jumps.
    pub jumps: usize,
    /// Why the number of sign changes is undefined.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_sign_changes: Option<&'static str>,
    /// Why there is no variation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_variation: Option<&'static str>,
}

impl FairnessReport {
    /// Measures an object.
    pub(super) fn new(built: &BuiltObject) -> Self {
        let each: Vec<Fairness> = built.item.curves().iter().map(|curve| fairness(curve.as_curve())).collect();
        let sign_changes = each.iter().map(|f| f.sign_changes).sum::<Option<usize>>();
        // The sum of nothing is -0.
        let variation = each.iter().map(|f| f.variation).sum::<Option<f64>>().map(|sum| sum + 0.0);
        let cusps = each.iter().any(|f| f.cusps > 0);
        let why_not = if cusps { "cusp" } else { "curvature-jumps" };
        Self {
            sign_changes,
            extrema: each.iter().map(|f| f.extrema).sum(),
            variation,
            total_variation: Some(0.0 + each.iter().map(|f| f.total_variation).sum::<f64>()).filter(|v| v.is_finite()),
            jumps: each.iter().map(|f| f.jumps).sum(),
            no_sign_changes: sign_changes.is_none().then_some("space"),
            no_variation: variation.is_none().then_some(why_not),
        }
    }
}
