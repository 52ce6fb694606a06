//! Surfaces that are given otherwise than by polygons: B-spline surfaces and grids of heights, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;

/// A rational B-spline surface (NURBS), given by its degrees, knots, control points and weights, like `nurbs` curves.
///
/// ```
/// use cyclide_io::{Document, document::ObjectSpec};
/// let hypar = r#"{"degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]], "control_points": [[[0, 0, 0], [4, 0, 0]], [[0, 4, 0], [4, 4, 1]]]}"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"g": {{"type": "principal-grid", "nurbs": {hypar}, "edge_length": 0.5}}}}}}"#);
/// let document: Document = text.parse()?;
/// let ObjectSpec::PrincipalGrid(spec) = &document.objects[0].1 else { unreachable!("the type says so") };
/// assert_eq!(spec.nurbs.as_ref().map(|surface| surface.degrees), Some([1, 1]));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NurbsSurfaceSpec {
    /// Degrees along the rows of control points, and from row to row.
    #[schemars(inner(range(min = 1, max = 25)))]
    pub degrees: [u32; 2],
    /// Knots along the rows, and from row to row, with their repetitions; their number is that of the control points
    /// plus the degree plus 1. Ends that are not clamped are clamped by exact knot insertion.
    #[schemars(inner(length(min = 4)))]
    pub knots: [Vec<f64>; 2],
    /// Control points, row by row.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub control_points: Vec<Vec<Coordinates>>,
    /// Weights of the control points, row by row, all positive. Default: 1, a polynomial surface.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub weights: Option<Vec<Vec<f64>>>,
}

/// Heights over a grid in the plane z = 0, in a file (`csv`) or row by row (`z`).
///
/// ```
/// use cyclide_io::{Document, document::ObjectSpec};
/// let heights = r#"{"z": [[0, 0, 0], [0, 0.1, 0.2], [0, null, 0.4]], "spacing": [2, 2]}"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"g": {{"type": "principal-grid", "heights": {heights}, "edge_length": 2}}}}}}"#);
/// let document: Document = text.parse()?;
/// let ObjectSpec::PrincipalGrid(spec) = &document.objects[0].1 else { unreachable!("the type says so") };
/// assert_eq!(spec.heights.as_ref().map(|heights| heights.spacing), Some([2.0, 2.0]));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["csv"], "properties": { "z": false } },
    { "required": ["z"], "properties": { "csv": false } }
]))]
pub struct HeightsSpec {
    /// Path of a file of numbers, relative to the document: one line for each row along x, separated by commas,
    /// semicolons, tabs or blanks, without a header. Empty cells and `NaN` are holes.
    pub csv: Option<String>,
    /// The heights, one list for each row along x; `null` is a hole.
    #[schemars(length(min = 2), inner(length(min = 2)))]
    pub z: Option<Vec<Vec<Option<f64>>>>,
    /// Distance from one height to the next along x, and from one row to the next along y; negative if rows begin on
    /// the far side.
    pub spacing: [f64; 2],
    /// Position of the first height. Default: x = y = 0.
    #[serde(default)]
    pub origin: [f64; 2],
}
