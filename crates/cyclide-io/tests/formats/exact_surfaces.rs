//! JSON of surfaces: exact rational patches with positive weights.

use crate::models::{annulus, bent_quad, curve_and_surfaces, octant, surfaces, torus_part};
use cyclide::Point3;
use cyclide_io::{
    ExportOptions, Format,
    formats::{export, file_deviation, read_back},
};
use serde_json::Value;

#[test]
fn patches_are_exact_with_positive_weights() {
    for m in
        [surfaces(&[octant(), annulus(), torus_part(Point3::new(5.0, -3.0, 9.0)), bent_quad()]), curve_and_surfaces()]
    {
        let file = export(&m, Format::Json, &ExportOptions::default()).unwrap();
        assert!(file.exact && file.bound == 0.0);
        // Rounding of coordinates up to 52.
        assert!(file_deviation(&m, Format::Json, &file).unwrap() < 1e-13);
        let content = read_back(Format::Json, &file.bytes).unwrap();
        assert!(content.patches.len() >= m.items.iter().map(|item| item.surfaces().len()).sum());
        assert!(content.patches.iter().all(|patch| patch.surface.has_positive_weights()));
    }
}

/// The ring's outer edge is half a circle, whose weights are not all positive: the patch is cut.
#[test]
fn wide_patches_are_cut() {
    let patches = |patch| {
        let file = export(&surfaces(&[patch]), Format::Json, &ExportOptions::default()).unwrap();
        read_back(Format::Json, &file.bytes).unwrap().patches.len()
    };
    assert_eq!((patches(torus_part(Point3::ORIGIN)), patches(annulus())), (1, 2));
}

#[test]
fn the_text_says_what_it_holds() {
    let bytes = export(&curve_and_surfaces(), Format::Json, &ExportOptions::default()).unwrap().bytes;
    let json: Value = serde_json::from_slice(&bytes).unwrap();
    let objects = &json["objects"];
    assert_eq!(objects["slot"]["contours"].as_array().unwrap().len(), 1);
    assert!(objects["slot"].get("surfaces").is_none());
    let body = &objects["s1"]["surfaces"][0];
    assert_eq!((&body["closed"], &body["exact"]), (&Value::from(false), &Value::from(true)));
    let patch = &body["shells"][0]["patches"][0];
    assert_eq!(patch["degrees"], serde_json::json!([2, 2]));
    let knots = [0, 0, 0, 1, 1, 1];
    assert_eq!(patch["knots"], serde_json::json!([knots, knots]));
    assert_eq!([&patch["control_points"], &patch["weights"]].map(|list| list.as_array().unwrap().len()), [9, 9]);
}

#[test]
fn a_missing_or_wrong_patch_is_found_out() {
    let m = surfaces(&[octant(), bent_quad()]);
    let file = export(&m, Format::Json, &ExportOptions::default()).unwrap();
    let other = export(&surfaces(&[octant(), octant()]), Format::Json, &ExportOptions::default()).unwrap();
    assert!(file_deviation(&m, Format::Json, &other).map_or(true, |d| d > 0.5), "another patch, or another number");
    let less = export(&surfaces(&[octant()]), Format::Json, &ExportOptions::default()).unwrap();
    let error = file_deviation(&m, Format::Json, &less).unwrap_err();
    assert!(error.to_string().contains("1 bodies in the file, 2 in the model"), "{error}");
    assert!(file_deviation(&m, Format::Json, &file).unwrap() < 1e-14);
}
