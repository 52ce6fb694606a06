//! What only STEP has: its text rules, units, names and the choice of entities.

use crate::models::{Map, bulges, flat, mixed, model, splines, tilted};
use cyclide::{CurveObject, Units};
use cyclide_io::{ExportOptions, Format, export, file_deviation};

fn text(m: &cyclide::Model) -> String {
    let file = export(m, Format::Step, &ExportOptions::default()).unwrap();
    String::from_utf8(file.bytes).unwrap()
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
    assert!(text.contains("COMPOSITE_CURVE('slot 1'") && text.contains("COMPOSITE_CURVE('slot 2'"));
    assert!(text.contains("'it''s a \"1\\\\2\" <&> 5\\X2\\00B0\\X0\\ \\X2\\5186\\X0\\'"));
    assert!(text.contains("PRODUCT('cyclide','cyclide',''"));
    let options = ExportOptions { title: Some("track".to_owned()), ..ExportOptions::default() };
    let titled = export(&mixed(flat), Format::Step, &options).unwrap().bytes;
    assert!(String::from_utf8(titled).unwrap().contains("PRODUCT('track','track',''"));
}

#[test]
fn units_are_said_and_coordinates_kept() {
    for (units, expected) in [
        (Units::Millimetre, "SI_UNIT(.MILLI.,.METRE.)"),
        (Units::Centimetre, "SI_UNIT(.CENTI.,.METRE.)"),
        (Units::Metre, "SI_UNIT($,.METRE.)"),
        (Units::Inch, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)"),
        (Units::Foot, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(304.8)"),
    ] {
        let m = cyclide::Model { units, ..mixed(flat) };
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
        // The second one is a circle of radius 1.25e6: half an ulp of centre and radius. The others are better.
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
