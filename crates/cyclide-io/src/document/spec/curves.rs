//! Curves, field by field.

use cyclide::{BiarcRule, BlendVariant, Effort, FitTarget, Outliers};
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use super::radii::RadiiSpec;
use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, Lists, PointSource};

/// A circular arc or straight segment: through three points, or from one point to another with one more datum
/// (`tangent`, `end_tangent`, `weights` or `bulge`).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "arc", "through": [[1, 0], [0, 1], [-1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    {
        "required": ["through"],
        "properties": {
            "from": false, "to": false, "tangent": false, "end_tangent": false, "weights": false, "bulge": false
        }
    },
    { "required": ["from", "to", "tangent"], "properties": { "through": false } },
    { "required": ["from", "to", "end_tangent"], "properties": { "through": false } },
    { "required": ["from", "to", "weights"], "properties": { "through": false } },
    { "required": ["from", "to", "bulge"], "properties": { "through": false } }
], "dependentRequired" = { "normal": ["bulge"] }))]
#[non_exhaustive]
pub struct ArcSpec {
    /// The word `arc`.
    #[schemars(with = "String", extend("const" = "arc"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Start, a point between, end.
    pub through: Option<[Coordinates; 3]>,
    /// Start.
    pub from: Option<Coordinates>,
    /// End.
    pub to: Option<Coordinates>,
    /// Direction of travel at the start, of any length.
    pub tangent: Option<Coordinates>,
    /// Direction of travel at the end, of any length.
    pub end_tangent: Option<Coordinates>,
    /// Quaternion weights `[w, x, y, z]` of start and end; only their ratio matters, and its vector part must be
    /// perpendicular to the chord.
    pub weights: Option<[[f64; 4]; 2]>,
    /// DXF bulge, the tangent of a quarter of the swept angle: positive turns counter-clockwise about `normal`, 0 is
    /// the straight segment.
    pub bulge: Option<f64>,
    /// Axis about which a positive bulge turns counter-clockwise. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
}

/// A full circle: by its centre and radius, or through three points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
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
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Three points of the circle: it starts at the first and runs through the second to the third.
    pub through: Option<[Coordinates; 3]>,
    /// Centre.
    pub center: Option<Coordinates>,
    /// Axis about which the circle runs counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
    /// Radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
}

/// Two arcs from one point and direction to another, tangent-continuous at their joint.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"b": {"type": "biarc", "from": [0, 0], "from_tangent": [1, 0], "to": [2, 1], "to_tangent": [1, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves()[0].as_curve().piece_count(), 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct BiarcSpec {
    /// The word `biarc`.
    #[schemars(with = "String", extend("const" = "biarc"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Start.
    pub from: Coordinates,
    /// Direction of travel at the start, of any length.
    pub from_tangent: Coordinates,
    /// End.
    pub to: Coordinates,
    /// Direction of travel at the end, of any length.
    pub to_tangent: Coordinates,
    /// How the joint is chosen.
    #[serde(default)]
    pub rule: BiarcRule,
}

/// Arcs through points: a biarc from each point to the next, tangent-continuous everywhere.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "arc-spline", "points": [[0, 0], [1, 1], [2, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let curve = built[0].item.curves()[0].as_curve();
/// assert!(cyclide::joints(curve).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcSplineSpec {
    /// The word `arc-spline`.
    #[schemars(with = "String", extend("const" = "arc-spline"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: PointSource,
    /// Directions of travel, one per point, of any length. Default: estimated from the circle through each point and
    /// its neighbours.
    pub tangents: Option<Lists>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// How the joint between two points is chosen.
    #[serde(default)]
    pub rule: BiarcRule,
}

/// Segments through points, with corners that arcs round.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - (16.0 + std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolylineSpec {
    /// The word `polyline`.
    #[schemars(with = "String", extend("const" = "polyline"))]
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
    /// Radius of the arcs that round the corners, or a list of one per point. Default 0: the corners are sharp.
    #[serde(default)]
    pub radius: RadiiSpec,
}

