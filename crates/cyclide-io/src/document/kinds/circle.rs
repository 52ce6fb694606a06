//! A full circle.

use cyclide::{Vec3, curve::Circle, model::CurveObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// A full circle: by its center and radius, or through three points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["center", "radius"], "properties": { "through": false } },
    { "required": ["through"], "properties": { "center": false, "radius": false, "normal": false } }
]))]
#[non_exhaustive]
pub struct CircleSpec {
    /// The word `circle`.
    #[schemars(with = "String", extend("const" = "circle"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Three points of the circle: it starts at the first and runs through the second to the third.
    pub through: Option<[Coordinates; 3]>,
    /// Center.
    pub center: Option<Coordinates>,
    /// Axis about which the circle runs counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
    /// Radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
}

impl Kind for CircleSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::Circle(at.circle(self)?).into())
    }

    fn fields(&self) -> FieldNames {
        vec![("", "through")]
    }
}

impl Builder<'_> {
    /// The circle.
    pub(in crate::document) fn circle(&self, spec: &CircleSpec) -> Result<Circle> {
        let circle = match (spec.through, spec.center, spec.radius) {
            (Some(points), None, None) if spec.normal.is_none() => {
                Circle::through_points(points.map(Coordinates::point))
            }
            (None, Some(center), Some(radius)) => {
                let normal = spec.normal.map_or(Vec3::Z, Coordinates::vector);
                Circle::from_radius(center.point(), normal, radius)
            }
            _ => {
                return Err(self.unfit(
                    "a circle requires either `center` and `radius` (and optionally `normal`) or only `through` (three points)",
                ));
            }
        };
        circle.map_err(|e| self.refused(&e, None))
    }
}
