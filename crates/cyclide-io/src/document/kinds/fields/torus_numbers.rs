//! Numbers of curves on a torus: pairs of angles and of rates, and what may be left free.

use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};

use crate::document::coordinates::Coordinates;

/// Pairs of longitude and meridian angle, in radians: `[[0, 0.5], …]`, `{"degrees": [[0, 30], …]}`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": {"degrees": [[0, 0], [90, 45]]}, "rates": [[1, 1], "free"]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// let angles = spec.angles.as_ref().expect("they are given");
/// assert!(angles.in_degrees && angles.pairs[1] == [std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_4]);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AnglePairs {
    /// In radians.
    pub pairs: Vec<[f64; 2]>,
    /// True if the document has them in degrees.
    pub in_degrees: bool,
}

/// The same for rates, of which any may be left free.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": {"degrees": [[0, 0], [90, 45]]}, "rates": [[1, 1], "free"]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// let rates = spec.rates.as_ref().expect("they are given");
/// assert_eq!(rates.pairs, [Some([1.0, 1.0]), None]);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RatePairs {
    /// In radians by the knots.
    pub pairs: Vec<Option<[f64; 2]>>,
    /// True if the document has them in degrees.
    pub in_degrees: bool,
}

/// A velocity, or the word `free`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "torus-spline", "torus": {"major_radius": 40, "minor_radius": 15}, "angles": [[0, 0], [1, 1]], "tangents": ["free", [0, 10, 5]]}}}"#.parse()?;
/// let cyclide_io::document::ObjectSpec::TorusSpline(spec) = &document.objects[0].1 else { unreachable!("by its type") };
/// let tangents = spec.tangents.as_ref().expect("they are given");
/// assert!(tangents[0].0.is_none() && tangents[1].0.is_some());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeOr<T>(pub Option<T>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for FreeOr<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FreeVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for FreeVisitor<T> {
            type Value = FreeOr<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of numbers, or the word `free`")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<FreeOr<T>, E> {
                if word == "free" { Ok(FreeOr(None)) } else { Err(E::unknown_variant(word, &["free"])) }
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<FreeOr<T>, A::Error> {
                T::deserialize(SeqAccessDeserializer::new(seq)).map(|given| FreeOr(Some(given)))
            }
        }
        deserializer.deserialize_any(FreeVisitor(std::marker::PhantomData))
    }
}

impl JsonSchema for FreeOr<Coordinates> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "FreeOrVelocity".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<Coordinates>();
        json_schema!({ "description": "A velocity, or the word `free`.", "anyOf": [one, { "const": "free" }] })
    }
}

/// A list of pairs as it stands, or in degrees.
struct PairsVisitor<T>(std::marker::PhantomData<T>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InDegrees<T> {
    degrees: Vec<T>,
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for PairsVisitor<T> {
    /// The pairs, and whether they are in degrees.
    type Value = (Vec<T>, bool);
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "pairs of longitude and meridian angle, `[[0, 0.5], …]` in radians or `{\"degrees\": [[0, 30], …]}`",
        )
    }
    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Self::Value, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(seq)).map(|pairs| (pairs, false))
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        InDegrees::deserialize(MapAccessDeserializer::new(map)).map(|given| (given.degrees, true))
    }
}

impl<'de> Deserialize<'de> for AnglePairs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (pairs, in_degrees) = deserializer.deserialize_any(PairsVisitor::<[f64; 2]>(std::marker::PhantomData))?;
        // Whole turns do not matter; in degrees they are left out before the conversion, which is exact.
        let within_a_turn = |pair: [f64; 2]| if in_degrees { pair.map(|angle| angle % 360.0) } else { pair };
        Ok(Self {
            pairs: pairs.into_iter().map(|pair| in_radians(within_a_turn(pair), in_degrees)).collect(),
            in_degrees,
        })
    }
}

impl<'de> Deserialize<'de> for RatePairs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let visitor = PairsVisitor::<FreeOr<[f64; 2]>>(std::marker::PhantomData);
        let (pairs, in_degrees) = deserializer.deserialize_any(visitor)?;
        let radians = |FreeOr(pair): FreeOr<[f64; 2]>| pair.map(|pair| in_radians(pair, in_degrees));
        Ok(Self { pairs: pairs.into_iter().map(radians).collect(), in_degrees })
    }
}

impl JsonSchema for AnglePairs {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "AnglePairs".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        pairs_schema("Pairs of longitude and meridian angle, in radians or as an object in degrees.", &pair_schema())
    }
}

impl JsonSchema for RatePairs {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "RatePairs".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        let pair = json_schema!({ "anyOf": [pair_schema(), { "const": "free" }] });
        pairs_schema("Pairs of rates of longitude and meridian angle, in radians or as an object in degrees.", &pair)
    }
}

/// In radians.
fn in_radians(pair: [f64; 2], in_degrees: bool) -> [f64; 2] {
    if in_degrees { pair.map(f64::to_radians) } else { pair }
}

fn pairs_schema(description: &str, pair: &Schema) -> Schema {
    let list = json_schema!({ "type": "array", "items": pair, "minItems": 1 });
    json_schema!({
        "description": description,
        "anyOf": [
            list,
            {
                "type": "object",
                "properties": { "degrees": list },
                "required": ["degrees"],
                "additionalProperties": false
            }
        ]
    })
}

fn pair_schema() -> Schema {
    json_schema!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_radians_or_say_degrees() {
        let parse = |text: &str| serde_json::from_str::<AnglePairs>(text).map_err(|e| e.to_string());
        assert_eq!(parse("[[1,2]]").map(|a| a.pairs), Ok(vec![[1.0, 2.0]]));
        let degrees = parse("{\"degrees\":[[180,-90]]}").unwrap();
        assert_eq!(degrees.pairs, [[std::f64::consts::PI, -std::f64::consts::FRAC_PI_2]]);
        assert!(degrees.in_degrees);
        let rates: RatePairs = serde_json::from_str("{\"degrees\":[[180,0],\"free\"]}").unwrap();
        assert_eq!(rates.pairs, [Some([std::f64::consts::PI, 0.0]), None]);
        for (text, message) in [
            ("[1,2]", "invalid type: integer `1`"),
            ("{\"radians\":[[1,2]]}", "unknown field `radians`, expected `degrees`"),
            ("7", "expected pairs of longitude and meridian angle"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
