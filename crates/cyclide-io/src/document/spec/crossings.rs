//! Crossings of pipes, field by field.

use cyclide::TeeEnds;
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;

/// Two pipes that pass each other, blended by a ball that rolls between them: the first about the x axis, the second `distance` above it, at an `angle` to it; solid, or with a `wall` and one bore. Where they do not touch the blend is a bridge between them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("if" = {"properties": {"ends": {"const": "open"}}, "required": ["ends"]}),
    extend("then" = {"properties": {"wall": false}})
)]
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
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "CrossingPipe")]
pub struct CrossingPipeSpec {
    /// Its outer radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Where it ends along its axis, counted from where the axes are nearest; the lower place first.
    pub ends: [f64; 2],
}
