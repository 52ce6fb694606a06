//! Which columns are coordinates: those asked for, else those whose names say so, else the only numbers there are.

use cyclide::Units;

use super::PointColumns;
use super::decimals::is_number;
use super::table::{Field, Table};
use super::unit::UnitWord;
use crate::text::place::{Diagnostic, Source, quoted};

/// The columns that are read, as indices.
#[derive(Debug)]
pub(super) struct Chosen {
    pub(super) coordinates: Vec<usize>,
    pub(super) contour: Option<usize>,
    pub(super) corner: Option<usize>,
    /// The sentence about a choice that could have been another one.
    pub(super) remark: Option<String>,
}

/// Names of columns that are numbers and no coordinates.
const NOT_COORDINATES: [&str; 16] = [
    "id",
    "fid",
    "oid",
    "no",
    "nr",
    "num",
    "number",
    "index",
    "idx",
    "point",
    "pt",
    "time",
    "timestamp",
    "t",
    "date",
    "row",
];

/// Words that stand for the first and the second coordinate of maps.
const COMPASS: [&[&str]; 2] =
    [&["e", "east", "easting", "eastings", "rechtswert"], &["n", "north", "northing", "northings", "hochwert"]];

/// Words that stand for the angles of places on the globe.
const GLOBE: [&[&str]; 2] = [&["lon", "lng", "long", "longitude"], &["lat", "latitude"]];

/// Words in names of columns that a curve has a use for beside its x and y: heights, and what tells contours apart.
const OF_USE: [&str; 14] = [
    "h",
    "height",
    "elevation",
    "elev",
    "altitude",
    "alt",
    "höhe",
    "hoehe",
    "höhen",
    "level",
    "layer",
    "ebene",
    "polyline",
    "part",
];

/// Words beside the letter of an axis: `point_x`, `x coordinate`.
const BESIDE: [&str; 9] = ["coord", "coords", "coordinate", "point", "pt", "pos", "position", "p", "loc"];

/// Coordinate columns that were found, with the sentence about a choice that could have been another one.
type Found = (Vec<usize>, Option<String>);

impl Chosen {
    pub(super) fn new(source: Source<'_>, table: &Table<'_>, columns: &PointColumns) -> Result<Self, Box<Diagnostic>> {
        let required = |name: &String| {
            let by_number = || name.parse::<usize>().ok().filter(|n| (1..=table.width).contains(n)).map(|n| n - 1);
            named(table, name)?.or_else(by_number).ok_or_else(|| table.no_column(name))
        };
        let contour = match &columns.contour {
            Some(name) => Some(required(name)?),
            None => named(table, "contour")?,
        };
        let corner = named(table, "corner")?;
        let (coordinates, remark) = match &columns.coordinates {
            Some(names) if !(2..=3).contains(&names.len()) => {
                let message = format!("{} coordinate columns named, 2 or 3 are needed", names.len());
                return Err(source.diagnostic(0..0, "", message));
            }
            Some(names) => (names.iter().map(required).collect::<Result<Vec<_>, _>>()?, None),
            None => found(table, &[contour, corner])?,
        };
        if coordinates.len() < 2 {
            return Err(table.refused("two or three coordinates are needed in each line"));
        }
        if let Some(k) = (1..coordinates.len()).find(|&k| coordinates[..k].contains(&coordinates[k])) {
            let name = table.names([coordinates[k]]);
            return Err(table.refused(format!("the column {name} is asked for twice: each coordinate has its own")));
        }
        let chosen = Self { coordinates, contour, corner, remark };
        chosen.refuse_several_units(table)?;
        Ok(chosen)
    }

    /// The sentence about columns that are not read and may be meant to be: heights beside two coordinates, layers.
    pub(super) fn not_read(&self, table: &Table<'_>) -> Option<String> {
        let read = |i: &usize| self.coordinates.contains(i) || [self.contour, self.corner].contains(&Some(*i));
        let of_use = |i: &usize| {
            let (words, unit) = words_of(table.header[*i].text);
            let words = &words[..words.len() - usize::from(unit)];
            matches!(words, [only] if OF_USE.contains(&only.as_str()))
        };
        let all: Vec<usize> = (0..table.header.len()).filter(|i| !read(i)).filter(of_use).collect();
        (!all.is_empty()).then(|| {
            format!(
                "not read: {}; a third coordinate is chosen by `columns`, a column that tells contours apart by `contour` \
                 (`--columns`, `--contour-column`)",
                table.names(all)
            )
        })
    }

    /// Units that the names of the coordinates speak of.
    pub(super) fn unit_hints(&self, table: &Table<'_>) -> Vec<(String, Units)> {
        let known = |(i, word): (usize, UnitWord)| match word {
            UnitWord::Known(unit) => Some((table.header.get(i)?.text.to_owned(), unit)),
            UnitWord::Other => None,
        };
        self.unit_words(table).into_iter().filter_map(known).collect()
    }

