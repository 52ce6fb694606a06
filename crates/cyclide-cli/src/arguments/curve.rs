//! `curve`: a list of points as a curve of any kind.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use cyclide::{
    construct::{BiarcRule, Effort, FitTarget, Outliers},
    curve::BlendVariant,
};
use cyclide_io::document::{
    Angle, ObjectSpec, PointSource,
    kinds::{
        ArcFitSpec, ArcSplineSpec, CircleSplineSpec, Comment, EndsSpec, FairEndWord, FairEndsSpec, FairFitSpec,
        FairSplineSpec, FairTolerance, MoebiusContinuity, MoebiusSplineSpec, ParametersSpec, QbInterpolationSpec,
        StraightWord, TypeWord,
    },
};

use super::make::OutputArgs;
use super::numbers::{positive, up_to_half_a_turn};
use super::table::TableArgs;
use super::words::word;
use crate::output::failure::Failure;

pub const EXAMPLES: &str = "\
Examples:
  A race track, closed, in meters, as an exact curve for CAD and a picture:
      cyclide curve track.csv --closed --units m -o track.step -o track.png
  The fewest arcs within 0.05 of the points, for a machine that supports only arcs:
      cyclide curve track.csv --closed --units m --kind arc-fit --tolerance 0.05 -o track.dxf
  Measured points, as a fair curve with continuous curvature and without noise:
      cyclide curve survey.csv --closed --units m --smooth auto -o survey.step -o survey.png
  A logo with contours, its corners marked in a column, columns selected by name:
      cyclide curve logo.csv --closed --columns x_mm,y_mm -o logo.svg

The file has one point per line, with values separated by commas, semicolons, tabs or blanks; a header line is optional. Coordinates
are the columns named x, y and z, or their surveying names (easting, Rechtswert, Abscisse, Nord, Cota, ...); columns with numbers or
names of points label the points. A blank line starts a new contour, as does a new value in a column named 'contour'; a column
'corner' (0 or 1) marks corners. See docs/document.md for the rest.";

