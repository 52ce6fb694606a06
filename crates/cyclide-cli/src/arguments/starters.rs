//! The types of object that `new` knows, as an argument and in a list.

use clap::builder::{PossibleValue, PossibleValuesParser};
use cyclide_io::document::ObjectSpec;

/// The types of object, each with the first sentence of its document.
pub fn kinds() -> PossibleValuesParser {
    let values = ObjectSpec::TYPES.iter().map(|kind| PossibleValue::new(*kind).help(title(text(kind))));
    PossibleValuesParser::new(values.collect::<Vec<_>>())
}

/// The kinds that are asked for are known to the argument parser.
pub fn text(kind: &str) -> &'static str {
    ObjectSpec::starter(kind).unwrap_or_default()
}

/// The first line of the document's comment.
fn title(document: &str) -> String {
    let value: serde_json::Value = serde_json::from_str(document).unwrap_or_default();
    value.pointer("/comment/0").and_then(serde_json::Value::as_str).unwrap_or_default().to_owned()
}
