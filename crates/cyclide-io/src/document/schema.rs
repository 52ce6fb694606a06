//! The published schema of the model document, derived from the types that read it.

use std::collections::BTreeMap;

use cyclide::model::Units;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Value, json};

use super::kinds::ObjectSpec;
use super::kinds::fields::comment::Comment;

/// A cyclide model: named curves and surfaces made of circles. Lengths are in the document's units and are never
/// rescaled, angles are in radians or say `degrees`.
#[derive(JsonSchema)]
#[schemars(rename = "cyclide model document", deny_unknown_fields)]
#[expect(dead_code, reason = "the shape of the whole document, for the schema; parsing goes object by object")]
struct DocumentShape {
    /// Address of this schema, for editors; ignored.
    #[schemars(rename = "$schema")]
    schema: Option<String>,
    /// A comment for readers; the program ignores it.
    comment: Option<Comment>,
    /// Version of the document format.
    #[schemars(extend("const" = 1))]
    cyclide: u64,
    /// The unit of the coordinates.
    #[schemars(default)]
    units: Units,
    /// The objects by name.
    #[schemars(extend("propertyNames" = { "minLength": 1 }))]
    objects: BTreeMap<String, ObjectSpec>,
}

/// The JSON Schema (draft 2020-12) of the model document, as text.
///
/// ```
/// let schema = cyclide_io::document::document_schema();
/// assert!(schema.contains("cyclide model document"));
/// ```
#[must_use]
pub fn document_schema() -> String {
    let mut value = shape();
    tidy(&mut value);
    format!("{value:#}\n")
}

fn shape() -> Value {
    SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<DocumentShape>().to_value()
}

/// The words of the types of object that have a field, for messages.
pub(super) fn types_with_field(field: &str) -> Vec<String> {
    let shape = shape();
    let definitions = shape.get("$defs").and_then(Value::as_object).into_iter().flat_map(serde_json::Map::values);
    let with_field = definitions.filter_map(|definition| {
        let fields = definition.get("properties")?;
        fields.get(field)?;
        fields.pointer("/type/const")?.as_str().map(str::to_owned)
    });
    with_field.collect()
}

/// Takes out `null` (an optional field may be left out, not null), the number formats of the program's own types, and of
/// descriptions the line breaks within paragraphs and the examples, which are those of the library.
fn tidy(value: &mut Value) {
    match value {
        Value::Object(object) => {
            if let Some(Value::Array(types)) = object.get("type")
                && let [one, null] = types.as_slice()
                && *null == json!("null")
            {
                object["type"] = one.clone();
            }
            if let Some(Value::Array(cases)) = object.get_mut("anyOf") {
                cases.retain(|case| *case != json!({ "type": "null" }));
                if let [Value::Object(only)] = cases.as_slice() {
                    let only = only.clone();
                    object.shift_remove("anyOf");
                    // What a field says of itself is more than what its type says.
                    for (key, value) in only {
                        object.entry(key).or_insert(value);
                    }
                }
            }
            if object.get("format").is_some_and(Value::is_string) {
                object.shift_remove("format");
            }
            if let Some(Value::String(text)) = object.get_mut("description") {
                let prose = text.split("```").next().unwrap_or_default();
                let paragraphs = prose.trim_end().split("\n\n").map(|paragraph| paragraph.replace('\n', " "));
                *text = paragraphs.collect::<Vec<_>>().join("\n\n");
            }
            object.values_mut().for_each(tidy);
        }
        Value::Array(items) => items.iter_mut().for_each(tidy),
        _ => {}
    }
}
