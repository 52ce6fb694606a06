//! Grids of heights: a line of text for each row, a hole for each empty cell.

use super::decimals::Decimals;
use super::fields::Field;
use super::missing_heights::MissingHeights;
use super::table::Table;
use super::{HEIGHTS_MISSING, MOST_POINTS};
use crate::text::encoding::decode_table;
use crate::text::place::{Diagnostic, Source};

/// A grid of heights, row by row.
pub(crate) struct HeightTable {
    /// As many in each row; `None` is a hole.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
    /// Whether fractions are written with commas.
    pub(crate) decimal_commas: bool,
}

/// Reads a grid of heights from the bytes of a file; `name` is what messages call it.
///
/// # Errors
/// A message with file, line and column: not UTF-8, no numbers, a field that is neither a finite number nor a hole, heights that stand for none, a row that is longer
/// or shorter than the first one, more cells than points are read.
pub(crate) fn read_heights(name: &str, bytes: &[u8]) -> Result<HeightTable, Box<Diagnostic>> {
    let decoded = decode_table(name, bytes)?;
    let source = Source { name, text: &decoded.text };
    let table = Table::parse(source, &[])?;
    let mut decimals = Decimals::of(source, &table, None)?;
    let mut rows: Vec<Vec<Option<f64>>> = Vec::new();
    let mut starts: Vec<usize> = Vec::new();
    table.for_each_line(|fields, end| {
        let mut value = |field: &Field<'_>| match field.text {
            text if text.is_empty() || text.eq_ignore_ascii_case("nan") => Ok(None),
            _ => decimals.read(source, field).map(Some),
        };
        let row = fields.iter().map(&mut value).collect::<Result<Vec<_>, _>>()?;
        let needed = rows.first().map_or(row.len(), Vec::len);
        if row.len() != needed {
            let span = fields.get(needed).map_or(end..end, |field| field.start..field.start + field.text.len());
            let message = format!(
                "the row has {} heights, the first one has {needed}: write holes as empty cells or NaN",
                row.len()
            );
            return Err(source.diagnostic(span, "", message).with_reason("count-differs"));
        }
        if (rows.len() + 1).saturating_mul(needed) > MOST_POINTS {
            let message = format!("the file has too many heights, maximum {MOST_POINTS}");
            return Err(source.diagnostic(end..end, "", message).with_reason("too-many-pieces"));
        }
        starts.extend(fields.iter().zip(&row).filter(|(_, height)| height.is_some()).map(|(field, _)| field.start));
        rows.push(row);
        Ok(())
    })?;
    if let Some(missing) = MissingHeights::of(rows.iter().flatten().flatten().copied()).filter(|found| found.is_certain)
    {
        let start = starts[missing.first];
        let message = format!("{}; write holes as empty cells or NaN", missing.sentence());
        return Err(source.diagnostic(start..start, "", message).with_reason(HEIGHTS_MISSING));
    }
    Ok(HeightTable { rows, decimal_commas: decimals.comma })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<Vec<Option<f64>>>, String> {
        read_heights("h.csv", text.as_bytes()).map(|table| table.rows).map_err(|e| e.to_string())
    }

    #[test]
    fn cells_are_heights_or_holes_whatever_separates_them() {
        let wanted = vec![vec![None, None], vec![Some(1.5), None], vec![Some(-2.0), Some(3.0)]];
        for text in [
            "# from a survey\n,\n1.5,\n-2,3\n",
            ";\n1,5;NaN\n\n-2;3",
            "nan NaN\r\n 1.5 nan # a hole\r\n-2 3\r\n",
            "\t\n1.5\t\n-2\t3\n",
        ] {
            assert_eq!(read(text).unwrap(), wanted, "{text:?}");
        }
    }

    #[test]
    fn what_is_no_grid_is_shown_at_its_place() {
        for (text, wanted) in [
            ("1,2,3\n4,5\n", "h.csv:2:4: the row has 2 heights, the first one has 3"),
            ("1,2\n4,5,6\n", "h.csv:2:5: the row has 3 heights, the first one has 2"),
            ("1,2\n4,five\n", "h.csv:2:3: `five` is not a number"),
            ("1,2\n4,inf\n", "h.csv:2:3: `inf` is not a finite number"),
            ("x,y\n4,5\n", "h.csv:1:1: `x` is not a number"),
            ("", "h.csv"),
            (
                "1,2,3\n4,-9999,-9999\n",
                "h.csv:2:3: 2 heights are -9999, which marks a missing value: the others lie from 1 to 4; write holes",
            ),
        ] {
            let message = read(text).unwrap_err();
            assert!(message.starts_with(wanted), "{text:?}: {message}");
        }
    }
}
