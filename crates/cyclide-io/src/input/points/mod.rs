//! Point lists: comma-separated (or semicolon, tab, blank) text into contours.
//!
//! ```text
//! # x_m,y_m,w_tr_right_m,w_tr_left_m      a header line is optional and may stand behind a '#'
//! 0.96,4.02,7.57,7.36
//! ```
//! A blank line starts a new contour (unless one stands after every point), or a column named `contour` says which one a
//! point belongs to; a column named `corner` (0 or 1) marks corners. Coordinates are two or three columns: those asked
//! for, else those named x, y (and z) or in the words of surveying, else the only two or three numbers of a line; without a
//! header the first two of more. Numbers and names of points are no coordinates, they say what the points are called. Where
//! that is a choice it is said, and where it would be a guess it is refused. Above the header there may be titles, below it a
//! line of units; the text may be UTF-8, UTF-16 or Windows-1252.

mod bulges_as_z;
mod civil_time;
mod clock;
mod column_unit;
mod columns;
mod compass;
mod decimals;
mod fields;
mod find;
mod globe;
mod groups;
mod headless;
mod height_words;
mod heights;
mod merge;
mod missing_heights;
mod names;
mod northing;
mod point_table;
mod pose_clocks;
mod pose_columns;
mod pose_entries;
mod pose_names;
mod pose_places;
mod pose_proposal;
mod pose_rows;
#[cfg(test)]
mod pose_tests;
mod poses;
mod preamble;
mod remarks;
mod sampled;
mod strings;
mod table;
mod unit;
mod unit_said;
mod unread;
mod words;

use std::collections::HashMap;

use cyclide::Point3;

use crate::text::encoding::decode_table;
use crate::text::place::{Diagnostic, Source, quoted};
use bulges_as_z::{BULGES_AS_Z, ThirdColumn};
pub use column_unit::{ColumnUnit, unit_of_columns};
use columns::Chosen;
use decimals::{Decimals, Pairs};
use fields::Field;
pub(crate) use heights::read_heights;
pub(crate) use merge::{Merged, merge_repeated};
use missing_heights::MissingHeights;
pub use point_table::{PointColumns, PointList, PointRemark, PointTable};
pub(crate) use poses::{SIX_DECIMALS, read_poses, whole_turns};
use table::{Row, Table, numbers_of};
use unread::Bulges;

/// The reason of the remark that coordinates look like those of a map grid, and no unit is named.
pub(crate) const UNITS_ASSUMED: &str = "units-assumed";

/// The reason of what is said of heights that stand for none.
const HEIGHTS_MISSING: &str = "heights-missing";

/// Most points of one input: a curve of so many takes some ten gigabytes.
pub(crate) const MOST_POINTS: usize = 10_000_000;

