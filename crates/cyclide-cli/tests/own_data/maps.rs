//! Maps in tables: whatever the words, the order, the separators and the units, no map comes out as its mirror image in silence, and no command
//! that is offered first makes one.

use cyclide_io::input::{PointColumns, PointTable, read_points, unit_of_columns};

use crate::common::Folder;

/// Points of a plan, east and north of its corner, that have no mirror image among themselves.
const PLAN: [[f64; 2]; 6] = [[0.0, 0.0], [4.134, 5.378], [8.038, 10.502], [14.5, 11.25], [21.75, 9.125], [24.0, 2.5]];

/// Corners of plans: UTM, Swiss LV95, Gauss-Krüger, Lambert 93; local ones, of which figures tell nothing.
const GRIDS: [[f64; 2]; 4] =
    [[432_000.0, 5_412_000.0], [2_600_000.0, 1_200_000.0], [3_456_000.0, 5_432_000.0], [652_000.0, 6_862_000.0]];
const LOCAL: [[f64; 2]; 2] = [[0.0, 0.0], [5_123.0, 2_044.0]];

/// Names of easting and northing in six languages.
const WORDS: [[&str; 2]; 20] = [
    ["Easting", "Northing"],
    ["East", "North"],
    ["eastings", "northings"],
    ["Rechtswert", "Hochwert"],
    ["GK_R", "GK_H"],
    ["R", "H"],
    ["Ost", "Nord"],
    ["Ostwert", "NORDWERT"],
    ["Östlich", "Nördlich"],
    ["OESTLICH", "NOERDLICH"],
    ["Osten", "Norden"],
    ["Est", "Nord"],
    ["Coord. Est", "Coord. Nord"],
    ["Coordonnée Est", "Coordonnée Nord"],
    ["Este", "Norte"],
    ["Leste", "Norte"],
    ["Coordenada Leste", "Coordenada Norte"],
    ["E", "N"],
    ["UTM_E", "UTM_N"],
    ["E_LV95", "N_LV95"],
];

/// How a table is written.
#[derive(Clone, Copy)]
struct Dialect {
    separator: &'static str,
    /// Between thousands, and before fractions.
    thousands: &'static str,
    decimal: &'static str,
    /// The name of the numbers of the points, or none.
    label: &'static str,
    /// Behind the names.
    unit: &'static str,
    northing_first: bool,
}

/// All that go with each other.
fn dialects() -> Vec<Dialect> {
    let mut all = Vec::new();
    for (separator, thousands, decimal) in [
        (",", "", "."),
        (";", "'", "."),
        (";", "\u{a0}", ","),
        (";", "\u{202f}", ","),
        ("\t", "\u{2019}", "."),
        (";", ".", ","),
    ] {
        for label in ["", "Nr.", "#"] {
            for unit in ["", " [m]"] {
                for northing_first in [false, true] {
                    all.push(Dialect { separator, thousands, decimal, label, unit, northing_first });
                }
            }
        }
    }
    all
}

impl Dialect {
    fn number(self, value: f64) -> String {
        let text = format!("{value:.3}");
        let (whole, fraction) = text.split_once('.').unwrap();
        let mut grouped = String::new();
        for (k, c) in whole.chars().enumerate() {
            if k > 0 && (whole.len() - k) % 3 == 0 {
                grouped.push_str(self.thousands);
            }
            grouped.push(c);
        }
        format!("{grouped}{}{fraction}", self.decimal)
    }

    /// The text of a table.
    fn table(self, [east, north]: [&str; 2], corner: [f64; 2]) -> String {
        let pair = |east: String, north: String| if self.northing_first { [north, east] } else { [east, north] };
        let name = |word: &str| format!("{word}{}", self.unit);
        let label = |text: String| (!self.label.is_empty()).then_some(text);
        let names = label(self.label.to_owned()).into_iter().chain(pair(name(east), name(north)));
        let mut lines = vec![names.collect::<Vec<_>>().join(self.separator)];
        for (k, [e, n]) in PLAN.into_iter().enumerate() {
            let numbers = pair(self.number(corner[0] + e), self.number(corner[1] + n));
            let cells = label((100 + k).to_string()).into_iter().chain(numbers);
            lines.push(cells.collect::<Vec<_>>().join(self.separator));
        }
        lines.join("\n") + "\n"
    }
}

/// Twice the area that the points enclose, which is negative for the plan and positive for its mirror image.
fn is_mirrored(table: &PointTable) -> bool {
    let points: Vec<[f64; 2]> = table.contours.iter().flat_map(|list| &list.points).map(|p| [p.x, p.y]).collect();
    let from = points[0];
    let area: f64 = points
        .windows(2)
        .map(|pair| {
            let [a, b] = [0, 1].map(|k| [pair[k][0] - from[0], pair[k][1] - from[1]]);
            a[0] * b[1] - a[1] * b[0]
        })
        .sum();
    area > 0.0
}

fn read(text: &str, columns: Option<Vec<String>>) -> Result<PointTable, String> {
    let columns = PointColumns { coordinates: columns, ..PointColumns::default() };
    read_points("t.csv", text.as_bytes(), &columns).map_err(|refused| refused.message)
}

