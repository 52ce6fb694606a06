//! The unit that the names of coordinate columns speak of: its words, and what a whole file says.

use cyclide::Units;

use super::PointColumns;
use super::columns::Chosen;
use super::table::Table;
use crate::text::place::{Source, decode};

/// A unit that columns name.
///
/// ```
/// use cyclide_io::{PointColumns, unit_of_columns};
/// let found = unit_of_columns(b"x_m,y_m\n0,1\n", &PointColumns::default());
/// assert!(found.is_some_and(|found| found.unit == cyclide::Units::Metre));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnUnit {
    /// The unit.
    pub unit: Units,
    /// The names of the coordinate columns that speak of it.
    pub columns: Vec<String>,
}

/// What a word in a column's name says about its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitWord {
    /// One that models can have.
    Known(Units),
    /// A length that no model is measured in.
    Other,
}

impl UnitWord {
    /// The unit of a word in small letters: its symbol, or its name in one spelling or the other.
    pub(super) fn of(word: &str) -> Option<Self> {
        let unit = match word {
            "millimetre" | "millimetres" | "millimeter" | "millimeters" => Units::Millimetre,
            "centimetre" | "centimetres" | "centimeter" | "centimeters" => Units::Centimetre,
            "metre" | "metres" | "meter" | "meters" => Units::Metre,
            "inch" | "inches" => Units::Inch,
            "foot" | "feet" => Units::Foot,
            "nm" | "nanometre" | "nanometres" | "nanometer" | "nanometers" | "um" | "\u{b5}m" | "\u{3bc}m"
            | "micron" | "microns" | "micrometre" | "micrometres" | "micrometer" | "micrometers" | "dm"
            | "decimetre" | "decimetres" | "decimeter" | "decimeters" | "km" | "kilometre" | "kilometres"
            | "kilometer" | "kilometers" | "mil" | "mils" | "thou" | "usft" | "ftus" | "yd" | "yard" | "yards"
            | "mi" | "mile" | "miles" => return Some(Self::Other),
            symbol => Units::from_symbol(symbol)?,
        };
        Some(Self::Known(unit))
    }
}

/// The unit that the names of the coordinate columns agree on (`x_m`, `y [mm]`), from the first bytes of a file that is
/// read as [`read_points`](super::read_points) does; `None` if they speak of none, or are refused.
///
/// ```
/// use cyclide_io::{PointColumns, unit_of_columns};
/// let found = unit_of_columns(b"x_m,y_m\n0,1\n", &PointColumns::default());
/// assert!(found.is_some_and(|found| found.unit == cyclide::Units::Metre));
/// ```
#[must_use]
pub fn unit_of_columns(head: &[u8], columns: &PointColumns) -> Option<ColumnUnit> {
    // The last line may be cut in two.
    let whole = head.iter().rposition(|byte| matches!(byte, b'\n' | b'\r')).map_or(head, |end| &head[..end]);
    let source = Source { name: "", text: decode("", whole).ok()? };
    let table = Table::parse(source, columns.coordinates.as_deref().unwrap_or_default()).ok()?;
    let hints = Chosen::new(source, &table, columns).ok()?.unit_hints(&table);
    let &(_, unit) = hints.first()?;
    Some(ColumnUnit { unit, columns: hints.into_iter().map(|(name, _)| name).collect() })
}
