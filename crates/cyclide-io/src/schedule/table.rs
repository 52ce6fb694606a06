//! A table with its columns, the same as CSV and in JSON; units stand in the names of the columns.

use std::fmt::{Arguments, Write as _};

use cyclide::{Point3, Vec3, model::Units};
use serde_json::Value;

use crate::text::csv::{field, fields};
use crate::text::number::push_plain;

/// What a column measures: how its unit is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// A text, a count, a direction.
    Plain,
    /// Radians.
    Angle,
    Length,
    Area,
}

/// A place of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Cell {
    Empty,
    Text(String),
    Number(f64),
    Count(usize),
}

/// Rows of cells under the names of their columns.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    /// What its file is called, without suffix.
    pub(super) name: &'static str,
    columns: Vec<String>,
    cells: Vec<Cell>,
}

/// A row as it is filled, or the names of the columns: what fills a row tells both.
pub(super) struct Row {
    units: Units,
    names: Option<Vec<String>>,
    cells: Vec<Cell>,
}

impl Table {
    /// A table of items by what writes a row of one, or the columns for none.
    pub(super) fn of<T>(
        name: &'static str,
        units: Units,
        items: impl Iterator<Item = T>,
        write: impl Fn(&mut Row, Option<&T>),
    ) -> Self {
        let mut row = Row { units, names: Some(Vec::new()), cells: Vec::new() };
        write(&mut row, None);
        let columns = row.names.take().unwrap_or_default();
        row.cells.clear();
        for item in items {
            write(&mut row, Some(&item));
        }
        debug_assert!(
            columns.is_empty() || row.cells.len().is_multiple_of(columns.len()),
            "{name}: rows are of one length"
        );
        Self { name, columns, cells: row.cells }
    }

    fn rows(&self) -> impl Iterator<Item = &[Cell]> {
        self.cells.chunks(self.columns.len().max(1))
    }

    /// Comma-separated, the names of the columns first.
    pub(super) fn csv(&self) -> String {
        let mut out = self.columns.join(",") + "\n";
        for row in self.rows() {
            for (k, cell) in row.iter().enumerate() {
                if k > 0 {
                    out.push(',');
                }
                match cell {
                    Cell::Empty => {}
                    Cell::Text(text) => out.push_str(&field(text)),
                    Cell::Number(value) => push_plain(&mut out, *value),
                    Cell::Count(count) => push_count(&mut out, *count),
                }
            }
            out.push('\n');
        }
        out
    }

    /// `{"columns": […], "rows": [[…], …]}`, a line for each row.
    pub(super) fn push_json(&self, out: &mut String) {
        // Texts have no value that could fail.
        let text = |text: &str| serde_json::to_string(text).unwrap_or_default();
        let names: Vec<String> = self.columns.iter().map(|name| text(name)).collect();
        let _ = write!(out, "{{\"columns\": [{}],\n   \"rows\": [", names.join(", "));
        for (index, row) in self.rows().enumerate() {
            out.push_str(if index > 0 { ",\n    [" } else { "\n    [" });
            for (k, cell) in row.iter().enumerate() {
                if k > 0 {
                    out.push(',');
                }
                match cell {
                    Cell::Empty => out.push_str("null"),
                    Cell::Text(value) => out.push_str(&text(value)),
                    Cell::Number(value) => push_plain(out, *value),
                    Cell::Count(count) => push_count(out, *count),
                }
            }
            out.push(']');
        }
        out.push_str("]}");
    }

    /// Where a CSV file holds something else than the table, if it does.
    pub(super) fn csv_differs(&self, bytes: &[u8]) -> Option<String> {
        let Ok(text) = std::str::from_utf8(bytes) else { return Some("it is not text".to_owned()) };
        let mut lines = text.lines();
        if lines.next().map(fields).as_deref() != Some(&self.columns) {
            return Some("the columns in line 1 differ".to_owned());
        }
        for (number, row) in self.rows().enumerate() {
            let line = number + 2;
            let found = lines.next().map(fields).unwrap_or_default();
            let same = found.len() == row.len() && row.iter().zip(&found).all(|(cell, text)| cell.is_read_from(text));
            if !same {
                return Some(format!("line {line} differs from the row that was written"));
            }
        }
        lines.next().map(|_| "it has more lines than rows".to_owned())
    }

