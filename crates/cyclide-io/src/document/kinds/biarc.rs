//! Two arcs between two points with given directions.

use cyclide::{
    construct::{Biarc, BiarcRule},
    model::CurveObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// Two arcs from one point and direction to another, tangent-continuous at their joint.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"b": {"type": "biarc", "from": [0, 0], "from_tangent": [1, 0], "to": [2, 1], "to_tangent": [1, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves()[0].as_curve().piece_count(), 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct BiarcSpec {
    /// The word `biarc`.
    #[schemars(with = "String", extend("const" = "biarc"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Start.
    pub from: Coordinates,
    /// Direction of travel at the start, of any length.
    pub from_tangent: Coordinates,
    /// End.
    pub to: Coordinates,
    /// Direction of travel at the end, of any length.
    pub to_tangent: Coordinates,
    /// How the joint is chosen.
    #[serde(default)]
    pub rule: BiarcRule,
}

impl Kind for BiarcSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let (t0, t1) = (self.from_tangent.vector(), self.to_tangent.vector());
        let biarc = Biarc::new(self.from.point(), t0, self.to.point(), t1, self.rule);
        Ok(CurveObject::ArcPath(biarc.map_err(|e| at.refused(&e, None))?.to_path()).into())
    }

    fn fields(&self) -> FieldNames {
        vec![("tangents[0]", "from_tangent"), ("tangents[1]", "to_tangent")]
    }
}
