//! `build` and `curve`: all files are made and checked, then all are written, then the report is printed.

use cyclide_io::{ExportError, FileReport, Report, export, write_files};

use crate::failure::Failure;
use crate::load;
use crate::plan::{Input, MakePlan, refuse_overwriting};
use crate::progress::Progress;
use crate::terminal;

/// Carries the plan out.
pub fn run(plan: &MakePlan) -> Result<(), Failure> {
    let (document, folder) = load::document(&plan.input)?;
    let progress = Progress::new(document.objects.len() + plan.outputs.len() + 1);
    let loaded = load::build(&document, &folder, &progress)?;
    for (path, _) in &plan.outputs {
        for input in &loaded.input_files {
            refuse_overwriting(Some(path), input)?;
        }
    }
    let model = loaded.model();
    let mut options = plan.options.clone();
    if let (None, Input::File(path)) = (&options.title, &plan.input) {
        // One object gives its name to the file, several have that of their document.
        let stem = || path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        options.title = if model.items.len() == 1 { None } else { stem() };
    }
    progress.doing("measuring".to_owned());
    let mut report = Report::new(loaded.units, &loaded.objects, plan.options.tolerance);
    progress.done();
    let mut files = Vec::with_capacity(plan.outputs.len());
    for (path, format) in &plan.outputs {
        progress.doing(path.display().to_string());
        let exported = export(&model, *format, &options).map_err(|error| refused(path, &error))?;
        let checked = FileReport::new(path, *format, &model, &exported);
        report.files.push(checked.map_err(|error| Failure::Check(error.to_string()))?);
        files.push((path, exported.bytes));
        progress.done();
    }
    drop(progress);
    write_files(&files).map_err(|(i, error)| Failure::write(files[i].0.display(), &error))?;
    print_report(&report, plan.json)
}

/// Prints a report as text or JSON.
pub fn print_report(report: &Report, json: bool) -> Result<(), Failure> {
    if !json {
        return terminal::print(&report.to_string());
    }
    let text = serde_json::to_string_pretty(report);
    terminal::print(&(text.map_err(|error| Failure::Check(error.to_string()))? + "\n"))
}

fn refused(path: &std::path::Path, error: &ExportError) -> Failure {
    Failure::Refused(format!("{}: {error} [{}]", path.display(), error.reason()))
}