/// The fewest arcs and segments within a tolerance, tangent-continuous except at corners.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "arc-fit", "tolerance": 0.1, "points": [[1, 0], [0.92, 0.38], [0.71, 0.71], [0.38, 0.92], [0, 1], [-0.38, 0.92], [-0.71, 0.71]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves()[0].as_curve().piece_count(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("oneOf" = [{"required": ["points"]}, {"required": ["of"]}]),
    extend("if" = {"required": ["of"]}),
    extend("then" = {"properties": {"closed": false, "target": false}})
)]
pub struct ArcFitSpec {
    /// The word `arc-fit`.
    #[schemars(with = "String", extend("const" = "arc-fit"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points.
    pub points: Option<PointSource>,
    /// Name of a curve of any kind, in place of points; it may be construction geometry. The arcs are within the tolerance of it, both ways.
    pub of: Option<String>,
    /// The last point joins the first.
    #[serde(default)]
    pub closed: bool,
    /// Largest distance between the arcs and the target.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: f64,
    /// What the points are.
    #[serde(default)]
    pub target: FitTarget,
    /// How hard to search for fewer arcs.
    #[serde(default)]
    pub effort: Effort,
    /// Turns of the points above this angle are kept as corners. Default: those above pi/6 that no samples of a smooth
    /// curve explain.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
    /// Least radius of an arc; what cannot keep it is refused. Default: any.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub min_radius: Option<f64>,
    /// Least length of an arc (lines may be shorter), for machines that reject short arcs; what cannot keep it is refused. Default: any.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub min_arc_length: Option<f64>,
}

/// The fairest smooth curve within a tolerance of points, with few nodes and continuous curvature: for dense or noisy
/// data.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "fair-fit", "tolerance": 0.2, "points": [[0, 0], [1, 0.1], [2, 0], [3, 0.1], [4, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let Some(cyclide_io::Fitted::Fair(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.deviation <= 0.2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FairFitSpec {
    /// The word `fair-fit`.
    #[schemars(with = "String", extend("const" = "fair-fit"))]
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
    /// `"auto"`: the curve follows the points as closely as their noise asks, whose standard deviation is estimated from them;
    /// this is right for measured points. A number: largest distance of a point from the curve, which is the fairest there.
    pub tolerance: FairTolerance,
    /// With the tolerance `"auto"`: the standard deviation of the noise across the curve. Default: estimated from the points.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub noise: Option<f64>,
    /// What becomes of outliers. With `keep`, the default, they are named and have little influence where the tolerance is
    /// `"auto"`.
    #[serde(default)]
    pub outliers: Outliers,
    /// A tolerance for the heights (z) alone, larger than `tolerance`; `"auto"` with the tolerance `"auto"`: by their own noise.
    pub tolerance_z: Option<FairTolerance>,
    /// With a number as tolerance: how much the curve keeps to the middle of the points. 0 (default): the fairest curve, which
    /// leans on the bounds of the tolerance and leaves out more than noise; 10 and more approach least squares. For noisy
    /// points use the tolerance `"auto"` instead.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e6))]
    pub centre: f64,
    /// An open curve starts and ends exactly at the first and last point.
    #[serde(default)]
    pub fix_ends: bool,
    /// Turns of the points above this angle that last over eight tolerances are kept as corners. Default: none are (a column `corner` of a file of points marks corners too).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
    /// Fits spent on taking nodes out; 0 keeps those of the first fit. Default: 16.
    pub max_fits: Option<u32>,
    /// Nodes of each smooth piece at which taking out stops. Default: as few as the budget allows.
    #[schemars(range(min = 2))]
    pub nodes: Option<u32>,
    /// The part of its fairness that the curve may lose for fewer nodes. Default: 0.1.
    #[schemars(range(min = 0, max = 1000))]
    pub budget: Option<f64>,
    /// Places on each edge between two points that the tolerance binds too. Default: 0, the points are samples of a
    /// smooth curve.
    #[serde(default)]
    #[schemars(range(min = 0, max = 100))]
    pub polyline: u32,
}

