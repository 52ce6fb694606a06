//! Pipes about curves.

use cyclide_io::document::BuiltObject;

use super::{build, surface};

#[test]
fn pipes_follow_arcs_and_segments() {
    let run = r#""run": {"type": "polyline", "points": [[0, 0, 0], [30, 0, 0], [30, 20, 0], [30, 20, 25]],
        "radius": [0, 6, 8, 0], "construction": true}"#;
    let with = |rest: &str| format!(r#"{run}, "pipe": {{"type": "pipe", "of": "run"{rest}}}"#);
    let length = 75.0 - (6.0 + 8.0) * (2.0 - std::f64::consts::FRAC_PI_2);
    let pipe = surface(&build(&with(r#", "radius": 3, "wall": 1"#)).unwrap());
    assert!(pipe.closed && pipe.bodies == 1 && pipe.free_edges == 0);
    assert!((pipe.volume.unwrap() / (std::f64::consts::PI * 5.0 * length) - 1.0).abs() < 1e-12);
    let open = surface(&build(&with(r#", "radius": 3, "ends": "open""#)).unwrap());
    assert!(!open.closed && open.free_edges == 8);
    assert!((open.area.unwrap() / (std::f64::consts::TAU * 3.0 * length) - 1.0).abs() < 1e-12);
    let spline = r#""s": {"type": "circle-spline", "points": [[0, 0, 0], [30, 0, 0], [30, 20, 10], [30, 20, 25]], "construction": true}"#;
    let about = |rest: &str| format!(r#"{spline}, "pipe": {{"type": "pipe", "of": "s", "radius": 1{rest}}}"#);
    assert!(surface(&build(&about(r#", "tolerance": 0.01"#)).unwrap()).closed);
    for (objects, place, reason) in [
        (about(""), "objects.pipe.of", "[not-of-arcs]"),
        (about(r#", "tolerance": -1"#), "objects.pipe.tolerance", "[tolerance-not-positive]"),
        (with(r#", "radius": 0"#), "objects.pipe.radius", "[radius-not-positive]"),
        (with(r#", "radius": 6"#), "objects.pipe.radius", "[pipe-too-wide]"),
        (with(r#", "radius": 3, "wall": 3"#), "objects.pipe.wall", "[parameter-out-of-range]"),
        (
            r#""p": {"type": "polyline", "points": [[0, 0], [9, 0], [9, 9]], "radius": 10}"#.to_owned(),
            "objects.p.points[1]",
            "[bend-does-not-fit]",
        ),
        (
            r#""p": {"type": "polyline", "points": [[0, 0], [9, 0], [9, 9]], "radius": [0, 1]}"#.to_owned(),
            "objects.p.radius",
            "[count-differs]",
        ),
    ] {
        let error = build(&objects).unwrap_err().to_string();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    let error = build(r#""t": {"type": "cyclide", "a": 3, "mu": 1}, "v": {"type": "pipe", "of": "t", "radius": 1}"#);
    assert!(error.unwrap_err().to_string().contains("a pipe requires a curve"));
}

#[test]
fn pipes_that_run_into_each_other_are_warned_of() {
    let rods = |second: &str, pipe: &str| {
        build(&format!(
            r#""r": {{"type": "polyline", "points": [[[-40, 0, 0], [40, 0, 0]], {second}], "construction": true}},
            "p": {{"type": "pipe", "of": "r", {pipe}}}"#
        ))
        .unwrap()
    };
    let reasons = |built: &BuiltObject| built.remarks.iter().map(|remark| remark.reason).collect::<Vec<_>>();
    // Across, touching with plane ends, beside, and end to end: only what has a part in common is warned of.
    for (second, pipe, found) in [
        ("[[0, -40, 30], [0, 40, 30]]", r#""radius": 20"#, &["pipes-meet"][..]),
        ("[[0, -40, 40], [0, 40, 40]]", r#""radius": 20"#, &[]),
        ("[[-40, 41, 0], [40, 41, 0]]", r#""radius": 20"#, &[]),
        ("[[40, 0, 0], [80, 0, 0]]", r#""radius": 20"#, &[]),
        ("[[40, 0, 0], [80, 0, 0]]", r#""radius": 20, "ends": "round""#, &["pipes-meet"]),
        ("[[0, 0, 0], [0, 40, 0]]", r#""radius": 5"#, &["pipes-meet"]),
    ] {
        let built = rods(second, pipe);
        assert_eq!(reasons(&built), found, "{second} {pipe}");
        assert_eq!(built.bodies.len(), 2);
    }
    let crossing = rods("[[0, -40, 30], [0, 40, 30]]", r#""radius": 20"#);
    assert_eq!(crossing.remarks[0].contour, Some(1));
    assert!(crossing.remarks[0].message.contains("(distance of the spines 30)"), "{}", crossing.remarks[0].message);
}

#[test]
fn fields_of_pipes_without_effect_are_named() {
    let pipe = |closed: bool, rest: &str| {
        let built = build(&format!(
            r#""r": {{"type": "polyline", "points": [[0, 0], [50, 0], [50, 50], [0, 50]], "radius": 9, "closed": {closed}, "construction": true}},
            "p": {{"type": "pipe", "of": "r", "radius": 2, {rest}}}"#
        ))
        .unwrap();
        built.remarks.iter().map(|remark| (remark.reason, remark.place.clone().unwrap())).collect::<Vec<_>>()
    };
    let named = |field: &str| vec![("no-effect", format!("objects.p.{field}"))];
    assert_eq!(pipe(true, r#""ends": "round""#), named("ends"));
    assert_eq!(pipe(false, r#""ends": "round""#), []);
    assert_eq!(pipe(false, r#""ends": "open", "wall": 1"#), named("ends"));
    assert_eq!(pipe(false, r#""tolerance": 0.1"#), named("tolerance"));
}
