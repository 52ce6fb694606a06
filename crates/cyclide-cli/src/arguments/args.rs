//! The command line as it is typed.

use std::path::PathBuf;

use cyclide::{BiarcRule, BlendVariant, Effort, FitTarget, Outliers, Units};
use cyclide_io::{
    Camera, DxfVersion, Format, PictureColour, StepEdges, StepFaces, StepProducts, VtuCells, VtuEncoding, WriteOptions,
    kinds::{FairEndWord, FairTolerance, MoebiusContinuity, ParametersSpec, StraightWord},
};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgAction, Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use super::compare::{self, CompareArgs};
use super::sample::{self, SampleArgs};
use super::schedule::{self, ScheduleArgs};
use super::words::word;

const EXIT_CODES: &str = "\
Exit codes:
  0  success (also when nobody reads standard output to its end)
  1  the input was refused: the message shows the file, line and column
  2  the command line makes no sense
  3  a file or standard output could not be read or written
  4  a file failed its check when read back and was not written (a fault of cyclide)

All files of a run are made and checked before the first is written, and each is written whole or not at all: where the exit
code is not 0 old files are as they were, unless a disk fails for good in the last step (the message then names what was
written). A signal ends the program without leaving a temporary file. Warnings and progress go to standard error, reports to standard output; the name - is standard input or, after -o,
standard output (docs/files.md).";

const EXAMPLES: &str = "\
First steps:
  cyclide gallery -o gallery            every example, with a page of pictures
  cyclide new fair-spline -o my.json    a commented document to change ('cyclide new' lists all kinds)
  cyclide build my.json -o my.step -o my.png

Examples:
  cyclide curve track.csv --closed --units m -o track.step -o track.dxf -o track.png
  cyclide build logo.json -o logo.dxf --tolerance 0.01
  cyclide build roof.json -o roof.step -o roof.glb -o roof.png
  cyclide new pipe -o pipe.json && cyclide build pipe.json -o pipe.step
  cyclide report roof.json --json

'cyclide help KIND' is the manual of a kind of object ('cyclide help kinds' lists them). The documentation of the project explains
the rest: docs/document.md (what documents share), docs/report.md (every word of the report), docs/formats.md (what each format
carries).";

const NEW_EXAMPLES: &str = "\
Examples:
  cyclide new arc-fit -o part.json
  cyclide build part.json -o part.dxf -o part.png

Each document builds as printed. Its comments say what the fields mean; 'cyclide help TYPE' explains all of them.";

const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  bash:        cyclide completions bash > ~/.local/share/bash-completion/completions/cyclide
  zsh:         cyclide completions zsh > ~/.zfunc/_cyclide        (a folder of $fpath)
  fish:        cyclide completions fish > ~/.config/fish/completions/cyclide.fish
  PowerShell:  cyclide completions powershell | Out-String | Invoke-Expression
Then start a new shell.";

const MAN_EXAMPLES: &str = "\
Examples:
  cyclide man -o man && man -l man/cyclide.1
  cyclide man -o ~/.local/share/man/man1        (then: man cyclide, man cyclide-build)";

