//! `sample`, `report` and `schema`: looking at a model without writing exchange files.

use cyclide_io::{Report, document_schema, write_file};

use crate::failure::Failure;
use crate::load;
use crate::make::print_report;
use crate::plan::{ReportPlan, SamplePlan, refuse_overwriting};
use crate::progress::Progress;
use crate::terminal;

/// Samples one object.
pub fn sample(plan: &SamplePlan) -> Result<(), Failure> {
    let (mut document, folder) = load::document(&plan.input)?;
    let names = || document.objects.iter().map(|(name, _)| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    let index = match &plan.object {
        Some(name) => document
            .objects
            .iter()
            .position(|(n, _)| n == name)
            .ok_or_else(|| Failure::Usage(format!("the model has no object '{name}'; it has {}", names())))?,
        None if document.objects.len() == 1 => 0,
        None => return Err(Failure::Usage(format!("--object is needed: the model has {}", names()))),
    };
    // The other objects need not be built.
    document.objects = vec![document.objects.swap_remove(index)];
    let loaded = load::build(&document, &folder, &Progress::new(1))?;
    for input in &loaded.point_files {
        refuse_overwriting(plan.output.as_deref(), input)?;
    }
    let text = cyclide_io::sample(&loaded.objects[0].item, plan.count, plan.spacing);
    match &plan.output {
        None => terminal::print(&text),
        Some(path) => write_file(path, text.as_bytes()).map_err(|error| Failure::write(path.display(), &error)),
    }
}

/// Reports on the objects of a model.
pub fn report(plan: &ReportPlan) -> Result<(), Failure> {
    let (document, folder) = load::document(&plan.input)?;
    let progress = Progress::new(document.objects.len());
    let loaded = load::build(&document, &folder, &progress)?;
    progress.doing("measuring".to_owned());
    let report = Report::new(loaded.units, &loaded.objects, None);
    drop(progress);
    print_report(&report, plan.json)
}

/// Prints the schema of the model document.
pub fn schema() -> Result<(), Failure> {
    terminal::print(&document_schema())
}
