//! Half circles between two ellipses.

use cyclide::{ShortNumber, construct::EllipseBridge, error::PointError, model::SurfaceObject};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape, main_field};
use crate::error::Result;

/// Half circles over the chords between two ellipses about the origin, in upright planes. The surface is tangent to the
/// elliptic cylinders below both ellipses.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"e": {"type": "ellipse-bridge", "ellipses": [[20, 34], [36, 42]], "depth": 6}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("if" = {"properties": {"arcs": {"const": "full"}}, "required": ["arcs"]}),
    extend("then" = {"properties": {"depth": false}})
)]
#[non_exhaustive]
pub struct EllipseBridgeSpec {
    /// The word `ellipse-bridge`.
    #[schemars(with = "String", extend("const" = "ellipse-bridge"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The semi-axes along x and y of the first ellipse, and those of the second.
    #[schemars(extend("items" = {
        "type": "array", "items": {"type": "number", "exclusiveMinimum": 0}, "minItems": 2, "maxItems": 2
    }))]
    pub ellipses: [[f64; 2]; 2],
    /// Half circles or whole circles.
    #[serde(default)]
    pub arcs: BridgeArcs,
    /// Makes a solid: the elliptic cylinders extend down to a base at z = -depth. One ellipse must be inside the other.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub depth: Option<f64>,
}

/// The arcs over the chords between two ellipses.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"e": {"type": "ellipse-bridge", "ellipses": [[3, 3], [5, 5]], "arcs": "full"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.volume() - 8.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9); // a torus
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BridgeArcs {
    /// Half circles above the plane of the ellipses.
    #[default]
    Half,
    /// Whole circles: a solid ring.
    Full,
}

impl Kind for EllipseBridgeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ellipse_bridge(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        main_field("ellipses")
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::Point(PointError::CoincidentPoints { distance, limit, .. }) = error else { return None };
        Some(format!(
            "the ellipses touch: their semi-axes in one direction differ by {}; the difference must exceed {}",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}

impl Builder<'_> {
    /// The bridge between two ellipses.
    pub(in crate::document) fn ellipse_bridge(&mut self, spec: &EllipseBridgeSpec) -> Result<Vec<SurfaceObject>> {
        let [first, second] = spec.ellipses;
        if spec.arcs == BridgeArcs::Full && spec.depth.is_some() {
            return Err(self.unfit("`depth` requires half circles: whole circles bound a solid by themselves"));
        }
        let bridge = EllipseBridge::new(first, second).map_err(|e| self.refused(&e, None))?;
        let body = match spec.arcs {
            BridgeArcs::Half => bridge.body(spec.depth),
            BridgeArcs::Full => bridge.whole_circles(),
        };
        let body = body.map_err(|e| self.refused(&e, None))?;
        for warning in bridge.warnings() {
            self.warn_at("ellipses", None, warning);
        }
        Ok(vec![SurfaceObject::Body(body)])
    }
}
