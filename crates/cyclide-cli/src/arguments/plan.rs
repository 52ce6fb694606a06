//! From arguments as typed to a plan that makes sense: formats known, options that fit together, defaults filled in.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use clap_complete::Shell;
use cyclide_io::{
    Angle, Document, ExportOptions, Format, ObjectSpec, PointColumns, PointFile, PointSource, SpeedLimits,
    WriteOptions, is_folder_name,
    kinds::{
        ArcFitSpec, ArcSplineSpec, CircleSplineSpec, Comment, EndsSpec, FairEndsSpec, FairFitSpec, FairSplineSpec,
        MoebiusSplineSpec, QbInterpolationSpec, TypeWord,
    },
    leads_to_standard_input, same_file,
};

use crate::arguments::args::{
    Args, BuildArgs, Command, CompletionsArgs, CurveArgs, GalleryArgs, HelpArgs, Kind, ManArgs, NewArgs, OutputArgs,
    ReportArgs,
};
use crate::arguments::compare::ComparePlan;
use crate::arguments::effect;
use crate::arguments::mistaken::{Wanted, refuse_suffix};
use crate::arguments::sample::{SampleArgs, SamplePlan};
use crate::arguments::schedule::{ScheduleArgs, SchedulePlan};
use crate::output::failure::Failure;
use crate::output::standard::{is_standard, is_standard_output};

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
    /// The tolerance is that of an arc fit, not of the files alone.
    pub fit_tolerance: bool,
    /// No kind was given: the curve is the default one.
    pub kind_by_default: bool,
    pub json: bool,
    /// Places of curves tighter than this are named.
    pub min_radius: Option<f64>,
}

/// Where the model comes from.
pub enum Input {
    /// A model document; the name `-` is standard input.
    File(PathBuf),
    /// A document made from the command line; it refers to files by their paths as given.
    Made {
        document: Box<Document>,
        /// The columns of its file: unless they were named, the file is looked at for what it is.
        columns: PointColumns,
        /// Whether the columns' names may say the unit: not if it was told.
        unit_of_columns: bool,
    },
}

/// Report on a model.
pub struct ReportPlan {
    pub input: Input,
    pub read_below: Option<PathBuf>,
    pub json: bool,
    /// Places of curves tighter than this are named.
    pub min_radius: Option<f64>,
    /// Places of motions faster than this are named.
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
                output.as_deref().map_or(Ok(()), |path| refuse_other_suffix(path, "json", "a document is JSON"))?;
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
            return Err(Failure::Usage("standard output takes one file: `-o -` stands alone".to_owned()));
        }
        if self.per_object && self.output.iter().any(|path| is_standard_output(path)) {
            return Err(Failure::Usage("--per-object writes several files: standard output takes one".to_owned()));
        }
        for path in &self.output {
            refuse_folder_name(path)?;
            let format = format_of(path, self.format)?;
            if let Some((other, _)) = outputs.iter().find(|(other, _)| same_file(other, path)) {
                let (path, other) = (path.display(), other.display());
                return Err(Failure::Usage(format!("{path} is given twice as output: it is the same file as {other}")));
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

/// The format of an output: that of its suffix, else the one that was told.
fn format_of(path: &Path, told: Option<Format>) -> Result<Format, Failure> {
    match (Format::from_path(path), told) {
        (Ok(format), Some(told)) if format != told => {
            let (name, told) = (format.name(), told.name());
            Err(Failure::Usage(format!("{}: the suffix says {name}, --format says {told}", path.display())))
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
        let Some(csv) = self.points.to_str().map(str::to_owned) else {
            return Err(Failure::Usage(format!("{}: the path is not Unicode", self.points.display())));
        };
        let file = PointFile { csv, columns: self.columns.clone(), contour: self.contour_column.clone() };
        let spec = self.spec(kind, PointSource::File(file))?;
        let objects = vec![(name.to_owned(), spec)];
        for path in &self.output.output {
            refuse_overwriting(Some(path), &self.points)?;
        }
        let units = self.units.unwrap_or_default();
        let document = Document::from_objects(&self.points.display().to_string(), units, objects);
        let document = if self.units.is_some() { document } else { document.assuming_units() };
        let columns = PointColumns { coordinates: self.columns, contour: self.contour_column };
        let input = Input::Made { document: Box::new(document), columns, unit_of_columns: self.units.is_none() };
        let plan = self.output.plan(input, self.tolerance)?;
        Ok(MakePlan { fit_tolerance: kind == Kind::ArcFit, kind_by_default, ..plan })
    }

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

/// Refuses the suffix of a format that another command writes; names without one, and unknown ones, may be meant.
pub fn refuse_other_suffix(path: &Path, suffix: &str, what: &str) -> Result<(), Failure> {
    match Format::from_path(path) {
        Ok(format) if format.name() != suffix => {
            Err(Failure::Usage(format!("{}: {what}; for this format see 'cyclide build'", path.display())))
        }
        _ => Ok(()),
    }
}

/// Refuses the name of a folder (`out/`) where a file is meant: the separator would be dropped without a word.
pub fn refuse_folder_name(path: &Path) -> Result<(), Failure> {
    if is_folder_name(path) {
        let path = path.display();
        return Err(Failure::Usage(format!("{path} is the name of a folder: the name of a file is needed")));
    }
    Ok(())
}

/// Refuses the name of a file where a folder is meant.
pub fn refuse_file_name(path: &Path) -> Result<(), Failure> {
    let page = path.extension().is_some_and(|suffix| suffix.eq_ignore_ascii_case("html"));
    if is_standard_output(path) || !path.is_dir() && (page || Format::from_path(path).is_ok()) {
        return Err(Failure::Usage(format!("{}: the name of a folder is needed, for several files", path.display())));
    }
    Ok(())
}

/// Refuses to write over a file that is read.
pub fn refuse_overwriting(output: Option<&Path>, input: &Path) -> Result<(), Failure> {
    let is_input = |output: &&Path| {
        if is_standard(input) { leads_to_standard_input(output) } else { same_file(output, input) }
    };
    match output.filter(|output| !is_standard(output)).filter(is_input) {
        None => Ok(()),
        Some(path) => Err(Failure::Usage(format!("{} is an input: it will not be written over", path.display()))),
    }
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
