//! Rational B-spline curves, as other programs have them.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::coordinates::Coordinates;

/// A rational B-spline curve (NURBS) by its degree, knots, control points and weights.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "nurbs", "degree": 2, "knots": [0, 0, 0, 1, 1, 1],
///     "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 0.7071067811865476, 1]}}}"#.parse()?;
/// let built = document.build()?;
/// let quarter = cyclide::length(built[0].item.curves()[0].as_curve());
/// assert!((quarter - 0.5 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NurbsSpec {
    /// The word `nurbs`.
    #[schemars(with = "String", extend("const" = "nurbs"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Degree of the polynomials; the order is one more.
    #[schemars(range(min = 1, max = 25))]
    pub degree: u32,
    /// Knots with their repetitions, as many as control points, degree and 1 together, none less than the one before and
    /// no inner one more often than the degree. Ends that are not clamped (`degree + 1` equal knots) are clamped by exact knot
    /// insertion: the curve is the part where all control points count.
    #[schemars(length(min = 4))]
    pub knots: Vec<f64>,
    /// Control points, `degree + 1` at least. The curve is closed if the last one is the first.
    #[schemars(length(min = 2))]
    pub control_points: Vec<Coordinates>,
    /// Weights of the control points, all positive. Default: 1, a polynomial spline.
    pub weights: Option<Vec<f64>>,
}
