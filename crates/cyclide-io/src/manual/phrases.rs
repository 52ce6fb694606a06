//! Types of the schema in words.

use serde_json::Value;

/// A count of what a list holds, or the range of a number: numbers as the schema writes them.
fn bound(schema: &Value, key: &str) -> Option<String> {
    schema.get(key).filter(|value| value.is_number()).map(plain)
}

/// A value as people write it: whole numbers without a point.
pub(super) fn plain(value: &Value) -> String {
    let text = value.to_string();
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// A type in words; `named` says what a reference is called.
pub(super) fn type_words(schema: &Value, named: &dyn Fn(&str) -> Vec<String>) -> String {
    either(&choices(schema, named), ", ", " or ")
}

/// The types in words one of which a value has; `named` says them of a reference.
pub(super) fn choices(schema: &Value, named: &dyn Fn(&str) -> Vec<String>) -> Vec<String> {
    if let Some(target) = reference(schema) {
        return named(target);
    }
    if let Some(word) = schema.get("const") {
        return vec![format!("`{word}`")];
    }
    if let Some(cases) = cases(schema) {
        let mut words: Vec<String> = Vec::new();
        for word in cases.iter().flat_map(|case| choices(case, named)) {
            if !words.contains(&word) {
                words.push(word);
            }
        }
        return words;
    }
    let word = match schema.get("type").and_then(Value::as_str).unwrap_or_default() {
        "number" => "number".to_owned() + &range(schema),
        "integer" => "whole number".to_owned() + &range(schema),
        "boolean" => return ["`true`", "`false`"].map(str::to_owned).to_vec(),
        "string" => if is_name(schema) { "name of an object" } else { "text" }.to_owned(),
        "array" => list(schema, named),
        "object" => "object".to_owned(),
        _ => "value".to_owned(),
    };
    vec![word]
}

/// The target of a reference to a definition.
pub(super) fn reference(schema: &Value) -> Option<&str> {
    schema.get("$ref")?.as_str()?.strip_prefix("#/$defs/")
}

/// The cases of a choice. A choice among forms of the same object is none: its fields are one list.
pub(super) fn cases(schema: &Value) -> Option<&Vec<Value>> {
    let cases = schema.get("anyOf").or_else(|| schema.get("oneOf"))?.as_array()?;
    schema.get("properties").is_none().then_some(cases)
}

/// Things one of which is meant: `a`, `a or b`, `a, b or c`.
pub(super) fn either(words: &[String], comma: &str, last: &str) -> String {
    match words {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., end] => format!("{}{last}{end}", first.join(comma)),
    }
}

/// True of texts that name another object of the document: their descriptions say so.
fn is_name(schema: &Value) -> bool {
    let said = schema.get("description").and_then(Value::as_str).unwrap_or_default();
    ["Name of ", "Names of ", "The name of a"].iter().any(|start| said.starts_with(start))
}

/// The range of a number, as the end of its type.
fn range(schema: &Value) -> String {
    let least = bound(schema, "minimum").map(|from| (from, "at least"));
    let least = least.or_else(|| bound(schema, "exclusiveMinimum").map(|from| (from, "above")));
    let most = bound(schema, "maximum").map(|to| (to, "at most"));
    let most = most.or_else(|| bound(schema, "exclusiveMaximum").map(|to| (to, "below")));
    match (least, most) {
        (Some((from, "at least")), Some((to, "at most"))) => format!(" from {from} to {to}"),
        (Some((from, how)), Some((to, other))) => format!(" {how} {from} and {other} {to}"),
        (Some((limit, how)), None) | (None, Some((limit, how))) => format!(" {how} {limit}"),
        (None, None) => String::new(),
    }
}

fn list(schema: &Value, named: &dyn Fn(&str) -> Vec<String>) -> String {
    let of_names = is_name(schema).then(|| "names of objects".to_owned());
    let items =
        of_names.unwrap_or_else(|| match choices(schema.get("items").unwrap_or(&Value::Null), named).as_slice() {
            [one] => plural(one),
            several => format!("values, each {}", either(several, ", ", " or ")),
        });
    match (bound(schema, "minItems"), bound(schema, "maxItems")) {
        (Some(least), Some(most)) if least == most => format!("list of {least} {items}"),
        (Some(least), Some(most)) => format!("list of {least} to {most} {items}"),
        (Some(least), None) if least != "0" => format!("list of {least} or more {items}"),
        (None, Some(most)) => format!("list of at most {most} {items}"),
        _ => format!("list of {items}"),
    }
}

/// Several of a type: its noun with an s. Code, as `[x, y, z]`, stays as it is.
fn plural(words: &str) -> String {
    const NOUNS: [&str; 5] = ["whole number", "number", "list", "text", "object"];
    match NOUNS.iter().find_map(|noun| Some((noun, words.strip_prefix(noun)?))) {
        Some((noun, rest)) => format!("{noun}s{rest}"),
        None if words.ends_with(['`', 's']) => words.to_owned(),
        None => format!("{words}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn words(schema: &Value) -> String {
        type_words(schema, &|target| vec![target.to_lowercase()])
    }

    #[test]
    fn types_are_said_in_words() {
        for (schema, expected) in [
            (json!({"type": "number", "exclusiveMinimum": 0}), "number above 0"),
            (json!({"type": "integer", "minimum": 1, "maximum": 25.0}), "whole number from 1 to 25"),
            (json!({"type": "number", "minimum": 0, "exclusiveMaximum": 0.5}), "number at least 0 and below 0.5"),
            (json!({"type": "string", "description": "Name of the path."}), "name of an object"),
            (json!({"type": "string", "description": "Path of a file."}), "text"),
            (json!({"type": "array", "items": {"$ref": "#/$defs/Ball"}, "minItems": 2}), "list of 2 or more balls"),
            (
                json!({"type": "array", "items": {"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4}}),
                "list of lists of 4 numbers",
            ),
            (json!({"oneOf": [{"const": "a"}, {"const": "b"}, {"const": "c"}]}), "`\"a\"`, `\"b\"` or `\"c\"`"),
            (json!({"anyOf": [{"type": "number"}, {"type": "object"}]}), "number or object"),
            (json!({"anyOf": [{"type": "boolean"}, {"type": "object"}]}), "`true`, `false` or object"),
            (json!({"type": "array", "items": {"type": "boolean"}}), "list of values, each `true` or `false`"),
            (json!({"type": "array", "items": {"type": "integer", "minimum": 0}}), "list of whole numbers at least 0"),
        ] {
            assert_eq!(words(&schema), expected, "{schema}");
        }
    }
}