const BUILD_EXAMPLES: &str = "\
Examples:
  Curves, exact for CAD, within 0.01 for a cutter:
      cyclide build logo.json -o logo.step
      cyclide build logo.json -o logo.dxf --tolerance 0.01 --json > report.json
  Surfaces, one sewn shell or solid each for CAD, meshes within 0.5 of them, a picture:
      cyclide build roof.json -o roof.step -o roof.png
      cyclide build roof.json -o roof.glb -o roof.obj -o roof.stl --tolerance 0.5
  A document with the two skins of a roof over a mesh of quads:
      {\"cyclide\": 1, \"units\": \"m\", \"objects\": {
        \"outer\": {\"type\": \"cyclidic-net\", \"grid\": {\"obj\": \"roof.obj\"}, \"make_circular\": true},
        \"inner\": {\"type\": \"offset\", \"of\": \"outer\", \"distance\": -0.3}}}";

const CURVE_EXAMPLES: &str = "\
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

const REPORT_EXAMPLES: &str = "\
Examples:
  cyclide report logo.json
  cyclide report logo.json --json | jq '.objects[].length'
  cyclide report track.json --min-radius 12
  cyclide report gripper.json --max-speed 500 --max-angular-speed 3
  cyclide report roof.json --json | jq '.objects[].circular.move_max'

docs/report.md explains every word of the report, with what is good and what to do about the rest; the fields of --json are in
docs/formats.md.";

const GALLERY_EXAMPLES: &str = "\
Example:
  cyclide gallery -o gallery

Each model comes with its document, so that it can be changed and built again: cyclide build gallery/patch.json -o new.step";

const SCHEMA_EXAMPLES: &str = "\
Example:
  cyclide schema > cyclide-1.schema.json";

const HELP_EXAMPLES: &str = "\
Examples:
  cyclide help build       the options of a command
  cyclide help pipe-tee    the fields of a kind of object, and a document to start from
  cyclide help kinds       all kinds of object";

/// Curves and surfaces made of circles: points or meshes in, exact and smooth geometry out, for CAD, cutting, drawing and
/// rendering.
#[derive(Debug, Parser)]
#[command(name = "cyclide", version, arg_required_else_help = true, disable_help_subcommand = true, after_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Build a model document and write its curves and surfaces to files.
    #[command(after_help = BUILD_EXAMPLES)]
    Build(BuildArgs),
    /// Turn a list of points into a curve and write it to files.
    #[command(after_help = CURVE_EXAMPLES)]
    Curve(Box<CurveArgs>),
    /// Set all kinds of curve through or near the same points side by side.
    #[command(after_help = compare::EXAMPLES)]
    Compare(CompareArgs),
    /// Sample an object of a model: points, stations, tangents, frames or normals, curvatures as CSV or JSON.
    #[command(after_help = sample::EXAMPLES)]
    Sample(SampleArgs),
    /// List the panels, edges, nodes and beams of the nets of a model, with plans and flat patterns, for a workshop.
    #[command(after_help = schedule::EXAMPLES)]
    Schedule(ScheduleArgs),
    /// Build a model document and report on its objects without writing files.
    #[command(after_help = REPORT_EXAMPLES)]
    Report(ReportArgs),
    /// Print a commented model document to start from, for any type of object.
    #[command(after_help = NEW_EXAMPLES)]
    New(NewArgs),
    /// Build every example model to files, with a page that shows them.
    #[command(after_help = GALLERY_EXAMPLES)]
    Gallery(GalleryArgs),
    /// Print the JSON Schema of the model document.
    #[command(after_help = SCHEMA_EXAMPLES)]
    Schema,
    /// Print a script that completes commands and options in a shell.
    #[command(after_help = COMPLETIONS_EXAMPLES)]
    Completions(CompletionsArgs),
    /// Write manual pages to a folder, one per command.
    #[command(after_help = MAN_EXAMPLES)]
    Man(ManArgs),
    /// Print the help of a command, or the manual of a kind of object.
    #[command(after_help = HELP_EXAMPLES)]
    Help(HelpArgs),
}

#[derive(Debug, ClapArgs)]
pub struct NewArgs {
    /// The type of object; without it the types are listed.
    #[arg(value_parser = crate::arguments::starters::kinds())]
    pub kind: Option<String>,
    /// Write to a new file instead of standard output; an old one is never written over.
    #[arg(short, long, value_name = "FILE", requires = "kind")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, ClapArgs)]
pub struct HelpArgs {
    /// A command, a kind of object, or 'kinds' for a list of these; without it the help of the program.
    #[arg(value_name = "COMMAND|KIND")]
    pub word: Option<String>,
}

#[derive(Debug, ClapArgs)]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: Shell,
}

#[derive(Debug, ClapArgs)]
pub struct ManArgs {
    /// The folder for the pages, made if it does not exist.
    #[arg(short, long = "output", value_name = "DIR")]
    pub output: PathBuf,
    #[command(flatten)]
    pub write: WriteArgs,
}

#[derive(Debug, ClapArgs)]
pub struct BuildArgs {
    /// The model document (JSON), - for standard input; 'cyclide new' prints one to start from.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    /// Largest distance between a file's curve or mesh and the object, where the format needs an approximation [default:
    /// 1e-5 of the model's size for curves, 1e-4 for meshes].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
}

