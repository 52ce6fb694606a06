//! Curves of quaternion pairs through lists of points, from the fields of a document to the kernel's options.

use cyclide::{
    CircleSpline, CircleSplineOptions, CurveObject, ErrorItem, MoebiusSplineOptions, NodeParameters, QbInterpolation,
    QbNode, QbSpline, Vec3,
};

use super::construct::{Contour, Made, corners};
use super::coordinates::Coordinates;
use super::spec::{FreeOr, MoebiusContinuity, MoebiusSplineSpec, ParameterRule, ParametersSpec, QbInterpolationSpec};

/// What is known of a curve of lowest degree through points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "points": [[0, 0], [1, 2], [3, 2], [5, 1], [6, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let found = built[0].contours[0].interpolation.as_ref().expect("by its type");
/// assert!(found.reach < 3.0 && found.parameters[4] == 1.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct InterpolationFacts {
    /// Degree of its quaternion polynomials; half of that of its rational form.
    pub degree: usize,
    /// The parameters of its points.
    pub parameters: Vec<f64>,
    /// Largest distance from the middle of the points, relative to theirs.
    pub reach: f64,
    /// The least that is left of the curve's weight at a point, of 1.
    pub attainability: f64,
}

pub(super) fn qb_interpolation(spec: &QbInterpolationSpec, at: &Contour<'_>) -> Made {
    let points = &at.list.points;
    // One point is a curve of degree 0, which goes nowhere.
    if points.len() < 3 && spec.derivatives.is_none() {
        return Err(cyclide::Error::TooFewPoints { given: points.len(), needed: 3 });
    }
    let parameters = node_parameters(&spec.parameters, at, 0);
    let found = match &spec.derivatives {
        None => QbInterpolation::through_points(points, &parameters)?,
        Some(given) => {
            let given: Vec<Vec<Vec3>> =
                at.kept.iter().filter_map(|&i| Some(vectors(given.get(i).filter(|_| at.index == 0)?))).collect();
            if given.len() != points.len() {
                let what = ErrorItem::Tangent;
                return Err(cyclide::Error::CountDiffers { what, given: given.len(), needed: points.len() });
            }
            // Points and derivatives are the conditions: a single one is a point, and no curve.
            let conditions = points.len() + given.iter().map(Vec::len).sum::<usize>();
            if conditions < 2 {
                return Err(cyclide::Error::TooFewPoints { given: conditions, needed: 3 });
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

pub(super) fn moebius_spline(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> Made {
    let (points, closed) = (&at.list.points, spec.closed);
    let corners = corners(at, closed, spec.corner_angle)?;
    let spline = match spec.continuity {
        MoebiusContinuity::G1 => {
            let circles = CircleSpline::from_points(
                points,
                &CircleSplineOptions { closed, order: 1, corners, ..Default::default() },
            )?;
            circles.check_finite()?;
            let no_spline =
                cyclide::Error::NotASpline { detail: "a circle spline of order 1 is one of quaternion pairs" };
            QbSpline::from_circle_spline(&circles).ok_or(no_spline)?
        }
        MoebiusContinuity::C1 => {
            let knots = node_parameters(&spec.knots, at, usize::from(closed));
            let tangents = tangents(spec, at)?;
            QbSpline::through_points(points, &MoebiusSplineOptions { closed, knots, corners, tangents })?
        }
    };
    let warnings = spline.warnings().to_vec();
    Ok((CurveObject::QbSpline(spline), at.facts(None), warnings))
}

/// Those given go with the points as given; `more` follow them.
fn node_parameters(spec: &ParametersSpec, at: &Contour<'_>, more: usize) -> NodeParameters {
    match spec {
        ParametersSpec::Rule(ParameterRule::Auto) => NodeParameters::Automatic,
        ParametersSpec::Rule(ParameterRule::Chord) => NodeParameters::Chord,
        ParametersSpec::Rule(ParameterRule::Centripetal) => NodeParameters::Centripetal,
        ParametersSpec::Rule(ParameterRule::Uniform) => NodeParameters::Uniform,
        ParametersSpec::Each(given) => {
            let points = given_count(at);
            if given.len() != points + more {
                return NodeParameters::Given(given.clone());
            }
            let own = at.kept.iter().filter_map(|&i| given.get(i)).copied();
            NodeParameters::Given(own.chain(given[points..].iter().copied()).collect())
        }
    }
}

/// Points of the list as given, up to the last one that was kept.
fn given_count(at: &Contour<'_>) -> usize {
    at.kept.last().map_or(0, |last| last + 1)
}

fn tangents(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> cyclide::Result<Vec<Option<Vec3>>> {
    let Some(given) = &spec.tangents else { return Ok(Vec::new()) };
    let needed = given_count(at);
    if given.len() != needed {
        return Err(cyclide::Error::CountDiffers { what: ErrorItem::Tangent, given: given.len(), needed });
    }
    Ok(at.kept.iter().filter_map(|&i| given.get(i)).map(|FreeOr(t)| t.map(Coordinates::vector)).collect())
}

fn vectors(list: &[Coordinates]) -> Vec<Vec3> {
    list.iter().map(|v| v.vector()).collect()
}
