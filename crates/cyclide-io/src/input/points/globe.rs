//! Geographic angles: longitudes and latitudes, by the names of their columns, and where these may mean something else by their figures.

use super::fields::Field;
use super::names::{is_of_system, speaks_of};
use super::sampled::Sampled;
use super::table::{Table, numbers_of};
use super::words::folded;
use crate::text::place::Diagnostic;

/// Words that stand for the angles of places on the globe, longitudes first.
pub(super) const GLOBE: [&[&str]; 2] = [
    &[
        "lon",
        "lng",
        "long",
        "longitude",
        "longitud",
        "longitudine",
        "langengrad",
        "laengengrad",
        "\u{434}\u{43e}\u{43b}\u{433}\u{43e}\u{442}\u{430}",
    ],
    &["lat", "latitude", "latitud", "latitudine", "breitengrad", "\u{448}\u{438}\u{440}\u{43e}\u{442}\u{430}"],
];

/// Words that stand for them, or for lengths and widths and other angles, in small letters without accents.
const EITHER: [&[&str]; 2] = [
    &["l", "lambda", "\u{3bb}", "lange", "laenge", "la", "dlugosc"],
    &["b", "phi", "\u{3c6}", "\u{3d5}", "breite", "br", "szerokosc"],
];

/// Words beside them that say that they are angles,
const ANGLES: &str = "deg degree degrees grad dd dez dezimal decimal wgs geogr geographisch geographische geog geo geod geodatisch geodatische \
    ell ellips ellipsoidisch ellipsoidische gps gnss";

/// Degrees of places that are known to a meter have so many figures behind the point; coordinates in meters have fewer.
const FIGURES: usize = 5;
/// Most degrees from the equator and from Greenwich.
const MOST: [f64; 2] = [180.0, 90.0];
/// Coordinates that are measured in degrees lie nearer to each other than this part of their distance from 0, and than so many degrees: those of a
/// site, and of a region.
const NEAR: f64 = 0.05;
const SITE: f64 = 0.05;
const REGION: f64 = 2.0;

/// The columns of longitudes and latitudes.
pub(super) fn on_the_globe(table: &Table<'_>, sampled: &Sampled) -> Option<[usize; 2]> {
    by_names(table).or_else(|| by_figures(table, sampled))
}

fn by_names(table: &Table<'_>) -> Option<[usize; 2]> {
    match GLOBE.map(|words| table.header.iter().position(|f| speaks_of(words, f))) {
        [Some(lon), Some(lat)] => Some([lon, lat]),
        _ => None,
    }
}

/// The columns of words that may mean something else, where their figures are those of degrees.
fn by_figures(table: &Table<'_>, sampled: &Sampled) -> Option<[usize; 2]> {
    let [lon, lat] = EITHER.map(|words| {
        let mut found = (0..table.header.len()).filter(|i| may_be_angle(&table.header[*i], words));
        found.next().filter(|_| found.next().is_none())
    });
    let pair = [lon?, lat?];
    if pair.iter().any(|i| table.columns_have_units(&[*i])) {
        return None;
    }
    let is_said = || pair.iter().all(|i| says_angle(&table.header[*i])) || units_are_angles(table, pair);
    let are_degrees = fit(sampled, pair) && (has_figures(sampled, pair) || is_said());
    (has_signs(table, pair) || are_degrees).then_some(pair)
}

/// True if degrees are written with their sign.
fn has_signs(table: &Table<'_>, pair: [usize; 2]) -> bool {
    let is = |i: &usize| table.first.get(*i).is_some_and(|field| field.text.contains(['\u{b0}', '\u{ba}']));
    pair.iter().all(is)
}

/// True for the name of one of some words, alone or beside the name of a system, or words that say what it is.
fn may_be_angle(field: &Field<'_>, words: &[&str]) -> bool {
    let name = folded(field.text);
    let own = |word: &&String| words.contains(&word.as_str());
    let beside = |word: &String| is_of_system(word) || is_angle(word);
    name.iter().filter(own).count() == 1 && name.iter().all(|word| own(&word) || beside(word))
}

fn is_angle(word: &str) -> bool {
    ANGLES.split_whitespace().any(|own| own == word.trim_end_matches(|c: char| c.is_ascii_digit()))
}

fn says_angle(field: &Field<'_>) -> bool {
    field.text.contains('\u{b0}') || folded(field.text).iter().any(|word| is_angle(word))
}

/// True if a line of units says so.
fn units_are_angles(table: &Table<'_>, pair: [usize; 2]) -> bool {
    let is = |i: &usize| table.unit_words.get(*i).is_some_and(says_angle);
    pair.iter().all(is)
}

/// True if numbers can be longitudes and latitudes.
fn fit(sampled: &Sampled, pair: [usize; 2]) -> bool {
    pair.iter()
        .zip(MOST)
        .all(|(i, most)| sampled.range(*i).is_some_and(|range| range.iter().all(|value| value.abs() <= most)))
}

fn has_figures(sampled: &Sampled, pair: [usize; 2]) -> bool {
    pair.iter().all(|i| sampled.decimals(*i) >= FIGURES)
}

/// Whether two columns are degrees by their figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Degrees {
    /// They are, if their names are those of directions: nobody measures a site of a few centimeters to a hundredth of a millimeter, meters from
    /// the origin.
    Certain,
    Possible,
    No,
}

