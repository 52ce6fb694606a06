//! What a document is told about a net that is not what was given: refusals, warnings and figures of the report.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::warning::NetWarning;
use cyclide_io::{
    Document, ModelBuilder, Report,
    document::BuiltObject,
    report::{GeometryReport, ObjectReport, SurfaceReport},
};
use serde_json::{Value, json};
use std::f64::consts::{PI, TAU};
use std::path::Path;

fn build(net: &Value) -> Result<BuiltObject, String> {
    last_of(&format!("\"n\": {net}"))
}

/// Builds the last of these objects.
fn last_of(objects: &str) -> Result<BuiltObject, String> {
    let text = format!("{{\"cyclide\": 1, \"units\": \"m\", \"objects\": {{{objects}}}}}");
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    builder.build(document.objects.len() - 1, &mut |_| {}).map_err(|e| e.to_string())
}

fn surface(built: &BuiltObject) -> SurfaceReport {
    match ObjectReport::new(built, None).geometry {
        GeometryReport::Surface(report) => report,
        _ => unreachable!("it is of surfaces"),
    }
}

/// Rows of points of a surface over `[0, 1]²`, open.
fn rows(surface: impl Fn(f64, f64) -> [f64; 3], [m, n]: [usize; 2]) -> Value {
    let row = |j: usize| (0..=m).map(|i| surface(i as f64 / m as f64, j as f64 / n as f64)).collect::<Vec<_>>();
    json!((0..=n).map(row).collect::<Vec<_>>())
}

fn reasons(built: &BuiltObject) -> Vec<&str> {
    built.remarks.iter().map(|remark| remark.reason).collect()
}

#[test]
fn a_flattened_relief_is_refused_at_the_field_that_would_allow_it() {
    let wave = |u: f64, v: f64| {
        let (x, y) = (24.0 * u, 16.0 * v);
        [x, y, 0.5 * (0.4 * x).sin() * (0.5 * y).cos()]
    };
    let net = |circular: Value| {
        build(&json!({"type": "cyclidic-net", "grid": rows(wave, [24, 16]), "make_circular": circular}))
    };
    for refused in [json!(true), json!({"allow_shape_change": false}), json!({"max_steps": 400})] {
        let message = net(refused).unwrap_err();
        for words in [
            "objects.n.make_circular: the shape is lost: ",
            "(minimum 50 %)",
            "curvature lines",
            "\"allow_shape_change\": true",
            "[shape-lost]",
        ] {
            assert!(message.contains(words), "{message}");
        }
    }
    let built = net(json!({"allow_shape_change": true})).unwrap();
    assert_eq!(reasons(&built)[..2], ["across-curvature-lines", "shape-changed"]);
    let shape = surface(&built).circular.unwrap().shape.unwrap();
    assert!(shape.bending.unwrap() < 0.1 && shape.lost_relief > 0.9, "{shape:?}");
    let text = Report::new(cyclide::model::Units::Metre, &[built], None).to_string();
    let line = text.lines().find(|line| line.starts_with("  shape ")).unwrap();
    assert!(line.contains("% of the bending, ") && line.ends_with("% of the surface"), "{line}");
}

#[test]
fn a_tube_cut_open_says_how_far_its_seam_gaps() {
    let tower = |u: f64, v: f64| {
        let (r, a) = (1.0 - v / 4.0, TAU * u);
        let (x, y) = (22.0 * r * a.cos(), 18.0 * r * a.sin());
        let (sine, cosine) = (PI / 6.0 * v).sin_cos();
        [x * cosine - y * sine, x * sine + y * cosine, 120.0 * v]
    };
    let net = json!({"type": "cyclidic-net", "grid": rows(tower, [24, 20]), "make_circular": true});
    let built = build(&net).unwrap();
    let report = surface(&built);
    let [seam] = report.seams[..] else { panic!("{:?}", report.seams) };
    assert_eq!((seam.border, seam.reversed), ("column", false));
    // Both sides move by up to the largest move, and by more than nothing.
    assert!(seam.gap > 0.1 && seam.gap < 2.0 * report.circular.unwrap().move_max, "{seam:?}");
    assert!(seam.angle > 0.0 && seam.angle < 0.5, "{seam:?}");
    let remark = built.remarks.iter().find(|remark| remark.reason == "open-seam").unwrap();
    assert!(
        remark
            .message
            .contains("the distance between the first and the last column of the grid is at most an edge length")
    );
    assert!(remark.message.contains("`closed`") && remark.message.contains(" m and an angle of"), "{}", remark.message);
    let text = Report::new(cyclide::model::Units::Metre, &[built], None).to_string();
    assert!(text.contains("\n  open seam  first and last column: gap "), "{text}");

    let roof = |u: f64, v: f64| [10.0 * u, 10.0 * v, 2.0 * u * (1.0 - u)];
    let roof = build(&json!({"type": "cyclidic-net", "grid": rows(roof, [8, 8])})).unwrap();
    assert!(surface(&roof).seams.is_empty() && reasons(&roof).is_empty());
    assert!(!serde_json::to_value(surface(&roof)).unwrap().as_object().unwrap().contains_key("seams"));
}

