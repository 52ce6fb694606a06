//! `new`: a commented document to start from.

use std::path::Path;

use cyclide_io::{document::ObjectSpec, file::WriteOptions, manual::KindPage};

use crate::arguments::plan::NewPlan;
use crate::arguments::starters::text;
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::terminal;

/// Prints the document, or writes it to a file that does not exist yet; or lists the types.
pub fn run(plan: &NewPlan) -> Result<(), Failure> {
    let Some(kind) = &plan.kind else { return terminal::print(&list()) };
    let text = text(kind);
    let Some(path) = &plan.output else { return terminal::print_bytes(text.as_bytes()) };
    if path.exists() {
        return Err(Failure::Usage(format!("{} exists and will not be overwritten", path.display())));
    }
    let stem = path.file_stem().map_or_else(|| kind.clone().into(), |stem| stem.to_string_lossy());
    let (name, next) = (path.display(), Path::new(stem.as_ref()).display());
    let suffix = if ObjectSpec::has_exact_form(kind) { "step" } else { "glb" };
    let said = format!("{name} written. Build it with: cyclide build {name} -o {next}.{suffix} -o {next}.png\n");
    files::write(&[(path, text)], WriteOptions::default(), &said)
}

/// Every type by group, with its sentence.
fn list() -> String {
    let head = "Types of object, each with a starter document ('cyclide new TYPE') and a manual ('cyclide help TYPE').";
    format!("{head}\n\n{}", KindPage::list())
}
