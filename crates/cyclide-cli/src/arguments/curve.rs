//! `curve`: a list of points as a curve of any kind.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use cyclide::{BiarcRule, BlendVariant, Effort, FitTarget, Outliers, Units};
use cyclide_io::{
    Angle, ObjectSpec, PointSource,
    kinds::{
        ArcFitSpec, ArcSplineSpec, CircleSplineSpec, Comment, EndsSpec, FairEndWord, FairEndsSpec, FairFitSpec,
        FairSplineSpec, FairTolerance, MoebiusContinuity, MoebiusSplineSpec, ParametersSpec, QbInterpolationSpec,
        StraightWord, TypeWord,
    },
};

use super::make::OutputArgs;
use super::numbers::{positive, up_to_half_a_turn};
use super::words::word;
use crate::output::failure::Failure;

pub const EXAMPLES: &str = "\
Examples:
  A race track, closed, in metres, as an exact curve for CAD and a picture:
      cyclide curve track.csv --closed --units m -o track.step -o track.png
  The fewest arcs within 0.05 of the points, for a machine that knows arcs only:
      cyclide curve track.csv --closed --units m --kind arc-fit --tolerance 0.05 -o track.dxf
  Measured points, a fair curve with continuous curvature without their noise:
      cyclide curve survey.csv --closed --units m --smooth auto -o survey.step -o survey.png
  A logo with contours, its corners marked in a column, columns chosen by name:
      cyclide curve logo.csv --closed --columns x_mm,y_mm -o logo.svg

The file: one point per line, separated by commas, semicolons, tabs or blanks; a header line is optional. Coordinates are
the columns named x, y and z, or in the words of surveys (easting, Rechtswert, Abscisse, Nord, Cota, ...); numbers and names
of points are kept as what the points are called. A blank line starts a new contour, as does a new value in a column named
'contour'; a column 'corner' (0 or 1) marks corners. docs/document.md has the rest.";

