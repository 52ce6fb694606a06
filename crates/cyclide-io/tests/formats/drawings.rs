//! SVG: what is drawn, and how large.

use crate::models::{bulges, circle_spline, flat, mixed, model, slot, space_chain};
use cyclide::{
    Point3,
    conformal::Conformal as _,
    curve::BlendVariant,
    model::{CurveObject, Model, Units},
};
use cyclide_io::{
    ExportOptions, Format,
    formats::{export, file_deviation},
};

fn svg(m: &Model, options: &ExportOptions) -> String {
    String::from_utf8(export(m, Format::Svg, options).unwrap().bytes).unwrap()
}

fn contours(text: &str) -> Vec<&str> {
    let paths = text.split("<path class=\"contour\" d=\"").skip(1);
    paths.map(|p| p.split('"').next().unwrap()).collect()
}

#[test]
fn slots_are_arcs_and_lines_and_closed() {
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    let text = svg(&m, &ExportOptions::default());
    // Counter-clockwise in the model is falling angle on the page; half circles come in two parts.
    let expected =
        "M0 0 L40 0 A6 6 0 0 0 46 -6 A6 6 0 0 0 40 -12 L0 -12 A6 6 0 0 0 -5.999999999999999 -6 A6 6 0 0 0 0 0 Z";
    assert_eq!(contours(&text), [expected]);
}

#[test]
fn the_segment_that_closes_is_left_to_the_close_command() {
    let triangle = bulges(flat, &[(0.0, 0.0), (4.0, 0.0), (0.0, 0.0), (0.0, 3.0)], &[0.0; 4]);
    let m = model(vec![("t", vec![CurveObject::ArcPath(triangle)])]);
    // The pass through the start in the middle is drawn.
    assert_eq!(contours(&svg(&m, &ExportOptions::default())), ["M0 0 L4 0 L0 0 L0 -3 Z"]);
}

#[test]
fn paper_size_is_true_or_to_a_round_scale() {
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    for (units, size) in [
        (Units::Millimetre, "width=\"56.2mm\""),
        (Units::Centimetre, "width=\"562mm\""),
        (Units::Inch, "width=\"1427.48mm\""),
        (Units::Metre, "width=\"281mm\""), // 1:200
    ] {
        let text = svg(&Model { units, ..m.clone() }, &ExportOptions::default());
        assert!(text.contains(size), "{units:?}: {}", &text[..300]);
        assert!(text.contains("viewBox=\"-8.1 -14.1 56.2 16.2\""));
    }
}

#[test]
fn comb_and_joints_only_on_request() {
    let m = model(vec![("slot", vec![CurveObject::ArcPath(slot(flat))])]);
    let plain = svg(&m, &ExportOptions::default());
    assert!(!plain.contains("id=\"comb\"") && !plain.contains("<circle"));
    let options = ExportOptions { svg_comb: true, svg_points: true, ..ExportOptions::default() };
    let rich = svg(&m, &options);
    assert!(rich.contains("id=\"comb\"") && rich.matches("<circle").count() == 4);
    assert_eq!(contours(&plain), contours(&rich));
}

#[test]
fn space_is_seen_from_above_and_points_are_refused() {
    let m = model(vec![("s", vec![CurveObject::ArcPath(space_chain())])]);
    let file = export(&m, Format::Svg, &ExportOptions::default()).unwrap();
    assert!(!file.exact && file.notes[0].contains("view along the z axis"));
    let up = cyclide::curve::Arc::segment([1.0, 2.0, 0.0].into(), [1.0, 2.0, 5.0].into()).unwrap();
    let m = model(vec![("up", vec![CurveObject::Arc(up)])]);
    let error = export(&m, Format::Svg, &ExportOptions::default()).unwrap_err();
    assert_eq!(error.reason(), "not-in-format");
    assert!(error.to_string().contains("object up"), "{error}");
}

