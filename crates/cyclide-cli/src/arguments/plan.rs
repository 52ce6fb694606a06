//! From arguments as typed to a plan that makes sense: formats known, options that fit together, defaults filled in.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use clap_complete::Shell;
use cyclide_io::{
    ExportOptions, Format,
    file::{WriteOptions, same_file},
    report::SpeedLimits,
};

use crate::arguments::args::{
    Args, BuildArgs, Command, CompletionsArgs, GalleryArgs, HelpArgs, ManArgs, NewArgs, ReportArgs,
};
use crate::arguments::compare::ComparePlan;
use crate::arguments::curve::{CurveArgs, Kind};
use crate::arguments::effect;
use crate::arguments::files::{Input, refuse_file_name, refuse_folder_name, refuse_other_suffix, refuse_overwriting};
use crate::arguments::make::{MakePlan, OutputArgs};
use crate::arguments::mistaken::{Wanted, refuse_suffix};
use crate::arguments::sample::{SampleArgs, SamplePlan};
use crate::arguments::schedule::{ScheduleArgs, SchedulePlan};
use crate::output::failure::Failure;
use crate::output::standard::is_standard_output;

/// What to do.
pub enum Plan {
    Make(MakePlan),
    Compare(ComparePlan),
    Sample(SamplePlan),
    Schedule(SchedulePlan),
    Report(ReportPlan),
    New(NewPlan),
    Gallery(GalleryPlan),
    Schema,
    Completions(Shell),
    /// The manual pages, into a folder.
    Man(PathBuf, WriteOptions),
    /// The help of a command or kind of object, or of the program.
    Help(Option<String>),
}

/// A document to start from.
pub struct NewPlan {
    /// The type of object; `None` for a list of the types.
    pub kind: Option<String>,
    pub output: Option<PathBuf>,
}

/// Report on a model.
pub struct ReportPlan {
    pub input: Input,
    pub read_below: Option<PathBuf>,
    pub json: bool,
    /// Parts of curves tighter than this are reported.
    pub min_radius: Option<f64>,
    /// Intervals in which motions are faster than this are reported.
    pub limits: SpeedLimits,
}

/// Build the gallery.
pub struct GalleryPlan {
    pub folder: PathBuf,
    pub write: WriteOptions,
}

impl Args {
    /// The plan for what was typed.
    pub fn plan(self) -> Result<Plan, Failure> {
        match &self.command {
            Command::Build(BuildArgs { model: path, .. })
            | Command::Sample(SampleArgs { model: path, .. })
            | Command::Schedule(ScheduleArgs { model: path, .. })
            | Command::Report(ReportArgs { model: path, .. }) => {
                refuse_suffix(path, Wanted::Document)?;
            }
            Command::Curve(args) => refuse_suffix(&args.points, Wanted::Points)?,
            Command::Compare(args) => refuse_suffix(&args.points, Wanted::Points)?,
            Command::New(_)
            | Command::Gallery(_)
            | Command::Schema
            | Command::Completions(_)
            | Command::Man(_)
            | Command::Help(_) => {}
        }
        match self.command {
            Command::Build(BuildArgs { model, read, output, tolerance }) => {
                let plan = output.plan(Input::File(model), tolerance)?;
                Ok(Plan::Make(MakePlan { read_below: read.read_below, ..plan }))
            }
            Command::Curve(args) => args.plan().map(Plan::Make),
            Command::Compare(args) => args.plan().map(Plan::Compare),
            Command::Schedule(args) => args.plan().map(Plan::Schedule),
            Command::Sample(args) => args.plan().map(Plan::Sample),
            Command::Report(ReportArgs { model, read, json, min_radius, max_speed, max_angular_speed }) => {
                let limits = SpeedLimits { speed: max_speed, angular_speed: max_angular_speed };
                let (input, read_below) = (Input::File(model), read.read_below);
                Ok(Plan::Report(ReportPlan { input, read_below, json, min_radius, limits }))
            }
            Command::New(NewArgs { kind, output }) => {
                let output = output.filter(|path| !is_standard_output(path));
                output.as_deref().map_or(Ok(()), refuse_folder_name)?;
                output.as_deref().map_or(Ok(()), |path| refuse_other_suffix(path, "json", "documents are JSON"))?;
                Ok(Plan::New(NewPlan { kind, output }))
            }
            Command::Gallery(GalleryArgs { output, write }) => {
                refuse_file_name(&output)?;
                Ok(Plan::Gallery(GalleryPlan { folder: output, write: write.options() }))
            }
            Command::Schema => Ok(Plan::Schema),
            Command::Help(HelpArgs { word }) => Ok(Plan::Help(word)),
            Command::Completions(CompletionsArgs { shell }) => Ok(Plan::Completions(shell)),
            Command::Man(ManArgs { output, write }) => {
                refuse_file_name(&output)?;
                Ok(Plan::Man(output, write.options()))
            }
        }
    }
}

