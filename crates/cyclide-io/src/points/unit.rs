//! The unit that the names of coordinate columns speak of, from the beginning of a file.

use cyclide::Units;

use super::PointColumns;
use super::columns::Chosen;
use super::table::Table;
use crate::place::{Source, decode};

/// A unit that columns name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnUnit {
    /// The unit.
    pub unit: Units,
    /// The names of the coordinate columns that speak of it.
    pub columns: Vec<String>,
}

/// The unit that the names of the coordinate columns agree on (`x_m`, `y [mm]`), from the first bytes of a file that is
/// read as [`read_points`](super::read_points) does; `None` if they speak of none or of several, or cannot be read.
#[must_use]
pub fn unit_of_columns(head: &[u8], columns: &PointColumns) -> Option<ColumnUnit> {
    // The last line may be cut in two.
    let whole = head.iter().rposition(|byte| matches!(byte, b'\n' | b'\r')).map_or(head, |end| &head[..end]);
    let source = Source { name: "", text: decode("", whole).ok()? };
    let table = Table::parse(source, columns.coordinates.as_deref().unwrap_or_default()).ok()?;
    let hints = Chosen::new(source, &table, columns).ok()?.unit_hints(&table);
    let &(_, unit) = hints.first()?;
    let agreed = hints.iter().all(|(_, other)| *other == unit);
    agreed.then(|| ColumnUnit { unit, columns: hints.into_iter().map(|(name, _)| name).collect() })
}