/// A net of one patch in the plane: its lines are arcs of the plane.
#[test]
fn the_plan_of_a_level_patch_is_made_of_arcs() {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
    let (v1, v2) = (cyclide::Vec3::new(0.6, 0.8, 0.0), cyclide::Vec3::new(-0.8, 0.6, 0.0));
    let patch = cyclide::surface::CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap();
    let m = Model::new(Units::Metre).with_surface("", patch);
    let file = export(&m, Format::Svg, &ExportOptions::default()).unwrap();
    assert!(file.exact && file.notes.len() <= 1, "{:?}", file.notes);
    let text = String::from_utf8(file.bytes).unwrap();
    let edges = text.split("<g id=\"edges\"").nth(1).unwrap();
    assert_eq!((edges.matches("<path").count(), edges.matches(" A").count()), (4, 4));
    let circles = text.split("<g id=\"circles\"").nth(1).unwrap().split("</g>").next().unwrap();
    // Halved five times along one parameter and four times along the other, whose lines are shorter; the middle ones
    // are straight, for the figure is symmetric about them.
    assert_eq!((circles.matches("<path").count(), circles.matches(" L").count()), (31 + 15, 2));
    assert_eq!(contours(&text), [""; 0]);
}

/// Seen from above, the riser is a point and the hairpin leads back over itself.
#[test]
fn the_plan_of_a_riser_keeps_its_promise() {
    let points = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 40.0],
        [6.0, 2.0, 78.0],
        [30.0, 10.0, 104.0],
        [70.0, 24.0, 110.0],
        [70.0, 24.0, 60.0],
        [30.0, 10.0, 50.0],
    ];
    let points = points.map(Point3::from);
    let m = model(vec![("cable", vec![circle_spline(&points, false, BlendVariant::Rational, vec![])])]);
    let file = export(&m, Format::Svg, &ExportOptions::default()).unwrap();
    let d = file_deviation(&m, Format::Svg, &file).unwrap();
    assert!(d <= file.bound, "{d:e} of {:e}", file.bound);
}

#[test]
fn plans_of_surfaces_are_measured_line_by_line() {
    let ring = cyclide::surface::DupinCyclide::new(6.0, 2.0, 3.5).unwrap();
    let surfaces: Vec<_> = ring.nets([8, 8]).unwrap().into_iter().map(cyclide::model::SurfaceObject::Net).collect();
    let item = cyclide::model::Item::new("ring", surfaces);
    let m = Model { items: vec![item], ..Model::default() };
    for tolerance in [0.1, 1e-3] {
        let options = ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() };
        let file = export(&m, Format::Svg, &options).unwrap();
        // Chords: as far away as allowed within a factor, and no farther.
        let found = file_deviation(&m, Format::Svg, &file).unwrap();
        assert!(file.bound == tolerance && found > 0.2 * tolerance && found <= tolerance, "{found:e} of {tolerance:e}");
        // A corner of one line moved by 5: seen.
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        let (before, rest) = text.split_once("<path d=\"M").unwrap();
        let (x, after) = rest.split_once(' ').unwrap();
        let moved = format!("{before}<path d=\"M{} {after}", x.parse::<f64>().unwrap() + 5.0);
        let mut wrong = file.clone();
        wrong.bytes = moved.into_bytes();
        assert!((file_deviation(&m, Format::Svg, &wrong).unwrap() - 5.0).abs() < 2.0);
        // A line less: said.
        wrong.bytes = text.replacen("<path d=", "<path data-d=", 1).into_bytes();
        assert!(matches!(file_deviation(&m, Format::Svg, &wrong), Err(cyclide_io::check::ReadError::LineCount { .. })));
    }
}

/// Inverted about a point beside one of its vertices: circles as large as the distance is small, nearly all of each in a
/// tiny part of its parameters.
#[test]
fn plans_of_images_near_infinity_keep_their_promise() {
    let ring = cyclide::surface::DupinCyclide::new(50.0, 20.0, 32.0).unwrap();
    for beside in [1.0, 1e-2, 1e-4] {
        let map = cyclide::conformal::Mobius::inversion(Point3::new(38.0 + beside, 0.0, 0.0), 10.0).unwrap();
        let net = ring.nets([4, 4]).unwrap().remove(0).transformed(&map).unwrap();
        let m = Model::default().with_surface("", net);
        let file = export(&m, Format::Svg, &ExportOptions::default()).unwrap();
        let found = file_deviation(&m, Format::Svg, &file).unwrap();
        assert!(found <= file.bound, "{beside}: {found:e} of {:e}", file.bound);
    }
}

#[test]
fn titles_are_escaped() {
    let text = svg(&mixed(flat), &ExportOptions::default());
    assert!(text.contains("<title>it's a \"1\\2\" &lt;&amp;&gt; 5° 円</title>"));
}
