//! A circular arc or straight segment.

use cyclide::{Quat, Vec3, curve::Arc, error::ArcError, model::CurveObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// What an arc of a document must leave of a full turn at least, radians: a bulge of a million. The kernel makes arcs up to
/// ten times that, whose places are rounded by a hundredth of their chord.
const FULL_CIRCLE_LIMIT: f64 = 3.9e-6;

/// Weights of an arc whose lengths differ by more than this factor are evened: files and their checks go by the parameter,
/// whose numbers cannot tell the points near the end of such an arc apart.
const EVEN_RATIO: f64 = 1e3;

/// A circular arc or straight segment: through three points, or between two points with one more item (`tangent`,
/// `end_tangent`, `weights` or `bulge`).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "arc", "through": [[1, 0], [0, 1], [-1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - std::f64::consts::PI).abs() < 1e-12);
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
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Start, intermediate point and end.
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
    /// perpendicular to the chord. If their lengths differ by more than a factor of 1000 the parameter is evened out;
    /// the points stay the same.
    pub weights: Option<[[f64; 4]; 2]>,
    /// DXF bulge, the tangent of a quarter of the swept angle: positive turns counter-clockwise about `normal`, 0 is a
    /// straight segment. At most a million (`nearly-full-circle`).
    pub bulge: Option<f64>,
    /// Axis about which a positive bulge turns counter-clockwise. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
}

impl Kind for ArcSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::Arc(at.arc(self)?).into())
    }

    fn fields(&self) -> FieldNames {
        let tangent = if self.tangent.is_some() { "tangent" } else { "end_tangent" };
        let mut fields = vec![("tangents[]", tangent)];
        if self.bulge.is_some() {
            fields.push(("weights[]", "bulge"));
        }
        fields
    }
}

impl Builder<'_> {
    /// The arc.
    pub(in crate::document) fn arc(&self, spec: &ArcSpec) -> Result<Arc> {
        let ArcSpec { through, from, to, tangent, end_tangent, weights, bulge, normal, .. } = *spec;
        if normal.is_some() && bulge.is_none() {
            return Err(self.unfit("`normal` requires `bulge`"));
        }
        let [from, to] = [from, to].map(|end| end.map(Coordinates::point));
        let arc = match (through, from, to, tangent, end_tangent, weights, bulge) {
            (Some(three), None, None, None, None, None, None) => {
                let [a, b, c] = three.map(Coordinates::point);
                Arc::from_three_points(a, b, c)
            }
            (None, Some(a), Some(b), Some(t), None, None, None) => Arc::from_start_tangent(a, b, t.vector()),
            (None, Some(a), Some(b), None, Some(t), None, None) => Arc::from_end_tangent(a, b, t.vector()),
            (None, Some(a), Some(b), None, None, Some([start, end]), None) => {
                Arc::from_weights(a, b, Quat::from(start), Quat::from(end))
            }
            (None, Some(a), Some(b), None, None, None, Some(bulge)) => {
                Arc::from_bulge(a, b, normal.map_or(Vec3::Z, Coordinates::vector), bulge)
            }
            _ => {
                return Err(self.unfit(
                    "an arc requires `through` (three points), or `from` and `to` with exactly one of `tangent`, `end_tangent`, `weights`, `bulge`",
                ));
            }
        };
        // Nearer to a full circle no file can be promised to a ten thousandth of the chord.
        let kept = |arc: Arc| {
            let rest = std::f64::consts::TAU - arc.angle();
            let limit = FULL_CIRCLE_LIMIT;
            if rest < limit { Err(ArcError::NearlyFullCircle { rest, limit }.into()) } else { Ok(arc) }
        };
        let even = |arc: Arc| {
            let ratio = arc.weight_ratio().norm();
            if (EVEN_RATIO.recip()..=EVEN_RATIO).contains(&ratio) { arc } else { arc.evened() }
        };
        let arc = arc.map(even).and_then(kept).map_err(|error| match error {
            cyclide::Error::Arc(ArcError::NearlyFullCircle { rest, .. }) => {
                cyclide::Error::Arc(ArcError::NearlyFullCircle { rest, limit: FULL_CIRCLE_LIMIT })
            }
            other => other,
        });
        arc.map_err(|e| self.refused(&e, None))
    }
}
