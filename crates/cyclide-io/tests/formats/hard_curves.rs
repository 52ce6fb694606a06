//! Curves at the edge of what doubles carry: every format keeps its promise, or the document is refused by name.

use cyclide::model::Model;
use cyclide_io::{Document, ExportOptions, Format, ModelBuilder, formats::export, report::FileReport};
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
        assert!(refused.contains("[nearly-full-circle]") && refused.contains("minimum 3.9e-6"), "{bulge:e}: {refused}");
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
            ["objects.a.points[0]", "times the distance between its points", "less sharp", "[arc-through-infinity]"],
        ),
        (
            json!({"type": "arc", "from": [1e11, 0], "to": [1e11, 1e-6], "bulge": 1}),
            ["objects.a", "has size 1e-6 at coordinates of up to 1e11", "move it", "[below-rounding-of-place]"],
        ),
        (
            json!({"type": "circle-spline", "points": [[1e9, 0], [1e9, 1e-7], [1.000_000_000_000_000_1e9, 1e-7]]}),
            ["objects.a", "at coordinates of up to 1e9", "move it", "[below-rounding-of-place]"],
        ),
    ] {
        let refused = model(&json!({"a": object})).unwrap_err();
        for part in says {
            assert!(refused.contains(part), "{part}: {refused}");
        }
    }
    // A polyline is its vertices, a circle its center and radius.
    for object in [
        json!({"type": "arc-spline", "points": [[1e11, 0], [1e11, 1e-6]]}),
        json!({"type": "circle", "center": [1e11, 0], "radius": 1e-3}),
        json!({"type": "arc", "from": [1e9, 0], "to": [1e9, 1], "bulge": 1}),
        json!({"type": "circle-spline", "points": [[1e11, 0], [1e11, 1e-6]]}),
        json!({"type": "fair-spline", "points": [[1e11, 0], [1e11, 1e-4], [1e11, 2e-4]]}),
    ] {
        let model = model(&json!({"a": object})).unwrap();
        for format in [Format::Step, Format::Dxf, Format::Csv, Format::Json] {
            assert_eq!(check(&model, format), Ok(()), "{object} {format:?}");
        }
    }
}

/// Tangents of any length, weights of any ratio, points beside an end: the parameter of such an arc crowds all of it into
/// numbers that are one.
#[test]
fn arcs_of_uneven_parameters_are_written() {
    let arc = |key: &str, value: Value| json!({"type": "arc", "from": [0, 0], "to": [1, 0], key: value});
    let weights = |real: f64, vector: f64| arc("weights", json!([[1, 0, 0, 0], [real, 0, 0, vector]]));
    let mut arcs = vec![
        arc("tangent", json!([1e-18, 1e-18])),
        arc("tangent", json!([1e-25, 1e-25])),
        arc("tangent", json!([1e-13, 1e-13])),
        arc("end_tangent", json!([1e18, 1e18])),
        json!({"type": "arc", "through": [[0, 0], [1e-25, 1e-26], [1, 0]]}),
        json!({"type": "arc", "through": [[0, 0], [1e-18, 1e-19], [1, 0]]}),
    ];
    arcs.extend(
        [(-1.0001e-12, 1e-14), (-1e-10, 1e-14), (-1e-12, 3e-13), (8e-13, 8e-13), (1e-25, 1e-25), (1e25, 1e25)]
            .map(|(real, vector)| weights(real, vector)),
    );
    for object in arcs {
        let model = model(&json!({"a": object})).unwrap();
        for format in [Format::Csv, Format::Glb, Format::Obj, Format::Svg, Format::Dxf, Format::Step] {
            assert_eq!(check(&model, format), Ok(()), "{object} {format:?}");
        }
    }
}

/// Circles that are joined of two that differ by their last digits pass no nearer to infinity than they do.
#[test]
fn nearly_equal_tangents_of_a_large_circle_are_not_near_infinity() {
    for (lean, differs) in [(1e-2, 1e-13), (1e-4, 1e-8), (1e-3, 1e-12), (1e-3, 1e-11)] {
        let ends = json!({"start": [-1, lean], "end": [-1, -lean * (1.0 + differs)]});
        let object = json!({"type": "circle-spline", "points": [[0, 0], [1, 0]], "ends": ends});
        let model = model(&json!({"a": object})).unwrap();
        for format in [Format::Step, Format::Dxf, Format::Svg, Format::Json] {
            assert_eq!(check(&model, format), Ok(()), "{object} {format:?}");
        }
    }
}

/// Pairs next to a common zero: once round a circle in a hundredth of the parameter, slowly along it before and behind.
#[test]
fn loops_in_a_tiny_range_of_the_parameter_are_written() {
    let points = json!([
        [1.947_339_294_244_502_7, 0.675_970_892_945_564_8, -2.603_096_842_618_945e-8],
        [0.759_309_217_197_173, 1.916_381_153_917_463_6, -1.222_439_555_944_576_4e-8],
        [-0.012_180_831_852_404_324, 2.061_290_542_685_152, 6.606_349_533_215_535e-8],
        [-1.948_452_435_467_552_3, 0.672_755_882_617_963_2, -3.927_436_912_637_206e-8],
        [-1.752_640_508_265_688_4, -1.085_043_207_634_100_8, -1.361_773_080_176_638e-8]
    ]);
    let parameters = json!([0, 0.602_556_352_890_967_5, 0.879_231_102_125_070_7, 0.919_713_198_925_492_5, 1]);
    let center = json!([2.223_695_921_841_327_5, 0.060_627_573_531_631_39, 0.789_601_322_561_077_5]);
    let model = model(&json!({
        "a": {"type": "qb-interpolation", "points": points, "parameters": parameters, "construction": true},
        "b": {"type": "transform", "of": "a", "steps": [{"inversion": {"center": center, "radius": 15.464_502_226_399_528}}]}
    }))
    .unwrap();
    for format in FORMATS {
        assert_eq!(check(&model, format), Ok(()), "{format:?}");
    }
}