/// How closely a fair fit follows its points: a number, or the word `auto`.
///
/// ```
/// use cyclide_io::Document;
/// let points: Vec<String> = (0..60).map(|k| format!("[{k}, {}]", 0.02 * f64::from(k * k % 7))).collect();
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"f": {{"type": "fair-fit", "tolerance": "auto", "points": [{}]}}}}}}"#, points.join(","));
/// let built = text.parse::<Document>()?.build()?;
/// let Some(cyclide_io::Fitted::Fair(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.noise.is_some_and(|noise| noise > 0.02 && noise < 0.06));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged)]
#[non_exhaustive]
pub enum FairTolerance {
    /// Largest distance of a point from the curve.
    Within(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// As the noise of the points asks.
    Auto(AutoWord),
}

impl FairTolerance {
    /// The word.
    pub const AUTO: Self = Self::Auto(AutoWord::Auto);

    /// The number, if it is one.
    #[must_use]
    pub fn within(self) -> Option<f64> {
        match self {
            Self::Within(tolerance) => Some(tolerance),
            Self::Auto(_) => None,
        }
    }
}

/// The word `auto`.
///
/// ```
/// assert_eq!(cyclide_io::FairTolerance::AUTO.within(), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AutoWord {
    /// As the noise of the points asks.
    #[default]
    Auto,
}

impl<'de> Deserialize<'de> for FairTolerance {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ToleranceVisitor;
        impl serde::de::Visitor<'_> for ToleranceVisitor {
            type Value = FairTolerance;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number or \"auto\"")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<FairTolerance, E> {
                AutoWord::deserialize(serde::de::value::StrDeserializer::new(text)).map(FairTolerance::Auto)
            }
            fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<FairTolerance, E> {
                Ok(FairTolerance::Within(value))
            }
            fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<FairTolerance, E> {
                Ok(FairTolerance::Within(value as f64))
            }
            fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<FairTolerance, E> {
                Ok(FairTolerance::Within(value as f64))
            }
        }
        deserializer.deserialize_any(ToleranceVisitor)
    }
}

/// A smooth curve through points: neighbouring circles blended into each other.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - 2.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleSplineSpec {
    /// The word `circle-spline`.
    #[schemars(with = "String", extend("const" = "circle-spline"))]
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
    /// Blend order: joints are continuous of this order (2: no jump of curvature).
    #[serde(default = "default_order")]
    #[schemars(range(min = 1, max = 4))]
    pub order: u32,
    /// How the circles are blended.
    #[serde(default)]
    pub variant: BlendVariant,
    /// What happens at the ends of an open curve.
    #[serde(default)]
    pub ends: EndsSpec,
    /// Turns of the points above this angle are kept as corners. Default: none are (a column `corner` of a file of
    /// points marks corners too).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
}

/// The default blend order.
pub(super) const fn default_order() -> u32 {
    2
}

/// The ends of an open circle spline: `natural`, or given directions.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "ends": {"start": [0, 3]}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "Ends")]
#[non_exhaustive]
pub enum EndsSpec {
    /// The end segments are arcs.
    #[default]
    #[schemars(with = "NaturalWord")]
    Natural,
    /// Directions of travel at the ends.
    Clamped(ClampedEnds),
}

/// The word for ends without given directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum NaturalWord {
    /// The end segments are arcs.
    #[serde(rename = "natural")]
    Natural,
}

/// Directions of travel at the ends of an open curve; an end that is left out is natural.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "ends": {"start": [0, 3], "end": [0, -1]}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClampedEnds {
    /// Direction at the first point, of any length.
    pub start: Option<Coordinates>,
    /// Direction at the last point, of any length.
    pub end: Option<Coordinates>,
}

impl<'de> Deserialize<'de> for EndsSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct EndsVisitor;
        impl<'de> serde::de::Visitor<'de> for EndsVisitor {
            type Value = EndsSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"natural\" or {\"start\": [x, y], \"end\": [x, y]}")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<EndsSpec, E> {
                let word = serde::de::value::StrDeserializer::new(word);
                NaturalWord::deserialize(word).map(|_| EndsSpec::Natural)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<EndsSpec, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                ClampedEnds::deserialize(map).map(EndsSpec::Clamped)
            }
        }
        deserializer.deserialize_any(EndsVisitor)
    }
}
