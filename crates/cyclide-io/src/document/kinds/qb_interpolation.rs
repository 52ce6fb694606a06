//! A rational curve of lowest degree through points.

use cyclide::{
    Vec3,
    construct::{QbInterpolation, QbNode},
    curve::QbSpline,
    error::{ErrorItem, NumberError, PointError},
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::parameters::{ParametersSpec, node_parameters, vectors};
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made};
use crate::document::objects::facts::InterpolationFacts;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// The rational curve of lowest degree of its kind through an odd number of points: the quotient of two quaternion
/// polynomials, a kind that Möbius maps preserve. Points on a circle, a sphere or a plane give a curve on it.
///
/// Through `2n + 1` points both polynomials have degree `n`, and the curve is rational of degree `2n`; the degree drops
/// to what the points require.
///
/// It is suitable for few points: above a dozen it swings. Above degree 12, which is more than 25 points and
/// derivatives, it is rejected (`degree-too-high`), unless all lie on a curve of a degree up to 12. It is also rejected
/// if it would pass through infinity, or if a point cannot be attained because the others lie on a curve of lower
/// degree that misses it (`unattainable-point`).
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
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The points. Together with all `derivatives` their number is odd, `2n + 1` for a curve of degree `n`.
    pub points: PointSource,
    /// The parameters at which the curve passes through its points, which influence its shape: a rule, or numbers from
    /// 0 to 1. Default `auto`.
    #[serde(default)]
    pub parameters: ParametersSpec,
    /// Derivatives with respect to the parameter: for each point a list of the first, the second and so on, `[]` for
    /// none. Default: none at all.
    pub derivatives: Option<Vec<Vec<Coordinates>>>,
}

impl Kind for QbInterpolationSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let made = at.each_contour(&self.points, false, |at| qb_interpolation(self, at))?;
        at.warn_of_cusps_in("points", &made);
        Ok(Shape::Curves(made))
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn keeps_repeated_points(&self) -> bool {
        true
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Points, WaverRemedy::FairSpline))
    }

    fn fields(&self) -> FieldNames {
        vec![("tangents[]", "derivatives")]
    }
}

pub(in crate::document) fn qb_interpolation(spec: &QbInterpolationSpec, at: &Contour<'_>) -> Made {
    let points = &at.list.points;
    // One point is a curve of degree 0, which goes nowhere.
    if points.len() < 3 && spec.derivatives.is_none() {
        return Err(PointError::TooFewPoints { given: points.len(), needed: 3 }.into());
    }
    let parameters = node_parameters(&spec.parameters, at, 0);
    let found = match &spec.derivatives {
        None => QbInterpolation::through_points(points, &parameters)?,
        Some(given) => {
            let given: Vec<Vec<Vec3>> =
                at.kept.iter().filter_map(|&i| Some(vectors(given.get(i).filter(|_| at.index == 0)?))).collect();
            if given.len() != points.len() {
                let what = ErrorItem::Tangent;
                return Err(NumberError::CountDiffers { what, given: given.len(), needed: points.len() }.into());
            }
            // Points and derivatives are the conditions: a single one is a point, and no curve.
            let conditions = points.len() + given.iter().map(Vec::len).sum::<usize>();
            if conditions < 2 {
                return Err(PointError::TooFewPoints { given: conditions, needed: 3 }.into());
            }
            let parameters = parameters.of(points)?;
            let node = |i: usize| QbNode { parameter: parameters[i], point: points[i], derivatives: given[i].clone() };
            QbInterpolation::through_nodes(&(0..points.len()).map(node).collect::<Vec<_>>())?
        }
    };
    let facts = InterpolationFacts {
        degree: found.curve().degree(),
        parameters: found.parameters().to_vec(),
        reach: found.reach(),
        attainability: found.attainability().iter().copied().fold(1.0, f64::min),
    };
    let spline = QbSpline::from_curve(found.curve().clone())?;
    let mut known = at.facts(None);
    known.interpolation = Some(facts);
    Ok((CurveObject::QbSpline(spline), known, found.warnings().to_vec()))
}
