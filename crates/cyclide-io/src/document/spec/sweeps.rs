//! Sections along a path, field by field.

use cyclide::SweepFrame;
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// A plane section led across a path: of closed contours a solid, with mitres at corners between segments. Exact along arcs and segments where the section does not turn
/// about the path.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "way": {"type": "polyline", "points": [[0, 0], [50, 0], [50, 30]], "construction": true},
///     "bar": {"type": "polyline", "points": [[-2, -3], [2, -3], [2, 3], [-2, 3]], "closed": true, "construction": true},
///     "rail": {"type": "sweep", "of": "way", "section": "bar"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.volume() - 24.0 * 80.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SweepSpec {
    /// The word `sweep`.
    #[schemars(with = "String", extend("const" = "sweep"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the path, which may be construction geometry.
    pub of: String,
    /// Name of the section, a curve in the plane z = 0: its origin runs on the path, x and y stay across it. Contours inside others are holes. It may be construction geometry.
    pub section: String,
    /// The section is drawn in space, across the path at its start, and is taken as it lies there. Default `false`.
    #[serde(default)]
    pub in_place: bool,
    /// How the section is turned about the path.
    #[serde(default)]
    pub frame: SweepFrame,
    /// Where the y axis of the section points at the start; with `"frame": "up"` everywhere, as far as the path allows. Default `[0, 0, 1]`; where the path starts along it, x of
    /// the section is x of space.
    pub up: Option<Coordinates>,
    /// Turn about the path over its length, right-handed; on a closed path whole turns.
    pub twist: Option<Angle>,
    /// How closed sections end on an open path.
    #[serde(default)]
    pub ends: SweepEnds,
    /// Largest distance of arcs from a path of another kind, and of points from the law of a turn. Default: a thousandth of the size of the section.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// How what a closed curve runs over ends.
///
/// ```
/// use cyclide_io::SweepEnds;
/// assert_eq!(SweepEnds::default(), SweepEnds::Flat);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum SweepEnds {
    /// Plane faces: a solid.
    #[default]
    Flat,
    /// None: the surface only.
    Open,
}
