//! The unit that a title or a remark above the data says the coordinates are in: `Coordinates in US survey feet`, `Einheit: m`.

use super::height_words::is_height;
use super::unit::{UnitWord, unit_alone};
use super::words::folded;

/// Words after which such a line says the unit.
const UNITS: &str = "unit units einheit einheiten unite unites unita unidad unidades unidade";
const COORDINATES: &str =
    "coordinate coordinates coords coord koordinaten coordonnees coordenadas easting eastings northing northings";

/// Words between them and the unit.
const BETWEEN: &str = "in en em are is of the all sind ist son sont sono length linear lineal horizontal";

/// The unit that lines say, with the first that says it; `None` if they say several.
pub(super) fn unit_said_by<'a>(lines: &[&'a str]) -> Option<(UnitWord, &'a str)> {
    let mut said = lines.iter().filter_map(|line| unit_said(line).map(|unit| (unit, *line)));
    let first = said.next()?;
    said.all(|(unit, _)| unit == first.0).then_some(first)
}

/// The unit that a line says.
fn unit_said(line: &str) -> Option<UnitWord> {
    let is_among = |list: &str, word: &str| list.split_whitespace().any(|own| own == word);
    let line = line.to_lowercase();
    let words: Vec<&str> =
        line.split(|c: char| c.is_whitespace() || ":=;,()[]|\"".contains(c)).filter(|word| !word.is_empty()).collect();
    let is_one_of = |list: &str, word: &str| matches!(folded(word).as_slice(), [only] if is_among(list, only));
    // Heights have their own unit.
    if words.iter().any(|word| folded(word).iter().any(|word| word.len() > 1 && is_height(word))) {
        return None;
    }
    let of_units = words.iter().rposition(|word| is_one_of(UNITS, word));
    let at = of_units.or_else(|| words.iter().rposition(|word| is_one_of(COORDINATES, word)))?;
    let mut rest = &words[at + 1..];
    // An inch, and no word between.
    if of_units.is_some() && matches!(rest, ["in"]) {
        return unit_alone("in");
    }
    while let Some((_, behind)) = rest.split_first().filter(|(word, _)| is_among(BETWEEN, word)) {
        rest = behind;
    }
    // The name of a system may stand before: `Coordinates: NAD83, in US survey feet`.
    let after_in = rest.iter().rposition(|word| matches!(*word, "in" | "en" | "em")).map(|at| &rest[at + 1..]);
    [Some(rest), after_in].into_iter().flatten().find_map(|words| unit_alone(words.join(" ").trim_end_matches('.')))
}

#[cfg(test)]
mod tests {
    use cyclide::model::Units;

    use super::*;

    #[test]
    fn titles_say_the_unit_of_coordinates_and_of_nothing_else() {
        for (line, unit) in [
            ("Coordinates in US survey feet", Some(Units::UsSurveyFoot)),
            ("All coordinates: NAD83 / Utah, in ft (US survey)", Some(Units::UsSurveyFoot)),
            ("Units: US survey feet", Some(Units::UsSurveyFoot)),
            ("Units;ft", Some(Units::Foot)),
            ("Coordinates are in international feet.", Some(Units::Foot)),
            ("Koordinaten in Metern", Some(Units::Metre)),
            ("Einheit: m", Some(Units::Metre)),
            ("Coordonn\u{e9}es en m\u{e8}tres", Some(Units::Metre)),
            ("Unidades = metros", Some(Units::Metre)),
            ("units: in", Some(Units::Inch)),
            ("Coordinates in", None),
            ("Coordinates in UTM 32", None),
            ("Coordinates in m, heights in ft", None),
            ("Radius in mm", None),
            ("Survey of 12 March", None),
            ("Pipe, DN 200 mm", None),
        ] {
            assert_eq!(unit_said(line), unit.map(UnitWord::Known), "{line}");
        }
        assert_eq!(unit_said_by(&["Units: m", "Coordinates in ft"]), None);
    }
}
