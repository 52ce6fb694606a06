//! The fairest smooth curve near points.

use cyclide::{
    construct::{FairFit, FairFitOptions, Heights, Noise, Outliers},
    model::CurveObject,
    warning::WaverRemedy,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::angle::Angle;
use crate::document::coordinates::PointSource;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::contours::{Contour, Fitted, Made};
use crate::document::objects::idle::{Idle, NO_CORNER, NO_ENDS, found, has_no_corner};
use crate::document::objects::kind::{Kind, Shape};
use crate::document::objects::wavers::{WaverData, WaverRule};
use crate::error::Result;

/// The fairest smooth curve within a tolerance of points, with few nodes and continuous curvature: for dense or noisy
/// data.
///
/// It is a circle spline of fair segments, exact in files as a rational curve of degree 4. Its nodes are few and are
/// not points of the list. Fairness is the variation of curvature, the integral of `k'²` over the length. Corners are
/// kept exactly, each piece between them is fitted separately, and straight sides stay straight. Points that were
/// measured while nothing moved are a stop: they are named (`stop`) and count as one point.
///
/// The tolerance `"auto"` is right for measured points. The standard deviation of the noise across the curve is
/// estimated from the points and reported (`noise`); the root mean square of the distances is about the same.
///
/// A numeric tolerance is proved. One above 1/32 of the size of the figure lets the curve swing out or get lost between
/// turns: smaller ones are tried too, and if one of them gives a better curve, the warning `wide-tolerance` names the
/// tolerance used. Bends and loops within the tolerance may vanish (`shape-smoothed-away`: the curve is shorter than
/// 0.8 of the polyline).
///
/// A fit with `centre` 0 touches the bounds of the tolerance, farther than necessary from the true positions of noisy
/// points. The warning `leans-on-walls` gives the scatter of the points from one to the next, which is the standard
/// deviation of their noise. For noisy points use the tolerance `"auto"` instead, for exact points 0.
///
/// Outliers are named, each with its row and its distance (`outlier`). Those that are kept have little influence if the
/// tolerance is `"auto"`.
///
/// With `polyline`, a tolerance below the sagitta of the edges leaves little room (`samples-too-coarse`). A curve that
/// leaves an edge by more than the tolerance and 0.146 of its length, as no smooth curve with such samples does, swings
/// out: it is fitted again with three positions or more on each edge, and the warning `swings-out` reports this.
///
/// The report gives the nodes, the largest distance of a point, and a proved bound on the distance between curve and
/// polyline in both directions. Where points are denser than their noise, their nearest positions on the curve run
/// backwards (`feet-not-monotone`), and the bound applies only from the curve to the polyline.
///
/// More than one node for three points is a warning: `tolerance-below-noise` if the points change between left and
/// right as noise does, else `many-nodes`. There is never more than one node for each point (and position on an edge):
/// `tolerance-not-reached` names the points that remain outside. Increase the tolerance, or mark corners where the data
/// turn sharply. Neighboring points nearer to each other than 1e-9 of the size of the figure and a hundredth of the
/// tolerance are one point (`points-merged`).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"f": {"type": "fair-fit", "tolerance": 0.2, "points": [[0, 0], [1, 0.1], [2, 0], [3, 0.1], [4, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let Some(cyclide_io::document::Fitted::Fair(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.deviation <= 0.2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FairFitSpec {
    /// The word `fair-fit`.
    #[schemars(with = "String", extend("const" = "fair-fit"))]
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
    /// `"auto"`, for measured points: the curve follows the points as closely as their noise requires. A number: the
    /// largest distance of a point from the curve, which is the fairest within it.
    pub tolerance: FairTolerance,
    /// With the tolerance `"auto"`: the standard deviation of the noise across the curve. Give it if errors drift, like
    /// those of a GPS receiver over minutes: drift cannot be distinguished from shape. Default: estimated from the
    /// points.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub noise: Option<f64>,
    /// What happens to outliers, which are points that do not agree with the others. If a numeric tolerance is not
    /// reached because of them, the fit is rejected (`outliers`).
    #[serde(default)]
    pub outliers: Outliers,
    /// A separate tolerance for the heights (z), for example of GPS points, whose heights are two to three times worse:
    /// a number larger than `tolerance`, or `"auto"` with the tolerance `"auto"`, which estimates the noise of the
    /// heights separately (`noise_z`). Default: the tolerance of all directions.
    pub tolerance_z: Option<FairTolerance>,
    /// With a numeric tolerance: how closely the curve keeps to the middle of the points. 0 (default) gives the fairest
    /// curve, 1 keeps as close to noisy points as their noise allows, and 10 and more approach least squares.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1e6))]
    pub centre: f64,
    /// An open curve starts and ends exactly at the first and last point; otherwise its ends are as free as the rest. A
    /// closed curve has no ends (`no-effect`), and does not depend on the point at which its list starts.
    #[serde(default)]
    pub fix_ends: bool,
    /// Points that turn by more than this angle over a length of eight tolerances are kept as corners, others are not
    /// (a column `corner` of a file of points also marks corners). Default: the corners of an outline, which no samples
    /// of a smooth curve explain and which are sharp over eight tolerances on both sides, so that noise makes none.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = std::f64::consts::PI))]
    pub corner_angle: Option<Angle>,
    /// Number of fits spent on removing nodes, in batches with a fit after each; 0 keeps the nodes of the first fit and
    /// is about five times as fast. Default: 16.
    pub max_fits: Option<u32>,
    /// Number of nodes of each smooth piece at which the removal stops. If it is not reached the program says why
    /// (`nodes-not-reached`). Default: as few as the budget allows.
    #[schemars(range(min = 2))]
    pub nodes: Option<u32>,
    /// Fraction of its fairness that the curve may lose for fewer nodes: the variation of curvature grows by no more
    /// than this fraction. Default: 0.1.
    #[schemars(range(min = 0, max = 1000))]
    pub budget: Option<f64>,
    /// Number of positions on each straight edge between two points to which the tolerance also applies, for polylines
    /// whose edges are themselves the target. Default: 0, the points are samples of a smooth curve.
    #[serde(default)]
    #[schemars(range(min = 0, max = 100))]
    pub polyline: u32,
}

