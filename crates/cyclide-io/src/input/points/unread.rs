//! Columns that are not read and may be meant to be: heights beside two coordinates, layers, radii, numbers that nobody knows.

use super::columns::Chosen;
use super::globe::on_the_globe;
use super::names::{Role, words_of};
use super::point_table::PointColumns;
use super::sampled::Sampled;
use super::table::{Row, Table, numbers_of};
use super::unit::unit_in_name;
use crate::text::place::{Diagnostic, Source, quoted};

/// Words in names of columns that tell contours apart.
const LAYERS: [&str; 11] = [
    "layer",
    "ebene",
    "polyline",
    "part",
    "ring",
    "parcel",
    "parcelle",
    "parzelle",
    "flurstuck",
    "particella",
    "parcela",
];

/// Other words of them, in names that say more.
fn is_of_parts(word: &str) -> bool {
    let parts =
        ["contour", "contours", "kontur", "contorno", "shape", "path", "loop", "hole", "curve", "object", "group"];
    LAYERS.contains(&word) || parts.contains(&word)
}

/// Words of measures of the shape between the points, which points alone do not have.
const SHAPES: &str = "radius radii radien radio rayon raggio r diameter durchmesser diametre diametro arc bogen bulge bulges pfeilhohe sagitta";

/// Words of numbers beside points that are none of them: of accuracies, directions, speeds, colors, receivers and days.
const QUIET: &str = "s sx sy sz sh se sn mx my mz mp ms mh me mn sigma cq nx ny nz vx vy vz ve vn vu v vel ax ay az gx gy gz ix iy iz \
    roll pitch yaw psi kappa tangent normal binormal look torsion qw qx qy qz g b red green blue rgb alpha nir return returns classification \
    scan age status state mode sat satnum nsat numsat snr cn0 rssi signal battery voltage pressure humidity year month day hour minute second \
    seconds jahr monat tag stunde jour area flache cost cadence power pulse hr heartrate track tr lane spur mps kmh kph rpm acceleration \
    accel antenna antennen antenne instrument reflektor reflector prisma prism antennenhohe instrumentenhohe zielhohe reflektorhohe prismenhohe \
    stabhohe geratehohe hi ih dx dy dz de dn dh delta diff difference differenz w right left";

/// Columns with heights that a message offers at most.
const OFFERED: usize = 3;

/// True for a word of a list.
fn is_among(list: &str, word: &str) -> bool {
    list.split_whitespace().any(|own| own == word)
}

/// The columns that are not read, by why they may be meant to be.
#[derive(Debug, Default)]
struct Unread {
    heights: Vec<usize>,
    parts: Vec<usize>,
    shapes: Vec<usize>,
    numbers: Vec<usize>,
}

impl Unread {
    fn of(chosen: &Chosen, table: &Table<'_>) -> Self {
        let sampled = Sampled::of(table);
        // What stands in runs calls no points, whatever its name.
        let is_label = |i: usize| chosen.label == Some(i) && !sampled.comes_in_runs(i);
        let read = |i: usize| {
            chosen.coordinates.contains(&i) || [chosen.contour, chosen.corner].contains(&Some(i)) || is_label(i)
        };
        let globe = on_the_globe(table, &sampled);
        let on_globe = |i: usize| globe.is_some_and(|globe| globe.contains(&i));
        let mut unread = Self::default();
        for (i, field) in table.header.iter().enumerate().filter(|(i, _)| !read(*i)) {
            let (words, unit) = words_of(field.text);
            let words = &words[..words.len() - usize::from(unit)];
            let role = Role::of(field);
            let quiet = || words.iter().any(|word| is_among(QUIET, word));
            let layer = matches!(words, [only] if LAYERS.contains(&only.as_str()));
            let tells_apart = chosen.contour.is_none()
                && sampled.comes_in_runs(i)
                && (matches!(role, Role::Unknown | Role::Label) || words.iter().any(|word| is_of_parts(word)));
            let measure = sampled.is_of_numbers(i)
                && (sampled.changes(i) || unit_in_name(field.text).is_some())
                && !sampled.counts(i);
            let of_shape = words.iter().any(|word| is_among(SHAPES, word));
            if matches!(role, Role::Height { .. })
                && !sampled.is_empty(i)
                && (sampled.is_of_numbers(i) || !sampled.are_numbers(i))
            {
                unread.heights.push(i);
            } else if layer || tells_apart {
                unread.parts.push(i);
            } else if of_shape && matches!(role, Role::Other | Role::Unknown) && sampled.is_of_numbers(i) {
                unread.shapes.push(i);
            } else if role == Role::Unknown && measure && !quiet() && !on_globe(i) {
                unread.numbers.push(i);
            }
        }
        unread
    }

    /// How each of them is read, or why not.
    fn ways(&self, chosen: &Chosen, table: &Table<'_>) -> String {
        let mut ways: Vec<String> = Vec::new();
        if let [x, y, ..] = chosen.coordinates[..] {
            let height =
                |z: &usize| format!("`--columns {}` takes `{}` as z", numbers_of([x, y, *z]), table.names([*z]));
            ways.extend(self.heights.iter().take(OFFERED).map(height));
        }
        if let Some(part) = self.parts.first() {
            ways.push(format!(
                "a column that separates contours is chosen by `contour` (`--contour-column \"{}\"`)",
                table.names([*part])
            ));
        }
        if !self.shapes.is_empty() {
            ways.push("only points are read, not radii or arcs between them: put points on the arcs".to_owned());
        }
        if !self.numbers.is_empty() {
            ways.push("coordinates are chosen by `columns` (`--columns`)".to_owned());
        }
        ways.join("; ")
    }
}

impl Chosen {
    /// The sentence about columns that are not read and may be meant to be.
    pub(super) fn not_read(&self, table: &Table<'_>) -> Option<String> {
        let unread = Unread::of(self, table);
        let mut all = [&unread.heights[..], &unread.parts, &unread.shapes, &unread.numbers].concat();
        all.sort_unstable();
        (!all.is_empty()).then(|| format!("not read: {}; {}", table.names(all), unread.ways(self, table)))
    }
}

/// The column of bulges, as dumps of drawings have it: arcs run between the points.
#[derive(Debug)]
pub(super) struct Bulges(Option<usize>);

impl Bulges {
    /// Those of a table whose columns nobody chose.
    pub(super) fn of(table: &Table<'_>, columns: &PointColumns) -> Self {
        let is_bulge = |name: &str| words_of(name).0.iter().any(|word| matches!(word.as_str(), "bulge" | "bulges"));
        let column = table.header.iter().position(|field| is_bulge(field.text));
        Self(column.filter(|_| columns.coordinates.is_none()))
    }

    /// Refuses an arc: read as points, the shape would have its chord.
    pub(super) fn refuse(
        &self,
        source: Source<'_>,
        coordinates: &[usize],
        row: &Row<'_, '_>,
    ) -> Result<(), Box<Diagnostic>> {
        let Some(field) = self.0.and_then(|column| row.fields.get(column)) else { return Ok(()) };
        let bulge = field.text.replacen(',', ".", 1).parse::<f64>();
        if bulge.is_ok_and(|bulge| bulge.abs() > 0.0) {
            let message = format!(
                "an arc with the bulge {} begins here, but only points are read, so its chord would replace it. Put points on the arcs, or take the points as they are (`--columns {}`, in a document `columns`)",
                quoted(field.text),
                numbers_of(coordinates.iter().copied())
            );
            return Err(field.refused(source, message));
        }
        Ok(())
    }
}
