//! Angles of a document: a number is radians, degrees say so.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::Deserializer;

use crate::document::forms::forms;

/// An angle as it is written: `1.5708` or `{"degrees": 90}`.
///
/// ```
/// use cyclide_io::document::Angle;
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

/// Three angles, each with its unit or all in degrees: `[0, 0, {"degrees": 90}]`, `{"degrees": [0, 0, 90]}`.
pub(super) struct ThreeAngles([Angle; 3]);

/// Reads the angles of a field that may be left out.
pub(super) fn three_angles<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<[Angle; 3]>, D::Error> {
    Option::<ThreeAngles>::deserialize(deserializer).map(|angles| angles.map(|ThreeAngles(angles)| angles))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AllInDegrees {
    degrees: [f64; 3],
}

forms! {
    ThreeAngles: "a list of three angles, or `{\"degrees\": [0, 0, 90]}`";
    list [Angle; 3] => ThreeAngles;
    object AllInDegrees => |all| ThreeAngles(all.degrees.map(Angle::Degrees));
}

impl JsonSchema for ThreeAngles {
    fn schema_name() -> Cow<'static, str> {
        "ThreeAngles".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Three angles: each in radians or as an object in degrees, or all three in degrees.",
            "anyOf": [
                { "type": "array", "items": generator.subschema_for::<Angle>(), "minItems": 3, "maxItems": 3 },
                {
                    "type": "object",
                    "properties": {
                        "degrees": {
                            "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3,
                            "description": "The angles in degrees."
                        }
                    },
                    "required": ["degrees"],
                    "additionalProperties": false
                }
            ]
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InDegrees {
    degrees: f64,
}

forms! {
    Angle: "a number of radians, or `{\"degrees\": 90}`";
    number f64 => Angle::Radians;
    object InDegrees => |angle| Angle::Degrees(angle.degrees);
}

impl JsonSchema for Angle {
    fn schema_name() -> Cow<'static, str> {
        "Angle".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An angle: a number in radians, or an object with the angle in degrees.",
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
        let three = |text: &str| serde_json::from_str::<ThreeAngles>(text).map(|ThreeAngles(angles)| angles);
        let all = [0.0, 45.0, 90.0].map(Angle::Degrees);
        assert_eq!(three("{\"degrees\": [0, 45, 90]}").unwrap(), all);
        assert_eq!(three("[1, {\"degrees\": 45}, 2]").unwrap(), [Angle::Radians(1.0), all[1], Angle::Radians(2.0)]);
        for (text, message) in [
            ("90", "expected a list of three angles, or `{\"degrees\": [0, 0, 90]}`"),
            ("[1, 2]", "invalid length 2, expected an array of length 3"),
            ("{\"degrees\": 90}", "invalid type: integer `90`, expected an array of length 3"),
            ("{\"radians\": [1, 2, 3]}", "unknown field `radians`"),
        ] {
            let error = three(text).unwrap_err().to_string();
            assert!(error.contains(message), "{text}: {error}");
        }
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
