//! Arcs between two curves.

use cyclide::{ShortNumber, Vec3, construct::RailSurface, error::PointError, model::SurfaceObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::{Coordinates, Directions};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, rails};
use crate::error::Result;

/// Arcs between two curves. They connect points at equal parameters, piece by piece, and leave the first curve in given
/// directions.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "polyline", "points": [[0, 0], [5, 0]]}, "b": {"type": "polyline", "points": [[0, 2], [5, 2]]}, "s": {"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 1]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 5.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CircularSurfaceSpec {
    /// The word `circular-surface`.
    #[schemars(with = "String", extend("const" = "circular-surface"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Names of the two curves, which may be construction geometry. Each has one contour, and both have the same number
    /// of pieces; a whole circle is divided like the other closed curve.
    pub rails: [String; 2],
    /// Direction in which the arcs leave the first curve: one for all, or a list with one for each joint between its
    /// pieces and for its ends, linear in between.
    pub tangent: Directions,
}

impl Kind for CircularSurfaceSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.circular_surface(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        rails(&self.rails)
    }

    fn fields(&self) -> FieldNames {
        let mut fields = main_field("rails");
        // One direction is that of all points.
        fields.push(if self.tangent.0.len() > 1 { ("tangents", "tangent") } else { ("tangents[]", "tangent") });
        fields
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::Point(PointError::CoincidentPoints { distance, limit, .. }) = error else { return None };
        Some(format!(
            "the curves meet or come within {} of each other, but an arc requires points more than {} apart",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}

impl Builder<'_> {
    /// Arcs between two curves.
    pub(in crate::document) fn circular_surface(&mut self, spec: &CircularSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let tangents: Vec<Vec3> = spec.tangent.0.iter().copied().map(Coordinates::vector).collect();
        self.between_rails(|rails, closed| RailSurface::circular(rails, &tangents, closed))
    }
}
