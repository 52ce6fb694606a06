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
    for bulge in [1.1e6, -1e9, 1e12] {
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
