//! A curve that winds evenly around the axis and the tube of a torus.

use cyclide::{Point2, model::CurveObject, surface::TorusSpline};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::torus_source::{TorusSource, place};
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape};
use crate::error::Result;

/// A torus knot: the closed curve that winds evenly around the axis and around the tube of a torus.
///
/// It is the straight line of the `conformal` map of an `unrolled` curve, which crosses all parallels at the same
/// angle, to 4e-3 rad. It is not the curve whose meridian angle is linear in the longitude: on a torus with the radii
/// 40 and 15 the two are up to 0.4 rad apart.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [2, 3]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].item.curves()[0].as_curve().is_closed());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TorusKnotSpec {
    /// The word `torus-knot`.
    #[schemars(with = "String", extend("const" = "torus-knot"))]
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
    /// Turns around the axis and turns around the tube, without a common divisor (`not-coprime`); negative numbers
    /// reverse the direction.
    pub turns: [i32; 2],
    /// Longitude and meridian angle of its start. Default `[0, 0]`.
    pub start: Option<[Angle; 2]>,
}

impl Kind for TorusKnotSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::TorusSpline(at.torus_knot(self)?).into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn fields(&self) -> FieldNames {
        vec![("angle[]", "start"), ("winding[]", "turns")]
    }
}

impl Builder<'_> {
    /// A torus knot.
    pub(in crate::document) fn torus_knot(&self, spec: &TorusKnotSpec) -> Result<TorusSpline> {
        let torus = self.torus(&spec.torus)?;
        let start = spec.start.map_or(Point2::default(), |start| place(&torus, start));
        TorusSpline::knot(&torus, spec.turns, start).map_err(|e| self.refused(&e, None))
    }
}
