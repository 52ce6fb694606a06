//! The materials of a GLB file: the colors of the pictures.

use crate::check::read_error::ReadError;
use crate::drawing::palette;
use cyclide::model::Item;
use serde_json::{Value, json};
use std::fmt;

/// The extension for lines.
pub(super) const UNLIT: &str = "KHR_materials_unlit";
/// How much surfaces scatter light.
const ROUGHNESS: f64 = 0.45;

/// A material.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Look {
    name: String,
    /// Red, green and blue of a screen. Factors that are the same there look the same.
    colour: u32,
    /// Lines have their color alone; surfaces are lit from both sides.
    unlit: bool,
}

/// What messages say of it.
impl fmt::Display for Look {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, #{:06X}{}", self.name, self.colour, if self.unlit { ", unlit" } else { "" })
    }
}

impl Look {
    /// That of an object's surfaces, by its number in the model.
    pub(super) fn surface(item: &Item, index: usize) -> Self {
        Self { name: item.name.clone(), colour: palette::surface_on_screen(index), unlit: false }
    }

    /// That of an object's curves and of the edges of its patches.
    pub(super) fn line(item: &Item, index: usize) -> Self {
        Self { name: format!("{} lines", item.name), colour: palette::object(index), unlit: true }
    }

    /// That of an axis of a body in motion: red, green, blue.
    pub(super) fn axis(item: &Item, axis: usize) -> Self {
        let (letter, colour) = [("x", 0xD0_2C_2C), ("y", 0x2C_9A_3C), ("z", 0x2C_5C_D0)][axis];
        Self { name: format!("{} {letter}", item.name), colour, unlit: true }
    }

    pub(super) fn is_unlit(&self) -> bool {
        self.unlit
    }

    pub(super) fn to_json(&self) -> Value {
        let [red, green, blue] = palette::to_linear(self.colour);
        let colour = json!([red, green, blue, 1.0]);
        let mut material = json!({
            "name": self.name,
            "pbrMetallicRoughness": {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": ROUGHNESS},
        });
        if self.unlit {
            material["extensions"] = json!({UNLIT: {}});
        } else {
            material["doubleSided"] = json!(true);
        }
        material
    }

    /// The material of an entry of the file.
    pub(super) fn read(entry: &Value) -> Result<Self, ReadError> {
        let factors = entry.pointer("/pbrMetallicRoughness/baseColorFactor").and_then(Value::as_array);
        let factors: Option<Vec<f64>> = factors.and_then(|list| list.iter().map(Value::as_f64).collect());
        let Some([red, green, blue, _]) = factors.as_deref() else {
            return Err(ReadError::syntax("materials", "expected a color of four factors"));
        };
        let name = entry.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
        let unlit = entry.get("extensions").is_some();
        let look = Self { name, colour: palette::on_screen([*red, *green, *blue]), unlit };
        // Everything but the color is the same in all of ours.
        let mut expected = look.to_json();
        expected["pbrMetallicRoughness"]["baseColorFactor"] = json!([red, green, blue, 1.0]);
        if expected == *entry {
            Ok(look)
        } else {
            Err(ReadError::unsupported("an unexpected kind of material", "materials"))
        }
    }
}
