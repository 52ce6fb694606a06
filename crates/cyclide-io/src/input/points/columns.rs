//! Which columns are coordinates: those asked for, else those whose names say so, else the only numbers there are.

use cyclide::model::Units;

use super::fields::is_number;
use super::find::found;
use super::names::{Role, words_of};
use super::point_table::PointColumns;
use super::sampled::Sampled;
use super::table::Table;
use super::unit::UnitWord;
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
        let sampled = Sampled::of(table);
        let (coordinates, remark) = match &columns.coordinates {
            Some(names) if !(2..=3).contains(&names.len()) => {
                let message = format!("{} coordinate columns named, 2 or 3 are needed", names.len());
                return Err(source.diagnostic(0..0, "", message));
            }
            Some(names) => (names.iter().map(required).collect::<Result<Vec<_>, _>>()?, None),
            None => found(table, &sampled, &[contour, corner])?,
        };
        if coordinates.len() < 2 {
            return Err(table.refused("each line needs two or three coordinates"));
        }
        if let Some(k) = (1..coordinates.len()).find(|&k| coordinates[..k].contains(&coordinates[k])) {
            let name = table.names([coordinates[k]]);
            return Err(
                table.refused(format!("the column {name} is chosen twice: each coordinate needs its own column"))
            );
        }
        let taken: Vec<usize> = coordinates.iter().copied().chain(contour).chain(corner).collect();
        let label = label(table, &sampled, &taken);
        let chosen = Self { coordinates, contour, corner, label, remark };
        chosen.refuse_several_units(table)?;
        Ok(chosen)
    }

    /// Units that the names of the coordinates speak of.
    pub(super) fn unit_hints(&self, table: &Table<'_>) -> Vec<(String, Units)> {
        let known = |(i, word): (usize, UnitWord)| match word {
            UnitWord::Known(unit) => {
                let said = || table.said.map(|(_, line)| line.trim());
                Some((table.header.get(i).map(|field| field.text).or_else(said)?.to_owned(), unit))
            }
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
                "the columns {} name a unit that models do not have ({units}): it is ignored, and the coordinates are taken as they are",
                table.names(other)
            )
        })
    }

    /// The coordinates of whose unit the file speaks.
    fn unit_words(&self, table: &Table<'_>) -> Vec<(usize, UnitWord)> {
        self.coordinates.iter().filter_map(|&i| table.unit(i).map(|word| (i, word))).collect()
    }

    /// Refuses coordinates in several units: no model has them.
    pub(super) fn refuse_several_units(&self, table: &Table<'_>) -> Result<(), Box<Diagnostic>> {
        let words = self.unit_words(table);
        if words.windows(2).all(|pair| pair[0].1 == pair[1].1) {
            return Ok(());
        }
        let names = table.names(words.into_iter().map(|(i, _)| i));
        let message = format!("the columns {names} have different units: write all coordinates in one unit");
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
fn label(table: &Table<'_>, sampled: &Sampled, taken: &[usize]) -> Option<usize> {
    let mut free = (0..table.width).filter(|i| !taken.contains(i));
    if table.header.is_empty() {
        let mut texts = free.filter(|i| table.first.get(*i).is_some_and(|f| !f.text.is_empty() && !is_number(f)));
        return texts.next().filter(|_| texts.next().is_none());
    }
    free.find(|i| Role::of(&table.header[*i]) == Role::Label && !sampled.is_empty(*i))
}

#[cfg(test)]
mod tests {
    use super::super::unit::unit_in_name;
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
        for name in [
            "x_us-ft",
            "x [ftUS]",
            "x (US survey feet)",
            "X_USFT",
            "E (US ft)",
            "E (ft (US survey))",
            "N ft US",
            "x_us-survey-feet",
        ] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Known(Units::UsSurveyFoot)), "{name}");
        }
        for name in ["x (int ft)", "E (ft (int))", "N ft (Intl.)"] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Known(Units::Foot)), "{name}");
        }
        for name in ["x_um", "x [km]", "x (\u{b5}m)", "x (\u{3bc}m)", "X_YD"] {
            assert_eq!(unit_in_name(name), Some(UnitWord::Other), "{name}");
        }
    }
}
