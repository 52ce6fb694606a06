//! The steps of a `transform`, one map each.

use cyclide::{Quat, Vec3, conformal::Mobius};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// One map, or one cut or reversal of curves. Full circles, curves on tori, fair and circle splines, surfaces with rational
/// faces and surfaces over triangles accept similarities only.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"translation": [1, 0, 0]}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[1].item.curves()[0].as_curve()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Step")]
#[non_exhaustive]
pub enum StepSpec {
    /// Inversion in a sphere.
    Inversion(SphereSpec),
    /// Translation by a vector.
    Translation(Coordinates),
    /// Rotation about an axis.
    Rotation(RotationSpec),
    /// Scaling.
    Scale(ScaleSpec),
    /// Reflection in a plane.
    Mirror(PlaneSpec),
    /// The map `x -> (A x + B)(C x + E)^-1` with quaternions `[w, x, y, z]`, rows `[A, B]`, `[C, E]`.
    Matrix([[[f64; 4]; 2]; 2]),
    /// The Möbius map that takes three points to three points.
    Map(MapSpec),
    /// Reverses curves: the word alone, `"reverse"`. A closed curve keeps its start.
    Reverse,
    /// The part of curves between two positions. On a closed curve the second may come before the first: the part then
    /// crosses the start.
    Cut(CutSpec),
}

/// The positions between which a curve is cut, in one of two measures.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": ["reverse", {"cut": {"parameters": [0.5, 0.25]}}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[1].item.curves()[0].as_curve()) - 3.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Cut")]
#[non_exhaustive]
pub enum CutSpec {
    /// Parameters from 0 to 1, of which each smooth piece of the curve has an equal share (`cyclide sample` shows
    /// them).
    Parameters([f64; 2]),
    /// Lengths along the curve from its start.
    Stations([f64; 2]),
}

/// The sphere of an inversion.
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
    /// Center.
    pub center: Coordinates,
    /// Radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// A rotation.
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
    /// Angle of the rotation.
    pub angle: Angle,
    /// A point on the axis. Default: the origin.
    pub center: Option<Coordinates>,
}

/// A change of size.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}, "t": {"type": "transform", "of": "c", "steps": [{"scale": {"factor": 3}}]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[1].item.curves()[0].as_curve()) - 12.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = "an object with a `factor`, as in {\"factor\": 2}")]
#[non_exhaustive]
pub struct ScaleSpec {
    /// Factor for all lengths.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub factor: f64,
    /// The fixed point. Default: the origin.
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
    /// A point on the plane. Default: the origin.
    pub origin: Option<Coordinates>,
}

/// Three points and their images.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "arc", "through": [[1, 0], [0, 1], [-1, 0]]}, "t": {"type": "transform", "of": "a", "steps": [{"map": {"from": [[1, 0], [0, 1], [-1, 0]], "to": [[2, 0], [0, 3, 1], [0, 0, 5]]}}]}}}"#.parse()?;
/// let built = document.build()?;
/// let end = built[1].item.curves()[0].as_curve().point(1.0);
/// assert!((end.z - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct MapSpec {
    /// Three different points.
    pub from: [Coordinates; 3],
    /// Their images, different too. A circle through the points goes to the circle through the images.
    pub to: [Coordinates; 3],
    /// Turn about the circle of the images. Default 0: the plane of the points goes to the plane of the images, side to side.
    pub turn: Option<Angle>,
    /// Normal of the plane of `from`, needed where these are on a line.
    pub up_from: Option<Coordinates>,
    /// Normal of the plane of `to`, needed where these are on a line.
    pub up_to: Option<Coordinates>,
}

/// The map of one step; what is no map moves nothing.
pub(in crate::document) fn map_of(step: &StepSpec) -> cyclide::Result<Mobius> {
    let origin = |given: Option<Coordinates>| given.unwrap_or_default().point();
    match step {
        StepSpec::Inversion(s) => Mobius::inversion(s.center.point(), s.radius),
        StepSpec::Translation(v) => Mobius::translation(v.vector()),
        StepSpec::Rotation(s) => {
            Mobius::rotation(origin(s.center), s.axis.map_or(Vec3::Z, Coordinates::vector), s.angle.turn())
        }
        StepSpec::Scale(s) => {
            let center = origin(s.center).to_vec();
            Mobius::similarity(Quat::ONE, s.factor, center * (1.0 - s.factor))
        }
        StepSpec::Mirror(s) => Mobius::reflection(origin(s.origin), s.normal.vector()),
        StepSpec::Matrix(rows) => {
            let [[a, b], [c, e]] = rows.map(|row| row.map(|[w, x, y, z]| Quat::new(w, x, y, z)));
            Mobius::from_matrix(a, b, c, e)
        }
        StepSpec::Map(s) => {
            let turn = s.turn.map_or(0.0, |angle| angle.turn());
            let normals = [s.up_from, s.up_to].map(|up| up.map(Coordinates::vector));
            Mobius::from_three_points(s.from.map(Coordinates::point), s.to.map(Coordinates::point), turn, normals)
        }
        StepSpec::Reverse | StepSpec::Cut(_) => Mobius::translation(Vec3::ZERO),
    }
}
