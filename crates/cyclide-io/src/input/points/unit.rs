//! The unit that the names of coordinate columns speak of: its words, and what a whole file says.

use cyclide::Units;

use super::PointColumns;
use super::columns::Chosen;
use super::names::by_capitals;
use super::table::Table;
use crate::text::encoding::decode_table;
use crate::text::place::Source;

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
            "metre" | "metres" | "meter" | "meters" | "m\u{e8}tre" | "m\u{e8}tres" | "metro" | "metri" | "metros"
            | "\u{43c}" => Units::Metre,
            "inch" | "inches" | "zoll" | "pouce" | "pouces" | "pulgada" | "pulgadas" | "pollice" | "pollici" | "\""
            | "''" => Units::Inch,
            "foot" | "feet" | "fuss" | "fu\u{df}" | "pied" | "pieds" | "pie" | "pies" | "piede" | "piedi" => {
                Units::Foot
            }
            "usft" | "ftus" | "sft" | "usfeet" | "usfoot" | "us-foot" | "us-feet" => Units::UsSurveyFoot,
            "nm" | "nanometre" | "nanometres" | "nanometer" | "nanometers" | "um" | "\u{b5}m" | "\u{3bc}m"
            | "micron" | "microns" | "micrometre" | "micrometres" | "micrometer" | "micrometers" | "dm"
            | "decimetre" | "decimetres" | "decimeter" | "decimeters" | "km" | "kilometre" | "kilometres"
            | "kilometer" | "kilometers" | "mil" | "mils" | "thou" | "yd" | "yard" | "yards" | "mi" | "mile"
            | "miles" => return Some(Self::Other),
            symbol => Units::from_symbol(symbol)?,
        };
        Some(Self::Known(unit))
    }
}

/// The unit that positions have by convention in messages of ROS (`pose.position.x`) and records of Universal Robots (`actual_TCP_pose_0`).
pub(super) fn unit_of_convention(name: &str) -> Option<UnitWord> {
    let name = name.to_lowercase();
    let ros = name.contains("pose.position.") || name.contains("transform.translation.");
    (ros || name.contains("tcp_pose_")).then_some(UnitWord::Known(Units::Metre))
}

/// The unit a column's name speaks of: `x_m`, `x [mm]`, `x (inch)`, `x/ft`, `x (US survey feet)`, `eastUSft`.
pub(super) fn unit_in_name(name: &str) -> Option<UnitWord> {
    let mut words = name.split(['_', ' ', '[', ']', '(', ')', '/']).filter(|w| !w.is_empty());
    let words = by_capitals(words.next()?).into_iter().skip(1).chain(words);
    let words: Vec<String> = words.map(str::to_lowercase).collect();
    unit_of_words(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The unit that a text in small letters is: `m`, `us survey feet`.
pub(super) fn unit_alone(text: &str) -> Option<UnitWord> {
    let words: Vec<&str> = text.split([' ', '_']).filter(|w| !w.is_empty()).collect();
    let says_nothing_else = |word: &&str| matches!(*word, "us" | "u.s." | "survey" | "international" | "intl" | "in");
    let unit = unit_of_words(&words)?;
    words[..words.len() - 1].iter().all(says_nothing_else).then_some(unit)
}

/// The unit that the last of several words is, with those of the survey foot before it.
fn unit_of_words(words: &[&str]) -> Option<UnitWord> {
    let (last, before) = words.split_last()?;
    let of_survey = before.iter().any(|word| matches!(*word, "us" | "u.s." | "survey"));
    match UnitWord::of(last)? {
        UnitWord::Known(Units::Foot) if of_survey => Some(UnitWord::Known(Units::UsSurveyFoot)),
        unit => Some(unit),
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
    let decoded = decode_table("", whole).ok()?;
    let source = Source { name: "", text: &decoded.text };
    let table = Table::parse(source, columns.coordinates.as_deref().unwrap_or_default()).ok()?;
    let hints = Chosen::new(source, &table, columns).ok()?.unit_hints(&table);
    let unit = hints.first()?.1;
    Some(ColumnUnit { unit, columns: hints.into_iter().map(|(name, _)| name).collect() })
}
