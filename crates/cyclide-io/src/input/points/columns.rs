//! Which columns are coordinates: those asked for, else those whose names say so, else the only numbers there are.

use cyclide::Units;

use super::PointColumns;
use super::decimals::is_number;
use super::names::{GLOBE, Role, axis_kind, is_letter, speaks_of, words_of};
use super::sampled::Sampled;
use super::table::Table;
use super::unit::{UnitWord, unit_in_name, unit_of_convention};
use crate::text::place::{Diagnostic, Source, quoted};

/// The columns that are read, as indices.
#[derive(Debug)]
pub(super) struct Chosen {
    pub(super) coordinates: Vec<usize>,
    pub(super) contour: Option<usize>,
    pub(super) corner: Option<usize>,
    /// That of what the points are called.
    pub(super) label: Option<usize>,
    /// The sentence about a choice that could have been another one.
    pub(super) remark: Option<String>,
}

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

/// The only column called `contour_id` or the like.
fn numbers_of_contours(table: &Table<'_>) -> Option<usize> {
    let is_number = |word: &str| matches!(word, "id" | "no" | "nr" | "number" | "num" | "index" | "idx");
    let is_of_contours = |i: &usize| {
        let (words, _) = words_of(table.header[*i].text);
        matches!(words.as_slice(), [first, second] if first == "contour" && is_number(second))
    };
    let mut all = (0..table.header.len()).filter(is_of_contours);
    all.next().filter(|_| all.next().is_none())
}

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
            None => named(table, "contour")?.or_else(|| numbers_of_contours(table)),
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
        let taken: Vec<usize> = coordinates.iter().copied().chain(contour).chain(corner).collect();
        let label = label(table, &taken);
        let chosen = Self { coordinates, contour, corner, label, remark };
        chosen.refuse_several_units(table)?;
        Ok(chosen)
    }

    /// The sentence about columns that are not read and may be meant to be: heights beside two coordinates, layers.
    pub(super) fn not_read(&self, table: &Table<'_>) -> Option<String> {
        let sampled = Sampled::of(table);
        // What stands in runs calls no points, whatever its name.
        let is_label = |i: &usize| self.label == Some(*i) && !sampled.comes_in_runs(*i);
        let read =
            |i: &usize| self.coordinates.contains(i) || [self.contour, self.corner].contains(&Some(*i)) || is_label(i);
        let of_use = |i: &usize| {
            let (words, unit) = words_of(table.header[*i].text);
            let words = &words[..words.len() - usize::from(unit)];
            let layer = matches!(words, [only] if LAYERS.contains(&only.as_str()));
            let tells_apart = self.contour.is_none()
                && sampled.comes_in_runs(*i)
                && (matches!(Role::of(&table.header[*i]), Role::Unknown | Role::Label)
                    || words.iter().any(|word| is_of_parts(word)));
            layer || tells_apart || Role::of(&table.header[*i]) == Role::Height
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

    /// The coordinates whose names, or whose cell of a line of units, speak of a unit.
    fn unit_words(&self, table: &Table<'_>) -> Vec<(usize, UnitWord)> {
        let below = |i: usize| table.units.get(i).copied().flatten();
        let word = |i: usize| {
            let name = table.header.get(i)?.text;
            unit_in_name(name).or(below(i)).or_else(|| unit_of_convention(name)).map(|word| (i, word))
        };
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

/// What the points are called: a column whose name says so, else the only one of texts in a file without names.
fn label(table: &Table<'_>, taken: &[usize]) -> Option<usize> {
    let mut free = (0..table.width).filter(|i| !taken.contains(i));
    if table.header.is_empty() {
        let mut texts = free.filter(|i| table.first.get(*i).is_some_and(|f| !f.text.is_empty() && !is_number(f)));
        return texts.next().filter(|_| texts.next().is_none());
    }
    free.find(|i| Role::of(&table.header[*i]) == Role::Label)
}

/// Coordinates by their names, else the only numbers.
fn found(table: &Table<'_>, taken: &[Option<usize>]) -> Result<Found, Box<Diagnostic>> {
    let free = || (0..table.width).filter(|i| !taken.contains(&Some(*i)));
    let numeric = |i: &usize| table.first.get(*i).is_some_and(is_number);
    if table.header.is_empty() {
        return found_without_names(table, &free().filter(numeric).collect::<Vec<_>>(), free());
    }
    if let [Some(lon), Some(lat)] = GLOBE.map(|words| table.header.iter().position(|f| speaks_of(words, f))) {
        let message = format!(
            "{} are angles on the globe: project them to a plane grid first (UTM or the national one; GIS programs and \
             `cs2cs` do it), and name the columns x_m, y_m",
            table.names([lon, lat])
        );
        return Err(table.header_refused(message));
    }
    let roles: Vec<Role> = table.header.iter().map(Role::of).collect();
    let mut map = [
        one_of(table, &roles, |role| matches!(role, Role::East { .. }))?,
        one_of(table, &roles, |role| matches!(role, Role::North { .. }))?,
    ];
    if let ([None, None], [Some(east), Some(north)]) = (map, ["r", "h"].map(|letter| letter_column(table, letter))) {
        // Rechtswert and Hochwert.
        map = [Some(east), Some(north)];
    }
    let z = axis(table, &roles, "z")?;
    if let (Some(x), Some(y)) = (axis(table, &roles, "x")?, axis(table, &roles, "y")?) {
        let all: Vec<usize> = [x, y].into_iter().chain(z).collect();
        // `x_acc` may be anything, and is no coordinate beside an easting.
        let guessed = |i: &usize| ["x", "y", "z"].iter().any(|letter| axis_kind(letter, &table.header[*i]) == Some(2));
        let guess = all.iter().any(guessed);
        if !(guess && map.iter().all(Option::is_some)) {
            // `X(N)`, `Y(E)`: the letter of the map counts.
            let is_of_map = |i: usize, letter: &str| words_of(table.header[i].text).0.iter().any(|word| word == letter);
            if is_of_map(x, "n") && is_of_map(y, "e") {
                let turned: Vec<usize> = [y, x].into_iter().chain(z).collect();
                let remark = taken_columns(table, &turned);
                return Ok((turned, Some(remark)));
            }
            // As in Gauss-Krüger coordinates, where x is the northing.
            let turned = y + 1 == x && z.is_none_or(|z| z > x);
            let clear = |i: usize| roles[i] == Role::East { clear: true } || roles[i] == Role::North { clear: true };
            if turned && Sampled::of(table).are_on_a_grid([x, y]) {
                return Err(table.header_refused(format!(
                    "y stands before x, and the coordinates are those of a map grid: in German and many other surveys x is the northing. \
                     Choose the easting first, the northing second: `--columns {}` if x is the northing, `--columns {}` if it is the easting (in a \
                     document `columns`)",
                    numbers_of([y, x].into_iter().chain(z)),
                    numbers_of(all)
                )));
            }
            let remark = if turned {
                Some(format!(
                    "{}; y stands before x: if x is the northing, as in Gauss-Krüger coordinates, the curve is mirrored, and `--columns {}` is right",
                    taken_columns(table, &all),
                    numbers_of([y, x].into_iter().chain(z))
                ))
            } else {
                let both = map.iter().flatten().filter(|i| clear(**i)).count() == 2;
                (guess || both).then(|| taken_columns(table, &all))
            };
            return Ok((all, remark));
        }
    }
    let height = |z: Option<usize>| -> Result<Option<usize>, Box<Diagnostic>> {
        z.map_or_else(|| one_of(table, &roles, |role| role == Role::Height), |z| Ok(Some(z)))
    };
    if let [Some(x), Some(y)] = map {
        let all: Vec<usize> = [x, y].into_iter().chain(height(z)?.filter(|z| *z != y)).collect();
        let letters = all.iter().any(|&i| words_of(table.header[i].text).0[0].len() == 1 && roles[i] != Role::Axis);
        let remark = letters.then(|| taken_columns(table, &all));
        return Ok((all, remark));
    }
    let pair = [Role::Abscissa, Role::Ordinate];
    if let [Some(x), Some(y)] = [one_of(table, &roles, |r| r == pair[0])?, one_of(table, &roles, |r| r == pair[1])?] {
        return Ok(([x, y].into_iter().chain(height(z)?).collect(), None));
    }
    // The only numbers there are, if nothing says that they are something else, or the partner of one is missing.
    let possible = |i: &usize| !matches!(roles[*i], Role::Label | Role::Other);
    let numbers: Vec<usize> = free().filter(numeric).filter(possible).collect();
    let heights = numbers.iter().filter(|i| roles[**i] == Role::Height).count();
    let partner_missing = heights > 1 || numbers.iter().any(|i| roles[*i].is_of_a_pair());
    let sampled = Sampled::of(table);
    if (2..=3).contains(&numbers.len()) && !partner_missing && !sampled.numbers_points(&numbers) {
        let remark = taken_columns(table, &numbers);
        return Ok((numbers, Some(remark)));
    }
    let names = table.names(0..table.header.len());
    let all: Vec<usize> = free().filter(numeric).collect();
    let which = match numbers.len() {
        // A profile, of stations and heights, is a curve too.
        0 | 1 if all.len() == 2 => all,
        0 | 1 => Vec::new(),
        _ => sampled.without_numbers(&numbers),
    };
    Err(table.header_refused(format!(
        "no column is named x or y; there are {names}: name two or three of them, x first (`--columns {}`, in a document \
         `columns`)",
        example(&which)
    )))
}

/// The columns of a file without names.
fn found_without_names(
    table: &Table<'_>,
    numbers: &[usize],
    free: impl Iterator<Item = usize>,
) -> Result<Found, Box<Diagnostic>> {
    let sampled = Sampled::of(table);
    if numbers.len() > 2 && sampled.numbers_points(numbers) {
        let others = sampled.without_numbers(numbers);
        let both = if others.len() > 1 {
            format!(
                "; in the order number, northing, easting `--columns {}`",
                numbers_of([others[1], others[0]].into_iter().chain(others.get(2).copied()))
            )
        } else {
            String::new()
        };
        return Err(table.refused(format!(
            "column {} seems to number the points, and the file has no header line to say so: choose the coordinates, x first \
             (`--columns {}`, in a document `columns`){both}; if it is x, `--columns {}`",
            numbers[0] + 1,
            example(&others),
            numbers_of(numbers.iter().copied().take(3)),
        )));
    }
    Ok(match numbers.len() {
        2 | 3 if numbers.len() == table.width => (numbers.to_vec(), None),
        0 | 1 => (free.take(2).collect(), None),
        2 | 3 => (numbers.to_vec(), Some(taken_columns(table, numbers))),
        _ => (numbers[..2].to_vec(), Some(taken_columns(table, &numbers[..2]))),
    })
}

/// Numbers of columns, from 1, as `--columns` takes them.
pub(super) fn numbers_of(columns: impl IntoIterator<Item = usize>) -> String {
    columns.into_iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(",")
}

/// Two or three columns of those that may be meant, as `--columns` takes them.
fn example(columns: &[usize]) -> String {
    match columns.len() {
        0 | 1 => "A,B".to_owned(),
        2 | 3 => numbers_of(columns.iter().copied()),
        _ => numbers_of(columns[..2].iter().copied()),
    }
}

/// The column of a role: a word before a letter that may mean something else; two as clear are refused.
fn one_of(table: &Table<'_>, roles: &[Role], fits: impl Fn(Role) -> bool) -> Result<Option<usize>, Box<Diagnostic>> {
    let all: Vec<usize> = (0..roles.len()).filter(|i| fits(roles[*i])).collect();
    let letter = |i: &usize| words_of(table.header[*i].text).0.first().is_some_and(|word| word.len() == 1);
    let clear: Vec<usize> = all.iter().copied().filter(|i| !letter(i)).collect();
    match if clear.is_empty() { &all[..] } else { &clear[..] } {
        [] => Ok(None),
        [only] => Ok(Some(*only)),
        several => {
            let names = table.names(several.iter().copied());
            let message = format!(
                "several columns may be one coordinate: {names}; choose (`--columns A,B`, in a document `columns`)"
            );
            Err(table.header_refused(message))
        }
    }
}

/// The only column whose name is this letter.
fn letter_column(table: &Table<'_>, letter: &str) -> Option<usize> {
    let mut all = (0..table.header.len()).filter(|i| is_letter(letter, &table.header[*i]));
    all.next().filter(|_| all.next().is_none())
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

/// The column of an axis: `x` before `x_m` before `x_left` before `point_x`; two of the same kind are refused.
fn axis(table: &Table<'_>, roles: &[Role], letter: &str) -> Result<Option<usize>, Box<Diagnostic>> {
    let all = table.header.iter().enumerate().filter(|(i, _)| roles[*i] == Role::Axis);
    let kinds: Vec<(usize, usize)> = all.filter_map(|(i, f)| axis_kind(letter, f).map(|kind| (kind, i))).collect();
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
        for name in ["x_us-ft", "x [ftUS]", "x (US survey feet)", "X_USFT", "E (US ft)"] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Known(Units::UsSurveyFoot)), "{name}");
        }
        for name in ["x_um", "x [km]", "x (\u{b5}m)", "x (\u{3bc}m)", "X_YD"] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Other), "{name}");
        }
    }
}