    /// The sentence about names that speak of a unit which no model has.
    pub(super) fn unit_not_applied(&self, table: &Table<'_>) -> Option<String> {
        let other: Vec<usize> =
            self.unit_words(table).into_iter().filter(|(_, word)| *word == UnitWord::Other).map(|(i, _)| i).collect();
        let units = Units::ALL.map(Units::symbol).join(", ");
        (!other.is_empty()).then(|| {
            format!(
                "the names of the columns {} speak of a unit that models do not have ({units}): it is not applied, \
                 coordinates are taken as they are",
                table.names(other)
            )
        })
    }

    /// The coordinates whose names speak of a unit.
    fn unit_words(&self, table: &Table<'_>) -> Vec<(usize, UnitWord)> {
        let word = |i: usize| unit_in_name(table.header.get(i)?.text).map(|word| (i, word));
        self.coordinates.iter().filter_map(|&i| word(i)).collect()
    }

    /// Refuses coordinates in several units: no model has them.
    pub(super) fn refuse_several_units(&self, table: &Table<'_>) -> Result<(), Box<Diagnostic>> {
        let words = self.unit_words(table);
        if words.windows(2).all(|pair| pair[0].1 == pair[1].1) {
            return Ok(());
        }
        let names = table.names(words.into_iter().map(|(i, _)| i));
        let message =
            format!("the columns {names} speak of different units: write all coordinates in one, and name it once");
        Err(table.header_refused(message))
    }
}

/// The column of a name; one that two columns have is refused.
fn named(table: &Table<'_>, name: &str) -> Result<Option<usize>, Box<Diagnostic>> {
    let mut all = table.header.iter().enumerate().filter(|(_, f)| f.text.eq_ignore_ascii_case(name)).map(|(i, _)| i);
    let first = all.next();
    match all.next() {
        None => Ok(first),
        Some(_) => {
            let message = format!("two columns are named `{}`: choose by numbers", quoted(name));
            Err(table.header_refused(message))
        }
    }
}

/// Coordinates by their names, else the only numbers.
fn found(table: &Table<'_>, taken: &[Option<usize>]) -> Result<Found, Box<Diagnostic>> {
    let is_one_of = |words: &[&str], field: &Field<'_>| {
        let (name, unit) = words_of(field.text);
        let name = if unit { &name[..name.len() - 1] } else { &name[..] };
        matches!(name, [only] if words.contains(&only.as_str()))
    };
    let by_words = |words: &[&str]| table.header.iter().position(|f| is_one_of(words, f));
    let compass = COMPASS.map(by_words);
    if let [Some(lon), Some(lat)] = GLOBE.map(|words| table.header.iter().position(|f| speaks_of(words, f))) {
        let message = format!(
            "{} are angles on the globe: project them to a plane grid first (UTM or the national one; GIS programs and \
             `cs2cs` do it), and name the columns x_m, y_m",
            table.names([lon, lat])
        );
        return Err(table.header_refused(message));
    }
    if let (Some(x), Some(y)) = (axis(table, "x")?, axis(table, "y")?) {
        let all: Vec<usize> = [x, y].into_iter().chain(axis(table, "z")?).collect();
        // `x_acc` may be anything, and is no coordinate beside an easting.
        let guessed = |i: &usize| ["x", "y", "z"].iter().any(|letter| axis_kind(letter, &table.header[*i]) == Some(2));
        let guess = all.iter().any(guessed);
        if !(guess && compass.iter().all(Option::is_some)) {
            let remark = guess.then(|| taken_columns(table, &all));
            return Ok((all, remark));
        }
    }
    if let [Some(x), Some(y)] = compass {
        let all: Vec<usize> = [x, y].into_iter().chain(axis(table, "z")?).collect();
        let letters = all.iter().any(|&i| words_of(table.header[i].text).0[0].len() == 1);
        let remark = letters.then(|| taken_columns(table, &all));
        return Ok((all, remark));
    }
    let free = (0..table.width).filter(|&i| !taken.contains(&Some(i)));
    let numeric = |i: &usize| table.first.get(*i).is_some_and(is_number);
    if table.header.is_empty() {
        let numbers: Vec<usize> = free.clone().filter(numeric).collect();
        return Ok(match numbers.len() {
            2 | 3 if numbers.len() == table.width => (numbers, None),
            0 | 1 => (free.take(2).collect(), None),
            2 | 3 => (numbers.clone(), Some(taken_columns(table, &numbers))),
            _ => (numbers[..2].to_vec(), Some(taken_columns(table, &numbers[..2]))),
        });
    }
    let other = |i: &usize| {
        table.header.get(*i).is_some_and(|f| NOT_COORDINATES.iter().any(|n| f.text.eq_ignore_ascii_case(n)))
    };
    let numbers: Vec<usize> = free.filter(numeric).filter(|i| !other(i)).collect();
    if (2..=3).contains(&numbers.len()) {
        let remark = taken_columns(table, &numbers);
        return Ok((numbers, Some(remark)));
    }
    let names = table.names(0..table.header.len());
    Err(table.header_refused(format!(
        "no column is named x or y; there are {names}: name two or three of them (`--columns A,B`, in a document \
         `columns`)"
    )))
}

