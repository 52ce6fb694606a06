//! `schedule`: the nets of a model as a workshop's lists, all files or none.

use std::io;

use cyclide_io::{
    schedule::{ScheduleError, WorkshopSchedule},
    text::did_you_mean,
};

use crate::arguments::schedule::SchedulePlan;
use crate::commands::load::{self, Inputs};
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::progress::Progress;
use crate::output::terminal;

/// Steps after the objects are built: measuring, and writing.
const STEPS: usize = 2;

/// Carries the plan out.
pub fn run(plan: &SchedulePlan) -> Result<(), Failure> {
    // Said before the work is done.
    if plan.folder.exists() && !plan.folder.is_dir() {
        return Err(Failure::write(plan.folder.display(), &io::ErrorKind::NotADirectory.into()));
    }
    let inputs = Inputs::below(plan.read_below.as_deref())?;
    let (document, folder) = load::document(&plan.input, &inputs)?;
    for name in &plan.options.objects {
        let names = || document.objects.iter().map(|(name, _)| name.as_str());
        if !names().any(|known| known == name) {
            let hint = did_you_mean(name, names());
            return Err(Failure::Usage(format!("--object: the model has no object '{name}'{hint}")));
        }
    }
    let progress = Progress::new(document.objects.len() + STEPS);
    let loaded = load::build(&document, &folder, &inputs, &progress)?;
    progress.doing("measuring".to_owned());
    let schedule = WorkshopSchedule::new(loaded.units, &loaded.objects, &plan.options).map_err(failure)?;
    progress.done();
    progress.doing("writing and checking lists and drawings".to_owned());
    let files = schedule.files().map_err(failure)?;
    drop(progress);
    let asked = &plan.options.objects;
    for left in schedule.not_scheduled().iter().filter(|left| asked.is_empty() || asked.contains(&left.name)) {
        terminal::note(&format!("{} ({}) is not scheduled: {}", left.name, left.r#type, left.why));
    }
    for net in schedule.listed_apart() {
        let offsets = net.offsets.join("`, `");
        terminal::note(&format!(
            "`{offsets}` are offsets of `{of}`: each is listed as a skin of its own. If one is the other side of the panels of `{of}`, \
             use --object {of} with its distance as --thickness",
            of = net.of
        ));
    }
    if !schedule.has_beams() {
        terminal::note("beams.csv and beams.dxf are empty: set the depth of the beams with --beam-depth");
    }
    let names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
    let text = format!("{}{}: {}\n", schedule.text(), plan.folder.display(), names.join(", "));
    files::write_folder(&plan.folder, &files, plan.write, &text)
}

fn failure(error: ScheduleError) -> Failure {
    match error {
        ScheduleError::Check { .. } => Failure::Check(error.to_string()),
        other => Failure::Refused(other.to_string()),
    }
}