/// The first command that a message offers.
fn offered(message: &str) -> Vec<String> {
    let (_, rest) = message.split_once("--columns ").unwrap_or_else(|| panic!("{message}"));
    rest.split('`').next().unwrap().split(',').map(str::to_owned).collect()
}

/// True if a remark says that what is read may be a mirror image.
fn says_so(table: &PointTable) -> bool {
    table.remarks.iter().any(|remark| remark.message.contains("mirror"))
}

/// Reads a table; where it is refused, with the first command offered. It may be mirrored only where figures and words tell nothing, and a remark says so.
fn is_read_right(text: &str, figures_tell: bool) {
    let read_at_once = read(text, None);
    let found = match &read_at_once {
        Ok(found) => found.clone(),
        Err(message) => read(text, Some(offered(message))).unwrap_or_else(|again| panic!("{message}\n{again}\n{text}")),
    };
    let known = !figures_tell && says_so(&found);
    assert!(!is_mirrored(&found) || known, "{:?}\n{text}", read_at_once.map(|found| found.remarks));
}

#[test]
fn words_of_the_map_are_read_in_any_order() {
    for words in WORDS {
        for dialect in dialects() {
            for corner in GRIDS.into_iter().chain(LOCAL) {
                let text = dialect.table(words, corner);
                let found = read(&text, None).unwrap_or_else(|message| panic!("{message}\n{text}"));
                assert!(!is_mirrored(&found), "{text}");
            }
        }
    }
}

/// A word that nobody knows beside one of the map: it is its partner, and the easting is offered first.
#[test]
fn one_known_word_tells_the_order() {
    for [east, north] in
        [["Easting", "foo"], ["foo", "Norte"], ["Abc", "Hochwert"], ["Östlich", "bar"], ["xyz", "Nordkoord."]]
    {
        for dialect in dialects() {
            for corner in GRIDS.into_iter().chain(LOCAL) {
                is_read_right(&dialect.table([east, north], corner), true);
            }
        }
    }
}

/// Letters of axes, and words that nobody knows: only the figures tell.
#[test]
fn figures_of_map_grids_tell_the_order() {
    for words in [["Y", "X"], ["X", "Y"], ["Y-Koordinate", "X-Koordinate"], ["X_UTM", "Y_UTM"], ["foo", "bar"]] {
        for dialect in dialects() {
            for corner in GRIDS {
                is_read_right(&dialect.table(words, corner), true);
            }
        }
    }
}

/// What is typed is read, and said where it is a mirror image.
#[test]
fn columns_that_are_typed_are_read_and_a_mirror_image_is_said() {
    for words in [["Easting", "Northing"], ["Y", "X"], ["foo", "bar"]] {
        for dialect in dialects().into_iter().filter(|dialect| dialect.label.is_empty()) {
            for corner in GRIDS {
                let text = dialect.table(words, corner);
                for columns in [["1", "2"], ["2", "1"]] {
                    let found = read(&text, Some(columns.map(str::to_owned).to_vec())).unwrap();
                    assert_eq!(is_mirrored(&found), says_so(&found), "{columns:?}\n{text}");
                }
            }
        }
    }
    let folder = Folder::with(&[("p.csv", "foo;bar\n5432000;456000\n5432010;456020\n5432040;456030\n")]);
    let run = folder.run("curve p.csv --columns 1,2 --units m -o p.json");
    assert!(run.code == 0 && run.stderr.contains("[northing-first]"), "{}", run.stderr);
}

/// Feet of the United States, in names, below them and above.
#[test]
fn feet_are_known_wherever_they_are_said() {
    let rows = "1500000.1;200000.2\n1500010.1;200020.2\n1500040.1;200030.2\n";
    for (unit, symbol) in [
        ("ft (US survey)", "us-ft"),
        ("US survey ft", "us-ft"),
        ("US survey feet", "us-ft"),
        ("ftUS", "us-ft"),
        ("survey ft", "us-ft"),
        ("int ft", "ft"),
        ("ft (int)", "ft"),
        ("international feet", "ft"),
    ] {
        for head in [
            format!("Easting ({unit});Northing ({unit})"),
            format!("Easting [{unit}];Northing [{unit}]"),
            format!("x ({unit});y ({unit})"),
            format!("Easting;Northing\n({unit});({unit})"),
            format!("Coordinates in {unit}\nEasting;Northing"),
            format!("# Units: {unit}\nEasting;Northing"),
            format!("Survey of Mill Lane\nUnits: {unit}\nx;y"),
        ] {
            let text = format!("{head}\n{rows}");
            let found = read(&text, None).unwrap_or_else(|message| panic!("{message}\n{text}"));
            let unit = unit_of_columns(text.as_bytes(), &PointColumns::default());
            assert_eq!(unit.map(|found| found.unit.symbol()), Some(symbol), "{text}");
            assert!(found.unit_hints.iter().all(|(_, unit)| unit.symbol() == symbol), "{text}");
            assert!(found.remarks.is_empty(), "{:?}\n{text}", found.remarks);
            let of_title = head.contains("Coordinates in") || head.contains("Units: ");
            let note = format!("the coordinates are in {symbol}, according to `");
            assert_eq!(found.notes.iter().any(|own| own.starts_with(&note)), of_title, "{:?}\n{text}", found.notes);
        }
    }
}