    /// Where a table in JSON holds something else, if it does.
    pub(super) fn json_differs(&self, found: &Value) -> Option<String> {
        let columns = found["columns"].as_array()?.iter().map(Value::as_str);
        if !columns.eq(self.columns.iter().map(|name| Some(name.as_str()))) {
            return Some("the columns differ".to_owned());
        }
        let rows = found["rows"].as_array().map(Vec::as_slice).unwrap_or_default();
        let same = |row: &[Cell], found: &Value| {
            let cells = found.as_array().map(Vec::as_slice).unwrap_or_default();
            cells.len() == row.len() && row.iter().zip(cells).all(|(cell, value)| cell.is_value(value))
        };
        if rows.len() != self.rows().count() {
            return Some("the number of rows differs".to_owned());
        }
        let other = self.rows().zip(rows).position(|(row, found)| !same(row, found));
        other.map(|index| format!("row {index} differs from the one that was written"))
    }
}

/// A count as it is.
fn push_count(out: &mut String, count: usize) {
    // Writing to a string cannot fail.
    let _ = write!(out, "{count}");
}

impl Cell {
    fn is_read_from(&self, text: &str) -> bool {
        match self {
            Self::Empty => text.is_empty(),
            Self::Text(own) => own.replace(['\n', '\r'], " ") == text,
            Self::Number(value) => text.parse().is_ok_and(|found: f64| same(found, *value)),
            Self::Count(count) => text.parse() == Ok(*count),
        }
    }

    fn is_value(&self, value: &Value) -> bool {
        match self {
            Self::Empty => value.is_null(),
            Self::Text(own) => value.as_str() == Some(own),
            Self::Number(own) => value.as_f64().is_some_and(|found| same(found, *own)),
            Self::Count(count) => value.as_u64() == Some(*count as u64),
        }
    }
}

/// The same double; both zeros are one.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a == 0.0 && b == 0.0)
}

impl Row {
    fn put(&mut self, name: Arguments<'_>, measure: Measure, cell: Cell) {
        if let Some(names) = &mut self.names {
            let unit = self.units.symbol();
            names.push(match measure {
                Measure::Plain => name.to_string(),
                Measure::Angle => format!("{name}_rad"),
                Measure::Length => format!("{name}_{unit}"),
                Measure::Area => format!("{name}_{unit}2"),
            });
        }
        self.cells.push(cell);
    }

    pub(super) fn text(&mut self, name: Arguments<'_>, text: Option<impl Into<String>>) {
        self.put(name, Measure::Plain, text.map_or(Cell::Empty, |text| Cell::Text(text.into())));
    }

    pub(super) fn count(&mut self, name: Arguments<'_>, count: Option<usize>) {
        self.put(name, Measure::Plain, count.map_or(Cell::Empty, Cell::Count));
    }

    /// A number; one that is not finite is none.
    pub(super) fn number(&mut self, name: Arguments<'_>, measure: Measure, value: Option<f64>) {
        self.put(name, measure, value.filter(|v| v.is_finite()).map_or(Cell::Empty, Cell::Number));
    }

    pub(super) fn point(&mut self, name: Arguments<'_>, point: Option<Point3>) {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            self.number(format_args!("{name}_{letter}"), Measure::Length, point.map(|p| p[axis]));
        }
    }

    pub(super) fn direction(&mut self, name: Arguments<'_>, direction: Option<Vec3>) {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            self.number(format_args!("{name}_{letter}"), Measure::Plain, direction.map(|v| v[axis]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let items = [("a,b", Some(0.1)), ("c", None)];
        Table::of("panels", Units::Metre, items.into_iter(), |row, item| {
            row.text(format_args!("id"), item.map(|item| item.0));
            row.number(format_args!("area"), Measure::Area, item.and_then(|item| item.1));
            row.count(format_args!("row"), item.map(|_| 7));
            row.direction(format_args!("normal"), item.map(|_| Vec3::Z));
        })
    }

    #[test]
    fn both_forms_are_read_as_they_were_written() {
        let table = table();
        let csv = table.csv();
        assert_eq!(csv, "id,area_m2,row,normal_x,normal_y,normal_z\n\"a,b\",0.1,7,0,0,1\nc,,7,0,0,1\n");
        assert_eq!(table.csv_differs(csv.as_bytes()), None);
        let mut json = String::new();
        table.push_json(&mut json);
        let value = serde_json::from_str(&json).unwrap();
        assert_eq!(table.json_differs(&value), None);
        for (from, to) in
            [("0.1", "0.10000000000000002"), ("c,,7", "c,,8"), ("area_m2", "area_ft2"), ("\nc,,7,0,0,1", "")]
        {
            assert!(table.csv_differs(csv.replace(from, to).as_bytes()).is_some(), "{from}");
        }
        for (from, to) in [("0.1", "0.10000000000000002"), ("null", "0"), ("area_m2", "area_ft2")] {
            assert!(table.json_differs(&serde_json::from_str(&json.replace(from, to)).unwrap()).is_some(), "{from}");
        }
    }
}