impl Degrees {
    /// Of two columns that are to be coordinates: degrees have many figures behind the point, are near to each other and far from 0.
    pub(super) fn of(table: &Table<'_>, sampled: &Sampled, pair: [usize; 2]) -> Self {
        let [first, second] = pair;
        let are_degrees = !table.columns_have_units(&pair)
            && table.said.is_none()
            && (fit(sampled, pair) || fit(sampled, [second, first]))
            && has_figures(sampled, pair);
        let within = |span: f64| {
            let is_near = |[low, high]: [f64; 2]| high - low <= span.min(NEAR * low.abs().max(high.abs()));
            pair.iter().all(|i| sampled.range(*i).is_some_and(is_near))
        };
        if are_degrees && within(SITE) {
            Self::Certain
        } else if are_degrees && within(REGION) {
            Self::Possible
        } else {
            Self::No
        }
    }

    /// What is said of coordinates that may be degrees.
    pub(super) fn remark(before: String) -> String {
        before
            + "; by their values they may be longitudes and latitudes in degrees: then project them to a plane grid first (UTM or the national one, with a GIS program or `cs2cs`)"
    }
}

/// The refusal of angles on the globe, with the remedy; `lengths` are the columns that are read where they are lengths nevertheless, unless their names
/// or signs leave no doubt.
pub(super) fn refused_on_the_globe(table: &Table<'_>, globe: [usize; 2], lengths: &[usize]) -> Box<Diagnostic> {
    let is_certain = by_names(table) == Some(globe) || has_signs(table, globe);
    let (values, otherwise) = if is_certain {
        ("", String::new())
    } else {
        let columns = numbers_of(lengths.iter().copied());
        (
            " by their values",
            format!("; `--columns {columns}` takes them as lengths nevertheless (in a document `columns`)"),
        )
    };
    table.header_refused(format!(
        "{} are geographic angles{values}: project them to a plane grid first (UTM or the national one, with a GIS program or `cs2cs`), and name the columns x_m, y_m{otherwise}",
        table.names(globe)
    ))
}

#[cfg(test)]
mod tests {
    use super::super::{PointColumns, read_points};

    fn read(text: &str, columns: Option<&str>) -> Result<Vec<[f64; 3]>, String> {
        let coordinates = columns.map(|columns| columns.split(',').map(str::to_owned).collect());
        let columns = PointColumns { coordinates, ..PointColumns::default() };
        let table = read_points("p.csv", text.as_bytes(), &columns).map_err(|refused| refused.message)?;
        Ok(table.contours[0].points.iter().map(|p| p.to_array()).collect())
    }

    #[test]
    fn angles_by_the_words_of_geodesy_are_refused() {
        let rows = "50.0001234;10.0002345;212.5\n50.0001934;10.0001945;212.8\n50.0002634;10.0003645;213.5\n";
        for header in [
            "phi;lambda;h",
            "\u{3c6};\u{3bb};h",
            "WGS84 B;WGS84 L;h",
            "B;L;H",
            "B [\u{b0}];L [\u{b0}];H",
            "Breite;L\u{e4}nge;H\u{f6}he",
            "Geogr. Breite;Geogr. L\u{e4}nge;Ell. H\u{f6}he",
            "breite_grad;laenge_grad;hoehe",
            "Lat.;Lon.;Alt.",
            "latitude_deg;longitude_deg;alt",
            "\u{448}\u{438}\u{440}\u{43e}\u{442}\u{430};\u{434}\u{43e}\u{43b}\u{433}\u{43e}\u{442}\u{430};h",
            "N;E;H",
            "GPS N;GPS E;H",
            "Nord;Ost;H\u{f6}he",
        ] {
            let refused = read(&format!("{header}\n{rows}"), None).unwrap_err();
            assert!(refused.contains("are geographic angles"), "{header}: {refused}");
            // What is offered for lengths reads them, with their heights.
            if let Some((_, rest)) = refused.split_once("--columns ") {
                let columns = rest.split('`').next().unwrap();
                assert!(refused.contains("by their values") && columns.len() == 5, "{header}: {refused}");
                assert!((read(&format!("{header}\n{rows}"), Some(columns)).unwrap()[0][2] - 212.5).abs() < 1e-12);
            }
        }
        let signs = "Punkt;Breite;L\u{e4}nge\n1;49\u{b0}10'12.3\"N;8\u{b0}10'1.2\"E\n";
        let refused = read(signs, None).unwrap_err();
        assert!(refused.contains("are geographic angles:") && !refused.contains("--columns"), "{refused}");
    }

    #[test]
    fn lengths_with_such_names_are_read_or_chosen() {
        let first = |text: &str| format!("{:?}", read(text, None).unwrap()[0]);
        // Three figures behind the point, or values that no angle has.
        assert_eq!(first("B;L\n10.125;20.250\n11.125;21.250\n"), "[10.125, 20.25, 0.0]");
        assert_eq!(first("b;l\n410.12525;20.25025\n11.12525;21.25025\n"), "[410.12525, 20.25025, 0.0]");
        assert_eq!(first("B [m];L [m]\n10.12525;20.25025\n11.12525;21.25025\n"), "[10.12525, 20.25025, 0.0]");
        // A way of a vehicle from its start on, in meters.
        let way = "east,north\n0.0000000,0.0000000\n0.4523412,0.1232211\n0.9512344,0.3423422\n";
        assert_eq!(read(way, None).unwrap().len(), 3);
        // A region is said.
        let region = "E;N\n10.12345;50.12345\n10.62345;50.82345\n";
        let table = read_points("p.csv", region.as_bytes(), &PointColumns::default()).unwrap();
        assert!(table.remarks.iter().any(|remark| remark.message.contains("in degrees")), "{:?}", table.remarks);
        let far = "E;N\n456000.12345;5432000.12345\n456001.12345;5432001.12345\n";
        assert_eq!(read(far, None).unwrap().len(), 2);
    }
}
