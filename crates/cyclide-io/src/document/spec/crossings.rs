//! Crossings of pipes, field by field.

use cyclide::TeeEnds;
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;

/// Two pipes that pass each other, blended by a ball that rolls between them: the first about the x axis, the second `distance` above it, at an `angle` to it; solid, or with a `wall` and one bore. Where they do not touch the blend is a bridge between them.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("if" = {"properties": {"ends": {"const": "open"}}, "required": ["ends"]}),
    extend("then" = {"properties": {"wall": false}})
)]
#[non_exhaustive]
pub struct PipeCrossingSpec {
    /// The word `pipe-crossing`.
    #[schemars(with = "String", extend("const" = "pipe-crossing"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The pipe about the x axis, and the one above it.
    pub pipes: [CrossingPipeSpec; 2],
    /// Distance of the axes, more than the radii differ.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub distance: f64,
    /// Angle of the second axis from the first, about the upward normal, between 0 and 180 degrees. Default: a right angle.
    pub angle: Option<Angle>,
    /// The radius of the ball; of pipes that do not touch more than half the gap.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub blend: f64,
    /// Largest difference from that one radius, which no rational blend has exactly. Default: a thousandth of it.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Thickness of the wall of both pipes, also within the blend: one bore. Default: the crossing is filled.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the pipes end. `open` leaves a surface, and goes without a wall.
    #[serde(default)]
    pub ends: TeeEnds,
}

/// A pipe of a crossing.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - 40.0).abs() < 1e-9 && (bounds.max.y - 35.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "CrossingPipe")]
#[non_exhaustive]
pub struct CrossingPipeSpec {
    /// Its outer radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Where it ends along its axis, counted from where the axes are nearest; the lower place first.
    pub ends: [f64; 2],
}