/// Options about the files that are written.
#[derive(Debug, Default, ClapArgs)]
pub struct OutputArgs {
    // Its help names the suffixes.
    #[arg(short, long = "output", value_name = "FILE", required = true, action = ArgAction::Append, help = output_help())]
    pub output: Vec<PathBuf>,
    /// The format of files whose names do not say it.
    #[arg(long, value_name = "FORMAT", value_parser = format_word())]
    pub format: Option<Format>,
    /// A file for each object, FILE-NAME with the object's name, all of them or none if their folder holds nothing else; for VTU also FILE.vtm, which ParaView opens with the objects as blocks.
    #[arg(long)]
    pub per_object: bool,
    #[command(flatten)]
    pub write: WriteArgs,
    /// Print the report as JSON (docs/report.md explains its words).
    #[arg(long)]
    pub json: bool,
    /// Name the places of curves whose radius is below R, in the report and as warnings; the arcs of --kind arc-fit keep to it.
    #[arg(long, value_name = "R", value_parser = positive, allow_hyphen_values = true)]
    pub min_radius: Option<f64>,
    /// What files and pictures call the model [default: the name of the only object, or of the document].
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Most pieces of one file, cells of meshes and vertices of polylines together; one to two kilobytes of memory each [default:
    /// 1000000, and 16 for each piece of a curve and each patch].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000_000))]
    pub max_pieces: Option<u64>,
    /// DXF: rational curves as exact SPLINE entities (many cutters and 2D programs ignore their weights).
    #[arg(long, help_heading = "Formats")]
    pub dxf_splines: bool,
    /// DXF: the version written [default: r2000].
    #[arg(long, value_name = "VERSION", value_parser = word::<DxfVersion>(), help_heading = "Formats")]
    pub dxf_version: Option<DxfVersion>,
    /// STEP: the curves of the edges between faces, and with them the faces [default: circle].
    #[arg(long, value_name = "CURVE", value_parser = word::<StepEdges>(), help_heading = "Formats")]
    pub step_edges: Option<StepEdges>,
    /// STEP: which faces bodies have [default: auto].
    #[arg(long, value_name = "FACES", value_parser = word::<StepFaces>(), help_heading = "Formats")]
    pub step_faces: Option<StepFaces>,
    /// STEP: the products of several objects [default: auto].
    #[arg(long, value_name = "PRODUCTS", value_parser = word::<StepProducts>(), help_heading = "Formats")]
    pub step_products: Option<StepProducts>,
    /// SVG: draw the curvature comb.
    #[arg(long, help_heading = "Formats")]
    pub svg_comb: bool,
    /// SVG: draw the joints of the curves as dots.
    #[arg(long, help_heading = "Formats")]
    pub svg_points: bool,
    /// GLB: draw the edges of the patches as lines on the surfaces.
    #[arg(long, help_heading = "Formats")]
    pub glb_edges: bool,
    /// VTU: the cells of the file [default: bezier].
    #[arg(long, value_name = "CELLS", value_parser = word::<VtuCells>(), help_heading = "Formats")]
    pub vtu_cells: Option<VtuCells>,
    /// VTU: how numbers are written [default: ascii].
    #[arg(long, value_name = "ENCODING", value_parser = word::<VtuEncoding>(), help_heading = "Formats")]
    pub vtu_encoding: Option<VtuEncoding>,
    /// PNG: the model alone, without curvature comb (pictures of surfaces have none), title, unit, scale bar, legend, names
    /// and axes.
    #[arg(long, help_heading = "Pictures")]
    pub png_plain: bool,
    /// PNG: width in pixels [default: 1600].
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(200..=10_000), allow_hyphen_values = true, help_heading = "Pictures")]
    pub width: Option<u32>,
    /// PNG: height in pixels [default: at most three quarters of the width].
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(150..=10_000), allow_hyphen_values = true, help_heading = "Pictures")]
    pub height: Option<u32>,
    /// PNG: what surfaces are coloured by, with one scale for all of them; curvatures are signed by the outer side [default: object].
    #[arg(long, visible_alias = "color", value_name = "WHAT", value_parser = word::<PictureColour>(), help_heading = "Pictures")]
    pub colour: Option<PictureColour>,
    /// PNG: write the names of objects on them, on the panels of nets and of solids over them row and column from 0 (r03-c07),
    /// and beside the points of curves what their table calls them, where they are seen and have room.
    #[arg(long, conflicts_with = "png_plain", help_heading = "Pictures")]
    pub labels: bool,
    /// PNG: where to look from: top, bottom, front, back, right, left, iso, or azimuth (0 is the front, 90 the right) and
    /// elevation (90 is from above) in degrees [default: top for plane curves, else a side and above].
    #[arg(long, value_name = "VIEW", allow_hyphen_values = true, help_heading = "Pictures")]
    pub camera: Option<Camera>,
    /// PNG: draw rulers with coordinates, below and at the left in views along an axis, else along three edges of the
    /// model's box.
    #[arg(long, conflicts_with = "png_plain", help_heading = "Pictures")]
    pub axes: bool,
}

