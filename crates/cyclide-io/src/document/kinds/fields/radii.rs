//! One radius for all corners of a polyline, or one for each.

use schemars::JsonSchema;
use serde::Serialize;

use crate::document::forms::forms;

/// The radius of all corners, or a list of one per point.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": [0, 2, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - (16.0 + std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(untagged, rename = "Radii")]
#[serde(untagged)]
#[non_exhaustive]
pub enum RadiiSpec {
    /// The same for all corners.
    All(f64),
    /// One per point; the values at the ends of an open polyline have no effect.
    Each(Vec<f64>),
}

impl Default for RadiiSpec {
    fn default() -> Self {
        Self::All(0.0)
    }
}

forms! {
    RadiiSpec: "a radius, or a list of radii, one per point";
    number f64 => RadiiSpec::All;
    list Vec<f64> => RadiiSpec::Each;
}
