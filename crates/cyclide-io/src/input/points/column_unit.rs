//! The unit that a whole file says by the names of its columns.

use cyclide::model::Units;

use super::columns::Chosen;
use super::point_table::PointColumns;
use super::table::Table;
use crate::text::encoding::decode_table;
use crate::text::place::Source;

/// A unit that columns name.
///
/// ```
/// use cyclide_io::input::{PointColumns, unit_of_columns};
/// let found = unit_of_columns(b"x_m,y_m\n0,1\n", &PointColumns::default());
/// assert!(found.is_some_and(|found| found.unit == cyclide::model::Units::Metre));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnUnit {
    /// The unit.
    pub unit: Units,
    /// The names of the coordinate columns that speak of it.
    pub columns: Vec<String>,
}

/// The unit that the names of the coordinate columns agree on (`x_m`, `y [mm]`), from the first bytes of a file that is
/// read as [`read_points`](super::read_points) does; `None` if they speak of none, or are refused.
///
/// ```
/// use cyclide_io::input::{PointColumns, unit_of_columns};
/// let found = unit_of_columns(b"x_m,y_m\n0,1\n", &PointColumns::default());
/// assert!(found.is_some_and(|found| found.unit == cyclide::model::Units::Metre));
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