/// How closely a fair fit follows its points: a number or the word `auto`.
///
/// ```
/// use cyclide_io::Document;
/// let points: Vec<String> = (0..60).map(|k| format!("[{k}, {}]", 0.02 * f64::from(k * k % 7))).collect();
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"f": {{"type": "fair-fit", "tolerance": "auto", "points": [{}]}}}}}}"#, points.join(","));
/// let built = text.parse::<Document>()?.build()?;
/// let Some(cyclide_io::document::Fitted::Fair(certificate)) = built[0].contours[0].fit else { unreachable!("by its type") };
/// assert!(certificate.noise.is_some_and(|noise| noise > 0.02 && noise < 0.06));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged)]
#[non_exhaustive]
pub enum FairTolerance {
    /// Largest distance of a point from the curve.
    Within(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// As closely as the noise of the points requires.
    Auto(AutoWord),
}

impl FairTolerance {
    /// The word.
    pub const AUTO: Self = Self::Auto(AutoWord::Auto);

    /// The number, if it is one.
    #[must_use]
    pub fn within(self) -> Option<f64> {
        match self {
            Self::Within(tolerance) => Some(tolerance),
            Self::Auto(_) => None,
        }
    }
}

/// The word `auto`.
///
/// ```
/// assert_eq!(cyclide_io::document::kinds::FairTolerance::AUTO.within(), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AutoWord {
    /// As closely as the noise of the points requires.
    #[default]
    Auto,
}

forms! {
    FairTolerance: "a number or \"auto\"";
    word AutoWord => FairTolerance::Auto;
    number f64 => FairTolerance::Within;
}

impl Kind for FairFitSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let auto = self.tolerance.within().is_none();
        let heights_auto = self.tolerance_z.is_some_and(|z| z.within().is_none());
        if self.noise.is_some() && !auto {
            return Err(
                at.unfit("`noise` requires `\"tolerance\": \"auto\"`: a number as tolerance determines the fit alone")
            );
        }
        if self.tolerance_z.is_some() && heights_auto != auto {
            return Err(at.unfit("`tolerance` and `tolerance_z` must both be numbers or both be `\"auto\"`"));
        }
        at.each_contour(&self.points, self.closed, |at| fair_fit(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_fair_fit(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        let remedy = if self.tolerance.within().is_some() { WaverRemedy::Tolerance } else { WaverRemedy::Noise };
        Some(WaverRule::of(WaverData::Fitted, remedy))
    }

    fn tolerance(&self) -> Option<f64> {
        self.tolerance.within()
    }
}

pub(in crate::document) fn fair_fit(spec: &FairFitSpec, at: &Contour<'_>) -> Made {
    let mut options = match spec.tolerance {
        FairTolerance::Within(tolerance) => FairFitOptions::new(tolerance),
        FairTolerance::Auto(_) => FairFitOptions::by_noise(spec.noise.map_or(Noise::Estimated, Noise::Known)),
    };
    options.outliers = spec.outliers;
    options.heights = match spec.tolerance_z {
        None => Heights::AsAll,
        Some(FairTolerance::Within(tolerance)) => Heights::Within(tolerance),
        Some(FairTolerance::Auto(_)) => Heights::ByNoise,
    };
    options.closed = spec.closed;
    options.centre = spec.centre;
    options.fix_ends = spec.fix_ends;
    options.corner_angle = spec.corner_angle.map(Angle::radians);
    options.corners.clone_from(&at.list.corners);
    options.max_fits = spec.max_fits.map_or(options.max_fits, |n| n as usize);
    options.nodes = spec.nodes.map(|n| n as usize);
    options.budget = spec.budget.unwrap_or(options.budget);
    options.edge_points = spec.polyline as usize;
    let fit = FairFit::new(&at.list.points, &options)?;
    fit.spline().check_finite()?;
    let (facts, warnings) = (at.facts(Some(Fitted::Fair(*fit.certificate()))), fit.warnings().to_vec());
    Ok((CurveObject::CircleSpline(fit.into_spline()), facts, warnings))
}

pub(in crate::document) fn in_fair_fit(spec: &FairFitSpec, at: &Contour<'_>) -> Vec<Idle> {
    let no_fits = spec.max_fits == Some(0);
    let none_taken_out = "with `max_fits` 0 no nodes are removed";
    let auto = spec.tolerance.within().is_none();
    found(&[
        (
            "centre",
            spec.centre != 0.0 && auto,
            "with the tolerance `auto` the curve already follows the middle of the points",
        ),
        ("fix_ends", spec.fix_ends && spec.closed, NO_ENDS),
        ("nodes", spec.nodes.is_some() && no_fits, none_taken_out),
        ("budget", spec.budget.is_some() && no_fits, none_taken_out),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}
