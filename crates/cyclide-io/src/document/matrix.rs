//! Matrices of documents: rows of four numbers, or their numbers row by row.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error as _};

use crate::document::forms::forms;

/// Reads the rows of a field that may be left out: lists of four numbers, or 12 or 16 numbers row by row.
pub(super) fn matrix_rows<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Vec<[f64; 4]>>, D::Error> {
    let Some(entries) = Option::<Vec<Entry>>::deserialize(deserializer)? else { return Ok(None) };
    let numbers: Vec<f64> = entries.iter().filter_map(|entry| entry.number()).collect();
    if numbers.is_empty() {
        return Ok(Some(entries.iter().filter_map(|entry| entry.row()).collect()));
    }
    if numbers.len() != entries.len() || ![12, 16].contains(&numbers.len()) {
        let given =
            if numbers.len() == entries.len() { format!("{} numbers", numbers.len()) } else { "both".to_owned() };
        return Err(D::Error::custom(format!(
            "a matrix requires three or four rows of four numbers, or 12 or 16 numbers row by row, not {given}"
        )));
    }
    Ok(Some(numbers.as_chunks().0.to_vec()))
}

/// A row, or a number of one.
enum Entry {
    Number(f64),
    Row([f64; 4]),
}

impl Entry {
    fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Row(_) => None,
        }
    }

    fn row(&self) -> Option<[f64; 4]> {
        match self {
            Self::Number(_) => None,
            Self::Row(row) => Some(*row),
        }
    }
}

forms! {
    Entry: "a row of four numbers, or a number";
    number f64 => Entry::Number;
    list [f64; 4] => Entry::Row;
}

/// The schema of the field.
pub(super) struct MatrixRows;

impl JsonSchema for MatrixRows {
    fn schema_name() -> Cow<'static, str> {
        "MatrixRows".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let row = || json_schema!({"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4});
        let flat = |count: u32| json_schema!({"type": "array", "items": {"type": "number"}, "minItems": count, "maxItems": count});
        json_schema!({"anyOf": [
            {"type": "array", "items": row(), "minItems": 3, "maxItems": 4},
            flat(12),
            flat(16)
        ]})
    }
}