/// True if a word of a column's name is one of these, or ends in a long one: `lat_deg`, `X (Longitude)`, `GPSLatitude`.
fn speaks_of(words: &[&str], field: &Field<'_>) -> bool {
    let known = |word: &String| words.iter().any(|w| word == w || w.len() > 4 && word.ends_with(w));
    words_of(field.text).0.iter().any(known)
}

fn taken_columns(table: &Table<'_>, columns: &[usize]) -> String {
    let names = table.names(columns.iter().copied());
    let all = if table.header.is_empty() {
        format!(" of {} (the file has no header line)", table.width)
    } else {
        String::new()
    };
    format!("the columns {names}{all} are taken as coordinates; `columns` chooses others")
}

/// How a column's name speaks of an axis: `x` (0), `x_m` or `x coordinate` (1), `x_left` (2), `point_x` (3).
pub(super) fn axis_kind(letter: &str, field: &Field<'_>) -> Option<usize> {
    let (words, unit) = words_of(field.text);
    let beside = |word: &String| BESIDE.contains(&word.as_str());
    let joined = |word: &str| BESIDE.iter().any(|b| word == format!("{letter}{b}") || word == format!("{b}{letter}"));
    match words.as_slice() {
        [only] if only == letter => Some(0),
        [first, _] if first == letter && unit => Some(1),
        [first, second, ..] if first == letter && beside(second) => Some(1),
        [first, ..] if first == letter => Some(2),
        [before, last] if beside(before) && last == letter => Some(3),
        [before, last, _] if beside(before) && last == letter && unit => Some(3),
        [first, ..] if joined(first) => Some(3),
        _ => None,
    }
}

/// The column of an axis: `x` before `x_m` before `x_left` before `point_x`; two of the same kind are refused.
fn axis(table: &Table<'_>, letter: &str) -> Result<Option<usize>, Box<Diagnostic>> {
    let kinds: Vec<(usize, usize)> =
        table.header.iter().enumerate().filter_map(|(i, f)| axis_kind(letter, f).map(|kind| (kind, i))).collect();
    let Some(best) = kinds.iter().map(|(kind, _)| *kind).min() else { return Ok(None) };
    let of_it: Vec<usize> = kinds.iter().filter(|(kind, _)| *kind == best).map(|(_, i)| *i).collect();
    match of_it.as_slice() {
        [only] => Ok(Some(*only)),
        several => {
            let names = table.names(several.iter().copied());
            let message =
                format!("several columns may be {letter}: {names}; choose (`--columns A,B`, in a document `columns`)");
            Err(table.header_refused(message))
        }
    }
}

/// The words of a column's name in small letters, and whether the last is a unit.
pub(super) fn words_of(name: &str) -> (Vec<String>, bool) {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty()).map(str::to_lowercase);
    let words: Vec<String> = words.collect();
    let unit = words.len() > 1 && unit_in_name(name).is_some();
    (words, unit)
}

/// The unit a column's name speaks of: `x_m`, `x [mm]`, `x (inch)`, `x/ft`.
fn unit_in_name(name: &str) -> Option<UnitWord> {
    let mut words = name.split(['_', ' ', '[', ']', '(', ')', '/']).filter(|w| !w.is_empty());
    words.next()?;
    UnitWord::of(&words.next_back()?.to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_from_names() {
        for (name, unit) in [
            ("x_inch", Some(Units::Inch)),
            ("x (inches)", Some(Units::Inch)),
            ("x_feet", Some(Units::Foot)),
            ("X_Foot", Some(Units::Foot)),
            ("x_metres", Some(Units::Metre)),
            ("x [millimeter]", Some(Units::Millimetre)),
            ("x_m", Some(Units::Metre)),
            ("x [mm]", Some(Units::Millimetre)),
            ("x_in", Some(Units::Inch)),
            ("X (ft)", Some(Units::Foot)),
            ("x/cm", Some(Units::Centimetre)),
            ("x", None),
            ("m", None),
            ("x_left", None),
        ] {
            assert_eq!(unit_in_name(name), unit.map(UnitWord::Known), "{name}");
        }
        for name in ["x_um", "x [km]", "x (\u{b5}m)", "x (\u{3bc}m)", "X_YD"] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Other), "{name}");
        }
    }
}
