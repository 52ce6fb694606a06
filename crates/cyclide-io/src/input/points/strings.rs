//! Codes of points by which one table has several lines: where the points of a code stand together, and the way to the next code is far longer than any
//! step within one, the contours are joined across a gap.

use cyclide::Point3;

use super::columns::Chosen;
use super::names::words_of;
use super::point_table::PointList;
use super::sampled::Sampled;
use super::table::Table;
use crate::text::place::{Diagnostic, quoted};

/// Words of columns with codes.
const CODES: &str = "code codes codigo codice kode type typ tipo art class klasse classe clase group gruppe color colour farbe couleur layer ebene \
    calque capa feature object objekt desc description descripcion descrizione beschreibung remark comment kommentar bemerkung note part polyline \
    ring line string linie id name";

/// A way between the points of two codes is none along a line if it is this much longer than the longest step within one.
const FAR: f64 = 5.0;
/// Points of a code at least: fewer have no steps to compare with.
const FEWEST: usize = 2;

/// The steps between the points of a table, by whether a code changes there.
#[derive(Debug, Default)]
struct Steps {
    longest_within: f64,
    shortest_between: Option<f64>,
    shortest_run: Option<usize>,
    run: usize,
}

impl Steps {
    fn take(&mut self, length: f64, changes: bool) {
        if changes {
            self.shortest_between = Some(self.shortest_between.map_or(length, |least| least.min(length)));
            self.end_run();
        } else {
            self.longest_within = self.longest_within.max(length);
        }
        self.run += 1;
    }

    fn end_run(&mut self) {
        self.shortest_run = Some(self.shortest_run.map_or(self.run, |least| least.min(self.run)));
        self.run = 0;
    }

    fn are_apart(&self) -> bool {
        self.shortest_run.is_some_and(|run| run >= FEWEST)
            && self.longest_within > 0.0
            && self.shortest_between.is_some_and(|length| length > FAR * self.longest_within)
    }
}

impl Chosen {
    /// The sentence about a column whose codes split the points of the only contour in lines that are far apart.
    ///
    /// # Errors
    /// As reading the lines has them.
    pub(super) fn joined_strings(
        &self,
        table: &Table<'_>,
        lists: &[PointList],
    ) -> Result<Option<String>, Box<Diagnostic>> {
        let ([only], None) = (lists, self.contour) else { return Ok(None) };
        let sampled = Sampled::of(table);
        let is_code = |i: &usize| {
            let words = words_of(table.header[*i].text).0;
            sampled.may_come_in_pairs(*i) && words.iter().any(|word| CODES.split_whitespace().any(|own| own == word))
        };
        for column in (0..table.header.len()).filter(|i| !self.coordinates.contains(i)).filter(is_code) {
            if are_apart(table, column, &only.points)? {
                let name = quoted(table.header[column].text).into_owned();
                return Ok(Some(format!(
                    "not read: {name}; where it changes, the distance to the next point is more than {FAR} times as long as any other step: if it separates contours, choose it by `contour` (`--contour-column \"{name}\"`)"
                )));
            }
        }
        Ok(None)
    }
}

/// Whether the points of each code of a column are together, and those of the next one far away.
fn are_apart(table: &Table<'_>, column: usize, points: &[Point3]) -> Result<bool, Box<Diagnostic>> {
    let (mut steps, mut index, mut code) = (Steps { run: 1, ..Steps::default() }, 0_usize, String::new());
    table.for_each_row(|row| {
        let text = row.fields.get(column).map_or("", |field| field.text);
        if let (Some(before), Some(point)) = (index.checked_sub(1).and_then(|i| points.get(i)), points.get(index)) {
            steps.take((*point - *before).length(), text != code);
        }
        code.clear();
        code.push_str(text);
        index += 1;
        Ok(())
    })?;
    steps.end_run();
    Ok(steps.are_apart())
}