#[derive(Debug, Default, ClapArgs)]
pub struct CurveArgs {
    /// The points (CSV, one per line: see below), - for standard input.
    pub points: PathBuf,
    #[command(flatten)]
    pub output: OutputArgs,
    /// The last point joins the first.
    #[arg(long)]
    pub closed: bool,
    /// The construction [default: fair-spline; fair-fit with --smooth].
    #[arg(long, value_enum)]
    pub kind: Option<Kind>,
    /// Measured points: a curve with continuous curvature near to them, with few nodes (--kind fair-fit). With auto it leaves
    /// out their noise and no more; the noise is estimated and reported. With a number T it is the fairest curve within T of
    /// every point, which leaves out more than noise.
    #[arg(long, value_name = "auto|T", value_parser = fair_tolerance, allow_hyphen_values = true)]
    pub smooth: Option<FairTolerance>,
    /// With --smooth auto: the standard deviation of the noise across the curve [default: estimated from the points].
    #[arg(long, value_name = "SIGMA", value_parser = positive, allow_hyphen_values = true)]
    pub noise: Option<f64>,
    /// Fair fit: what becomes of points that do not belong to the others [default: keep].
    #[arg(long, value_parser = word::<Outliers>())]
    pub outliers: Option<Outliers>,
    /// Fair fit: a tolerance for the heights (z) alone, larger than T; auto with --smooth auto, by their own noise.
    #[arg(long, value_name = "auto|T", value_parser = fair_tolerance, allow_hyphen_values = true)]
    pub smooth_z: Option<FairTolerance>,
    /// Arc fit: largest distance from the points (or the polyline). Else: largest distance between a file's curve and
    /// the curve, where the format needs an approximation [default: 1e-5 of the curve's size].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
    /// What the coordinates are measured in; they are labelled, never rescaled [default: what the names of the columns
    /// say, as x_m, else mm].
    #[arg(long, value_parser = word::<Units>())]
    pub units: Option<Units>,
    /// The two or three coordinate columns, x first, by name or by number from 1 [default: x, y and z by their names, or
    /// easting, northing and height; numbers and names of points are none].
    #[arg(long, value_name = "A,B", value_delimiter = ',', num_args = 1)]
    pub columns: Option<Vec<String>>,
    /// The column that tells contours apart [default: 'contour', else blank lines].
    #[arg(long, value_name = "NAME")]
    pub contour_column: Option<String>,
    /// Turns above this angle, in degrees, are corners, and others are not [default: none for splines and a fair fit; for an
    /// arc fit those above 30 that no samples of a smooth curve explain].
    #[arg(long, value_name = "DEGREES", value_parser = up_to_half_a_turn, allow_hyphen_values = true)]
    pub corner_angle_deg: Option<f64>,
    /// Fair spline: 0 is the fairest curve, with 1 every point follows its neighbours alone [default: 0].
    #[arg(long, value_name = "E", value_parser = up_to_one, allow_hyphen_values = true)]
    pub tension: Option<f64>,
    /// Fair spline: corners beside straight runs are rounded within this part of their shorter leg, below 0.5.
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
    /// Möbius spline: what is continuous at the points besides the curve [default: c1].
    #[arg(long, value_parser = word::<MoebiusContinuity>())]
    pub continuity: Option<MoebiusContinuity>,
    /// Möbius spline of c1: the parameters at which it passes its points: auto, chord, centripetal, uniform, or a list A,B,… that increases, with one number
    /// more for a closed curve [default: auto].
    #[arg(long, value_name = "KNOTS", value_parser = parameters, allow_hyphen_values = true)]
    pub knots: Option<ParametersSpec>,
    /// QB interpolation: the parameters at which it meets its points: auto, chord, centripetal, uniform, or a list A,B,… of numbers from 0 to 1
    /// [default: auto].
    #[arg(long, value_name = "PARAMETERS", value_parser = parameters, allow_hyphen_values = true)]
    pub parameters: Option<ParametersSpec>,
    /// Arc spline: how the joint between two points is chosen [default: equal-d].
    #[arg(long, value_parser = word::<BiarcRule>())]
    pub rule: Option<BiarcRule>,
    /// Arc fit: what the points are: samples of a smooth curve, with corners and straight sides where they cannot be
    /// samples, or a polyline all of whose edges are kept to [default: points].
    #[arg(long, value_parser = word::<FitTarget>())]
    pub target: Option<FitTarget>,
    /// Arc fit: how hard to search [default: default].
    #[arg(long, value_parser = word::<Effort>())]
    pub effort: Option<Effort>,
    /// Arc fit: no arc is shorter than L, for machines that reject short arcs; lines may be.
    #[arg(long, value_name = "L", value_parser = positive, allow_hyphen_values = true)]
    pub min_arc_length: Option<f64>,
    /// Fair fit within a number T: how much the curve keeps to the middle of the points: 0 for the fairest curve, 1 as close to
    /// noisy points as their noise allows, 10 and more approach least squares; see also --smooth auto [default: 0].
    #[arg(long, value_name = "B", value_parser = not_negative, allow_hyphen_values = true)]
    pub centre: Option<f64>,
    /// Fair fit: an open curve starts and ends exactly at the first and last point.
    #[arg(long)]
    pub fix_ends: bool,
    /// Fair fit: fits spent on taking nodes out [default: 16].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub max_fits: Option<u32>,
    /// Fair fit: take no nodes out; about five times as fast. The same as --max-fits 0.
    #[arg(long, conflicts_with_all = ["max_fits", "nodes", "budget"])]
    pub fast: bool,
    /// Fair fit: nodes of each smooth piece at which taking out stops.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..), allow_hyphen_values = true)]
    pub nodes: Option<u32>,
    /// Fair fit: the part of its fairness that the curve may lose for fewer nodes [default: 0.1].
    #[arg(long, value_name = "Q", value_parser = not_negative, allow_hyphen_values = true)]
    pub budget: Option<f64>,
    /// Fair fit: places on each edge between two points that T binds too; for polylines that are meant themselves
    /// [default: 0, the points are samples of a smooth curve].
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(0..=100), allow_hyphen_values = true)]
    pub polyline: Option<u32>,
}

/// Constructions that start from a list of points. What stands here `curve` makes and `compare` compares, by the objects of
/// `CurveArgs::spec`: there is no second list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Kind {
    /// The fairest smooth curve through the points.
    #[default]
    FairSpline,
    /// A smooth curve through the points, blended from circles.
    CircleSpline,
    /// A local smooth curve through the points that inversions keep.
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
        Ok(_) => Err("it must not be negative, and finite".to_owned()),
        Err(_) => Err("it is not a number".to_owned()),
    }
}

/// A positive number, or the word auto.
fn fair_tolerance(text: &str) -> Result<FairTolerance, String> {
    match positive(text) {
        _ if text == "auto" => Ok(FairTolerance::AUTO),
        Ok(tolerance) => Ok(FairTolerance::Within(tolerance)),
        Err(why) if text.parse::<f64>().is_ok() => Err(why),
        Err(_) => Err("it is auto or a positive number".to_owned()),
    }
}

/// A number from 0 to 1.
fn up_to_one(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..=1.0).contains(&value) => Ok(value),
        Ok(_) => Err("it must be from 0 to 1".to_owned()),
        Err(_) => Err("it is not a number".to_owned()),
    }
}

/// Parameters by a rule or one by one, as documents have them.
fn parameters(text: &str) -> Result<ParametersSpec, String> {
    let list: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    match list {
        Ok(list) => Ok(ParametersSpec::Each(list)),
        Err(_) => serde_json::from_value(serde_json::Value::String(text.to_owned()))
            .map_err(|_| "it is auto, chord, centripetal, uniform, or numbers with commas between them".to_owned()),
    }
}

/// A positive number below one half.
fn below_half(text: &str) -> Result<f64, String> {
    match positive(text) {
        Ok(value) if value >= 0.5 => Err("it must be below 0.5".to_owned()),
        other => other,
    }
}
