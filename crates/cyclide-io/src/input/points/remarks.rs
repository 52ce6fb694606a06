//! What is said of a table of points that was read: how, and what it may be.

use cyclide::Aabb;

use super::columns::Chosen;
use super::decimals::Decimals;
use super::fields::Field;
use super::globe::on_the_globe;
use super::names::{Role, axis_kind};
use super::point_table::PointList;
use super::sampled::{GRID, PART_OF_GRID, Sampled};
use super::table::{Row, Table};
use super::unit::UnitWord;
use crate::text::place::{Diagnostic, Source, quoted};

/// What is said of coordinates that [`seem_to_be_of_a_grid`].
pub(super) const GRID_COORDINATES: &str = "no unit is given, and the coordinates look like those of a map grid: they are \
     taken in the model's unit (`--units m`, or `us-ft` or `ft` for a grid in feet; in a document `\"units\": \"m\"`, or \
     name the columns x_m, y_m)";

/// Words below the last point of a table that name no point.
const TOTALS: [&str; 32] = [
    "total",
    "totals",
    "totale",
    "totaux",
    "summe",
    "gesamt",
    "somme",
    "somma",
    "suma",
    "sum",
    "average",
    "mean",
    "mittelwert",
    "moyenne",
    "promedio",
    "anzahl",
    "mittel",
    "durchschnitt",
    "media",
    "moy",
    "moy.",
    "min",
    "max",
    "minimum",
    "maximum",
    "std",
    "stdev",
    "std.-abw.",
    "standardabweichung",
    "ecart-type",
    "\u{e9}cart-type",
    "median",
];

/// True if coordinates are far from the origin, as those of map grids are, and near to each other.
pub(super) fn seem_to_be_of_a_grid(lists: &[PointList]) -> bool {
    let points = lists.iter().flat_map(|list| &list.points);
    let Some(bounds) = Aabb::of_points(points.map(|p| cyclide::Point3::new(p.x, p.y, 0.0))) else { return false };
    let (low, high) = (bounds.min, bounds.max);
    let far = low.x.abs().max(low.y.abs()).max(high.x.abs()).max(high.y.abs());
    far >= GRID && bounds.diagonal() <= PART_OF_GRID * far
}

/// Refuses a last line that names no point.
pub(super) fn refuse_total(source: Source<'_>, label: Option<Field<'_>>) -> Result<(), Box<Diagnostic>> {
    let Some(field) = label.filter(|field| TOTALS.contains(&field.text.trim_end_matches(':').to_lowercase().as_str()))
    else {
        return Ok(());
    };
    Err(field.refused(source, format!("`{}` is not the name of a point: remove this line", quoted(field.text))))
}

/// Why a line whose coordinates cannot be read is no point, where that is known: it has the names of the columns again, or sums.
pub(super) fn no_point(
    source: Source<'_>,
    chosen: &Chosen,
    names: &[Field<'_>],
    row: &Row<'_, '_>,
    label: Option<Field<'_>>,
) -> Option<Box<Diagnostic>> {
    if let Err(refused) = refuse_total(source, label) {
        return Some(refused);
    }
    let is_name =
        |i: &usize| row.fields.get(*i).zip(names.get(*i)).is_some_and(|(field, name)| field.text == name.text);
    let field = row.fields.first().filter(|_| chosen.coordinates.iter().all(is_name))?;
    Some(field.refused(source, "the names of the columns are repeated here: remove this line"))
}

/// What was chosen with certainty and is not plain.
pub(super) fn notes(
    source: Source<'_>,
    table: &Table<'_>,
    chosen: &Chosen,
    decimals: &Decimals,
    encoding: Option<&str>,
) -> Vec<String> {
    let mut notes = Vec::new();
    let name = |i: usize| match table.header.get(i) {
        Some(field) if !field.text.is_empty() => format!("`{}`", quoted(field.text)),
        _ => format!("column {}", i + 1),
    };
    let axes = ["x", "y", "z"];
    let by_words = |(k, i): (usize, &usize)| {
        table.header.get(*i).is_some_and(|f| Role::of(f) != Role::Axis || axis_kind(axes[k], f).is_none())
    };
    // What a remark says is not said again.
    let words = chosen.remark.is_none() && chosen.coordinates.iter().enumerate().any(by_words);
    let mut columns: Vec<String> = Vec::new();
    if words || chosen.label.is_some() {
        columns.extend(chosen.coordinates.iter().zip(axes).map(|(i, axis)| format!("{axis} is {}", name(*i))));
    }
    columns.extend(chosen.label.map(|i| format!("the names of the points are in {}", name(i))));
    if !columns.is_empty() {
        notes.push(columns.join(", "));
    }
    let globe = on_the_globe(table, &Sampled::of(table));
    if let Some(globe) = globe.filter(|globe| globe.iter().all(|i| !chosen.coordinates.contains(i))) {
        notes.push(format!("{} are geographic angles and are ignored", globe.map(name).join(" and ")));
    }
    if let Some(start) = table.titles.first() {
        let lines = match table.titles.len() {
            1 => "line".to_owned(),
            several => format!("the first of {several} lines"),
        };
        notes.push(format!("line {} is skipped ({lines} above the names of the columns)", source.line_of(*start)));
    }
    if let Some((UnitWord::Known(unit), line)) = table.said.filter(|_| !table.columns_have_units(&chosen.coordinates)) {
        notes.push(format!("the coordinates are in {}, according to `{}`", unit.symbol(), quoted(line.trim())));
    }
    if decimals.grouped {
        notes.push("the numbers have thousands separators".to_owned());
    }
    if let Some(encoding) = encoding {
        notes.push(format!("the text is read as {encoding}"));
    }
    notes
}
