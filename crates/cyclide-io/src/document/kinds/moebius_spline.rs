//! A local smooth curve through points, of a kind that Möbius maps preserve.

use cyclide::{
    Vec3,
    construct::MoebiusSplineOptions,
    curve::{CircleSpline, CircleSplineOptions, QbSpline},
    error::{ErrorItem, NumberError, NurbsError},
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::parameters::{ParametersSpec, given_count, node_parameters};
use crate::document::kinds::fields::torus_numbers::FreeOr;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made, corners};
use crate::document::objects::idle::{Idle, NO_CORNER, found, has_no_corner};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// A local smooth curve through points, of a kind that Möbius maps (including inversions) preserve. Points on a circle,
/// at any distances, give that circle.
///
/// A span depends on four points, and the curve is rational of degree 4. A `transform` by an inversion gives the Möbius
/// spline of the mapped points with the same `knots`: as a list or `uniform`, since chords change under inversions, and
/// with them the knots derived from chords. This holds as long as the inversion does not make a span take the long way
/// round. Otherwise the image is exact too, but it is not the spline of the mapped points.
///
/// The curvature jumps at its points; where that is visible, use a `fair-spline`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "moebius-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - 2.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MoebiusSplineSpec {
    /// The word `moebius-spline`.
    #[schemars(with = "String", extend("const" = "moebius-spline"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
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
    /// What is continuous at the points in addition to the curve itself.
    #[serde(default)]
    pub continuity: MoebiusContinuity,
    /// For `c1`: the parameters at which the curve passes through its points. A list increases, and has one more number
    /// for a closed curve. Default `auto`.
    #[serde(default)]
    pub knots: ParametersSpec,
    /// For `c1`: derivatives with respect to the knots, one per point, or the word `free` for that of the circle.
    /// Default: those of the circles everywhere.
    pub tangents: Option<Vec<FreeOr<Coordinates>>>,
    /// Points that turn by more than this angle are kept as corners. Default: none (a column `corner` of a file of
    /// points also marks corners).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
}

/// What is continuous at the points of a Möbius spline.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "moebius-spline", "continuity": "g1", "points": [[0, 0], [1, 2], [3, 2], [5, 0]]}}}"#.parse()?;
/// assert_eq!(document.build()?[0].provenance.kind, "moebius-spline");
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MoebiusContinuity {
    /// The derivative with respect to the knots, which is that of the circle through each point and its neighbors.
    #[default]
    C1,
    /// Only the direction, which is that of these circles: no knots are needed, and the curve is the circle spline of
    /// order 1. Its images under inversions are exact, though not the splines of the mapped points.
    G1,
}

impl Kind for MoebiusSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| moebius_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_moebius_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Nodes, WaverRemedy::FairSpline))
    }

    fn fields(&self) -> FieldNames {
        vec![("parameters", "knots")]
    }
}

pub(in crate::document) fn moebius_spline(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> Made {
    let (points, closed) = (&at.list.points, spec.closed);
    let corners = corners(at, closed, spec.corner_angle)?;
    let spline = match spec.continuity {
        MoebiusContinuity::G1 => {
            let circles = CircleSpline::from_points(
                points,
                &CircleSplineOptions { closed, order: 1, corners, ..Default::default() },
            )?;
            circles.check_finite()?;
            let no_spline = cyclide::Error::Nurbs(NurbsError::NotASpline {
                detail: "a circle spline of order 1 is one of quaternion pairs",
            });
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

pub(in crate::document) fn in_moebius_spline(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    let by_directions = spec.continuity == MoebiusContinuity::G1;
    let no_knots = "with `g1` the curve has no knots";
    found(&[
        ("knots", by_directions && spec.knots != ParametersSpec::default(), no_knots),
        (
            "tangents",
            by_directions && spec.tangents.is_some(),
            "with `g1` the curve uses the directions of its circles",
        ),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}

fn tangents(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> cyclide::Result<Vec<Option<Vec3>>> {
    let Some(given) = &spec.tangents else { return Ok(Vec::new()) };
    let needed = given_count(at);
    if given.len() != needed {
        return Err(NumberError::CountDiffers { what: ErrorItem::Tangent, given: given.len(), needed }.into());
    }
    Ok(at.kept.iter().filter_map(|&i| given.get(i)).map(|FreeOr(t)| t.map(Coordinates::vector)).collect())
}
