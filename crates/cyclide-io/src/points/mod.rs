//! Point lists: comma-separated (or semicolon, tab, blank) text into contours.
//!
//! ```text
//! # x_m,y_m,w_tr_right_m,w_tr_left_m      a header line is optional and may stand behind a '#'
//! 0.96,4.02,7.57,7.36
//! ```
//! A blank line starts a new contour, or a column named `contour` says which one a point belongs to; a column named
//! `corner` (0 or 1) marks corners. Coordinates are two or three columns: those named, else the ones whose names
//! start with x, y (and z), else the first two columns (three if the file has exactly three and no header).

mod merge;
mod table;

use cyclide::{Point3, Units};

use crate::place::{Diagnostic, Source, decode};
pub(crate) use merge::merge_repeated;
use table::{Field, Table};

/// Which columns to read.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct PointColumns {
    /// Names (or numbers from 1) of the two or three coordinate columns; `None` finds them.
    pub coordinates: Option<Vec<String>>,
    /// Name (or number) of the column that says which contour a point belongs to; `None` takes `contour` if there
    /// is such a column, else blank lines separate contours.
    pub contour: Option<String>,
}

/// The points of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct PointTable {
    /// The contours, in the file's order; none is empty, and there is at least one.
    pub contours: Vec<PointList>,
    /// Units that the names of the coordinate columns speak of (`x_m`, `y [mm]`), with the name.
    pub unit_hints: Vec<(String, Units)>,
}

/// One contour's points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointList {
    /// The points; height 0 where the file has two coordinates.
    pub points: Vec<Point3>,
    /// Indices of the points marked as corners.
    pub corners: Vec<usize>,
    /// Byte offset in the file's text of the first coordinate of each point; empty if they come from elsewhere.
    pub offsets: Vec<usize>,
}

/// Reads a point list from the bytes of a file; `name` is what messages call it.
///
/// # Errors
/// A message with file, line and column: not UTF-8, no points, a field that is not a finite number, a missing
/// column.
pub fn read_points(name: &str, bytes: &[u8], columns: &PointColumns) -> Result<PointTable, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let table = Table::parse(source, columns.coordinates.as_deref().unwrap_or_default())?;
    let chosen = Chosen::new(source, &table, columns)?;
    let mut contours: Vec<PointList> = Vec::new();
    let mut labels: std::collections::HashMap<&str, usize> = std::collections::HashMap::new();
    for row in &table.rows {
        let target = match chosen.contour {
            Some(column) => {
                let label = table.field(source, row, column, "contour")?.text;
                *labels.entry(label).or_insert(contours.len())
            }
            None => row.block,
        };
        if target == contours.len() {
            contours.push(PointList::default());
        }
        let list = &mut contours[target];
        let mut coordinates = [0.0; 3];
        for (value, &column) in coordinates.iter_mut().zip(&chosen.coordinates) {
            *value = number(source, &table.field(source, row, column, "coordinate")?)?;
        }
        if let Some(column) = chosen.corner {
            let field = table.field(source, row, column, "corner")?;
            match field.text {
                "0" => {}
                "1" => list.corners.push(list.points.len()),
                other => return Err(field.refused(source, format!("corner must be 0 or 1, not `{other}`"))),
            }
        }
        let [x, y, z] = coordinates;
        list.points.push(Point3::new(x, y, z));
        list.offsets.push(table.fields(row)[chosen.coordinates[0]].start);
    }
    if contours.is_empty() {
        return Err(source.diagnostic(0..0, "", "the file holds no points"));
    }
    Ok(PointTable { contours, unit_hints: chosen.unit_hints(&table) })
}

/// A coordinate: any decimal number, but neither NaN nor infinite.
fn number(source: Source<'_>, field: &Field<'_>) -> Result<f64, Box<Diagnostic>> {
    match field.text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(field.refused(source, format!("`{}` is not a finite number", field.text))),
        Err(_) if field.text.is_empty() => Err(field.refused(source, "a number is missing")),
        Err(_) if field.text.replacen(',', ".", 1).parse::<f64>().is_ok() => {
            Err(field.refused(source, format!("`{}` is not a number: use a decimal point", field.text)))
        }
        Err(_) => Err(field.refused(source, format!("`{}` is not a number", field.text))),
    }
}

/// The columns that are read, as indices.
struct Chosen {
    coordinates: Vec<usize>,
    contour: Option<usize>,
    corner: Option<usize>,
}

impl Chosen {
    fn new(source: Source<'_>, table: &Table<'_>, columns: &PointColumns) -> Result<Self, Box<Diagnostic>> {
        let named = |name: &str| table.header.iter().position(|f| f.text.eq_ignore_ascii_case(name));
        let required = |name: &String| {
            let by_number = || name.parse::<usize>().ok().filter(|n| (1..=table.width).contains(n)).map(|n| n - 1);
            named(name).or_else(by_number).ok_or_else(|| table.no_column(source, name))
        };
        let contour = columns.contour.as_ref().map_or(Ok(named("contour")), |name| required(name).map(Some))?;
        let corner = named("corner");
        let coordinates = match &columns.coordinates {
            Some(names) if !(2..=3).contains(&names.len()) => {
                let message = format!("{} coordinate columns named, 2 or 3 are needed", names.len());
                return Err(source.diagnostic(0..0, "", message));
            }
            Some(names) => names.iter().map(required).collect::<Result<_, _>>()?,
            None => Self::found(table, &[contour, corner]),
        };
        if coordinates.len() < 2 && !table.rows.is_empty() {
            return Err(table.rows[0].refused(source, table, "two or three coordinates are needed in each line"));
        }
        Ok(Self { coordinates, contour, corner })
    }

    /// Coordinate columns by their names, else the first ones that are not taken.
    fn found(table: &Table<'_>, taken: &[Option<usize>]) -> Vec<usize> {
        let axis = |letter: char| {
            let is_axis = |name: &str| {
                let mut chars = name.chars().map(|c| c.to_ascii_lowercase());
                chars.next() == Some(letter) && chars.next().is_none_or(|c| "_ [(".contains(c))
            };
            table.header.iter().position(|f| is_axis(f.text))
        };
        if let (Some(x), Some(y)) = (axis('x'), axis('y')) {
            return [x, y].into_iter().chain(axis('z')).collect();
        }
        let free: Vec<usize> = (0..table.width).filter(|&i| !taken.contains(&Some(i))).collect();
        let count = if table.header.is_empty() && table.width == 3 { 3 } else { 2 };
        // Columns of text (a name, a date) come into question only if there are not enough numbers.
        let numeric = |&i: &usize| table.first_row_field(i).is_some_and(|f| f.text.parse::<f64>().is_ok());
        let numbers: Vec<usize> = free.iter().copied().filter(numeric).take(count).collect();
        if numbers.len() == count { numbers } else { free.into_iter().take(count).collect() }
    }

    fn unit_hints(&self, table: &Table<'_>) -> Vec<(String, Units)> {
        let names = self.coordinates.iter().filter_map(|&i| table.header.get(i));
        names.filter_map(|f| unit_in_name(f.text).map(|u| (f.text.to_owned(), u))).collect()
    }
}

/// The unit a column's name speaks of: `x_m`, `x [mm]`, `x (in)`, `x/ft`.
fn unit_in_name(name: &str) -> Option<Units> {
    let mut words = name.split(['_', ' ', '[', ']', '(', ')', '/']).filter(|w| !w.is_empty());
    words.next()?;
    Units::from_symbol(&words.next_back()?.to_ascii_lowercase())
}

#[cfg(test)]
mod tests;
