//! `compare`: all kinds of curve from the same points.

use std::path::{Path, PathBuf};

use clap::{ArgAction, Args as ClapArgs, ValueEnum as _};
use cyclide_io::{
    document::{
        ObjectSpec, PointSource,
        kinds::{Comment, PolylineSpec, RadiiSpec, TypeWord},
    },
    file::{WriteOptions, same_file},
};

use super::curve::{CLOSED_KINDS, CurveArgs, Kind};
use super::files::{Input, WriteArgs, refuse_folder_name, refuse_overwriting};
use super::numbers::{positive, up_to_half_a_turn};
use super::table::TableArgs;
use crate::output::failure::Failure;

pub const EXAMPLES: &str = "\
Examples:
  cyclide compare points.csv
  cyclide compare track.csv --closed -o track.html
  cyclide compare survey.csv --tolerance 0.2 --corner-angle-deg 40 -o survey.html -o survey.csv

The page is a single self-contained file: a table of measures, and for each kind of curve a drawing with its curvature comb and a plot
of its curvature. Without -o the table is printed.";

#[derive(Debug, ClapArgs)]
pub struct CompareArgs {
    /// The points (CSV, one per line: see 'cyclide curve --help'), or - for standard input.
    pub points: PathBuf,
    /// File to write: a page (.html) or a table (.csv or .json). Repeat it for several files.
    #[arg(short, long = "output", value_name = "FILE", action = ArgAction::Append)]
    pub output: Vec<PathBuf>,
    /// Close the curve from the last point to the first.
    #[arg(long)]
    pub closed: bool,
    /// Largest distance of fits from the points, and of arcs from the curves that they replace [default: a thousandth of
    /// the diagonal of the points].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
    #[command(flatten)]
    pub table: TableArgs,
    /// Turns above this angle, in degrees, are corners, for kinds that support corners [default: as in 'cyclide curve'].
    #[arg(long, value_name = "DEGREES", value_parser = up_to_half_a_turn, allow_hyphen_values = true)]
    pub corner_angle_deg: Option<f64>,
    #[command(flatten)]
    pub write: WriteArgs,
}

/// What a file of a comparison holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ComparisonFile {
    Page,
    Table,
    Json,
}

/// Compare kinds of curve.
pub struct ComparePlan {
    /// The polygon of the points.
    pub input: Input,
    pub points: PathBuf,
    pub outputs: Vec<(PathBuf, ComparisonFile)>,
    pub tolerance: Option<f64>,
    pub write: WriteOptions,
    source: PointSource,
    closed: bool,
    corner_angle_deg: Option<f64>,
}

impl CompareArgs {
    pub fn plan(self) -> Result<ComparePlan, Failure> {
        let mut outputs: Vec<(PathBuf, ComparisonFile)> = Vec::new();
        for path in &self.output {
            refuse_folder_name(path)?;
            refuse_overwriting(Some(path), &self.points)?;
            if outputs.iter().any(|(other, _)| same_file(other, path)) {
                return Err(Failure::Usage(format!("output {} is given twice", path.display())));
            }
            outputs.push((path.clone(), file_of(path)?));
        }
        let source = self.table.source(&self.points)?;
        let polygon = ObjectSpec::Polyline(PolylineSpec {
            r#type: TypeWord,
            comment: Comment,
            construction: false,
            points: source.clone(),
            closed: self.closed,
            radius: RadiiSpec::default(),
        });
        Ok(ComparePlan {
            input: self.table.input(&self.points, ("points".to_owned(), polygon)),
            points: self.points,
            outputs,
            tolerance: self.tolerance,
            write: self.write.options(),
            source,
            closed: self.closed,
            corner_angle_deg: self.corner_angle_deg,
        })
    }
}

impl ComparePlan {
    /// Every kind of `cyclide curve --kind`, with fits within the tolerance; `None` for kinds that cannot be closed if the others
    /// are.
    pub fn kinds(&self, tolerance: f64) -> Result<Vec<(String, Option<ObjectSpec>)>, Failure> {
        let args = CurveArgs {
            closed: self.closed,
            tolerance: Some(tolerance),
            smooth: Some(cyclide_io::document::kinds::FairTolerance::Within(tolerance)),
            corner_angle_deg: self.corner_angle_deg,
            ..CurveArgs::default()
        };
        let fits = |kind: &Kind| !self.closed || CLOSED_KINDS.contains(kind);
        let spec = |kind: &Kind| fits(kind).then(|| args.spec(*kind, self.source.clone())).transpose();
        let made = |kind: &Kind| Ok((kind.word().to_owned(), spec(kind)?));
        Kind::value_variants().iter().map(made).collect()
    }
}

fn file_of(path: &Path) -> Result<ComparisonFile, Failure> {
    let suffix = path.extension().map(|suffix| suffix.to_string_lossy().to_lowercase());
    match suffix.as_deref() {
        Some("html" | "htm") => Ok(ComparisonFile::Page),
        Some("csv") => Ok(ComparisonFile::Table),
        Some("json") => Ok(ComparisonFile::Json),
        _ => Err(Failure::Usage(format!("{}: a comparison is written as .html, .csv or .json", path.display()))),
    }
}
