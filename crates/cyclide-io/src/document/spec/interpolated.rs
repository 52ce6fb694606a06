//! Quotients of quaternion polynomials through points, and Möbius splines.

use schemars::JsonSchema;
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::fmt;

use super::comment::Comment;
use super::{FreeOr, TypeWord};
use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, PointSource};

/// The rational curve of lowest degree of its kind through an odd number of points: the quotient of two quaternion polynomials, which
/// Möbius maps keep. Points on a circle, a sphere or a plane give a curve on it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "points": [[0, 0], [1, 2], [3, 2, 1], [5, 1, 1], [6, 0, 3]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].contours[0].interpolation.as_ref().map(|found| found.degree), Some(2));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QbInterpolationSpec {
    /// The word `qb-interpolation`.
    #[schemars(with = "String", extend("const" = "qb-interpolation"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points. They and all `derivatives` are an odd number together, `2n + 1` for a curve of degree `n`.
    pub points: PointSource,
    /// The parameters at which the curve meets its points.
    #[serde(default)]
    pub parameters: ParametersSpec,
    /// Derivatives by the parameter: for each point a list of the first, the second and so on, `[]` for none. Default: none at all.
    pub derivatives: Option<Vec<Vec<Coordinates>>>,
}

/// A local smooth curve through points that Möbius maps, inversions too, take to a curve of the same kind: points on a circle, at any
/// distances, give the circle.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "moebius-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - 2.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MoebiusSplineSpec {
    /// The word `moebius-spline`.
    #[schemars(with = "String", extend("const" = "moebius-spline"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: PointSource,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// What is continuous at the points besides the curve.
    #[serde(default)]
    pub continuity: MoebiusContinuity,
    /// Of `c1`: the parameters at which the curve passes its points. A list increases, and has one number more for a closed curve.
    #[serde(default)]
    pub knots: ParametersSpec,
    /// Of `c1`: derivatives by the knots, one per point, the word `free` for those of the circles. Default: those of the circles everywhere.
    pub tangents: Option<Vec<FreeOr<Coordinates>>>,
    /// Turns of the points above this angle are kept as corners. Default: none are (a column `corner` of a file of points marks
    /// corners too).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
}

/// What is continuous at the points of a Möbius spline.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "moebius-spline", "continuity": "g1", "points": [[0, 0], [1, 2], [3, 2], [5, 0]]}}}"#.parse()?;
/// assert_eq!(document.build()?[0].provenance.kind, "moebius-spline");
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MoebiusContinuity {
    /// The derivative by the knots, that of the circle through each point and its neighbours.
    #[default]
    C1,
    /// The direction only, by the directions of those circles alone: without knots, the circle spline of order 1.
    G1,
}

/// Parameters by a rule, or one by one.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "parameters": [0, 0.2, 1], "points": [[0, 0], [1, 1], [3, 0]]}}}"#.parse()?;
/// let curve = document.build()?;
/// assert!((curve[0].item.curves()[0].as_curve().point(0.2).x - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Parameters")]
pub enum ParametersSpec {
    /// By a rule.
    Rule(ParameterRule),
    /// These; of a `qb-interpolation` in `[0, 1]`, in any order.
    Each(Vec<f64>),
}

/// How parameters follow from points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "parameters": "uniform", "points": [[0, 0], [1, 1], [3, 0]]}}}"#.parse()?;
/// assert!((document.build()?[0].item.curves()[0].as_curve().point(0.5).x - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ParameterRule {
    /// As `chord`, of points in one plane as `centripetal`.
    #[default]
    Auto,
    /// By the distances of the points.
    Chord,
    /// By the square roots of their distances.
    Centripetal,
    /// Evenly.
    Uniform,
}

impl Default for ParametersSpec {
    fn default() -> Self {
        Self::Rule(ParameterRule::default())
    }
}

impl<'de> Deserialize<'de> for ParametersSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ParametersVisitor)
    }
}

struct ParametersVisitor;

impl<'de> Visitor<'de> for ParametersVisitor {
    type Value = ParametersSpec;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("`auto`, `chord`, `centripetal`, `uniform`, or a list of numbers")
    }

    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<ParametersSpec, E> {
        ParameterRule::deserialize(serde::de::value::StrDeserializer::new(word)).map(ParametersSpec::Rule)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<ParametersSpec, A::Error> {
        let mut all = Vec::new();
        while let Some(parameter) = list.next_element()? {
            all.push(parameter);
        }
        Ok(ParametersSpec::Each(all))
    }
}
