//! `build` and `curve`: the files that they make, and how.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgAction, Args as ClapArgs};
use cyclide_io::{
    ExportOptions, Format,
    export::{Camera, DxfVersion, PictureColour, StepEdges, StepFaces, StepProducts, VtuCells, VtuEncoding},
    file::WriteOptions,
};

use super::files::{Input, WriteArgs};
use super::numbers::positive;
use super::words::word;

/// Options about the files that are written.
#[derive(Debug, Default, ClapArgs)]
pub struct OutputArgs {
    // Its help names the suffixes.
    #[arg(short, long = "output", value_name = "FILE", required = true, action = ArgAction::Append, help = output_help())]
    pub output: Vec<PathBuf>,
    /// The format of files whose names have no known suffix.
    #[arg(long, value_name = "FORMAT", value_parser = format_word())]
    pub format: Option<Format>,
    /// Write a file for each object, FILE-NAME with the name of the object, either all of them or none if nothing else is in their folder;
    /// for VTU also FILE.vtm, which ParaView opens with the objects as blocks.
    #[arg(long)]
    pub per_object: bool,
    #[command(flatten)]
    pub write: WriteArgs,
    /// Print the report as JSON (docs/report.md explains its terms).
    #[arg(long)]
    pub json: bool,
    /// Report and warn where the radius of a curve is below R; the arcs of --kind arc-fit respect this limit.
    #[arg(long, value_name = "R", value_parser = positive, allow_hyphen_values = true)]
    pub min_radius: Option<f64>,
    /// Title of the model in files and pictures [default: the name of the only object, or of the document].
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Largest number of pieces in a file (mesh cells and polyline vertices), at one to two kilobytes of memory each [default:
    /// 1000000, plus 16 for each curve piece and each patch].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000_000))]
    pub max_pieces: Option<u64>,
    /// DXF: rational curves as exact SPLINE entities (many cutters and 2D programs ignore their weights).
    #[arg(long, help_heading = "Formats")]
    pub dxf_splines: bool,
    /// DXF: the version to write [default: r2000].
    #[arg(long, value_name = "VERSION", value_parser = word::<DxfVersion>(), help_heading = "Formats")]
    pub dxf_version: Option<DxfVersion>,
    /// STEP: the form of the edges between faces, and of the faces with them [default: circle].
    #[arg(long, value_name = "CURVE", value_parser = word::<StepEdges>(), help_heading = "Formats")]
    pub step_edges: Option<StepEdges>,
    /// STEP: how bodies are divided into faces [default: auto].
    #[arg(long, value_name = "FACES", value_parser = word::<StepFaces>(), help_heading = "Formats")]
    pub step_faces: Option<StepFaces>,
    /// STEP: how several objects become products [default: auto].
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
    /// VTU: the kind of cells [default: bezier].
    #[arg(long, value_name = "CELLS", value_parser = word::<VtuCells>(), help_heading = "Formats")]
    pub vtu_cells: Option<VtuCells>,
    /// VTU: how numbers are written [default: ascii].
    #[arg(long, value_name = "ENCODING", value_parser = word::<VtuEncoding>(), help_heading = "Formats")]
    pub vtu_encoding: Option<VtuEncoding>,
    /// PNG: only the model, without curvature comb (pictures of surfaces have none), title, unit, scale bar, legend, names
    /// and axes.
    #[arg(long, help_heading = "Pictures")]
    pub png_plain: bool,
    /// PNG: width in pixels [default: 1600].
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(200..=10_000), allow_hyphen_values = true, help_heading = "Pictures")]
    pub width: Option<u32>,
    /// PNG: height in pixels [default: at most three quarters of the width].
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(150..=10_000), allow_hyphen_values = true, help_heading = "Pictures")]
    pub height: Option<u32>,
    /// PNG: the quantity that colors surfaces, with one scale for all of them; the sign of curvatures refers to the outer side
    /// [default: object].
    #[arg(long, visible_alias = "color", value_name = "WHAT", value_parser = word::<PictureColour>(), help_heading = "Pictures")]
    pub colour: Option<PictureColour>,
    /// PNG: label objects with their names, panels of nets and of solids over them with row and column from 0 (r03-c07), and
    /// points of curves with their names in the table, where they are visible and there is room.
    #[arg(long, conflicts_with = "png_plain", help_heading = "Pictures")]
    pub labels: bool,
    /// PNG: the direction of view: top, bottom, front, back, right, left, iso, or azimuth (0 is the front, 90 the right)
    /// and elevation (90 is from above) in degrees [default: top for plane curves, otherwise from a side and above].
    #[arg(long, value_name = "VIEW", allow_hyphen_values = true, help_heading = "Pictures")]
    pub camera: Option<Camera>,
    /// PNG: draw rulers with coordinates, below and on the left in views along an axis, otherwise along three edges
    /// of the bounding box.
    #[arg(long, conflicts_with = "png_plain", help_heading = "Pictures")]
    pub axes: bool,
}

/// Build a model and write files.
pub struct MakePlan {
    pub input: Input,
    /// The folder below which all files are that the document may name.
    pub read_below: Option<PathBuf>,
    /// Files and their formats; the name `-`, alone, is standard output.
    pub outputs: Vec<(PathBuf, Format)>,
    /// Each object has files of its own, named after it.
    pub per_object: bool,
    pub options: ExportOptions,
    pub write: WriteOptions,
    /// The tolerance is that of an arc fit, not only of the files.
    pub fit_tolerance: bool,
    /// No kind was given: the curve has the default kind.
    pub kind_by_default: bool,
    pub json: bool,
    /// Parts of curves tighter than this are reported.
    pub min_radius: Option<f64>,
}

/// What is said of `--output`: the suffixes are those of the formats.
fn output_help() -> String {
    let suffixes: Vec<String> = Format::suffixes().map(|suffix| format!(".{suffix}")).collect();
    format!(
        "File to write; the suffix selects the format: {}. Repeat it for several files; - with --format is standard \
         output, and the report then goes to standard error",
        suffixes.join(" ")
    )
}

/// The name of a format.
fn format_word() -> impl TypedValueParser<Value = Format> {
    let named = |word: String| Format::ALL.iter().copied().find(|format| format.name() == word);
    PossibleValuesParser::new(Format::ALL.iter().map(|format| format.name()))
        .try_map(move |word| named(word).ok_or("unknown format"))
}
