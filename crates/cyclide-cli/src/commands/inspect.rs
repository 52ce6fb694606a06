//! `report` and `schema`: looking at a model without writing exchange files.

use cyclide_io::{
    Report,
    document::{NO_EFFECT, document_schema},
    report::{FASTER_THAN_LIMIT, GeometryReport, SpeedLimits},
};

use crate::arguments::plan::ReportPlan;
use crate::commands::load::{self, Inputs, Loaded};
use crate::commands::make::{self, report_text};
use crate::output::failure::Failure;
use crate::output::progress::Progress;
use crate::output::terminal;

/// Reports on the objects of a model.
pub fn report(plan: &ReportPlan) -> Result<(), Failure> {
    let inputs = Inputs::below(plan.read_below.as_deref())?;
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let progress = Progress::new(document.objects.len());
    let loaded = load::build(&document, &folder, &inputs, &progress)?;
    progress.doing("measuring".to_owned());
    let report = make::with_tight_places(Report::new(loaded.units, &loaded.objects, None), &loaded, plan.min_radius)?;
    let report = with_fast_places(report, &loaded, plan.limits);
    drop(progress);
    terminal::print(&report_text(&report, plan.json)?)
}

/// The report with the places that are faster than limits, if some were given; they are warned of.
fn with_fast_places(report: Report, loaded: &Loaded, limits: SpeedLimits) -> Report {
    if limits == SpeedLimits::default() {
        return report;
    }
    let report = report.with_speed_limits(&loaded.objects, limits);
    if !report.objects.values().any(|object| matches!(object.geometry, GeometryReport::Motion(_))) {
        let options = [("--max-speed", limits.speed), ("--max-angular-speed", limits.angular_speed)];
        for (option, _) in options.into_iter().filter(|(_, limit)| limit.is_some()) {
            terminal::warning(&format!("{option} has no effect: there are no motions [{NO_EFFECT}]"));
        }
    }
    for (name, object) in &report.objects {
        let count = object.warnings.iter().filter(|warning| warning.reason == FASTER_THAN_LIMIT).count();
        if count > 0 {
            let places = if count == 1 { "1 interval is".to_owned() } else { format!("{count} intervals are") };
            let message = format!("{name}: {places} faster than the given limits; see the report");
            terminal::warning(&format!("{message} [{FASTER_THAN_LIMIT}]"));
        }
    }
    report
}

/// Prints the schema of the model document.
pub fn schema() -> Result<(), Failure> {
    terminal::print(&document_schema())
}