#[derive(Debug, Default, ClapArgs)]
pub struct CurveArgs {
    /// The points (CSV, one per line: see below), or - for standard input.
    pub points: PathBuf,
    #[command(flatten)]
    pub output: OutputArgs,
    /// Close the curve from the last point to the first.
    #[arg(long)]
    pub closed: bool,
    /// The construction [default: fair-spline; fair-fit with --smooth].
    #[arg(long, value_enum)]
    pub kind: Option<Kind>,
    /// Measured points: fit a curve with continuous curvature and few nodes (--kind fair-fit). With auto the fit removes
    /// their noise and no more; the noise is estimated and reported. With a number T it is the fairest curve within T of
    /// every point, which removes more than noise.
    #[arg(long, value_name = "auto|T", value_parser = fair_tolerance, allow_hyphen_values = true)]
    pub smooth: Option<FairTolerance>,
    /// With --smooth auto: the standard deviation of the noise normal to the curve [default: estimated from the
    /// points].
    #[arg(long, value_name = "SIGMA", value_parser = positive, allow_hyphen_values = true)]
    pub noise: Option<f64>,
    /// Fair fit: what to do with outliers [default: keep].
    #[arg(long, value_parser = word::<Outliers>())]
    pub outliers: Option<Outliers>,
    /// Fair fit: a separate, larger tolerance for the heights (z); with --smooth auto it must be auto and follows
    /// their own noise.
    #[arg(long, value_name = "auto|T", value_parser = fair_tolerance, allow_hyphen_values = true)]
    pub smooth_z: Option<FairTolerance>,
    /// Arc fit: largest distance from the points (or the polyline). Other kinds: largest distance between the curve
    /// and its approximation in a file, if the format requires one [default: 1e-5 of the curve's size].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
    #[command(flatten)]
    pub table: TableArgs,
    /// Turns above this angle, in degrees, are corners, and others are not [default: no corners for splines and a fair fit;
    /// for an arc fit, turns above 30 that samples of a smooth curve cannot explain].
    #[arg(long, value_name = "DEGREES", value_parser = up_to_half_a_turn, allow_hyphen_values = true)]
    pub corner_angle_deg: Option<f64>,
    /// Fair spline: 0 is the fairest curve; with 1 the curve at each point depends only on its neighbors [default:
    /// 0].
    #[arg(long, value_name = "E", value_parser = up_to_one, allow_hyphen_values = true)]
    pub tension: Option<f64>,
    /// Fair spline: round corners beside straight runs within this fraction of their shorter leg, below 0.5.
    #[arg(long, value_name = "PART", value_parser = below_half, allow_hyphen_values = true)]
    pub tight: Option<f64>,
    /// Fair spline: the ends of an open curve [default: circle].
    #[arg(long, value_parser = word::<FairEndWord>())]
    pub ends: Option<FairEndWord>,
    /// Fair spline: whether runs of points on a line beside a corner stay straight [default: auto].
    #[arg(long, value_parser = word::<StraightWord>())]
    pub straight: Option<StraightWord>,
    /// Circle spline: blend order, 1 to 4 [default: 2].
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(1..=4), allow_hyphen_values = true)]
    pub order: Option<u32>,
    /// Circle spline: how circles are blended [default: rational].
    #[arg(long, value_parser = word::<BlendVariant>())]
    pub variant: Option<BlendVariant>,
    /// Möbius spline: continuity at the points [default: c1].
    #[arg(long, value_parser = word::<MoebiusContinuity>())]
    pub continuity: Option<MoebiusContinuity>,
    /// Möbius spline with c1: the parameters of the points: auto, chord, centripetal, uniform, or an increasing list A,B,…, with one extra
    /// number for a closed curve [default: auto].
    #[arg(long, value_name = "KNOTS", value_parser = parameters, allow_hyphen_values = true)]
    pub knots: Option<ParametersSpec>,
    /// QB interpolation: the parameters of the points: auto, chord, centripetal, uniform, or a list A,B,… of numbers from 0 to 1 [default:
    /// auto].
    #[arg(long, value_name = "PARAMETERS", value_parser = parameters, allow_hyphen_values = true)]
    pub parameters: Option<ParametersSpec>,
    /// Arc spline: how the joint between two points is chosen [default: equal-d].
    #[arg(long, value_parser = word::<BiarcRule>())]
    pub rule: Option<BiarcRule>,
    /// Arc fit: whether the points are samples of a smooth curve, with corners and straight sides where they cannot
    /// be samples, or a polyline whose edges are all within the tolerance [default: points].
    #[arg(long, value_parser = word::<FitTarget>())]
    pub target: Option<FitTarget>,
    /// Arc fit: how hard to search [default: default].
    #[arg(long, value_parser = word::<Effort>())]
    pub effort: Option<Effort>,
    /// Arc fit: no arc is shorter than L, for machines that reject short arcs; lines may be shorter.
    #[arg(long, value_name = "L", value_parser = positive, allow_hyphen_values = true)]
    pub min_arc_length: Option<f64>,
    /// Fair fit with a number T: how closely the curve follows the middle of the points. 0 is the fairest curve, 1 is as close
    /// to noisy points as their noise allows, 10 and more approach least squares; see also --smooth auto [default: 0].
    #[arg(long, value_name = "B", value_parser = not_negative, allow_hyphen_values = true)]
    pub centre: Option<f64>,
    /// Fair fit: an open curve starts and ends exactly at the first and last point.
    #[arg(long)]
    pub fix_ends: bool,
    /// Fair fit: largest number of fits used to remove nodes [default: 16].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub max_fits: Option<u32>,
    /// Fair fit: remove no nodes; about five times as fast. Same as --max-fits 0.
    #[arg(long, conflicts_with_all = ["max_fits", "nodes", "budget"])]
    pub fast: bool,
    /// Fair fit: stop removing nodes at this number of nodes per smooth piece.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..), allow_hyphen_values = true)]
    pub nodes: Option<u32>,
    /// Fair fit: the fraction of its fairness that the curve may lose to save nodes [default: 0.1].
    #[arg(long, value_name = "Q", value_parser = not_negative, allow_hyphen_values = true)]
    pub budget: Option<f64>,
    /// Fair fit: number of points on each edge of the polyline to which T also applies, if the polyline itself is the
    /// target [default: 0, the points are samples of a smooth curve].
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(0..=100), allow_hyphen_values = true)]
    pub polyline: Option<u32>,
}

/// Constructions from a list of points. The kinds listed here are those that `curve` makes and `compare` compares, with the
/// objects of `CurveArgs::spec`: there is no second list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Kind {
    /// The fairest smooth curve through the points.
    #[default]
    FairSpline,
    /// A smooth curve through the points, blended from circles.
    CircleSpline,
    /// A local smooth curve through the points; inversions take it to a curve of the same kind.
    MoebiusSpline,
    /// The rational curve of lowest degree through an odd number of points.
    QbInterpolation,
    /// Arcs through the points.
    ArcSpline,
    /// The fewest arcs within a tolerance.
    ArcFit,
    /// The fairest curve within a tolerance (--smooth).
    FairFit,
}

impl Kind {
    /// The word as it is typed.
    pub const fn word(self) -> &'static str {
        match self {
            Self::FairSpline => "fair-spline",
            Self::CircleSpline => "circle-spline",
            Self::MoebiusSpline => "moebius-spline",
            Self::QbInterpolation => "qb-interpolation",
            Self::ArcSpline => "arc-spline",
            Self::ArcFit => "arc-fit",
            Self::FairFit => "fair-fit",
        }
    }
}

