//! Words of options that are enums of the kernel, of documents and of the writers: read as documents read them, and explained as their
//! schema does. There is no second list of them.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use schemars::{JsonSchema, SchemaGenerator};
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Reads a word as the enum that it is in a document.
pub fn word<T: DeserializeOwned + JsonSchema + Clone + Send + Sync + 'static>() -> impl TypedValueParser<Value = T> {
    let schema = T::json_schema(&mut SchemaGenerator::default());
    let variants = schema.get("oneOf").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let words: Vec<PossibleValue> = variants.iter().filter_map(possible_value).collect();
    PossibleValuesParser::new(words).try_map(|word| serde_json::from_value(Value::String(word)))
}

/// A variant of the schema, with its first paragraph as one line and without marks.
fn possible_value(variant: &Value) -> Option<PossibleValue> {
    let said = variant["description"].as_str().unwrap_or_default().replace('`', "");
    let said = said.split("\n\n").next().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ");
    Some(PossibleValue::new(variant["const"].as_str()?.to_owned()).help(said.trim_end_matches('.').to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{
        construct::{BiarcRule, Effort, FitTarget},
        curve::BlendVariant,
        model::Units,
    };
    use cyclide_io::{
        document::kinds::{FairEndWord, MoebiusContinuity, StraightWord},
        export::{DxfVersion, PictureColour, StepEdges, StepFaces, StepProducts, VtuCells, VtuEncoding},
    };

    /// The words of an enum, each read back and explained.
    fn words<T: DeserializeOwned + JsonSchema + Clone + Send + Sync + 'static>() -> Vec<String> {
        let parser = word::<T>();
        let values = parser.possible_values().into_iter().flatten();
        let explained = values.inspect(|value| assert!(value.get_help().is_some(), "{value:?}"));
        explained.map(|value| value.get_name().to_owned()).collect()
    }

    #[test]
    fn options_have_the_words_of_documents() {
        assert_eq!(words::<Units>(), ["mm", "cm", "m", "in", "ft", "us-ft"]);
        assert_eq!(words::<BlendVariant>(), ["rational", "trigonometric"]);
        assert_eq!(words::<MoebiusContinuity>(), ["c1", "g1"]);
        assert_eq!(words::<BiarcRule>(), ["equal-d", "equal-chord", "auto"]);
        assert_eq!(words::<FitTarget>(), ["points", "polyline"]);
        assert_eq!(words::<Effort>(), ["fast", "default", "best"]);
        assert_eq!(words::<FairEndWord>(), ["circle", "arc", "free"]);
        assert_eq!(words::<StraightWord>(), ["auto", "off"]);
        assert_eq!(words::<DxfVersion>(), ["r2000", "r12"]);
        assert_eq!(words::<StepEdges>(), ["circle", "rational"]);
        assert_eq!(words::<StepFaces>(), ["auto", "merged", "split"]);
        assert_eq!(words::<StepProducts>(), ["auto", "assembly", "one"]);
        assert_eq!(words::<VtuCells>(), ["bezier", "linear"]);
        assert_eq!(words::<PictureColour>(), ["object", "gaussian", "mean", "k1", "k2", "deviation", "field"]);
        assert_eq!(words::<VtuEncoding>(), ["ascii", "base64"]);
    }
}
