//! Each part of a file is held to its own promise: what one part is allowed does not loosen the others.

use crate::models::{bent_quad, model, surfaces};
use cyclide::{
    Point3,
    curve::{Arc, ArcPath, CircleSpline, CircleSplineOptions},
    model::{CurveObject, Model},
};
use cyclide_io::{ExportOptions, Exporter, Format, report::CheckError};
use std::path::Path;

/// The message about a file in which one word was exchanged, and that the file is right without.
fn refused(model: &Model, format: Format, [from, to]: [&str; 2]) -> String {
    let exporter = Exporter::new(model).unwrap();
    let mut file = exporter.export(format, &ExportOptions::default()).unwrap();
    exporter.check(Path::new("o"), format, &file).unwrap();
    let text = String::from_utf8(file.bytes).unwrap();
    assert!(text.contains(from), "{format:?}: there is no {from}");
    file.bytes = text.replace(from, to).into_bytes();
    match exporter.check(Path::new("o"), format, &file) {
        Err(e @ CheckError::BeyondBound { .. }) => e.to_string(),
        other => format!("{format:?}: {other:?}"),
    }
}

/// A closed chain of segments.
fn polygon(points: &[[f64; 3]]) -> CurveObject {
    let p = |i: usize| Point3::from(points[i % points.len()]);
    let sides = (0..points.len()).map(|i| Arc::segment(p(i), p(i + 1)).unwrap()).collect();
    CurveObject::ArcPath(ArcPath::new(sides, true).unwrap())
}

/// Weights of 3e-9: its digits may cost as much as a tolerance.
fn hairpin() -> CurveObject {
    let points = [[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0002, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
    CurveObject::CircleSpline(CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap())
}

#[test]
fn a_hairpin_does_not_loosen_the_curve_beside_it() {
    let triangle = polygon(&[[0.0, 0.0, 0.0], [4.125, 0.0, 0.0], [0.0, 3.0, 0.0]]);
    let m = model(vec![("hairpin", vec![hairpin()]), ("triangle", vec![triangle])]);
    let json = refused(&m, Format::Json, ["4.125", "4.1250001"]);
    assert!(
        json.contains("o: triangle: the contents read back deviate by 1e-7 from the object (bound 0, limit "),
        "{json}"
    );
    let limit: f64 = json.trim_end_matches(')').rsplit_once(' ').unwrap().1.parse().unwrap();
    assert!(limit < 1e-8, "{json}");
}

#[test]
fn a_large_object_does_not_loosen_a_small_one() {
    let large = polygon(&[[0.0, 0.0, 0.0], [1e6, 0.0, 0.0], [0.0, 1e6, 0.0]]);
    let small = polygon(&[[0.0, 0.0, 0.0], [1.125, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let m = model(vec![("large", vec![large.clone()]), ("small", vec![small])]);
    let json = refused(&m, Format::Json, ["1.125", "1.1256"]);
    assert!(json.contains("o: small: the contents read back deviate by 6e-4 from the object (bound 0"), "{json}");
    let mut m = surfaces(&[bent_quad()]);
    m.items.insert(0, model(vec![("large", vec![large])]).items.remove(0));
    let json =
        refused(&m, Format::Json, ["\"control_points\": [[0, 0, 0], [-", "\"control_points\": [[0, 0.0006, 0], [-"]);
    assert!(json.contains("o: s0: the contents read back deviate by 6e-4 from the object (bound 0"), "{json}");
}
