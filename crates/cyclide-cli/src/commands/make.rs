//! `build` and `curve`: all files are made and checked before the first is written.

use std::path::{Path, PathBuf};

use cyclide_io::{
    ExportOptions, Exporter, Report,
    document::NO_EFFECT,
    export::{ExportError, VtuCells},
    report::{CheckError, FileReport, GeometryReport, ObjectReport, TIGHTER_THAN_RADIUS},
    text::escaped_json,
};

use crate::arguments::effect;
use crate::arguments::files::{Input, refuse_overwriting};
use crate::arguments::make::MakePlan;
use crate::commands::load::{self, Inputs, Loaded};
use crate::commands::outline_doubt;
use crate::commands::per_object::{self, Part};
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::progress::Progress;
use crate::output::standard::{is_standard, is_standard_output};
use crate::output::terminal;

/// Carries the plan out.
pub fn run(plan: &MakePlan) -> Result<(), Failure> {
    let (loaded, progress) = load(plan)?;
    progress.doing("measuring".to_owned());
    let report = Report::new(loaded.units, &loaded.objects, plan.options.tolerance);
    let mut report = with_tight_places(report, &loaded, plan.min_radius)?;
    progress.done();
    let mut input_files = loaded.input_files.clone();
    if let Input::File(path) = &plan.input {
        input_files.push(path.clone());
    }
    let (model, provenance) = loaded.into_model();
    let mut options = plan.options.clone();
    if let (None, Input::File(path)) = (&options.title, &plan.input)
        && !is_standard(path)
    {
        // One object gives its name to the file, several have that of their document.
        let stem = || path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        options.title = if model.items.len() == 1 || plan.per_object { None } else { stem() };
    }
    // Of nothing there are no files, which is refused below.
    let mut parts = if plan.per_object && !model.items.is_empty() {
        per_object::split(model, provenance, &plan.outputs)?
    } else {
        vec![Part { model, provenance, outputs: plan.outputs.clone() }]
    };
    if plan.per_object && options.vtu_cells == VtuCells::Linear {
        let names = per_object::leave_out_plain(&mut parts, &plan.outputs);
        if !names.is_empty() {
            let names = names.join(", ");
            terminal::warning(&format!(
                "linear cells in VTU require blocks: no such file is written for {names} [{NO_EFFECT}]"
            ));
        }
    }
    let paths = parts.iter().flat_map(|part| &part.outputs).map(|(path, _)| path);
    let indices = if plan.per_object { per_object::indices(&parts, &plan.outputs) } else { Vec::new() };
    for path in paths.chain(indices.iter().map(|(path, _)| path)) {
        for input in &input_files {
            refuse_overwriting(Some(path), input)?;
        }
    }
    let mut files = Vec::new();
    for part in &parts {
        push_files(part, &options, &progress, &mut files, &mut report)?;
    }
    for (path, bytes) in indices {
        report.files.push(FileReport::of_index(&path, bytes.len()));
        files.push((path, bytes));
    }
    drop(progress);
    if plan.per_object {
        say_what_is_left(&per_object::left_from_before(&parts, &plan.outputs));
    }
    let (model, provenance) = per_object::joined(parts);
    if plan.kind_by_default {
        outline_doubt::warnings(&model).iter().for_each(|message| terminal::warning(message));
    }
    for message in effect::without_effect(plan, &model, &provenance, &report) {
        terminal::warning(&message);
    }
    let report = report_text(&report, plan.json)?;
    if let [(path, bytes)] = files.as_slice()
        && is_standard_output(path)
    {
        terminal::print_aside(&report);
        return terminal::print_bytes(bytes);
    }
    // A folder that is not there is an error here: it may be a slip.
    let is_set = plan.per_object && files.iter().all(|(path, _)| path.parent().is_some_and(Path::is_dir));
    if is_set { files::write_set(&files, plan.write, &report) } else { files::write(&files, plan.write, &report) }
}

/// Says which files of an earlier run stay beside those of the objects.
fn say_what_is_left(left: &[PathBuf]) {
    if let [first, others @ ..] = left {
        let others = match others.len() {
            0 => "belongs".to_owned(),
            1 => "and one other file belong".to_owned(),
            count => format!("and {count} other files belong"),
        };
        terminal::note(&format!("{} {others} to no object of this model and will stay", first.display()));
    }
}

/// Makes and checks the files of a model.
fn push_files(
    part: &Part,
    options: &ExportOptions,
    progress: &Progress,
    files: &mut Vec<(PathBuf, Vec<u8>)>,
    report: &mut Report,
) -> Result<(), Failure> {
    let mut exporter = None;
    for (path, format) in &part.outputs {
        progress.doing(path.display().to_string());
        let exporter = match &mut exporter {
            Some(exporter) => exporter,
            none => {
                let formats = part.outputs.iter().map(|(_, format)| *format);
                let ready =
                    Exporter::with_provenance(&part.model, &part.provenance).map_err(|error| refused(path, &error))?;
                none.insert(ready.expecting(formats, options))
            }
        };
        let exported = exporter.export(*format, options).map_err(|error| refused(path, &error))?;
        let checked = exporter.check(path, *format, &exported);
        report.files.push(checked.map_err(|error| match error {
            CheckError::TooFewDigits { .. } => Failure::Refused(format!("{error} [too-few-digits]")),
            CheckError::BendsTooSharply { .. } => Failure::Refused(format!("{error} [bends-too-sharply]")),
            fault => Failure::Check(fault.to_string()),
        })?);
        files.push((path.clone(), exported.bytes));
        progress.done();
    }
    Ok(())
}

/// Builds the objects; the document and what was read for it are not needed any more then.
fn load(plan: &MakePlan) -> Result<(Loaded, Progress), Failure> {
    let inputs = Inputs::below(plan.read_below.as_deref())?;
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let progress = Progress::new(document.objects.len() + plan.outputs.len() + 1);
    let loaded = load::build(&document, &folder, &inputs, &progress)?;
    Ok((loaded, progress))
}

/// The report with the places that are tighter than a radius, if one was given; they are warned of.
pub fn with_tight_places(report: Report, loaded: &Loaded, radius: Option<f64>) -> Result<Report, Failure> {
    let Some(radius) = radius else { return Ok(report) };
    let report = report
        .with_min_radius(&loaded.objects, radius)
        .map_err(|error| Failure::Refused(format!("--min-radius: {error} [{}]", error.reason())))?;
    let has_curves = |object: &ObjectReport| matches!(object.geometry, GeometryReport::Curves(_));
    if !report.objects.values().any(has_curves) {
        terminal::warning(&format!("--min-radius has no effect: there are no curves [{NO_EFFECT}]"));
    }
    for (name, object) in &report.objects {
        let count = object.warnings.iter().filter(|warning| warning.reason == TIGHTER_THAN_RADIUS).count();
        if count > 0 {
            let places = if count == 1 { "1 place is".to_owned() } else { format!("{count} places are") };
            let message = format!("{name}: {places} tighter than radius {radius} {}; see the report", report.units);
            terminal::warning(&format!("{message} [{TIGHTER_THAN_RADIUS}]"));
        }
    }
    Ok(report)
}

/// A report as text or JSON.
pub fn report_text(report: &Report, json: bool) -> Result<String, Failure> {
    if !json {
        return Ok(report.to_string());
    }
    let text = serde_json::to_string_pretty(report).map_err(|error| Failure::Check(error.to_string()))?;
    Ok(escaped_json(&text).into_owned() + "\n")
}

fn refused(path: &Path, error: &ExportError) -> Failure {
    Failure::Refused(format!("{}: {error} [{}]", path.display(), error.reason()))
}
