//! The surface of the centers of all balls that touch two pipes.

use cyclide::{
    error::CrossingError,
    model::SurfaceObject,
    topology::{Body, Shell},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// The surface of the centers of all balls that touch both pipes of a crossing, around the path of the centers of its
/// blend: an exact patch of degree (2, 2).
///
/// The balls have any radius. Between overlapping pipes some radii are negative: such a ball is inside both pipes and
/// touches them from within. To map the surface, apply a `transform` to it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4},
///     "s": {"type": "center-surface", "of": "c", "margin": 0.5}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[1].bodies[0].outer.faces().len(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CenterSurfaceSpec {
    /// The word `center-surface`.
    #[schemars(with = "String", extend("const" = "center-surface"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `pipe-crossing`, with the ball outside or inside both pipes; it may be construction geometry.
    pub of: String,
    /// How far the surface extends beyond the path of the centers, as a fraction of the remaining range up to balls of
    /// infinite radius: from 0 to below 1. Default 0.25.
    #[serde(default = "quarter")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub margin: f64,
}

impl Kind for CenterSurfaceSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.center_surface(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}

impl Builder<'_> {
    /// The surface of all centers.
    pub(in crate::document) fn center_surface(&self, spec: &CenterSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let surface = self.centers_of_source()?.surface(spec.margin).map_err(|e| {
            let field =
                if matches!(e, cyclide::Error::Crossing(CrossingError::NoCenterSurface)) { "of" } else { "margin" };
            self.refused_at([Step::from(field)], &e)
        })?;
        let outer = Shell::from_surface(surface).map_err(|e| self.refused(&e, None))?;
        Ok(vec![SurfaceObject::Body(Body { outer, voids: Vec::new() })])
    }
}

fn quarter() -> f64 {
    0.25
}
