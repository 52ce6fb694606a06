//! The command line as it is typed.

use std::path::PathBuf;

use clap::{Args as ClapArgs, Parser, Subcommand};
use clap_complete::Shell;

use super::compare::{self, CompareArgs};
use super::curve::{self, CurveArgs};
use super::files::{ReadArgs, WriteArgs};
use super::make::OutputArgs;
use super::numbers::positive;
use super::sample::{self, SampleArgs};
use super::schedule::{self, ScheduleArgs};

const EXIT_CODES: &str = "\
Exit codes:
  0  success (also if standard output is closed early)
  1  the input was rejected: the message gives file, line and column
  2  invalid usage
  3  a file or standard output could not be read or written
  4  a file failed its check when read back and was not written (a bug in cyclide)

All files of a run are generated and checked before the first one is written, and each is written completely or not at all. If
the exit code is not 0, existing files are unchanged, unless the disk fails in the last step; the message then names the files
that were written. A signal ends the program without leaving temporary files. Warnings and progress go to standard error, reports
to standard output; the name - means standard input or, after -o, standard output (docs/files.md).";

const EXAMPLES: &str = "\
First steps:
  cyclide gallery -o gallery            every example, with a page of pictures
  cyclide new fair-spline -o my.json    a commented document to edit ('cyclide new' lists all kinds)
  cyclide build my.json -o my.step -o my.png

Examples:
  cyclide curve track.csv --closed --units m -o track.step -o track.dxf -o track.png
  cyclide build logo.json -o logo.dxf --tolerance 0.01
  cyclide build roof.json -o roof.step -o roof.glb -o roof.png
  cyclide new pipe -o pipe.json && cyclide build pipe.json -o pipe.step
  cyclide report roof.json --json

'cyclide help KIND' prints the manual of a kind of object ('cyclide help kinds' lists them). The documentation of the project covers
the rest: docs/document.md (the document format), docs/report.md (the terms of the report), docs/formats.md (what each format
contains).";

const NEW_EXAMPLES: &str = "\
Examples:
  cyclide new arc-fit -o part.json
  cyclide build part.json -o part.dxf -o part.png

Each document builds as printed. Its comments explain the main fields; 'cyclide help TYPE' explains all of them.";

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
  Surfaces: sewn shells or solids for CAD, meshes within 0.5 of them, a picture:
      cyclide build roof.json -o roof.step -o roof.png
      cyclide build roof.json -o roof.glb -o roof.obj -o roof.stl --tolerance 0.5
  A document with the two skins of a roof over a quad mesh:
      {\"cyclide\": 1, \"units\": \"m\", \"objects\": {
        \"outer\": {\"type\": \"cyclidic-net\", \"grid\": {\"obj\": \"roof.obj\"}, \"make_circular\": true},
        \"inner\": {\"type\": \"offset\", \"of\": \"outer\", \"distance\": -0.3}}}";

const REPORT_EXAMPLES: &str = "\
Examples:
  cyclide report logo.json
  cyclide report logo.json --json | jq '.objects[].length'
  cyclide report track.json --min-radius 12
  cyclide report gripper.json --max-speed 500 --max-angular-speed 3
  cyclide report roof.json --json | jq '.objects[].circular.move_max'

docs/report.md explains every term of the report, which values are good and how to improve the others; the fields of --json are in
docs/formats.md.";

const GALLERY_EXAMPLES: &str = "\
Example:
  cyclide gallery -o gallery

Each model comes with its document, which you can edit and build again: cyclide build gallery/patch.json -o new.step";

const SCHEMA_EXAMPLES: &str = "\
Example:
  cyclide schema > cyclide-1.schema.json";

const HELP_EXAMPLES: &str = "\
Examples:
  cyclide help build       the options of a command
  cyclide help pipe-tee    the fields of a kind of object, and a starter document
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
    #[command(after_help = curve::EXAMPLES)]
    Curve(Box<CurveArgs>),
    /// Compare all kinds of curve through or near the same points.
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
    /// Print a commented starter document for any type of object.
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
    /// The type of object; if omitted, the types are listed.
    #[arg(value_parser = crate::arguments::starters::kinds())]
    pub kind: Option<String>,
    /// Write to a new file instead of standard output; an existing file is never overwritten.
    #[arg(short, long, value_name = "FILE", requires = "kind")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, ClapArgs)]
pub struct HelpArgs {
    /// A command, a kind of object, or 'kinds' for a list of kinds; if omitted, the help of the program.
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
    /// The folder for the pages, created if it does not exist.
    #[arg(short, long = "output", value_name = "DIR")]
    pub output: PathBuf,
    #[command(flatten)]
    pub write: WriteArgs,
}

#[derive(Debug, ClapArgs)]
pub struct BuildArgs {
    /// The model document (JSON), or - for standard input; 'cyclide new' prints one to start from.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    /// Largest distance between the object and its curve or mesh in a file, if the format requires an approximation
    /// [default: 1e-5 of the model's size for curves, 1e-4 for meshes].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
}

#[derive(Debug, ClapArgs)]
pub struct ReportArgs {
    /// The model document (JSON), or - for standard input; 'cyclide new' prints one to start from.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    /// Print the report as JSON.
    #[arg(long)]
    pub json: bool,
    /// Report where the radius of a curve is below R.
    #[arg(long, value_name = "R", value_parser = positive, allow_hyphen_values = true)]
    pub min_radius: Option<f64>,
    /// Report when the tool of a motion is faster than V, in units of length per second.
    #[arg(long, value_name = "V", value_parser = positive, allow_hyphen_values = true)]
    pub max_speed: Option<f64>,
    /// Report when the body of a motion rotates faster than W, in radians per second.
    #[arg(long, value_name = "W", value_parser = positive, allow_hyphen_values = true)]
    pub max_angular_speed: Option<f64>,
}

#[derive(Debug, ClapArgs)]
pub struct GalleryArgs {
    /// The folder for the files, created if it does not exist. The page is index.html.
    #[arg(short, long = "output", value_name = "DIR")]
    pub output: PathBuf,
    #[command(flatten)]
    pub write: WriteArgs,
}
