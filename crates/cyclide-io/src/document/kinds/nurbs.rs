//! A rational B-spline curve.

use cyclide::{
    Point3, ShortNumber, error::NumberError, model::CurveObject, rational::NurbsCurve, warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape, main_field};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// A rational B-spline curve (NURBS), given by its degree, knots, control points and weights.
///
/// It is for curves from other programs, in the form in which STEP, Rhino, Blender and SciPy store them. What `-o
/// FILE.json` writes of any curve can be used in a `nurbs` again.
///
/// OpenNURBS (Rhino) omits the first and the last knot: repeat them. Ends that are not clamped (`degree + 1` equal
/// knots), as of periodic curves, are clamped by exact knot insertion: the curve is the part from knot number `degree`
/// to that number from the end, where all control points contribute. The warning `knots-clamped` then gives the number
/// of control points.
///
/// From an end of a span weights may grow by a factor of 1e9 with each step (`weights-uneven`). Weights that grow by
/// more than a factor of 30 from one to the next over a whole span are evened out: the points are the same, the
/// parameter is another.
///
/// A `transform` maps the curve exactly by similarities, and by inversions and any other Möbius map. The latter double
/// the degree, to at most 25 (a curve of degree 13 or more is rejected with `parameter-out-of-range`), in as many
/// pieces as positive weights require. A curve that passes through the center of an inversion is rejected
/// (`point-at-infinity`).
///
/// STEP and JSON contain it exactly, cut where it has kinks. JSON has the knots and weights given. So does STEP, unless
/// all inner knots have full multiplicity and the joints are C1 (as of circles): then the degree in STEP is higher by 3
/// and the knots are C1, since CAD programs take the continuity from the knots. DXF and SVG contain arcs within the
/// tolerance; DXF with `--dxf-splines` contains the curve itself.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "nurbs", "degree": 2, "knots": [0, 0, 0, 1, 1, 1],
///     "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 0.7071067811865476, 1]}}}"#.parse()?;
/// let built = document.build()?;
/// let quarter = cyclide::curve::length(built[0].item.curves()[0].as_curve());
/// assert!((quarter - 0.5 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NurbsSpec {
    /// The word `nurbs`.
    #[schemars(with = "String", extend("const" = "nurbs"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Degree of the polynomials; the order is one more.
    #[schemars(range(min = 1, max = 25))]
    pub degree: u32,
    /// Knots with their repetitions, never decreasing (`knots-decrease`); their number is that of the control points
    /// plus the degree plus 1. Inner knots are repeated at most `degree` times, those at the ends once more
    /// (`knot-multiplicity`).
    #[schemars(length(min = 4))]
    pub knots: Vec<f64>,
    /// Control points, at least `degree + 1`. The curve is closed if the last one equals the first.
    #[schemars(length(min = 2))]
    pub control_points: Vec<Coordinates>,
    /// Weights of the control points, all positive (`weight-not-positive`); control points are Cartesian, not
    /// multiplied by them. Default: 1, a polynomial spline.
    pub weights: Option<Vec<f64>>,
}

impl Kind for NurbsSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let curve = at.nurbs(self)?;
        at.warn_of_wavers("control_points", &curve);
        at.warn_of_cusps("control_points", None, curve.as_curve());
        Ok(curve.into())
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::ControlPoints, WaverRemedy::Source))
    }

    fn fields(&self) -> FieldNames {
        main_field("control_points")
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        knots_words(error)
    }
}

impl Builder<'_> {
    /// The curve, its ends clamped.
    pub(in crate::document) fn nurbs(&mut self, spec: &NurbsSpec) -> Result<CurveObject> {
        let points: Vec<Point3> = spec.control_points.iter().copied().map(Coordinates::point).collect();
        let weights = spec.weights.clone().unwrap_or_else(|| vec![1.0; points.len()]);
        let curve = NurbsCurve::with_even_weights(spec.degree as usize, spec.knots.clone(), points, weights)
            .map_err(|e| self.refused(&e, None))?;
        if !are_clamped(spec) {
            let (from, to) = curve.domain();
            let message = format!(
                "the knots are not clamped: the curve from {} to {} is used, clamped by exact knot insertion ({} control points)",
                ShortNumber(from),
                ShortNumber(to),
                curve.control_points().len()
            );
            let place = self.place_of([Step::from("knots")]);
            self.remark("knots-clamped", None, None, place, message);
        }
        Ok(curve.into())
    }
}

/// True if the knots at both ends are there once more than the degree: such a curve is kept as it is.
fn are_clamped(spec: &NurbsSpec) -> bool {
    let (knots, degree) = (&spec.knots, spec.degree as usize);
    let is_one = |run: &[f64]| run.iter().all(|knot| *knot <= run[0]);
    is_one(&knots[..=degree]) && is_one(&knots[knots.len() - degree - 1..])
}

/// What helps where the count of knots does not fit.
pub(in crate::document) fn knots_words(error: &cyclide::Error) -> Option<String> {
    let is_count = matches!(
        error,
        cyclide::Error::Number(NumberError::CountDiffers { what: cyclide::error::ErrorItem::Knot, .. })
    );
    is_count.then(|| {
        format!(
            "{error}: the number of knots is that of the control points + degree + 1 (if a program omits the first and the last knot, repeat them)"
        )
    })
}
