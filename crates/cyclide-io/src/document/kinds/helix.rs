//! A helix.

use cyclide::{Point3, Vec3, construct::Helix, model::CurveObject};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::ellipse::TOLERANCE;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Shape};
use crate::error::{Error, Result};

/// A helix: a spring, a thread, a coil. Its rise is given by two of `pitch`, `height` and `turns`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"h": {"type": "helix", "radius": 10, "pitch": 5, "turns": 4}}}"#.parse()?;
/// let built = document.build()?;
/// let end = built[0].item.curves()[0].as_curve().point(1.0);
/// assert!(end.distance(cyclide::Point3::new(10.0, 0.0, 20.0)) < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct HelixSpec {
    /// The word `helix`.
    #[schemars(with = "String", extend("const" = "helix"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Point on the axis at the height of the start. Default: the origin.
    pub center: Option<Coordinates>,
    /// The axis, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction from the axis to the start. Default: `[1, 0, 0]`, projected perpendicular to the axis; `[0, 1, 0]` if
    /// that is the direction of the axis.
    pub x_direction: Option<Coordinates>,
    /// Distance from the axis.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Rise along the axis over one turn.
    pub pitch: Option<f64>,
    /// Total rise along the axis.
    pub height: Option<f64>,
    /// Number of turns, not necessarily whole.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub turns: Option<f64>,
    /// Handedness of the helix.
    #[serde(default)]
    pub hand: Hand,
    /// Largest distance of the curve from the helix, which is not rational. The distance is proved, and the curve lies
    /// exactly on the cylinder. Default: a millionth of the radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// The handedness of a helix.
///
/// ```
/// use cyclide_io::document::kinds::Hand;
/// assert_eq!(Hand::default(), Hand::Right);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Hand {
    /// Like a common screw: counter-clockwise seen from above.
    #[default]
    Right,
    /// Clockwise seen from above.
    Left,
}

impl Kind for HelixSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(at.helix(self)?.into())
    }
}

impl Builder<'_> {
    /// The rational curve that stands for a helix.
    pub(in crate::document) fn helix(&mut self, spec: &HelixSpec) -> Result<CurveObject> {
        let (pitch, turns) = match (spec.pitch, spec.height, spec.turns) {
            (Some(pitch), None, Some(turns)) => (pitch, turns),
            (None, Some(height), Some(turns)) => (height / turns, turns),
            (Some(pitch), Some(height), None) if pitch != 0.0 => (pitch, height / pitch),
            _ => return Err(self.unfit("a helix requires two of `pitch`, `height` and `turns`, and a nonzero pitch if the turns follow from it")),
        };
        if !(turns > 0.0 && turns.is_finite()) {
            let field = if spec.turns.is_some() { "turns" } else { "height" };
            let message = format!(
                "the number of turns is {turns}: it must be positive; left-handed helices have `\"hand\": \"left\"`"
            );
            return Err(Error::Input(self.diagnostic([field.into()], &message)));
        }
        let turns = if spec.hand == Hand::Left { -turns } else { turns };
        let center = spec.center.map_or(Point3::ORIGIN, Coordinates::point);
        let (axis, x) = (spec.axis.map_or(Vec3::Z, Coordinates::vector), spec.x_direction.map(Coordinates::vector));
        let helix = Helix::new(center, axis, x, spec.radius, pitch, turns);
        let helix = helix.map_err(|e| self.refused_conic("radius", "axis", &e))?;
        let tolerance = spec.tolerance.unwrap_or(TOLERANCE * spec.radius);
        let (curve, bound) = helix.to_nurbs(tolerance).map_err(|e| self.refused_at(["tolerance".into()], &e))?;
        // Far from the origin coordinates are rounded by more.
        self.bound = Some(tolerance.max(bound));
        Ok(CurveObject::Nurbs(curve))
    }
}
