//! A closed quartic of one type on a torus.

use cyclide::{
    Error as E, Point2,
    error::{ErrorItem as I, NumberError},
    model::CurveObject,
    surface::{CircleFamily, QuarticType, TorusSpline},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::torus_source::{TorusSource, place};
use crate::document::kinds::torus_circle::FamilySpec;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape};
use crate::error::{Error, Result};

/// A closed quartic on a torus, of one of six types: it runs once around two families of circles at the same time.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "torus-quartic", "torus": {"major_radius": 40, "minor_radius": 15}, "families": ["parallel", "meridian"], "ratio": 3}}}"#.parse()?;
/// let built = document.build()?;
/// let curve = built[0].item.curves()[0].as_curve();
/// // From the outer side of the tube, and back to it.
/// assert!(curve.is_closed() && (curve.point(0.0).to_vec().length() - 55.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorusQuarticSpec {
    /// The word `torus-quartic`.
    #[schemars(with = "String", extend("const" = "torus-quartic"))]
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
    /// Two different families of circles, which determine the type.
    pub families: [FamilySpec; 2],
    /// Speed along the second family at the start, relative to that along the first; negative values run backwards. Its
    /// size is from 1/32 to 32; halfway around the curve the ratio is the inverse.
    pub ratio: f64,
    /// Longitude and meridian angle of its start. Default `[0, 0]`.
    pub start: Option<[Angle; 2]>,
}

impl Kind for TorusQuarticSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::TorusSpline(at.torus_quartic(self)?).into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn fields(&self) -> FieldNames {
        vec![("angle[]", "start"), ("turns", "ratio")]
    }
}

impl Builder<'_> {
    /// A closed quartic of one type.
    pub(in crate::document) fn torus_quartic(&self, spec: &TorusQuarticSpec) -> Result<TorusSpline> {
        let torus = self.torus(&spec.torus)?;
        let [one, other] = spec.families.map(CircleFamily::from);
        let Some(kind) = QuarticType::between(one, other) else {
            let message = "a quartic requires two different families of circles";
            return Err(Error::Input(self.diagnostic([Step::from("families")], message)));
        };
        // The type has its families in their order: the ratio is that of the second one given.
        let ratio = if kind.families() == [one, other] { spec.ratio } else { 1.0 / spec.ratio };
        let start = spec.start.map_or(Point2::default(), |start| place(&torus, start));
        TorusSpline::closed_quartic(&torus, kind, start, ratio).map_err(|e| match e {
            // The range is that of its reciprocal too: said of what was typed.
            E::Number(NumberError::ParameterOutOfRange { name: I::Ratio, min, max, .. }) => self.refused(
                &E::Number(NumberError::ParameterOutOfRange { name: I::Ratio, value: spec.ratio, min, max }),
                None,
            ),
            other => self.refused(&other, None),
        })
    }
}