/// The kinds of curve that can be closed.
pub const CLOSED_KINDS: [Kind; 6] =
    [Kind::FairSpline, Kind::CircleSpline, Kind::MoebiusSpline, Kind::ArcSpline, Kind::ArcFit, Kind::FairFit];

impl CurveArgs {
    /// The object of a kind from points, by the options that the kind has.
    pub fn spec(&self, kind: Kind, points: PointSource) -> Result<ObjectSpec, Failure> {
        let (closed, r#type) = (self.closed, TypeWord);
        let corner_angle = self.corner_angle_deg.map(Angle::Degrees);
        Ok(match kind {
            Kind::FairSpline => ObjectSpec::FairSpline(FairSplineSpec {
                r#type,
                comment: Comment,
                construction: false,
                points,
                closed,
                tension: self.tension.unwrap_or_default(),
                tight: self.tight,
                ends: self.ends.map_or_else(FairEndsSpec::default, FairEndsSpec::Both),
                straight: self.straight.unwrap_or_default(),
                corner_angle,
            }),
            Kind::CircleSpline => ObjectSpec::CircleSpline(CircleSplineSpec {
                r#type,
                comment: Comment,
                construction: false,
                points,
                closed,
                order: self.order.unwrap_or(2),
                variant: self.variant.unwrap_or_default(),
                ends: EndsSpec::Natural,
                corner_angle,
            }),
            Kind::MoebiusSpline => ObjectSpec::MoebiusSpline(MoebiusSplineSpec {
                r#type,
                comment: Comment,
                construction: false,
                points,
                closed,
                continuity: self.continuity.unwrap_or_default(),
                knots: self.knots.clone().unwrap_or_default(),
                tangents: None,
                corner_angle,
            }),
            Kind::QbInterpolation => ObjectSpec::QbInterpolation(QbInterpolationSpec {
                r#type,
                comment: Comment,
                construction: false,
                points,
                parameters: self.parameters.clone().unwrap_or_default(),
                derivatives: None,
            }),
            Kind::ArcSpline => ObjectSpec::ArcSpline(ArcSplineSpec {
                r#type,
                comment: Comment,
                construction: false,
                points,
                tangents: None,
                closed,
                rule: self.rule.unwrap_or_default(),
            }),
            Kind::ArcFit => {
                let needed = || Failure::Usage("--kind arc-fit needs --tolerance".to_owned());
                ObjectSpec::ArcFit(ArcFitSpec {
                    r#type,
                    comment: Comment,
                    construction: false,
                    points: Some(points),
                    of: None,
                    closed,
                    tolerance: self.tolerance.ok_or_else(needed)?,
                    target: self.target.unwrap_or_default(),
                    effort: self.effort.unwrap_or_default(),
                    corner_angle,
                    min_radius: self.output.min_radius,
                    min_arc_length: self.min_arc_length,
                })
            }
            Kind::FairFit => {
                let needed = || Failure::Usage("--kind fair-fit needs --smooth".to_owned());
                ObjectSpec::FairFit(FairFitSpec {
                    r#type,
                    comment: Comment,
                    construction: false,
                    points,
                    closed,
                    tolerance: self.smooth.ok_or_else(needed)?,
                    noise: self.noise,
                    outliers: self.outliers.unwrap_or_default(),
                    tolerance_z: self.smooth_z,
                    centre: self.centre.unwrap_or_default(),
                    fix_ends: self.fix_ends,
                    corner_angle,
                    max_fits: if self.fast { Some(0) } else { self.max_fits },
                    nodes: self.nodes,
                    budget: self.budget,
                    polyline: self.polyline.unwrap_or_default(),
                })
            }
        })
    }
}

/// A finite number that is not negative.
fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        Ok(_) => Err("must be finite and non-negative".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// A positive number, or the word auto.
fn fair_tolerance(text: &str) -> Result<FairTolerance, String> {
    match positive(text) {
        _ if text == "auto" => Ok(FairTolerance::AUTO),
        Ok(tolerance) => Ok(FairTolerance::Within(tolerance)),
        Err(why) if text.parse::<f64>().is_ok() => Err(why),
        Err(_) => Err("must be auto or a positive number".to_owned()),
    }
}

/// A number from 0 to 1.
fn up_to_one(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..=1.0).contains(&value) => Ok(value),
        Ok(_) => Err("must be from 0 to 1".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// Parameters by a rule or one by one, as documents have them.
fn parameters(text: &str) -> Result<ParametersSpec, String> {
    let list: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    match list {
        Ok(list) => Ok(ParametersSpec::Each(list)),
        Err(_) => serde_json::from_value(serde_json::Value::String(text.to_owned()))
            .map_err(|_| "must be auto, chord, centripetal, uniform, or a comma-separated list of numbers".to_owned()),
    }
}

/// A positive number below one half.
fn below_half(text: &str) -> Result<f64, String> {
    match positive(text) {
        Ok(value) if value >= 0.5 => Err("must be below 0.5".to_owned()),
        other => other,
    }
}
