//! Curves at the edge of what doubles carry: every format keeps its promise, or the document is refused by name.

use cyclide::Model;
use cyclide_io::{Document, ExportOptions, FileReport, Format, ModelBuilder, export};
use serde_json::{Value, json};
use std::path::Path;

const FORMATS: [Format; 5] = [Format::Step, Format::Dxf, Format::Svg, Format::Csv, Format::Json];

/// The model of a document with these objects, and the words of what was refused.
fn model(objects: &Value) -> Result<Model, String> {
    let text = json!({"cyclide": 1, "units": "mm", "objects": objects}).to_string();
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    let mut items = Vec::new();
    for index in 0..document.objects.len() {
        let object = builder.build(index, &mut |_| {}).map_err(|e| e.to_string())?;
        items.extend((!object.construction).then_some(object.item));
    }
    Ok(Model { units: document.units, items })
}

/// Writes and checks a file as the program does.
fn check(model: &Model, format: Format) -> Result<(), String> {
    let file = export(model, format, &ExportOptions::default()).map_err(|e| e.to_string())?;
    FileReport::new(Path::new("f"), format, model, &file).map(|_| ()).map_err(|e| e.to_string())
}

#[test]
fn hairpins_keep_their_promise_in_every_format() {
    // Weights of 3e-9 to 6e-14: circles through points that turn back run out to thousands and millions of chords.
    let hairpin = json!({"type": "circle-spline", "points": [[0, 0], [0, 9], [0.0002, 1], [1, 0]]});
    let back = |kind: &str, lean: f64, sign: f64| {
        let ends = json!({"start": [-1.0, lean], "end": [-1.0, sign * lean]});
        json!({"type": kind, "points": [[0, 0], [1, 0]], "ends": ends})
    };
    let mut curves = vec![hairpin];
    for lean in [1e-4, 1e-5, 1e-6] {
        curves.extend(["fair-spline", "circle-spline"].map(|kind| back(kind, lean, 1.0)));
    }
    for curve in curves {
        let model = model(&json!({"a": curve})).unwrap();
        for format in [Format::Step, Format::Json] {
            assert_eq!(check(&model, format), Ok(()), "{curve} {format:?}");
        }
    }
}

#[test]
fn what_no_file_can_carry_is_refused_by_name() {
    for bulge in [1.1e6, -1e9, 1e12, 1e16, -1e300] {
        let refused = model(&json!({"a": {"type": "arc", "from": [0, 0], "to": [1, 0], "bulge": bulge}})).unwrap_err();
        assert!(refused.contains("[nearly-full-circle]") && refused.contains("limit 3.9e-6"), "{bulge:e}: {refused}");
    }
    for bulge in [1e-12, 1e-6, 1.0, 1e3, 9e5, -1e6] {
        let model = model(&json!({"a": {"type": "arc", "from": [0, 0], "to": [1, 0], "bulge": bulge}})).unwrap();
        for format in FORMATS {
            assert_eq!(check(&model, format), Ok(()), "{bulge:e} {format:?}");
        }
    }
}

/// Each with the place in the document, what was measured, and a limit or a remedy.
#[test]
fn what_has_lost_its_digits_is_refused_where_it_stands() {
    for (object, says) in [
        (
            json!({"type": "circle-spline", "points": [[0, 0], [0, 9], [1e-7, 1], [1, 0]]}),
            ["objects.a.points[0]", "times the distance of its two points", "less sharp", "[arc-through-infinity]"],
        ),
        (
            json!({"type": "arc", "from": [1e11, 0], "to": [1e11, 1e-6], "bulge": 1}),
            ["objects.a", "is 1e-6 large at coordinates of up to 1e11", "move it", "[below-rounding-of-place]"],
        ),
        (
            json!({"type": "circle-spline", "points": [[1e9, 0], [1e9, 1e-7], [1.000_000_000_000_000_1e9, 1e-7]]}),
            ["objects.a", "large at coordinates of up to 1e9", "move it", "[below-rounding-of-place]"],
        ),
        (
            json!({"type": "arc", "from": [0, 0], "to": [1, 0], "weights": [[1, 0, 0, 0], [1e-25, 0, 0, 1e-25]]}),
            ["objects.a.weights", "1.4142135623730952e-25 is outside", "1e-12 to", "[parameter-out-of-range]"],
        ),
    ] {
        let refused = model(&json!({"a": object})).unwrap_err();
        for part in says {
            assert!(refused.contains(part), "{part}: {refused}");
        }
    }
    // A polyline is its vertices, a circle its centre and radius.
    for object in [
        json!({"type": "arc-spline", "points": [[1e11, 0], [1e11, 1e-6]]}),
        json!({"type": "circle", "center": [1e11, 0], "radius": 1e-3}),
        json!({"type": "arc", "from": [1e9, 0], "to": [1e9, 1], "bulge": 1}),
    ] {
        let model = model(&json!({"a": object})).unwrap();
        for format in [Format::Step, Format::Dxf, Format::Csv, Format::Json] {
            assert_eq!(check(&model, format), Ok(()), "{object} {format:?}");
        }
    }
}
