//! The fairest smooth curve through points.

use cyclide::{
    construct::{FairEnd, FairSplineOptions},
    curve::CircleSpline,
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::Angle;
use crate::document::coordinates::{Coordinates, PointFile, PointSource};
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Made, corners};
use crate::document::objects::idle::{Idle, NO_CORNER, NO_ENDS, found, has_no_corner, is_same};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// The fairest smooth curve through points: its curvature is continuous and varies as little as that of an Euler
/// spiral.
///
/// It is the smooth curve to start with, and it reproduces circles, lines and spheres. Every point influences the whole
/// curve, but the influence falls to a quarter from point to point. A `circle-spline` depends only on four neighboring
/// points at a time, so it wavers more.
///
/// Where the points turn by nearly half a turn such a curve may not exist, or it may swing out. It is then made less
/// fair (the warning `relaxed` names the segments) or cut (`sharp-turn-cut`): mark such points as corners with
/// `corner_angle`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - 2.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FairSplineSpec {
    /// The word `fair-spline`.
    #[schemars(with = "String", extend("const" = "fair-spline"))]
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
    /// 0 is the fairest curve; with 1 every point follows only its neighbors, as in a `circle-spline` of order 2.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1))]
    pub tension: f64,
    /// Rounds corners beside straight runs tightly: within this fraction, below 0.5, of the shorter of their two legs.
    /// With 0.2 the curve leaves the legs by a fifth of what it does otherwise.
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 0.5))]
    pub tight: Option<f64>,
    /// What happens at the ends of an open curve; a closed curve has none. Default `circle` at both.
    #[serde(default)]
    pub ends: FairEndsSpec,
    /// Whether runs of collinear points beside a corner stay straight.
    #[serde(default)]
    pub straight: StraightWord,
    /// Points that turn by more than this angle are kept as corners. Default: none (a column `corner` of a file of
    /// points also marks corners).
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
}

/// Whether runs of collinear points beside a corner stay straight.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "straight": "off", "corner_angle": {"degrees": 60}, "points": [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves()[0].as_curve().piece_count(), 4);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Straight")]
pub enum StraightWord {
    /// They stay straight, and the curve bends only at the corner, if neighboring points turn by more than 30 to 60
    /// degrees there and by less than a hundredth of that along the run.
    #[default]
    Auto,
    /// The curve is as fair as possible and swings slightly along them.
    Off,
}

/// The ends of an open fair spline: a word for both, or an object with one for each.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": {"start": [0, 3]}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "FairEnds")]
#[non_exhaustive]
pub enum FairEndsSpec {
    /// The same for both ends.
    Both(FairEndWord),
    /// Each end separately.
    Each(FairEndPair),
}

impl Default for FairEndsSpec {
    fn default() -> Self {
        Self::Both(FairEndWord::Circle)
    }
}

/// The two ends of an open curve; an omitted end is `circle`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": {"start": [0, 3], "end": "arc"}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let tangent = built[0].item.curves()[0].as_curve().jet(0.0).d1;
/// assert!(tangent.x.abs() < 1e-12 && tangent.y > 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FairEndPair {
    /// At the first point: a word, or the direction of travel, of any length.
    pub start: Option<FairEndSpec>,
    /// At the last point.
    pub end: Option<FairEndSpec>,
}

/// One end of an open fair spline.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": {"start": "free", "end": "arc"}, "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let start = built[0].item.curves()[0].as_curve().jet(0.0);
/// assert!(start.curvature().is_some_and(|k| k < 1e-9));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "FairEnd")]
#[non_exhaustive]
pub enum FairEndSpec {
    /// An end without a given direction.
    Word(FairEndWord),
    /// The direction of travel there, of any length.
    Direction(Coordinates),
}