impl OutputArgs {
    fn plan(self, input: Input, tolerance: Option<f64>) -> Result<MakePlan, Failure> {
        let mut outputs: Vec<(PathBuf, Format)> = Vec::new();
        if self.output.len() > 1 && self.output.iter().any(|path| is_standard_output(path)) {
            return Err(Failure::Usage("standard output takes one file: `-o -` must be the only output".to_owned()));
        }
        if self.per_object && self.output.iter().any(|path| is_standard_output(path)) {
            return Err(Failure::Usage(
                "--per-object writes several files, but standard output takes only one".to_owned(),
            ));
        }
        for path in &self.output {
            refuse_folder_name(path)?;
            let format = format_of(path, self.format)?;
            if let Some((other, _)) = outputs.iter().find(|(other, _)| same_file(other, path)) {
                let (path, other) = (path.display(), other.display());
                return Err(Failure::Usage(format!("output {path} is given twice: it is the same file as {other}")));
            }
            if let Input::File(model) = &input {
                refuse_overwriting(Some(path), model)?;
            }
            outputs.push((path.clone(), format));
        }
        effect::refuse_formats_not_written(&self, &outputs)?;
        let options = ExportOptions {
            tolerance,
            max_pieces: self.max_pieces.map(|n| usize::try_from(n).unwrap_or(usize::MAX)),
            dxf_splines: self.dxf_splines,
            dxf_version: self.dxf_version.unwrap_or_default(),
            step_edges: self.step_edges.unwrap_or_default(),
            step_faces: self.step_faces.unwrap_or_default(),
            step_products: self.step_products.unwrap_or_default(),
            glb_edges: self.glb_edges,
            svg_comb: self.svg_comb,
            svg_points: self.svg_points,
            vtu_cells: self.vtu_cells.unwrap_or_default(),
            vtu_encoding: self.vtu_encoding.unwrap_or_default(),
            png_plain: self.png_plain,
            png_width: self.width,
            png_height: self.height,
            png_axes: self.axes,
            png_colour: self.colour.unwrap_or_default(),
            png_labels: self.labels,
            camera: self.camera,
            title: self.title,
        };
        let write = self.write.options();
        Ok(MakePlan {
            input,
            read_below: None,
            outputs,
            per_object: self.per_object,
            options,
            write,
            fit_tolerance: false,
            kind_by_default: false,
            json: self.json,
            min_radius: self.min_radius,
        })
    }
}

/// The format of an output: that of its suffix, otherwise the given one.
fn format_of(path: &Path, told: Option<Format>) -> Result<Format, Failure> {
    match (Format::from_path(path), told) {
        (Ok(format), Some(told)) if format != told => {
            let (name, told) = (format.name(), told.name());
            Err(Failure::Usage(format!("{}: the suffix means {name}, but --format is {told}", path.display())))
        }
        (Ok(format), _) | (Err(_), Some(format)) => Ok(format),
        (Err(_), None) if is_standard_output(path) => {
            let names = Format::ALL.iter().map(|format| format.name()).collect::<Vec<_>>().join(", ");
            Err(Failure::Usage(format!("-o {} needs --format: one of {names}", path.display())))
        }
        (Err(error), None) => Err(Failure::Usage(error.to_string())),
    }
}

impl CurveArgs {
    fn plan(self) -> Result<MakePlan, Failure> {
        let kind_by_default = self.kind.is_none() && self.smooth.is_none();
        let kind = self.kind.unwrap_or(if self.smooth.is_some() { Kind::FairFit } else { Kind::default() });
        effect::refuse_options_of_other_kinds(&self, kind)?;
        let stem = self.points.file_stem().and_then(OsStr::to_str);
        let name = stem.filter(|s| !s.trim().is_empty() && *s != "-").unwrap_or("curve");
        let spec = self.spec(kind, self.table.source(&self.points)?)?;
        for path in &self.output.output {
            refuse_overwriting(Some(path), &self.points)?;
        }
        let input = self.table.input(&self.points, (name.to_owned(), spec));
        let plan = self.output.plan(input, self.tolerance)?;
        Ok(MakePlan { fit_tolerance: kind == Kind::ArcFit, kind_by_default, ..plan })
    }
}
