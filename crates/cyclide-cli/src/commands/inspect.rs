//! `sample`, `report` and `schema`: looking at a model without writing exchange files.

use std::path::Path;

use cyclide::Body;
use cyclide_io::{Report, Spacing, did_you_mean, document_schema, sample_poses, write_file};

use crate::arguments::plan::{ReportPlan, SamplePlan, refuse_overwriting};
use crate::commands::load::{self, Inputs};
use crate::commands::make::report_text;
use crate::output::failure::Failure;
use crate::output::progress::Progress;
use crate::output::terminal;

/// Most rows that one run samples: about a gigabyte of text, which is held in memory.
const MOST_ROWS: usize = 10_000_000;

/// Samples one object.
pub fn sample(plan: &SamplePlan) -> Result<(), Failure> {
    let inputs = Inputs::default();
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let names = || document.objects.iter().map(|(name, _)| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    let index = match &plan.object {
        Some(name) => document.objects.iter().position(|(n, _)| n == name).ok_or_else(|| {
            let hint = did_you_mean(name, document.objects.iter().map(|(n, _)| n.as_str()));
            Failure::Usage(format!("the model has no object '{name}'; it has {}{hint}", names()))
        })?,
        None if document.objects.len() == 1 => 0,
        None => return Err(Failure::Usage(format!("--object is needed: the model has {}", names()))),
    };
    for input in load::input_files(&document, &folder) {
        refuse_overwriting(plan.output.as_deref(), &input)?;
    }
    let object = load::build_one(&document, &folder, index, &inputs, &Progress::new(1))?;
    let patches: usize = object.bodies.iter().flat_map(Body::shells).map(|shell| shell.faces().len()).sum();
    if patches > 0 && plan.spacing == Spacing::Length {
        return Err(Failure::Usage("--equal-length is for curves, the object is a surface".to_owned()));
    }
    let motion = object.item.motion().is_some();
    if motion && plan.spacing == Spacing::Length {
        return Err(Failure::Usage(
            "--equal-length is for curves: a motion with the law `constant-speed` is sampled so".to_owned(),
        ));
    }
    let (of_one, parts, what) = match patches {
        0 if motion => (plan.count, 1, "motion"),
        0 => (plan.count, object.item.curves().len(), "contours"),
        _ => (plan.count.saturating_mul(plan.count), patches, "patches"),
    };
    let rows = parts.saturating_mul(of_one);
    if rows > MOST_ROWS {
        let message = format!("--count {} gives {rows} rows on {parts} {what}, more than {MOST_ROWS}", plan.count);
        return Err(Failure::Usage(message));
    }
    let as_json =
        plan.output.as_deref().and_then(Path::extension).is_some_and(|suffix| suffix.eq_ignore_ascii_case("json"));
    let poses = if as_json { sample_poses(&object, plan.count) } else { None };
    let text = poses.unwrap_or_else(|| cyclide_io::sample(&object, plan.count, plan.spacing));
    match &plan.output {
        None => terminal::print(&text),
        Some(path) => {
            write_file(path, text.as_bytes(), plan.write).map_err(|error| Failure::write(path.display(), &error))
        }
    }
}

/// Reports on the objects of a model.
pub fn report(plan: &ReportPlan) -> Result<(), Failure> {
    let inputs = Inputs::default();
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let progress = Progress::new(document.objects.len());
    let loaded = load::build(&document, &folder, &inputs, &progress)?;
    progress.doing("measuring".to_owned());
    let report = Report::new(loaded.units, &loaded.objects, None);
    drop(progress);
    terminal::print(&report_text(&report, plan.json)?)
}

/// Prints the schema of the model document.
pub fn schema() -> Result<(), Failure> {
    terminal::print(&document_schema())
}
