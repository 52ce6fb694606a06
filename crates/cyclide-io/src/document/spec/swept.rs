//! Surfaces of arcs and straight lines, field by field: necks, bridges, and what is spanned between two curves.

use cyclide::{NeckSide, NeckVariant};
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;
use crate::document::coordinates::Directions;

/// A pipe on a plate with a rounded neck between them, that of a ball rolling round the pipe; an open surface, or with a
/// `thickness` a solid. The upper side of the plate is the plane z = 0, the axis of the pipe meets it in the origin.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": [90, 90]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].outer.area() > 90.0 * 90.0 && !built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("dependentRequired" = {"wall": ["thickness"]}),
    extend("if" = {"properties": {"side": {"const": "inside"}}, "required": ["side"]}),
    extend("then" = {"properties": {"plate": false}}),
    extend("else" = {"required": ["plate"]})
)]
#[non_exhaustive]
pub struct PlateWithNeckSpec {
    /// The word `plate-with-neck`.
    #[schemars(with = "String", extend("const" = "plate-with-neck"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Radius of the pipe on the side of the ball: its outer radius, or with the side `inside` its inner one.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub pipe_radius: f64,
    /// Radius of the ball, which rounds the corner. Inside a pipe it is below that of the pipe.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub ball_radius: f64,
    /// Angle between the axis of the pipe and the normal of the plate; the pipe leans towards y. Default 0.
    pub slope: Option<Angle>,
    /// Distance of the end of the pipe from the plate, along the axis.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
    /// The plate round the axis. A pipe with a neck inside has none but its floor.
    pub plate: Option<PlateSpec>,
    /// Whether the ball rolls outside or inside the pipe.
    #[serde(default)]
    pub side: NeckSide,
    /// The arcs of the neck.
    #[serde(default)]
    pub variant: NeckVariant,
    /// Thickness of the plate, or of the floor inside a pipe, downwards: makes a solid.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: Option<f64>,
    /// Thickness of the wall of the pipe in a solid. Default: outside the pipe is filled, and with a wall it is bored through the
    /// plate; inside as thick as the floor.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
}

/// The border of a plate: the sides of a rectangle along x and y, or the radius of a disk.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": [90, 90]}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - bounds.min.x - 90.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Plate")]
#[non_exhaustive]
pub enum PlateSpec {
    /// Sides along x and y.
    #[schemars(extend("items" = {"type": "number", "exclusiveMinimum": 0}))]
    Rectangle([f64; 2]),
    /// A disk.
    Disk(DiskSpec),
}

/// A disk.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": {"radius": 40}}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - bounds.min.x - 80.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Disk")]
#[non_exhaustive]
pub struct DiskSpec {
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// Half circles, upright on the chords between two ellipses about the origin; tangent to the elliptic cylinders below both.
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
    /// What the author remarks; read and left aside.
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
    /// Half circles, or whole ones.
    #[serde(default)]
    pub arcs: BridgeArcs,
    /// Makes a solid: the elliptic cylinders go down to a base at z = -depth. One ellipse must be inside the other.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub depth: Option<f64>,
}

/// What stands on the chords between two ellipses.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"e": {"type": "ellipse-bridge", "ellipses": [[3, 3], [5, 5]], "arcs": "full"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.volume() - 8.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9); // a torus
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BridgeArcs {
    /// Half circles above the plane of the ellipses.
    #[default]
    Half,
    /// Whole circles: a solid ring.
    Full,
}

/// Arcs between two curves, from piece to piece at equal parameters, with given directions at the first curve.
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
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Names of the two curves, each of one contour and both of as many pieces; they may be construction geometry.
    pub rails: [String; 2],
    /// The direction in which the arcs leave the first curve: one for all, or a list with one for each point between its pieces and at its
    /// ends, linear in between.
    pub tangent: Directions,
}

/// Straight lines between two curves, from piece to piece at equal parameters.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "polyline", "points": [[0, 0], [5, 0]]}, "b": {"type": "polyline", "points": [[0, 2], [5, 2]]}, "s": {"type": "ruled", "rails": ["a", "b"]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 10.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RuledSpec {
    /// The word `ruled`.
    #[schemars(with = "String", extend("const" = "ruled"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Names of the two curves, each of one contour and both of as many pieces; they may be construction geometry.
    pub rails: [String; 2],
    /// Of closed curves: by how many of its pieces the second one starts later than it is drawn. Default 0.
    #[serde(default)]
    pub shift: usize,
}

impl<'de> Deserialize<'de> for PlateSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PlateVisitor;
        impl<'de> serde::de::Visitor<'de> for PlateVisitor {
            type Value = PlateSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("two sides `[80, 60]` or `{\"radius\": …}`")
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<PlateSpec, A::Error> {
                let seq = serde::de::value::SeqAccessDeserializer::new(seq);
                <[f64; 2]>::deserialize(seq).map(PlateSpec::Rectangle)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<PlateSpec, A::Error> {
                DiskSpec::deserialize(serde::de::value::MapAccessDeserializer::new(map)).map(PlateSpec::Disk)
            }
        }
        deserializer.deserialize_any(PlateVisitor)
    }
}
