//! The surface of the centres of the balls between two pipes.

use cyclide::{Body, CrossingError, Shell, SurfaceObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Reference, Shape, of};
use crate::error::Result;

/// The surface of the centres of all balls that touch the two pipes of a crossing, round the way of those that make its blend: an exact patch of degree (2, 2).
///
/// The balls are of any radius. Between pipes that overlap some have a negative radius, which is that of a ball inside both pipes that touches
/// them from within. The surface is mapped by a `transform` of its own.
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
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `pipe-crossing`, outside or inside both pipes; it may be construction geometry.
    pub of: String,
    /// How much more than the path of the centers it shows: the part of what is left to the balls without end, from 0 to below 1. Default 0.25.
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
    /// The surface of all centres.
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
