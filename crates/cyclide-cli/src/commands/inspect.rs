//! `report` and `schema`: looking at a model without writing exchange files.

use cyclide_io::{Report, document_schema};

use crate::arguments::plan::ReportPlan;
use crate::commands::load::{self, Inputs};
use crate::commands::make::{self, report_text};
use crate::output::failure::Failure;
use crate::output::progress::Progress;
use crate::output::terminal;

/// Reports on the objects of a model.
pub fn report(plan: &ReportPlan) -> Result<(), Failure> {
    let inputs = Inputs::default();
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let progress = Progress::new(document.objects.len());
    let loaded = load::build(&document, &folder, &inputs, &progress)?;
    progress.doing("measuring".to_owned());
    let report = make::with_tight_places(Report::new(loaded.units, &loaded.objects, None), &loaded, plan.min_radius)?;
    drop(progress);
    terminal::print(&report_text(&report, plan.json)?)
}

/// Prints the schema of the model document.
pub fn schema() -> Result<(), Failure> {
    terminal::print(&document_schema())
}