/// Reads a point list from the bytes of a file; `name` is what messages call it.
///
/// ```
/// use cyclide_io::input::{PointColumns, read_points};
/// let table = read_points("p.csv", b"x,y\n0,0\n3,4\n", &PointColumns::default())?;
/// assert_eq!(table.contours[0].points[1], cyclide::Point3::new(3.0, 4.0, 0.0));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
///
/// # Errors
/// A message with file, line and column: not text, no points, a field that is not a finite number or is lost below
/// the smallest, a missing column, columns that can only be guessed or speak of several units, a line or quote without end.
pub fn read_points(name: &str, bytes: &[u8], columns: &PointColumns) -> Result<PointTable, Box<Diagnostic>> {
    let decoded = decode_table(name, bytes)?;
    let source = Source { name, text: &decoded.text };
    let table = Table::parse(source, columns.coordinates.as_deref().unwrap_or_default())?;
    let chosen = Chosen::new(source, &table, columns)?;
    let mut pairs = columns.coordinates.is_none().then(|| Pairs::new(&table));
    let decimals = Decimals::of(source, &table, Some(&chosen.coordinates))?;
    let mut contours = Contours { decimals, ..Contours::default() };
    let mut count = 0;
    let bulges = Bulges::of(&table, columns);
    table.for_each_row(|row| {
        count += 1;
        if count > MOST_POINTS {
            return Err(row.fields[0].refused(source, format!("the file has more than {MOST_POINTS} points")));
        }
        pairs.iter_mut().for_each(|pairs| pairs.row(row.fields));
        bulges.refuse(source, &chosen.coordinates, row)?;
        contours.add(source, &chosen, &table.header, row)
    })?;
    let Contours { mut lists, decimals, last_label, .. } = contours;
    remarks::refuse_total(source, last_label)?;
    let [plane, space] = [2, 3].map(|count| numbers_of(chosen.coordinates.iter().copied().take(count)));
    let mut remarks = Vec::new();
    let mut remark = |reason, message: String| remarks.push(PointRemark { reason, message });
    if pairs.as_ref().is_some_and(Pairs::are_certain) {
        let count = if chosen.coordinates.len() == 2 { &plane } else { &space };
        return Err(table.refused(format!(
            "the commas are decimal commas and separate the columns too, by the zeros behind them: separate the columns by semicolons; `--columns {count}` takes all numbers as whole ones nevertheless"
        )));
    }
    if pairs.is_some_and(|pairs| pairs.found()) {
        let taken = if chosen.coordinates.len() == 2 { "the first two" } else { "the first three" };
        let message = format!(
            "all {} columns are whole numbers, {taken} are taken as coordinates; if the commas are decimal commas, as \
             in `{}`, separate the columns by semicolons (otherwise choose the columns by `--columns`)",
            table.width,
            if table.width == 3 { "1,5,2" } else { "1,5,2,5" }
        );
        remark("decimal-pairs", message);
    } else if let Some(message) = chosen.remark.clone() {
        remark("columns-taken", message);
    }
    if columns.coordinates.is_some()
        && let Some(message) = compass::asked_for_mirrored(&table, &chosen.coordinates)
    {
        remark("northing-first", message);
    }
    let not_read = chosen.not_read(&table).filter(|_| columns.coordinates.is_none());
    let strings = match &not_read {
        // It is named already.
        Some(message) if message.contains("--contour-column") => None,
        _ => chosen.joined_strings(&table, &lists)?,
    };
    for message in not_read.into_iter().chain(strings) {
        remark("columns-not-read", message);
    }
    if let Some(message) = chosen.unit_not_applied(&table) {
        remark("unit-not-applied", message);
    }
    // Without a header nothing says that a first column that counts on is no coordinate.
    if table.header.is_empty() && columns.coordinates.is_none() && chosen.coordinates.len() == 3 && counts_on(&lists) {
        let message = "the file has no header line, and its first column increases in equal steps: it is taken as x; if it numbers the points, or is a station, choose the others (`--columns 2,3`, in a document `columns`)";
        remark("numbers-as-x", message.to_owned());
    }
    let is_third_z = table.header.is_empty() && columns.coordinates.is_none() && chosen.coordinates.len() == 3;
    if let Some(third) = is_third_z.then(|| ThirdColumn::of(&lists)) {
        let message = third.message(&plane, &space);
        if let ThirdColumn::Bulges { first, .. } = third {
            return Err(at_point(source, &lists, first, message).with_reason(BULGES_AS_Z));
        }
        if !message.is_empty() {
            remark(BULGES_AS_Z, message);
        }
    }
    if decimals.comma {
        remark("decimal-commas", "the numbers are read with decimal commas".to_owned());
    }
    if chosen.contour.is_none() && lists.len() > 1 && lists.iter().all(|list| list.points.len() == 1) {
        lists = vec![joined(lists)];
        remark(
            "blank-lines",
            "there is a blank line after every point: blank lines are not taken as separators of contours".to_owned(),
        );
    }
    let heights = lists.iter().flat_map(|list| &list.points).map(|p| p.z);
    if let Some(missing) = MissingHeights::of(heights).filter(|_| columns.coordinates.is_none()) {
        let message = missing.of_points(&plane, &space);
        if missing.is_certain {
            return Err(at_point(source, &lists, missing.first, message).with_reason(HEIGHTS_MISSING));
        }
        remark(HEIGHTS_MISSING, message);
    }
    let unit_hints = chosen.unit_hints(&table);
    if unit_hints.is_empty() && chosen.unit_not_applied(&table).is_none() && remarks::seem_to_be_of_a_grid(&lists) {
        remark(UNITS_ASSUMED, remarks::GRID_COORDINATES.to_owned());
    }
    let notes = remarks::notes(source, &table, &chosen, &decimals, decoded.encoding);
    Ok(PointTable { contours: lists, unit_hints, remarks, notes })
}

