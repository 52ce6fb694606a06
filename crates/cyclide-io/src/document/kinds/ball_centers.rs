//! The paths of the centers of the balls of blends.

use cyclide::{construct::BallCenters, model::CurveObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// The paths of the centers of the balls that make the blends of a tee, a crossing or a contact blend: closed, exact
/// rational curves.
///
/// A tee has one path for each branch. A ball-nose cutter with the radius of the ball follows such a path. The blended
/// object may be construction geometry. To map the paths, apply a `transform` to them.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4},
///     "m": {"type": "ball-centers", "of": "c"}}}"#.parse()?;
/// let built = document.build()?;
/// // As far from the axis of the first pipe as its radius and the ball's.
/// let m = built[1].item.curves()[0].as_curve().point(0.2);
/// assert!((m.y.hypot(m.z) - 14.0).abs() < 4e-3);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallCentersSpec {
    /// The word `ball-centers`.
    #[schemars(with = "String", extend("const" = "ball-centers"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `pipe-tee`, `pipe-crossing` or `contact-blend`; it may be construction geometry.
    pub of: String,
}

impl Kind for BallCentersSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ball_centers().map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}

impl Builder<'_> {
    /// Where the balls are that the source is made with.
    pub(in crate::document) fn centers_of_source(&self) -> Result<&BallCenters> {
        let source = self.sources.first().and_then(|source| source.facts.blends()?.centers.as_deref());
        source.ok_or_else(|| {
            self.wrong_source(
                "only a `pipe-tee`, a `pipe-crossing` and a `contact-blend` have balls (for a transformed one, use the centers of the original and transform them)",
            )
        })
    }

    /// The paths of the centers.
    pub(in crate::document) fn ball_centers(&self) -> Result<Vec<CurveObject>> {
        Ok(self.centers_of_source()?.paths().iter().cloned().map(CurveObject::Nurbs).collect())
    }
}