/// How an end without a given direction is made.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": "free", "points": [[0, 0], [1, 1], [2, 1], [3, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let start = built[0].item.curves()[0].as_curve().jet(0.0);
/// assert!(start.curvature().is_some_and(|k| k < 1e-9));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "FairEndWord")]
pub enum FairEndWord {
    /// The curve leaves along the circle through the three points at its end.
    #[default]
    Circle,
    /// The end segment is an arc.
    Arc,
    /// The curvature is zero.
    Free,
}

forms! {
    FairEndsSpec: "\"circle\", \"arc\", \"free\" or {\"start\": …, \"end\": …} with these words or directions";
    word FairEndWord => FairEndsSpec::Both;
    object FairEndPair => FairEndsSpec::Each;
}

forms! {
    FairEndSpec: "\"circle\", \"arc\", \"free\" or a direction `[x, y]` or `[x, y, z]`";
    word FairEndWord => FairEndSpec::Word;
    list Coordinates => FairEndSpec::Direction;
}

impl From<FairEndsSpec> for [FairEnd; 2] {
    fn from(ends: FairEndsSpec) -> Self {
        match ends {
            FairEndsSpec::Both(word) => [word.into(); 2],
            FairEndsSpec::Each(FairEndPair { start, end }) => {
                [start, end].map(|end| end.map_or(FairEnd::Circle, FairEnd::from))
            }
        }
    }
}

impl From<FairEndSpec> for FairEnd {
    fn from(end: FairEndSpec) -> Self {
        match end {
            FairEndSpec::Word(word) => word.into(),
            FairEndSpec::Direction(direction) => Self::Clamped(direction.vector()),
        }
    }
}

impl From<FairEndWord> for FairEnd {
    fn from(word: FairEndWord) -> Self {
        match word {
            FairEndWord::Circle => Self::Circle,
            FairEndWord::Arc => Self::Arc,
            FairEndWord::Free => Self::Free,
        }
    }
}

impl Kind for FairSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| fair_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
        in_fair_spline(self, at, made)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { rounds_corners: true, ..WaverRule::of(WaverData::Nodes, WaverRemedy::Points) })
    }

    fn fields(&self) -> FieldNames {
        vec![("tangents[]", "ends")]
    }
}

pub(in crate::document) fn fair_spline(spec: &FairSplineSpec, at: &Contour<'_>) -> Made {
    let options = FairSplineOptions {
        closed: spec.closed,
        ends: spec.ends.into(),
        tension: spec.tension,
        straight_runs: spec.straight == StraightWord::Auto,
        tight: spec.tight,
        corners: corners(at, spec.closed, spec.corner_angle)?,
        ..FairSplineOptions::default()
    };
    let spline = CircleSpline::fair(&at.list.points, &options)?;
    spline.check_finite()?;
    let warnings = spline.warnings().to_vec();
    Ok((CurveObject::CircleSpline(spline), at.facts(None), warnings))
}

pub(in crate::document) fn in_fair_spline(spec: &FairSplineSpec, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
    let same = |change: &dyn Fn(&mut FairSplineSpec)| {
        // The points are in the contour.
        let mut other = FairSplineSpec {
            r#type: TypeWord,
            comment: Comment,
            construction: false,
            points: PointSource::File(PointFile::default()),
            ..*spec
        };
        change(&mut other);
        fair_spline(&other, at).is_ok_and(|(curve, ..)| is_same(&curve, made))
    };
    let ends = spec.ends != FairEndsSpec::default();
    let tests = [
        ("tension", spec.tension != 0.0 && same(&|s| s.tension = 0.0), "with 0 the curve is the same"),
        ("tight", spec.tight.is_some() && same(&|s| s.tight = None), "there is no corner beside a straight run"),
        (
            "straight",
            spec.straight != StraightWord::Auto && same(&|s| s.straight = StraightWord::Auto),
            "there is no run of collinear points beside a corner",
        ),
        ("ends", ends && spec.closed, NO_ENDS),
        (
            "ends",
            ends && !spec.closed && same(&|s| s.ends = FairEndsSpec::default()),
            "with `circle` the curve is the same",
        ),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ];
    found(&tests)
}
