//! A smooth curve through points, blended from circles.

use cyclide::{
    Point3,
    curve::{BlendVariant, CircleSpline, CircleSplineOptions, SplineEnds},
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, PointSource};
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made, corners};
use crate::document::objects::idle::{Idle, NO_CORNER, NO_ENDS, found, has_no_corner};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// A smooth curve through points: neighboring circles are blended into each other.
///
/// It depends only on four neighboring points at a time, so it wavers more than a `fair-spline`. With the orders 3 and
/// 4 the rate of change of the curvature is continuous too.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - 2.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleSplineSpec {
    /// The word `circle-spline`.
    #[schemars(with = "String", extend("const" = "circle-spline"))]
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
    /// Blend order: the joints are continuous of this order (2: the curvature is continuous).
    #[serde(default = "default_order")]
    #[schemars(range(min = 1, max = 4))]
    pub order: u32,
    /// How the circles are blended.
    #[serde(default)]
    pub variant: BlendVariant,
    /// What happens at the ends of an open curve. Default `natural`.
    #[serde(default)]
    pub ends: EndsSpec,
    /// Points that turn by more than this angle are kept as corners. Default: none (a column `corner` of a file of
    /// points also marks corners).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
}

/// The ends of an open circle spline: `natural`, or given directions.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "ends": {"start": [0, 3]}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "Ends")]
#[non_exhaustive]
pub enum EndsSpec {
    /// The end segments are arcs.
    #[default]
    #[schemars(with = "NaturalWord")]
    Natural,
    /// Directions of travel at the ends.
    Clamped(ClampedEnds),
}

/// The word for ends without given directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum NaturalWord {
    /// The end segments are arcs.
    #[serde(rename = "natural")]
    Natural,
}

/// Directions of travel at the ends of an open curve; an omitted end is natural.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "circle-spline", "ends": {"start": [0, 3], "end": [0, -1]}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClampedEnds {
    /// Direction at the first point, of any length.
    pub start: Option<Coordinates>,
    /// Direction at the last point, of any length.
    pub end: Option<Coordinates>,
}

forms! {
    EndsSpec: "\"natural\" or {\"start\": [x, y], \"end\": [x, y]}";
    word NaturalWord => |_| EndsSpec::Natural;
    object ClampedEnds => EndsSpec::Clamped;
}

impl Kind for CircleSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| circle_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_circle_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { rounds_corners: true, ..WaverRule::of(WaverData::Nodes, WaverRemedy::FairSpline) })
    }

    fn fields(&self) -> FieldNames {
        vec![("tangents[]", "ends")]
    }
}

pub(in crate::document) fn circle_spline(spec: &CircleSplineSpec, at: &Contour<'_>) -> Made {
    let points: &[Point3] = &at.list.points;
    let corners = corners(at, spec.closed, spec.corner_angle)?;
    let ends = match spec.ends {
        EndsSpec::Natural => SplineEnds::Natural,
        EndsSpec::Clamped(given) => {
            SplineEnds::Clamped { start: given.start.map(Coordinates::vector), end: given.end.map(Coordinates::vector) }
        }
    };
    let (closed, order, variant) = (spec.closed, spec.order, spec.variant);
    let spline = CircleSpline::from_points(points, &CircleSplineOptions { closed, order, variant, ends, corners })?;
    spline.check_finite()?;
    let warnings = spline.warnings().to_vec();
    Ok((CurveObject::CircleSpline(spline), at.facts(None), warnings))
}

/// The default blend order.
pub(in crate::document) const fn default_order() -> u32 {
    2
}

pub(in crate::document) fn in_circle_spline(spec: &CircleSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    found(&[
        ("ends", spec.closed && spec.ends != EndsSpec::Natural, NO_ENDS),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}