/// A surface of revolution with its coordinates rounded as a text format rounds them.
fn revolved(columns: usize, digits: i32) -> Vec<Vec<[f64; 3]>> {
    let round = |x: f64| (x * 10.0_f64.powi(digits)).round() / 10.0_f64.powi(digits);
    let row = |j: i32| {
        let v = f64::from(j) / 12.0;
        let r = 2.0 + 0.3 * (3.0 * v).sin();
        let at = |a: f64| [r * a.cos(), r * a.sin(), 3.0 * v].map(round);
        (0..columns).map(|i| at(TAU * i as f64 / 24.0)).collect()
    };
    (0..=12).map(row).collect()
}

#[test]
fn few_digits_are_named_and_each_advice_leads_out() {
    let net = |grid: &[Vec<[f64; 3]>], closed: bool, circular: bool| {
        build(&json!({"type": "cyclidic-net", "grid": grid, "closed": [closed, false], "make_circular": circular}))
    };
    // Six decimals of a right surface: quads are off by 4e-7, the frame by 1.5e-5.
    let message = net(&revolved(24, 6), true, false).unwrap_err();
    assert!(message.contains("have only about 7 digits") && message.contains("use 12 or more"), "{message}");
    assert!(message.contains("[not-concircular]") && message.contains("`make_circular`, which moves"), "{message}");
    // The advice: more digits, with and without `make_circular`; `make_circular` alone; or cut open.
    for circular in [false, true] {
        assert_eq!(reasons(&net(&revolved(24, 12), true, circular).unwrap()), [""; 0]);
    }
    let built = net(&revolved(24, 6), true, true).unwrap();
    let report = surface(&built);
    let circular = report.circular.unwrap();
    assert!(circular.move_max < 1e-5 && report.joints.creases == 0, "{}", circular.move_max);
    let [closing] = circular.closing[..] else { panic!("{:?}", circular.closing) };
    assert!(closing.direction == "s" && closing.angle_before > 1e-8 && closing.angle_after < 1e-12, "{closing:?}");
    let text = Report::new(cyclide::model::Units::Metre, &[built], None).to_string();
    assert!(text.contains("\n  closing    along s: after one turn the frame is rotated by "), "{text}");
    let message = net(&revolved(25, 6), false, false).unwrap_err();
    assert!(
        message.contains("7 digits")
            && message.contains("; or use `make_circular`, which moves the vertices by as little")
    );
    let built = net(&revolved(25, 6), false, true).unwrap();
    let report = surface(&built);
    assert!(report.circular.unwrap().move_max < 1e-5 && report.seams[0].gap < 1e-5);
    // Data of few digits that are no rounding are not blamed on them: heights off by a tenth of an edge.
    let mut bent = revolved(25, 6);
    bent[3][5][2] += 0.05;
    let message = net(&bent, false, false).unwrap_err();
    assert!(!message.contains("digits") || message.contains("7 digits"), "{message}");
    let square = [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 0]]];
    let message = build(&json!({"type": "cyclidic-net", "grid": square})).unwrap_err();
    assert!(
        !message.contains("digits") && message.contains("use `make_circular`, which moves the vertices until they do")
    );
}

