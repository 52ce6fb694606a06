//! Surfaces, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::coordinates::Coordinates;

/// One principal patch of a Dupin cyclide: four corners on one circle and a frame at one of them. All its parameter
/// lines are circular arcs.
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
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The corners at (s, t) = (0, 0), (1, 0), (0, 1), (1, 1). Round their circle they follow each other as the
    /// first, second, fourth, third.
    pub corners: [Coordinates; 4],
    /// Directions of the two edges at one corner, of growing s and growing t: perpendicular, of any length.
    pub frame: [Coordinates; 2],
    /// The corner at which the frame is given, from 0. Default: the first.
    #[serde(default)]
    #[schemars(range(min = 0, max = 3))]
    pub frame_corner: u32,
}
