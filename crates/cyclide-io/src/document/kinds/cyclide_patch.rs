//! One patch of circles: of a Dupin cyclide, or a general bilinear one.

use cyclide::{
    error::PatchError,
    model::SurfaceObject,
    surface::{CornerTwist, CyclidePatch, QbPatch, QbPatchKind},
    topology::Body,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::{direction, frame_words};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

/// One patch all of whose parameter lines are circular arcs: of a Dupin cyclide, by four corners on one circle and a perpendicular frame at one of
/// them, or a general one, by any four corners and the directions of two sides, or over four given arcs. A general patch whose lines turn out to be
/// lines of curvature is one of a Dupin cyclide; the others have no exact offset, and are rational faces.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.area() - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["frame"], "properties": { "directions": false, "twist": false, "arcs": false } },
    { "required": ["directions"], "properties": { "frame": false, "frame_corner": false, "arcs": false } },
    { "required": ["arcs"], "properties": { "frame": false, "frame_corner": false, "directions": false, "twist": false } }
]))]
#[non_exhaustive]
pub struct CyclidePatchSpec {
    /// The word `cyclide-patch`.
    #[schemars(with = "String", extend("const" = "cyclide-patch"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The corners at (s, t) = (0, 0), (1, 0), (0, 1), (1, 1). With a frame they lie on one circle, in the order first, second, fourth, third;
    /// otherwise anywhere.
    pub corners: [Coordinates; 4],
    /// Directions of the edges of increasing s and increasing t at one corner: perpendicular, of any length.
    pub frame: Option<[Coordinates; 2]>,
    /// Number of the corner at which the frame is given, from 0. Default: the first.
    #[schemars(range(min = 0, max = 3))]
    pub frame_corner: Option<u32>,
    /// Directions of the edges of increasing s and increasing t at the first corner: at any angle, of any length. With them the corners need not
    /// lie on one circle.
    pub directions: Option<[Coordinates; 2]>,
    /// How the corner opposite to the first is turned, with `directions`. Default: the twist of the patch of a Dupin cyclide wherever there is one.
    pub twist: Option<TwistSpec>,
    /// Directions in which the four sides start: from the first corner to the second, from the first to the third, from the second to the fourth,
    /// from the third to the fourth. Most four arcs bound no patch of circles; they are refused with the angle by which they miss.
    pub arcs: Option<[Coordinates; 4]>,
}

/// How the corner opposite to the first is turned: a number, or a vector.
///
/// ```no_run
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1, 1]], "directions": [[1, 0, 0.2], [0, 1, 0]], "twist": 0.3}}}"#.parse()?;
/// assert!(document.build()?[0].bodies[0].outer.area() > 2.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Twist")]
#[non_exhaustive]
pub enum TwistSpec {
    /// Any number, independent of the unit of length.
    Number(f64),
    /// A vector of which the free part is taken, where corners and directions lie on one sphere or plane or a side is a single point; a twist
    /// of 1 is a vector of length 1.
    Vector(Coordinates),
}

forms! {
    TwistSpec: "a number, or a vector `[x, y, z]`";
    number f64 => TwistSpec::Number;
    list Coordinates => TwistSpec::Vector;
}

impl Kind for CyclidePatchSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.patch(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        let directions = if self.arcs.is_some() { "arcs" } else { "directions" };
        vec![("", "corners"), ("tangents", directions)]
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        match (error, self.frame) {
            (cyclide::Error::Patch(PatchError::FrameNotOrthonormal { .. }), Some(frame)) => {
                let has_zero = frame.iter().any(|v| v.vector().unit().is_none());
                let way_out = if has_zero { "" } else { "; `directions` in place of `frame` may have any angle" };
                Some(format!("{}{way_out}", frame_words(frame)))
            }
            (cyclide::Error::Patch(PatchError::NotConcircular { .. }), Some(_)) => {
                Some(format!("{error}; with `directions` in place of `frame` they may lie anywhere"))
            }
            (cyclide::Error::Patch(PatchError::CrossingQuad { .. }), Some(_)) => Some(format!(
                "{error}; corners are listed row by row, (0,0), (1,0), (0,1), (1,1): are the last two swapped?"
            )),
            (cyclide::Error::Patch(PatchError::TwistNotUnique), _) => Some(format!("{error}: `\"twist\": [x, y, z]`")),
            _ => None,
        }
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }
}

impl Builder<'_> {
    /// The patch.
    pub(in crate::document) fn patch(&self, spec: &CyclidePatchSpec) -> Result<Vec<SurfaceObject>> {
        let corners = spec.corners.map(Coordinates::point);
        let general = match (spec.frame, spec.directions, spec.arcs) {
            (Some(frame), None, None) if spec.twist.is_none() => {
                let [v1, v2] = frame.map(direction);
                let corner = spec.frame_corner.unwrap_or(0) as usize;
                let patch = CyclidePatch::from_corners_and_frame_at(corners, corner, v1, v2);
                return patch.map(|patch| vec![SurfaceObject::Patch(patch)]).map_err(|e| self.refused(&e, None));
            }
            (None, Some(directions), None) if spec.frame_corner.is_none() => {
                let twist = match spec.twist {
                    None => CornerTwist::Default,
                    Some(TwistSpec::Number(twist)) => CornerTwist::Twist(twist),
                    Some(TwistSpec::Vector(corner)) => CornerTwist::Corner(corner.vector()),
                };
                QbPatch::from_directions(corners, directions.map(direction), twist)
            }
            (None, None, Some(arcs)) if spec.twist.is_none() && spec.frame_corner.is_none() => {
                QbPatch::from_arcs(corners, arcs.map(direction))
            }
            _ => {
                return Err(self.unfit(
                    "a patch requires `corners` and one of `frame` (and optionally `frame_corner`), `directions` (and optionally `twist`) and `arcs`",
                ));
            }
        };
        let made = general.and_then(|patch| surface_of(&patch));
        made.map(|surface| vec![surface]).map_err(|e| self.refused(&e, None))
    }
}

/// The patch of a Dupin cyclide that it is, or its exact rational faces.
fn surface_of(patch: &QbPatch) -> cyclide::Result<SurfaceObject> {
    if patch.recognize() == QbPatchKind::Dupin {
        let [v1, v2] = [patch.s_direction(0.0), patch.t_direction(0.0)];
        return CyclidePatch::from_corners_and_frame(patch.corners(), v1, v2).map(SurfaceObject::Patch);
    }
    Ok(SurfaceObject::Body(Body { outer: patch.to_shell()?, voids: Vec::new() }))
}