/// A message about a point, counted through all contours.
fn at_point(source: Source<'_>, lists: &[PointList], point: usize, message: String) -> Box<Diagnostic> {
    let start = lists.iter().flat_map(|list| &list.offsets).nth(point).copied().unwrap_or_default();
    source.diagnostic(start..start, "", message)
}

/// The contours as far as they are read.
#[derive(Default)]
struct Contours<'a> {
    lists: Vec<PointList>,
    indices: HashMap<&'a str, usize>,
    decimals: Decimals,
    /// What the last point is called.
    last_label: Option<Field<'a>>,
}

impl<'a> Contours<'a> {
    /// Adds the point of a line.
    fn add(
        &mut self,
        source: Source<'_>,
        chosen: &Chosen,
        names: &[Field<'_>],
        row: &Row<'_, 'a>,
    ) -> Result<(), Box<Diagnostic>> {
        let target = match chosen.contour {
            Some(column) => {
                let label = row.field(source, column, "contour")?.text;
                *self.indices.entry(label).or_insert(self.lists.len())
            }
            None => row.block,
        };
        if target == self.lists.len() {
            self.lists.push(PointList::default());
        }
        let list = &mut self.lists[target];
        self.last_label = chosen.label.and_then(|column| row.fields.get(column).copied());
        let mut coordinates = [0.0; 3];
        for (k, (value, &column)) in coordinates.iter_mut().zip(&chosen.coordinates).enumerate() {
            let field = row.field(source, column, "coordinate")?;
            // The points of a plan have no heights in places.
            if k == 2 && is_missing(field.text) {
                return Err(field.refused(
                    source,
                    format!(
                        "the height of this point is missing: leave the point out, or take all points in the plane (`--columns {}`, in a document \
                         `columns`)",
                        numbers_of(chosen.coordinates[..2].iter().copied())
                    ),
                ));
            }
            *value = self.decimals.read(source, &field).map_err(|mut refused| {
                let ends = ["is not a number", "is missing", "is not a finite number"];
                if ends.iter().any(|end| refused.message.ends_with(end)) {
                    refused.message.push_str("; remove the line if it is no point");
                }
                remarks::no_point(source, chosen, names, row, self.last_label).unwrap_or(refused)
            })?;
        }
        if let Some(column) = chosen.corner {
            let field = row.field(source, column, "corner")?;
            match field.text {
                "0" => {}
                "1" => list.corners.push(list.points.len()),
                other => return Err(field.refused(source, format!("corner must be 0 or 1, not `{}`", quoted(other)))),
            }
        }
        let [x, y, z] = coordinates;
        list.points.push(Point3::new(x, y, z));
        list.offsets.push(row.fields[chosen.coordinates[0]].start);
        if chosen.label.is_some() {
            list.labels.push(self.last_label.map_or(0..0, |field| field.start..field.start + field.text.len()));
        }
        Ok(())
    }
}

/// True for what stands for no number.
fn is_missing(text: &str) -> bool {
    text.is_empty()
        || ["-", "--", "---", "n/a", "na", "nan", "null", "none"].iter().any(|own| text.eq_ignore_ascii_case(own))
}

/// True if the first coordinates of at least three points are whole numbers that rise by one throughout, or rise from 0 in equal
/// steps, as stations do.
fn counts_on(lists: &[PointList]) -> bool {
    let all = || lists.iter().flat_map(|list| &list.points).map(|p| p.x);
    let mut first = all();
    let (Some(start), Some(second)) = (first.next(), first.next()) else { return false };
    let step = second - start;
    let numbers = start.fract() == 0.0 && step.total_cmp(&1.0).is_eq();
    let stations = start == 0.0 && step > 0.0;
    // Decimals are rounded.
    let even = all().zip(all().skip(1)).all(|(a, b)| (b - a - step).abs() <= 1e-9 * (step.abs() + b.abs()));
    (numbers || stations) && even && all().take(3).count() == 3
}

/// One list of several.
fn joined(lists: Vec<PointList>) -> PointList {
    let mut all = PointList::default();
    for list in lists {
        let before = all.points.len();
        all.corners.extend(list.corners.iter().map(|corner| before + corner));
        all.points.extend(list.points);
        all.offsets.extend(list.offsets);
        all.labels.extend(list.labels);
    }
    all
}

#[cfg(test)]
mod tests;
