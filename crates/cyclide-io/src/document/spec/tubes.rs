//! Tubes of changing radius, field by field.

use cyclide::PipeEnds;
use schemars::JsonSchema;
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::fmt;

use super::TypeWord;
use super::comment::Comment;

/// The tube of changing radius along a curve (`of`, `radius`), or through balls (`balls`), solid or with a `wall`. Along a curve it has the circle of its radius
/// across each point, so that it begins and ends where the curve does; through balls it is their envelope.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"cone": {"type": "tube", "balls": [[0, 0, 0, 2], [10, 0, 0, 1]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("oneOf" = [{"required": ["of", "radius"]}, {"required": ["balls"]}]),
    extend("if" = {"required": ["balls"]}),
    extend("then" = {"properties": {"radius": false, "radius_of": false, "tolerance": false}}),
    extend("else" = {"properties": {"closed": false}})
)]
#[non_exhaustive]
pub struct TubeSpec {
    /// The word `tube`.
    #[schemars(with = "String", extend("const" = "tube"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the curve that it runs along, which may be construction geometry.
    pub of: Option<String>,
    /// The radius along the curve: one; a list of radii, evenly spaced over the length; a list of `{"at": 0.3, "radius": 2}`, at
    /// fractions of the length. Between values it goes smoothly and never beyond them.
    pub radius: Option<RadiusLawSpec>,
    /// What has the radius along a curve. Default `sections`.
    pub radius_of: Option<RadiusOf>,
    /// Balls `[x, y, z, radius]` that it touches all round, in their order. It is exact.
    #[schemars(length(min = 2))]
    pub balls: Option<Vec<[f64; 4]>>,
    /// Whether the tube through balls comes back to the first.
    pub closed: Option<bool>,
    /// Thickness of the wall about a bore: across the curve, so that the bore has the radius less the wall; along the normals of the envelope of balls.
    /// Default: no bore.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How it ends, if it is open. Round ends are parts of balls: of sections that which goes on with their slope, of balls the rest of them.
    #[serde(default)]
    pub ends: PipeEnds,
    /// Largest distance from the tube of the law along the curve; 0 is kept along segments, and along arcs where the radius stays. Default: a thousandth of the
    /// least radius; a hundred thousandth along arcs with a radius of sections.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// What has the radius of a tube along a curve.
///
/// ```
/// use cyclide_io::RadiusOf;
/// let word: RadiusOf = serde_json::from_str("\"balls\"")?;
/// assert_eq!((word, RadiusOf::default()), (RadiusOf::Balls, RadiusOf::Sections));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum RadiusOf {
    /// The circles in which planes across the curve cut the tube.
    #[default]
    Sections,
    /// Balls that roll along the curve: the tube is their envelope. Where the radius changes its circles lie beside their centres, and it does not end where the
    /// curve does.
    Balls,
}

/// The radius along a curve, as fractions of its length and radii there.
///
/// ```
/// use cyclide_io::RadiusLawSpec;
/// let law: RadiusLawSpec = serde_json::from_str("[2, 3, 2]")?;
/// assert_eq!(law.values, [[0.0, 2.0], [0.5, 3.0], [1.0, 2.0]]);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RadiusLawSpec {
    /// Fractions of the length, and radii.
    pub values: Vec<[f64; 2]>,
}

/// The radius at a place.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "RadiusAt")]
struct RadiusAt {
    /// Fraction of the length.
    #[schemars(range(min = 0, max = 1))]
    at: f64,
    /// The radius there.
    #[schemars(extend("exclusiveMinimum" = 0))]
    radius: f64,
}

/// An entry of a list.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a radius, or an object such as {\"at\": 0.3, \"radius\": 2}")]
#[schemars(inline)]
enum Entry {
    Radius(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    At(RadiusAt),
}

/// The radius along a curve: one, a list of evenly spaced ones, or a list of `{"at": 0.3, "radius": 2}`.
#[derive(JsonSchema)]
#[schemars(untagged, rename = "RadiusLaw")]
#[expect(dead_code, reason = "it stands for the schema")]
enum Form {
    /// One radius.
    One(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// Radii, evenly spaced.
    Even(#[schemars(length(min = 1))] Vec<f64>),
    /// Radii at fractions of the length, which increase.
    At(#[schemars(length(min = 1))] Vec<RadiusAt>),
}

impl JsonSchema for RadiusLawSpec {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        Form::schema_name()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Form::json_schema(generator)
    }
}

impl<'de> Deserialize<'de> for RadiusLawSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LawVisitor)
    }
}

struct LawVisitor;

impl<'de> Visitor<'de> for LawVisitor {
    type Value = RadiusLawSpec;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a radius, a list of radii, or a list of entries such as `{\"at\": 0.3, \"radius\": 2}`")
    }

    fn visit_f64<E>(self, radius: f64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius]] })
    }

    fn visit_u64<E>(self, radius: u64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius as f64]] })
    }

    fn visit_i64<E>(self, radius: i64) -> Result<RadiusLawSpec, E> {
        Ok(RadiusLawSpec { values: vec![[0.0, radius as f64]] })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<RadiusLawSpec, A::Error> {
        let (mut even, mut at) = (Vec::new(), Vec::new());
        while let Some(entry) = list.next_element::<Entry>()? {
            match entry {
                Entry::Radius(radius) => even.push(radius),
                Entry::At(RadiusAt { at: place, radius }) => at.push([place, radius]),
            }
        }
        if !even.is_empty() && !at.is_empty() {
            return Err(serde::de::Error::custom("radii are either evenly spaced or all have their place `at`"));
        }
        let steps = even.len().saturating_sub(1).max(1) as f64;
        let spaced = even.into_iter().enumerate().map(|(k, radius)| [k as f64 / steps, radius]);
        Ok(RadiusLawSpec { values: if at.is_empty() { spaced.collect() } else { at } })
    }
}