/// What a document may read.
#[derive(Debug, Clone, Default, ClapArgs)]
pub struct ReadArgs {
    /// The document may name files below DIR only, for documents of people who are not trusted: `..` and links do not lead out of it.
    #[arg(long, value_name = "DIR")]
    pub read_below: Option<PathBuf>,
}

/// How files are written.
#[derive(Debug, Clone, Copy, Default, ClapArgs)]
pub struct WriteArgs {
    /// Replace files that are read-only too.
    #[arg(long)]
    pub force: bool,
    /// Wait until the files are on the disk, so that they survive a loss of power.
    #[arg(long)]
    pub durable: bool,
}

impl WriteArgs {
    pub const fn options(self) -> WriteOptions {
        WriteOptions { force: self.force, durable: self.durable }
    }
}

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

#[derive(Debug, ClapArgs)]
pub struct ReportArgs {
    /// The model document (JSON), - for standard input; 'cyclide new' prints one to start from.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    /// Print the report as JSON.
    #[arg(long)]
    pub json: bool,
    /// Name the places of curves whose radius is below R.
    #[arg(long, value_name = "R", value_parser = positive, allow_hyphen_values = true)]
    pub min_radius: Option<f64>,
    /// Name the places of motions where the tool is faster than V, in units of length per second.
    #[arg(long, value_name = "V", value_parser = positive, allow_hyphen_values = true)]
    pub max_speed: Option<f64>,
    /// Name the places of motions where the body turns faster than W, in radians per second.
    #[arg(long, value_name = "W", value_parser = positive, allow_hyphen_values = true)]
    pub max_angular_speed: Option<f64>,
}

#[derive(Debug, ClapArgs)]
pub struct GalleryArgs {
    /// The folder for the files, made if it does not exist. The page is index.html.
    #[arg(short, long = "output", value_name = "DIR")]
    pub output: PathBuf,
    #[command(flatten)]
    pub write: WriteArgs,
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

/// What is said of `--output`: the suffixes are those of the formats.
fn output_help() -> String {
    let suffixes: Vec<String> = Format::suffixes().map(|suffix| format!(".{suffix}")).collect();
    format!(
        "File to write; the suffix says the format: {}. Give it once per file; - with --format is standard output, and the \
         report goes to standard error",
        suffixes.join(" ")
    )
}

/// The name of a format.
fn format_word() -> impl TypedValueParser<Value = Format> {
    let named = |word: String| Format::ALL.iter().copied().find(|format| format.name() == word);
    PossibleValuesParser::new(Format::ALL.iter().map(|format| format.name()))
        .try_map(move |word| named(word).ok_or("no such format"))
}

/// A finite number that is not negative.
fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        Ok(_) => Err("it must not be negative, and finite".to_owned()),
        Err(_) => Err("it is not a number".to_owned()),
    }
}

/// A positive, finite number.
pub fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        Ok(_) => Err("it must be positive and finite".to_owned()),
        Err(_) => Err("it is not a number".to_owned()),
    }
}

/// A positive number, or the word auto.
pub fn fair_tolerance(text: &str) -> Result<FairTolerance, String> {
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

/// A positive number of degrees, at most 180.
pub fn up_to_half_a_turn(text: &str) -> Result<f64, String> {
    match positive(text) {
        Ok(value) if value > 180.0 => Err("it must be at most 180 degrees".to_owned()),
        other => other,
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
