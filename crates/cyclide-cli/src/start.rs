//! `new`: a commented document to start from.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use cyclide_io::{ObjectSpec, WriteOptions};

use crate::failure::Failure;
use crate::outputs;
use crate::terminal;

/// What to print or write.
pub struct NewPlan {
    /// The type of object; `None` for a list of the types.
    pub kind: Option<String>,
    pub output: Option<PathBuf>,
}

/// The types of object, each with the first sentence of its document.
pub fn kinds() -> PossibleValuesParser {
    let values = ObjectSpec::TYPES.iter().map(|kind| PossibleValue::new(*kind).help(title(text(kind))));
    PossibleValuesParser::new(values.collect::<Vec<_>>())
}

/// Prints the document, or writes it to a file that does not exist yet; or lists the types.
pub fn run(plan: &NewPlan) -> Result<(), Failure> {
    let Some(kind) = &plan.kind else { return terminal::print(&list()) };
    let text = text(kind);
    let Some(path) = &plan.output else { return terminal::print(text) };
    if path.exists() {
        return Err(Failure::Usage(format!("{} exists: it will not be written over", path.display())));
    }
    let stem = path.file_stem().map_or_else(|| kind.clone().into(), |stem| stem.to_string_lossy());
    let (name, next) = (path.display(), Path::new(stem.as_ref()).display());
    let said = format!("{name}: made. Build it with: cyclide build {name} -o {next}.step -o {next}.png\n");
    outputs::write(&[(path, text)], WriteOptions::default(), &said)
}

/// Every type with the first sentence of its document.
fn list() -> String {
    let width = ObjectSpec::TYPES.iter().map(|kind| kind.len()).max().unwrap_or(0);
    let lines = ObjectSpec::TYPES.iter().map(|kind| format!("  {kind:width$}  {}\n", title(text(kind))));
    format!("Types of object, each with a document to start from ('cyclide new TYPE'):\n{}", lines.collect::<String>())
}

/// The kinds that are asked for are known to the argument parser.
fn text(kind: &str) -> &'static str {
    ObjectSpec::starter(kind).unwrap_or_default()
}

/// The first line of the document's comment.
fn title(document: &str) -> String {
    let value: serde_json::Value = serde_json::from_str(document).unwrap_or_default();
    value.pointer("/comment/0").and_then(serde_json::Value::as_str).unwrap_or_default().to_owned()
}