/// An elliptic tube whose quads are rectangles: the frame is turned round an even number of them.
#[test]
fn closed_grids_are_told_how_to_close() {
    let point = |i: u32, j: u32| {
        let u = TAU * f64::from(i) / 8.0;
        [3.0 * u.cos(), 2.0 * u.sin(), f64::from(j)]
    };
    let rows: Vec<Vec<[f64; 3]>> = (0..5).map(|j| (0..8).map(|i| point(i, j)).collect()).collect();
    let net = |options: Value| {
        build(&json!({"type": "cyclidic-net", "grid": rows, "closed": [true, false], "make_circular": options}))
    };
    let message = net(json!(false)).unwrap_err();
    assert!(message.contains("[net-does-not-close]") && message.contains("the frame is off by 0."), "{message}");
    assert!(
        message.contains("use `make_circular`, which moves the vertices until it closes; or cut it open"),
        "{message}"
    );
    assert_eq!(surface(&net(json!(true)).unwrap()).joints.creases, 0);
    // Of an even number of edges of unequal lengths: nothing can close what is held.
    let message = net(json!({"border": "pinned"})).unwrap_err();
    assert!(message.contains("[net-does-not-close]") && message.contains("cannot close: make it `free`"), "{message}");
    assert!(message.contains("or cut it open: repeat the first column") && !message.contains("moves the"), "{message}");
}

#[test]
fn seams_that_lie_on_each_other_are_no_warning_unless_they_bend() {
    let ring = |m: usize, wave: f64| {
        let at = move |u: f64, v: f64| {
            let a = TAU * u;
            let r = 2.0 + wave * (2.0 * a + 1.0).sin();
            [r * a.cos(), r * a.sin(), 4.0 * v]
        };
        build(&json!({"type": "cyclidic-net", "grid": rows(at, [m, 8])})).unwrap()
    };
    let fine = ring(24, 0.1);
    let [seam] = surface(&fine).seams[..] else { panic!() };
    assert!(seam.gap < 1e-14 && seam.angle < 1e-3, "{seam:?}");
    assert_eq!(reasons(&fine), [""; 0]);
    // Eight coarse quads turn the frame by degrees. Seven do too, but closed they have a frame that comes back
    // (`docs/math/cyclides-and-nets.md#frames-and-weights-of-a-net`).
    for (count, closes) in [(8, false), (7, true)] {
        let coarse = ring(count, 0.3);
        let [seam] = surface(&coarse).seams[..] else { panic!() };
        assert!(seam.gap < 1e-14 && seam.angle > 0.05, "{seam:?}");
        let remark = coarse.remarks.iter().find(|remark| remark.reason == "open-seam").unwrap();
        let words = "they are coincident, and the surface has an angle of up to ";
        assert!(remark.message.contains(words) && !remark.message.contains("e-1"), "{}", remark.message);
        // Nobody is sent to where they are refused.
        assert_eq!(remark.message.contains("close the grid"), closes, "{}", remark.message);
    }
}

#[test]
fn curvatures_without_bounds_are_null_with_the_reason() {
    // A cone of slope 1 with its tip at t = 1, beside which the lines along s bend without end; k = ±1/(r sqrt 2).
    let patch = json!({
        "type": "cyclide-patch", "corners": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]],
        "frame": [[0, 1, 0], [-1, 0, 1]],
    });
    let built = build(&patch).unwrap();
    let report = serde_json::to_value(surface(&built)).unwrap();
    let ranges = ["curvature_s", "curvature_t"].map(|name| report[name].clone());
    assert!(!report["singular"].as_array().unwrap().is_empty(), "{report}");
    assert!(ranges[0]["min"].is_null() != ranges[0]["max"].is_null(), "{ranges:?}");
    let bound = [&ranges[0]["min"], &ranges[0]["max"]].into_iter().find_map(Value::as_f64).unwrap();
    assert!((bound.abs() - 0.5_f64.sqrt()).abs() < 1e-13, "{bound}"); // rounding
    let face = &built.bodies[0].outer.faces()[0];
    for (range, of) in ranges.iter().zip([0, 1]) {
        let unbounded = range["min"].is_null() || range["max"].is_null();
        assert_eq!(range["unbounded"].is_string(), unbounded, "{range}");
        let (min, max) =
            (range["min"].as_f64().unwrap_or(f64::NEG_INFINITY), range["max"].as_f64().unwrap_or(f64::INFINITY));
        let against = face.outer_sign_of_unit_normal() < 0.0;
        for i in 0..2000 {
            // Nearer and nearer to both ends.
            let near = 10.0_f64.powf(-8.0 * f64::from(i % 1000) / 1000.0);
            let x = if i < 1000 { 0.5 * near } else { 1.0 - 0.5 * near };
            let k = if of == 0 { face.surface.patch().unwrap().k1(x) } else { face.surface.patch().unwrap().k2(x) };
            let k = if against { -k } else { k };
            // Rounding of the quotient.
            let room = 1e-6 * k.abs();
            assert!(k >= min - room && k <= max + room, "{k} at {x}: {range}");
        }
    }
}

