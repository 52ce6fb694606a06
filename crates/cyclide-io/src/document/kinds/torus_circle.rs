//! A circle on a torus.

use cyclide::{
    Point2,
    curve::Circle,
    model::CurveObject,
    surface::{CircleFamily, Torus, TorusSpline},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::torus_source::{NEAR, TorusSource, place};
use crate::document::objects::Builder;
use crate::document::objects::contours::ContourFacts;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape};
use crate::error::Result;

/// A circle on a torus through a given point.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 40, "minor_radius": 15}, "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// // Villarceau circles are as large as the middle of the tube.
/// let length = cyclide::curve::length(built[0].item.curves()[0].as_curve());
/// assert!((length - 80.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["through"], "properties": { "at": false } },
    { "required": ["at"], "properties": { "through": false, "tolerance": false } }
]))]
#[non_exhaustive]
pub struct TorusCircleSpec {
    /// The word `torus-circle`.
    #[schemars(with = "String", extend("const" = "torus-circle"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The torus on which the curve lies: given here, or the name of a `cyclide` that is a torus (`c` = 0) or of a
    /// `transform` that moves, turns, scales or mirrors one.
    pub torus: TorusSource,
    /// Which of the four circles through the point.
    #[serde(default)]
    pub family: FamilySpec,
    /// The point, on or near the torus.
    pub through: Option<Coordinates>,
    /// Longitude and meridian angle of the point.
    pub at: Option<[Angle; 2]>,
    /// Largest distance of the point from the torus. Default: a millionth of its major radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// A family of circles on a torus.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "torus-circle", "torus": {"major_radius": 40, "minor_radius": 15}, "family": "meridian", "at": [0, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// let length = cyclide::curve::length(built[0].item.curves()[0].as_curve());
/// assert!((length - 30.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum FamilySpec {
    /// Villarceau circles along which longitude and meridian angle increase together.
    #[default]
    Villarceau,
    /// Villarceau circles along which the meridian angle decreases as the longitude increases.
    MirrorVillarceau,
    /// Circles around the axis.
    Parallel,
    /// Circles around the tube.
    Meridian,
}

impl From<FamilySpec> for CircleFamily {
    fn from(family: FamilySpec) -> Self {
        match family {
            FamilySpec::Villarceau => Self::Villarceau,
            FamilySpec::MirrorVillarceau => Self::MirrorVillarceau,
            FamilySpec::Parallel => Self::Parallel,
            FamilySpec::Meridian => Self::Meridian,
        }
    }
}

impl Kind for TorusCircleSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.torus_circle(self).map(|made| Shape::Curves(vec![made]))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn circle_of_torus(&self, at: &Builder<'_>) -> Option<Result<TorusSpline>> {
        let spline = at.torus(&self.torus).and_then(|torus| {
            let (place, _) = at.place_of_circle(self, &torus)?;
            TorusSpline::circle(&torus, self.family.into(), place).map_err(|e| at.refused(&e, None))
        });
        Some(spline)
    }

    fn fields(&self) -> FieldNames {
        let place = if self.at.is_some() { "at" } else { "through" };
        vec![("[]", place), ("angle[]", place)]
    }
}

impl Builder<'_> {
    /// The place that a circle runs through, and how far its point was moved.
    pub(in crate::document) fn place_of_circle(&self, spec: &TorusCircleSpec, torus: &Torus) -> Result<(Point2, f64)> {
        match (spec.through, spec.at) {
            (Some(through), None) => {
                let tolerance = spec.tolerance.unwrap_or(NEAR * torus.major_radius());
                let at = torus.locate(through.point(), tolerance).map_err(|e| self.refused(&e, None))?;
                Ok((at, torus.distance(through.point()).abs()))
            }
            (None, Some(at)) if spec.tolerance.is_none() => Ok((place(torus, at), 0.0)),
            (None, Some(_)) => Err(self.unfit("`tolerance` requires `through`: angles are always on the torus")),
            _ => Err(self.unfit("a circle of a torus requires a point: `through` or `at`")),
        }
    }

    /// A circle on a torus.
    pub(in crate::document) fn torus_circle(&mut self, spec: &TorusCircleSpec) -> Result<(CurveObject, ContourFacts)> {
        let torus = self.torus(&spec.torus)?;
        let (at, moved) = self.place_of_circle(spec, &torus)?;
        let circle: Circle = torus.circle(spec.family.into(), at).map_err(|e| self.refused(&e, None))?;
        self.warn_of_move(moved, &torus, "through");
        Ok((CurveObject::Circle(circle), ContourFacts::default()))
    }
}
