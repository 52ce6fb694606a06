//! The report on curves of quaternion pairs.

use std::fmt;

use cyclide::model::CurveObject;
use serde::Serialize;

use super::figures::{Line, plural, short};
use crate::document::BuiltObject;

/// Curves that are quotients of quaternion polynomials, over all contours.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "points": [[0, 0], [1, 2], [3, 2], [5, 1], [6, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!(found.qb.map(|qb| (qb.degree, qb.rational_degree)), Some((2, 4)));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QbReport {
    /// Largest degree of the quaternion polynomials.
    pub degree: usize,
    /// Degree of the exact rational form, twice as high.
    pub rational_degree: usize,
    /// Joints at which the curve is only connected.
    pub corners: usize,
    /// For curves of lowest degree: the parameters of the points of each contour.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<Vec<f64>>,
    /// For curves of lowest degree: their largest distance from the middle of the points, relative to that of the
    /// points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reach: Option<f64>,
    /// For curves of lowest degree: the smallest remaining weight at a point, at most 1. Near 0 the curve reaches the point in a
    /// spike.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attainability: Option<f64>,
}

/// So many parameters are shown as text.
const SHOWN: usize = 9;

impl QbReport {
    /// Of an object with such curves.
    pub(super) fn new(built: &BuiltObject) -> Option<Self> {
        let splines = || {
            built.item.curves().iter().filter_map(|curve| match curve {
                CurveObject::QbSpline(spline) => Some(spline),
                _ => None,
            })
        };
        let degree = splines().map(cyclide::curve::QbSpline::degree).max()?;
        let found = || built.contours.iter().filter_map(|facts| facts.interpolation.as_ref());
        Some(Self {
            degree,
            rational_degree: 2 * degree,
            corners: splines().map(|spline| spline.kinks().len()).sum(),
            parameters: found().map(|facts| facts.parameters.clone()).collect(),
            reach: found().map(|facts| facts.reach).reduce(f64::max),
            attainability: found().map(|facts| facts.attainability).reduce(f64::min),
        })
    }

    /// The lines of the text.
    pub(super) fn lines(&self, line: Line<'_>) -> fmt::Result {
        let mut text =
            format!("quaternion pairs of degree {}, rational of degree {}", self.degree, self.rational_degree);
        if self.corners > 0 {
            text += &format!(", {}", plural(self.corners, "corner"));
        }
        line("form", text)?;
        let (Some(reach), Some(attainability)) = (self.reach, self.attainability) else { return Ok(()) };
        let mut text =
            format!("reach {} times that of its points, least attainability {}", short(reach), short(attainability));
        if let [parameters] = self.parameters.as_slice() {
            let shown: Vec<String> = parameters.iter().take(SHOWN).map(|t| short(*t)).collect();
            let more = if parameters.len() > SHOWN { ", ..." } else { "" };
            text = format!("parameters {}{more}; {text}", shown.join(", "));
        }
        line("through", text)
    }
}
