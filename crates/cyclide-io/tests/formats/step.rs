//! What only STEP has: its text rules, units, names and the choice of entities.

use crate::models::{Map, bulges, flat, mixed, model, splines, tilted};
use cyclide::model::{CurveObject, Units};
use cyclide_io::{
    ExportOptions, Format,
    formats::{export, file_deviation},
};

fn text(m: &cyclide::model::Model) -> String {
    let file = export(m, Format::Step, &ExportOptions::default()).unwrap();
    unfolded(&String::from_utf8(file.bytes).unwrap())
}

/// The text with every instance on one line.
pub(crate) fn unfolded(text: &str) -> String {
    let mut out = String::new();
    for line in text.lines() {
        out.push_str(line);
        out.push_str(if line.ends_with(';') {
            "\n"
        } else if line.ends_with([',', '(']) {
            ""
        } else {
            " "
        });
    }
    out
}

/// The instances whose text contains a word, by the numbers that they refer to.
fn found<'a>(text: &'a str, word: &str) -> Vec<(&'a str, Vec<&'a str>)> {
    let numbers = |line: &'a str| {
        let references = line.split('#').skip(2);
        references.map(|r| r.split(|c: char| !c.is_ascii_digit()).next().unwrap_or("")).collect()
    };
    text.lines().filter(|l| l.contains(word)).map(|l| (l, numbers(l))).collect()
}

/// The number of the instance on a line.
fn number(line: &str) -> &str {
    line[1..].split('=').next().unwrap()
}

#[test]
fn text_is_ascii_with_capital_exponents_and_numbered_references() {
    for m in splines().into_iter().map(|(_, m)| m).chain([mixed(tilted)]) {
        let text = text(&m);
        assert!(text.is_ascii());
        let data = text.split("DATA;\n").nth(1).unwrap().split("ENDSEC;").next().unwrap();
        let count = data.lines().count();
        for (i, line) in data.lines().enumerate() {
            assert!(line.starts_with(&format!("#{}=", i + 1)) && line.ends_with(';'), "{line}");
            // Strings hold no digits with exponents here, names are words in capitals.
            assert!(!line.contains("e+") && !line.contains("e-") && !line.contains("NaN") && !line.contains("inf"));
            for reference in line.split('#').skip(2) {
                let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
                if let Ok(number) = digits.parse::<usize>() {
                    assert!(number >= 1 && number <= count && number != i + 1, "{line}");
                }
            }
        }
    }
}

#[test]
fn names_and_product() {
    let text = text(&mixed(flat));
    assert!(text.contains("GEOMETRIC_CURVE_SET('slot'"));
    assert!(text.contains("COMPOSITE_CURVE('slot 0'") && text.contains("COMPOSITE_CURVE('slot 1'"));
    assert!(text.contains("'it\\X\\27s a \"1\\\\2\" <&> 5\\X2\\00B0\\X0\\ \\X2\\5186\\X0\\'"));
    assert!(text.contains("PRODUCT('cyclide','cyclide',''"));
    let options = ExportOptions { title: Some("track".to_owned()), ..ExportOptions::default() };
    let titled = export(&mixed(flat), Format::Step, &options).unwrap().bytes;
    assert!(String::from_utf8(titled).unwrap().contains("PRODUCT('track','track',''"));
}

#[test]
fn lines_are_short_and_the_description_is_filled() {
    for m in splines().into_iter().map(|(_, m)| m).chain([mixed(tilted)]) {
        let file = export(&m, Format::Step, &ExportOptions::default()).unwrap();
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        assert!(text.lines().all(|line| line.len() < 80 || line.contains('\'')), "only texts are longer");
        assert!(text.lines().any(|line| line.len() > 70), "not more lines than needed");
        assert!(!text.contains("FILE_DESCRIPTION((''"));
        let mut whole = file.clone();
        whole.bytes = unfolded(&text).into_bytes();
        let deviation = |file| file_deviation(&m, Format::Step, file).unwrap();
        assert_eq!(deviation(&file), deviation(&whole));
    }
}