#[test]
fn offsets_beyond_the_focal_set_say_how_far_they_can_go() {
    let offset = |distance: f64| {
        let objects =
            r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "o": {"type": "offset", "of": "t", "distance": DD}"#;
        last_of(&objects.replace("DD", &format!("{distance:?}"))).unwrap()
    };
    let beyond = offset(-1.5);
    let [remark] = &beyond.remarks[..] else { panic!("{:?}", beyond.remarks) };
    assert_eq!((remark.reason, remark.place.as_deref()), ("beyond-focal-set", Some("objects.o.distance")));
    // All patches have the tube's radius 1.
    assert!(remark.message.contains("by -1.5 ") && remark.message.contains(" on 16 patch(es)"), "{}", remark.message);
    let warning = beyond.remarks[0].warning.as_ref().unwrap();
    let cyclide::Warning::Net(NetWarning::BeyondFocalSet { radius, count, .. }) = *warning else {
        panic!("{warning:?}")
    };
    assert!((radius - 1.0).abs() < 1e-12 && count == 16, "{radius}"); // rounding
    for near in [-0.999, 0.5, 1.99] {
        assert!(offset(near).remarks.is_empty(), "{near}");
    }
    // Outwards the inner half of the ring has centers of curvature, 2 and farther away.
    let outwards = offset(2.5);
    let Some(cyclide::Warning::Net(NetWarning::BeyondFocalSet { radius, count, .. })) = outwards.remarks[0].warning
    else {
        panic!("a warning")
    };
    assert!((radius - 2.0).abs() < 1e-12 && count == 8, "{radius} {count}");
    // And back: the ring as it was.
    let back = last_of(
        r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "o": {"type": "offset", "of": "t", "distance": -1.5},
        "b": {"type": "offset", "of": "o", "distance": 1.5}"#,
    );
    assert!(back.unwrap().remarks.is_empty());
}

#[test]
fn messages_say_what_may_be_meant() {
    let patch = |corners: &str, frame: &str| {
        last_of(&format!(r#""p": {{"type": "cyclide-patch", "corners": {corners}, "frame": {frame}}}"#)).unwrap_err()
    };
    let square = "[[0,0],[1,0],[0,1],[1,1]]";
    let skew = patch(square, "[[3,0,0],[1,1,0]]");
    assert!(
        skew.contains("p.frame: the directions of the frame must be perpendicular; the deviation is 45 degrees"),
        "{skew}"
    );
    let crossed = patch("[[0,0],[1,0],[1,1],[0,1]]", "[[1,0,0],[0,1,0]]");
    assert!(crossed.contains("corners are listed row by row") && crossed.contains("[crossing-quad]"), "{crossed}");
    let net =
        last_of(r#""n": {"type": "cyclidic-net", "grid": [[[0,0],[1,0]],[[1,1],[0,1]]], "frame": [[1,0,0],[0,1,0]]}"#);
    let message = net.unwrap_err();
    assert!(message.contains("points must be listed row by row, with all rows in the same direction"), "{message}");
    let turned = last_of(
        r#""a": {"type": "arc", "from": [0,0], "to": [1,0], "bulge": 0.5},
        "t": {"type": "transform", "of": "a", "steps": [{"rotation": {"angle": 90}}]}"#,
    );
    let remarks = turned.unwrap().remarks;
    assert_eq!((remarks.len(), remarks[0].reason), (1, "more-than-a-turn"));
    assert_eq!(remarks[0].place.as_deref(), Some("objects.t.steps[0].rotation.angle"));
    assert!(remarks[0].message.contains("write `{\"degrees\": 90}` or 1.5708"), "{}", remarks[0].message);
}
