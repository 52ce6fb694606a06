//! Objects made from other objects, field by field.

use cyclide::PipeEnds;
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// A parallel surface of another object, exact, or the solid between both; of a curve on a torus the parallel curve along the normal of the torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}, "o": {"type": "offset", "of": "r", "distance": 0.5}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.area() - 18.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct OffsetSpec {
    /// The word `offset`.
    #[schemars(with = "String", extend("const" = "offset"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the surface, or of a `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`.
    pub of: String,
    /// Distance along the normal; negative to the other side. The normal of a whole cyclide is outward, that of other
    /// surfaces along `f_s x f_t`. An offset keeps the normal of its surface, so that distances add up: beyond a focal
    /// set it is against its own `f_s x f_t`, and the report lists the patch as flipped.
    pub distance: f64,
    /// Make the solid between the surface and its parallel surface, with a rim along free edges.
    #[serde(default)]
    pub thick: bool,
}

/// The image of another object under a chain of maps; a curve may be run backwards and cut between them.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"scale": {"factor": 3}}, {"translation": [1, 0, 0]}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[1].item.curves()[0].as_curve()) - 12.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TransformSpec {
    /// The word `transform`.
    #[schemars(with = "String", extend("const" = "transform"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the object.
    pub of: String,
    /// The maps, and what else is done to curves, the first one first.
    #[schemars(length(min = 1))]
    pub steps: Vec<StepSpec>,
}

/// One map, or one cut or turn-round of curves. Inversions and matrices keep arcs and surfaces; full circles and circle splines take the other
/// maps only.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"translation": [1, 0, 0]}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[1].item.curves()[0].as_curve()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Step")]
#[non_exhaustive]
pub enum StepSpec {
    /// Inversion in a sphere.
    Inversion(SphereSpec),
    /// Shift by a vector.
    Translation(Coordinates),
    /// Turn about an axis.
    Rotation(RotationSpec),
    /// Enlarge or shrink.
    Scale(ScaleSpec),
    /// Reflection in a plane.
    Mirror(PlaneSpec),
    /// The map `x -> (A x + B)(C x + E)^-1` with quaternions `[w, x, y, z]`, rows `[A, B]`, `[C, E]`.
    Matrix([[[f64; 4]; 2]; 2]),
    /// Curves run backwards: the word alone, `"reverse"`. A closed curve starts at the same point.
    Reverse,
    /// The part of curves between two places. Of a closed curve the second may come before the first: then the part leads past the start.
    Cut(CutSpec),
}

/// Between which places a curve is cut, in one of two measures.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": ["reverse", {"cut": {"parameters": [0.5, 0.25]}}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[1].item.curves()[0].as_curve()) - 3.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Cut")]
#[non_exhaustive]
pub enum CutSpec {
    /// Parameters from 0 to 1, of which each smooth piece of the curve has an equal share (`cyclide sample` shows them).
    Parameters([f64; 2]),
    /// Lengths along the curve from its start.
    Stations([f64; 2]),
}

/// What a curve sweeps when it turns about an axis.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [3, 0], "radius": 1}, "r": {"type": "revolution", "of": "c", "axis": [0, 1, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.volume() - 6.0 * std::f64::consts::PI.powi(2)).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RevolutionSpec {
    /// The word `revolution`.
    #[schemars(with = "String", extend("const" = "revolution"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve, which may be construction geometry. It may meet the axis with its ends only; closed, or with both
    /// ends on the axis, it gives a solid.
    pub of: String,
    /// Axis about which a positive angle turns counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// A point of the axis. Default: the origin.
    pub center: Option<Coordinates>,
    /// The angle. Default: a whole turn.
    pub angle: Option<Angle>,
}

/// The tube of a radius about a curve of arcs and segments.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"l": {"type": "polyline", "points": [[0, 0], [10, 0]]}, "p": {"type": "pipe", "of": "l", "radius": 1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[1].bodies[0].outer.volume() - 10.0 * std::f64::consts::PI).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PipeSpec {
    /// The word `pipe`.
    #[schemars(with = "String", extend("const" = "pipe"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve, which may be construction geometry.
    pub of: String,
    /// Radius of the outer side.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Thickness of the wall about a bore. Default: no bore.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How it ends, if the curve is open.
    #[serde(default)]
    pub ends: PipeEnds,
    /// Distance within which arcs replace a curve that is not made of arcs and segments. Default: such a curve is refused.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// A sphere to invert in.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "arc", "through": [[1, 0], [1.5, 0.5], [2, 0]]}, "t": {"type": "transform", "of": "a", "steps": [{"inversion": {"center": [0, 0], "radius": 1}}]}}}"#.parse()?;
/// let built = document.build()?;
/// let end = built[1].item.curves()[0].as_curve().point(1.0);
/// assert!((end.x.abs() - 0.5).abs() < 1e-12 || (end.x.abs() - 1.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SphereSpec {
    /// Centre.
    pub center: Coordinates,
    /// Radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// A turn.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"rotation": {"axis": [1, 0, 0], "angle": {"degrees": 90}}}]}}}"#.parse()?;
/// let built = document.build()?;
/// let p = built[1].item.curves()[0].as_curve().point(0.25);
/// assert!(p.y.abs() < 1e-12 && (p.z.abs() - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RotationSpec {
    /// Axis about which a positive angle turns counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// The angle.
    pub angle: Angle,
    /// A point of the axis. Default: the origin.
    pub center: Option<Coordinates>,
}

/// A change of size.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"scale": {"factor": 3}}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[1].item.curves()[0].as_curve()) - 12.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = "an object with a `factor`, as in {\"factor\": 2}")]
#[non_exhaustive]
pub struct ScaleSpec {
    /// Factor of all lengths.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub factor: f64,
    /// The point that stays. Default: the origin.
    pub center: Option<Coordinates>,
}

/// A plane to reflect in.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"translation": [5, 0, 0]}, {"mirror": {"normal": [1, 0, 0]}}]}}}"#.parse()?;
/// let built = document.build()?;
/// let p = built[1].item.curves()[0].as_curve().point(0.0);
/// assert!(p.x < -2.9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PlaneSpec {
    /// Normal of the plane, of any length.
    pub normal: Coordinates,
    /// A point of the plane. Default: the origin.
    pub origin: Option<Coordinates>,
}

/// The edges of another surface as arcs: what carries a skin.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}, "e": {"type": "support-structure", "of": "p"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[1].item.curves()[0].as_curve()) - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SupportStructureSpec {
    /// The word `support-structure`.
    #[schemars(with = "String", extend("const" = "support-structure"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the surface.
    pub of: String,
}
