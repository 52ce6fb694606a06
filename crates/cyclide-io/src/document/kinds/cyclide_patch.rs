//! One patch of a Dupin cyclide, bounded by four circular arcs.

use cyclide::{error::PatchError, model::SurfaceObject, surface::CyclidePatch};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::{direction, frame_words};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

/// One principal patch of a Dupin cyclide, given by four corners on one circle and a frame at one of them. All its
/// parameter lines are circular arcs.
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
    /// The corners at (s, t) = (0, 0), (1, 0), (0, 1), (1, 1). Their order around the circle is first, second, fourth,
    /// third.
    pub corners: [Coordinates; 4],
    /// Directions of the edges of increasing s and increasing t at one corner: perpendicular, of any length.
    pub frame: [Coordinates; 2],
    /// Number of the corner at which the frame is given, from 0. Default: the first.
    #[serde(default)]
    #[schemars(range(min = 0, max = 3))]
    pub frame_corner: u32,
}

impl Kind for CyclidePatchSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.patch(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        vec![("", "corners")]
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        match error {
            cyclide::Error::Patch(PatchError::FrameNotOrthonormal { .. }) => Some(frame_words(self.frame)),
            cyclide::Error::Patch(PatchError::CrossingQuad { .. }) => Some(format!(
                "{error}; corners are listed row by row, (0,0), (1,0), (0,1), (1,1): are the last two swapped?"
            )),
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
        let [v1, v2] = spec.frame.map(direction);
        let corners = spec.corners.map(Coordinates::point);
        let patch = CyclidePatch::from_corners_and_frame_at(corners, spec.frame_corner as usize, v1, v2);
        patch.map(|patch| vec![SurfaceObject::Patch(patch)]).map_err(|e| self.refused(&e, None))
    }
}
