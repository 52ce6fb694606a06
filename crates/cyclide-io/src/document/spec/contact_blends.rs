//! Tubes and rings blended with a sphere or a plate, field by field.

use cyclide::{NeckSide, TeeEnds};
use schemars::JsonSchema;
use serde::Deserialize;

use super::comment::Comment;
use super::{PlateSpec, TypeWord};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// A cylinder or a cone blended with a `sphere` about the origin, or with a `plate` whose upper side is z = 0, by a ball that rolls round it: a strut on a node, a nozzle on a
/// tank, a boss. Or a `ring`, a torus about the z axis, blended in the corner round it and in that of its hole. Inside, the ball rolls in the rim of a tube that ends there: a rod with a domed end or, with a `wall`, a dished head.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "tube": {"through": [0, 12], "radius": 10, "length": 90}, "sphere": 40, "blend": 6}}}"#.parse()?;
/// assert!(document.build()?[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("allOf" = [
        {"if": {"properties": {"ends": {"const": "open"}}, "required": ["ends"]}, "then": {"properties": {"wall": false, "thickness": false}}},
        {"oneOf": [{"required": ["tube"]}, {"required": ["ring"]}]},
        {"if": {"required": ["ring"]}, "then": {"properties": {"side": {"const": "outside"}, "ends": {"const": "flat"}, "wall": false, "tolerance": false, "plate": {"type": "object"}}}},
        {"if": {"required": ["sphere"]}, "then": {"properties": {"plate": false, "thickness": false}}},
        {"if": {"required": ["wall"]}, "then": {"properties": {"thickness": false}}},
        {"if": {"properties": {"side": {"const": "inside"}}, "required": ["side"]},
         "then": {"properties": {"plate": false, "thickness": false}},
         "else": {"anyOf": [{"required": ["sphere"]}, {"required": ["plate"]}]}}
    ])
)]
#[non_exhaustive]
pub struct ContactBlendSpec {
    /// The word `contact-blend`.
    #[schemars(with = "String", extend("const" = "contact-blend"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The tube; or instead a `ring`.
    pub tube: Option<BlendTubeSpec>,
    /// A torus about the z axis, on a sphere or a round plate. Its ball has exactly one radius.
    pub ring: Option<BlendRingSpec>,
    /// Radius of the sphere about the origin that it is blended with. Without it that is the plane z = 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub sphere: Option<f64>,
    /// The border of the plate about the origin, from which the tube goes up. With the side `inside` there is none: the tube ends at the plane.
    pub plate: Option<PlateSpec>,
    /// Thickness of the plate below a filled tube: makes a solid. With a `wall` the plate is as thick as that.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: Option<f64>,
    /// The radius of the ball.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub blend: f64,
    /// Whether the ball rolls outside or inside the tube.
    #[serde(default)]
    pub side: NeckSide,
    /// Largest difference from that one radius, which no rational blend with a sphere off the axis has exactly. Default: a thousandth of it.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Thickness of all walls: of the tube, the sphere or plate, and the blend between. Default: filled.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the tube ends. `open` leaves a surface, and goes without a wall.
    #[serde(default)]
    pub ends: TeeEnds,
}

/// A cylinder, or with a taper a cone.
///
/// ```
/// use cyclide_io::{Document, ObjectSpec};
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "tube": {"radius": 10, "taper": {"degrees": 5}, "length": 90}, "sphere": 40, "blend": 6}}}"#.parse()?;
/// let ObjectSpec::ContactBlend(spec) = &document.objects[0].1 else { panic!("it is one") };
/// let tube = spec.tube.as_ref().expect("it has one");
/// assert!(tube.radius == 10.0 && tube.direction.is_none());
/// assert!((tube.taper.expect("a cone").radians() - 5.0_f64.to_radians()).abs() < 1e-15);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "BlendTube")]
#[non_exhaustive]
pub struct BlendTubeSpec {
    /// A point of its axis. Default: the origin.
    #[serde(default)]
    pub through: Coordinates,
    /// Along its axis towards its end. Default: up, along z.
    pub direction: Option<Coordinates>,
    /// Its outer radius, of a cone that at the point.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Half the angle of the cone that it is: above zero it grows thinner towards its end, below wider. Default 0, a cylinder.
    pub taper: Option<Angle>,
    /// Where it ends: distance from the point along the axis.
    pub length: f64,
}

/// A torus about the z axis.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "ring": {"radius": 30, "tube": 8, "height": 5}, "plate": {"radius": 60}, "thickness": 4, "blend": 3}}}"#.parse()?;
/// let built = document.build()?;
/// // From below the plate to the top of the tube.
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.z - 13.0).abs() < 1e-9 && (bounds.min.z + 4.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "BlendRing")]
#[non_exhaustive]
pub struct BlendRingSpec {
    /// Radius of the circle in the middle of its tube.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Radius of its tube, less than that.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tube: f64,
    /// Height of that circle above the origin. Default 0.
    #[serde(default)]
    pub height: f64,
}
