//! Angles of a document: a number is radians, degrees say so.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, MapAccess, Visitor};

/// An angle as it is written: `1.5708` or `{"degrees": 90}`.
///
/// ```
/// use cyclide_io::Angle;
/// assert_eq!(Angle::Degrees(180.0).radians(), Angle::Radians(std::f64::consts::PI).radians());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Angle {
    /// A number alone.
    Radians(f64),
    /// With the word.
    Degrees(f64),
}

impl Angle {
    /// In radians.
    #[must_use]
    pub fn radians(self) -> f64 {
        match self {
            Self::Radians(angle) => angle,
            Self::Degrees(angle) => angle.to_radians(),
        }
    }

    /// In radians, for a turn: whole turns in degrees are left out before they are converted, which is exact.
    #[must_use]
    pub fn turn(self) -> f64 {
        match self {
            Self::Radians(angle) => angle,
            Self::Degrees(angle) => (angle % 360.0).to_radians(),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InDegrees {
    degrees: f64,
}

impl<'de> Deserialize<'de> for Angle {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AngleVisitor;
        impl<'de> Visitor<'de> for AngleVisitor {
            type Value = Angle;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number of radians, or `{\"degrees\": 90}`")
            }
            fn visit_f64<E>(self, angle: f64) -> Result<Angle, E> {
                Ok(Angle::Radians(angle))
            }
            fn visit_i64<E>(self, angle: i64) -> Result<Angle, E> {
                Ok(Angle::Radians(angle as f64))
            }
            fn visit_u64<E>(self, angle: u64) -> Result<Angle, E> {
                Ok(Angle::Radians(angle as f64))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Angle, A::Error> {
                InDegrees::deserialize(MapAccessDeserializer::new(map)).map(|angle| Angle::Degrees(angle.degrees))
            }
        }
        deserializer.deserialize_any(AngleVisitor)
    }
}

impl JsonSchema for Angle {
    fn schema_name() -> Cow<'static, str> {
        "Angle".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An angle: a number of radians, or degrees with their name.",
            "anyOf": [
                { "type": "number" },
                {
                    "type": "object",
                    "properties": { "degrees": { "type": "number", "description": "The angle in degrees." } },
                    "required": ["degrees"],
                    "additionalProperties": false
                }
            ]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_radians_and_degrees_say_so() {
        let parse = |text: &str| serde_json::from_str::<Angle>(text).map_err(|e| e.to_string());
        assert_eq!(parse("1.5"), Ok(Angle::Radians(1.5)));
        assert_eq!(parse("-2"), Ok(Angle::Radians(-2.0)));
        assert_eq!(parse("{\"degrees\": 90}").map(Angle::radians), Ok(std::f64::consts::FRAC_PI_2));
        let turns = [360e9 + 90.0, -450.0].map(|degrees| Angle::Degrees(degrees).turn().to_bits());
        assert_eq!(turns, [90.0_f64, -90.0].map(|degrees| degrees.to_radians().to_bits()));
        for (text, message) in [
            ("\"90deg\"", "expected a number of radians, or `{\"degrees\": 90}`"),
            ("[90]", "expected a number of radians"),
            ("{\"radians\": 1}", "unknown field `radians`, expected `degrees`"),
            ("{}", "missing field `degrees`"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