#[test]
fn an_object_is_a_product_and_several_are_an_assembly() {
    let m = mixed(flat);
    let text = text(&m);
    let parts = m.items.len();
    assert_eq!(found(&text, "=PRODUCT(").len(), parts + 1);
    let usages = found(&text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE(");
    assert_eq!(usages.len(), parts);
    let whole: Vec<&str> = usages.iter().map(|(_, refs)| refs[0]).collect();
    assert!(whole.windows(2).all(|w| w[0] == w[1]), "one assembly");
    let mut placed: Vec<&str> = usages.iter().map(|(_, refs)| refs[1]).collect();
    placed.sort_unstable();
    placed.dedup();
    assert_eq!(placed.len(), parts, "each object is one part");
    // Each part's own shape is related to the whole's, and each has its layer.
    let related = found(&text, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(");
    assert_eq!(related.len(), parts);
    for name in m.items.iter().map(|i| &i.name).filter(|n| n.chars().all(char::is_alphanumeric)) {
        assert!(text.contains(&format!("=PRODUCT('{name}','{name}',''")), "{name}");
        assert_eq!(found(&text, &format!("=PRESENTATION_LAYER_ASSIGNMENT('{name}',''")).len(), 1, "{name}");
    }
    let single = self::text(&model(vec![("a", vec![m.items[0].curves()[0].clone()])]));
    assert_eq!(found(&single, "=PRODUCT(").len(), 1);
    assert_eq!(found(&single, "ASSEMBLY").len(), 0);
}

#[test]
fn every_curve_set_has_the_colour_of_its_object() {
    let m = mixed(flat);
    let text = text(&m);
    let styled = found(&text, "=STYLED_ITEM(");
    let sets = found(&text, "=GEOMETRIC_CURVE_SET(");
    assert_eq!(styled.len(), sets.len());
    for (set, _) in &sets {
        assert_eq!(styled.iter().filter(|(_, refs)| refs.last() == Some(&number(set))).count(), 1, "{set}");
    }
    // The first object's color in pictures, 0x1B2A41.
    let first = [27.0, 42.0, 65.0].map(|v: f64| (v / 255.0).to_string()).join(",");
    assert!(text.contains(&format!("=COLOUR_RGB('',{first})")), "{first}");
}

#[test]
fn units_are_said_and_coordinates_kept() {
    for (units, expected) in [
        (Units::Millimetre, "SI_UNIT(.MILLI.,.METRE.)"),
        (Units::Centimetre, "SI_UNIT(.CENTI.,.METRE.)"),
        (Units::Metre, "SI_UNIT($,.METRE.)"),
        (Units::Inch, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)"),
        (Units::Foot, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(304.8)"),
        (Units::UsSurveyFoot, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(304.8006096012192)"),
    ] {
        let m = cyclide::model::Model { units, ..mixed(flat) };
        let text = text(&m);
        assert!(text.contains(expected), "{units:?}");
        assert!(text.contains("CARTESIAN_POINT('',(40.,12.,0.))"));
    }
}

#[test]
fn arcs_are_circles_lines_lines_and_splines_splines() {
    let count = |text: &str, entity: &str| text.matches(entity).count();
    let flat_text = text(&mixed(flat));
    // Slot: two arcs, two lines; the full circle is one; open chain: five arcs and one all but straight; one arc.
    assert_eq!((count(&flat_text, "=CIRCLE("), count(&flat_text, "=LINE(")), (9, 2));
    assert_eq!(count(&flat_text, "RATIONAL_B_SPLINE_CURVE("), 1, "the arc of 4e-9 radians");
    for (name, m) in splines() {
        let text = text(&m);
        let splines = if ["corners", "fair"].contains(&name) { 2 } else { 1 };
        assert_eq!(count(&text, "RATIONAL_B_SPLINE_CURVE("), splines, "{name}");
        assert_eq!(count(&text, "=COMPOSITE_CURVE("), 1, "{name}");
    }
}

#[test]
fn nearly_straight_arcs_keep_their_digits() {
    let square = [(0.0, 0.0), (50.0, 0.0), (50.0, 50.0), (0.0, 50.0)];
    for map in [flat as Map, tilted] {
        let m = model(vec![("a", vec![CurveObject::ArcPath(bulges(map, &square, &[1e-3, 1e-5, 1e-7, 1e-9]))])]);
        let file = export(&m, Format::Step, &ExportOptions::default()).unwrap();
        // The second one is a circle of radius 1.25e6: half an ulp of center and radius. The others are better.
        let d = file_deviation(&m, Format::Step, &file).unwrap();
        assert!(file.exact && d < 3e-16 * 1.25e6, "{d:e}");
    }
}

#[test]
fn edges_that_readers_would_lose_are_named() {
    let tiny: Map = |x, y| cyclide::Point3::new(1e-8 * x, 1e-8 * y, 0.0);
    let m = model(vec![("a", vec![CurveObject::ArcPath(crate::models::slot(tiny))])]);
    let file = export(&m, Format::Step, &ExportOptions::default()).unwrap();
    assert!(file.notes[0].contains("1e-7"), "{:?}", file.notes);
}
