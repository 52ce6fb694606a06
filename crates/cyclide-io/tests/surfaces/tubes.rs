//! Tubes of changing radius.

use super::{build, surface};

fn tube(fields: &str) -> Result<cyclide_io::document::BuiltObject, String> {
    build(&format!(r#""t": {{"type": "tube", {fields}}}"#))
}

const BALLS: &str = r#""balls": [[0, 0, 0, 2], [10, 0, 0, 1], [18, 6, 0, 1.5]]"#;

#[test]
fn tubes_through_balls_are_exact_solids() {
    let solid = surface(&tube(BALLS).unwrap());
    assert!(solid.closed && solid.bodies == 1);
    let [known] = &solid.tubes[..] else { panic!("one tube: {:?}", solid.tubes) };
    assert_eq!((known.proof, known.within), ("exact", 0.0));
    assert!(known.radius.min <= 1.0 && known.radius.max >= 2.0 && known.arcs == 4, "{known:?}");
    let hollow = surface(&tube(&format!(r#"{BALLS}, "wall": 0.2"#)).unwrap());
    assert!(hollow.closed && hollow.volume.unwrap() < 0.5 * solid.volume.unwrap());
    assert!(!surface(&tube(&format!(r#"{BALLS}, "ends": "open""#)).unwrap()).closed);
}

#[test]
fn tubes_along_curves_are_within_their_tolerance() {
    let line = r#""l": {"type": "polyline", "points": [[0, 0], [10, 0]]}, "#;
    let cone = |law: &str| build(&format!(r#"{line}"t": {{"type": "tube", "of": "l", "radius": {law}}}"#));
    let exact = surface(&cone("[2, 1]").unwrap());
    assert_eq!(exact.tubes[0].proof, "exact");
    // Along segments any law is one of the parameter; balls of it are within a bound.
    let law = r#"[{"at": 0.2, "radius": 1}, {"at": 0.6, "radius": 2}]"#;
    let bulge = surface(&cone(law).unwrap());
    assert!(
        bulge.tubes[0].proof == "exact" && bulge.tubes[0].radius_of == cyclide_io::document::kinds::RadiusOf::Sections
    );
    let balls = surface(&cone(&format!(r#"{law}, "radius_of": "balls""#)).unwrap());
    assert!(balls.tubes[0].proof == "proved" && balls.tubes[0].within <= 1e-3, "{:?}", balls.tubes);
    assert_eq!((bulge.tubes[0].radius.min, bulge.tubes[0].radius.max), (1.0, 2.0));
}

/// Along splines too the distance is proved, whatever it is; so many pieces that nobody could use them are refused.
#[test]
fn tubes_along_splines_are_proved() {
    let points = "[[0, 0, 0], [60, 0, 0], [95, 35, 10], [70, 75, 30], [20, 70, 45]]";
    let along = |kind: &str, radius: &str, tolerance: &str| {
        let way = format!(r#""w": {{"type": "{kind}", "points": {points}}}"#);
        build(&format!(r#"{way}, "t": {{"type": "tube", "of": "w", "radius": {radius}, "tolerance": {tolerance}}}"#))
    };
    let (balls, sections) = (r#"[3, 6, 3], "radius_of": "balls""#, r#"[3, 6, 3], "radius_of": "sections""#);
    for (kind, radius) in [
        ("fair-spline", balls),
        ("circle-spline", balls),
        ("fair-spline", "3"),
        ("fair-spline", sections),
        ("circle-spline", sections),
    ] {
        for (tolerance, within) in [("0.01", 0.01), ("1e-5", 1e-5)] {
            let made = surface(&along(kind, radius, tolerance).unwrap());
            let [known] = &made.tubes[..] else { panic!("one tube") };
            // How far planes of circles lean is looked at in places; of balls, and of one radius, all is proved.
            let proof = if radius.contains("sections") { "sampled" } else { "proved" };
            assert!(known.proof == proof && known.within <= within, "{kind} {radius}: {known:?}");
        }
    }
    let error = along("fair-spline", "[3, 6, 3]", "1e-9").unwrap_err();
    assert!(error.contains("[too-many-pieces]") && error.contains("use a larger tolerance"), "{error}");
}

/// Directions of arcs in map coordinates are known to what their coordinates are rounded by; joints that turn by less are no corners.
#[test]
fn tubes_and_pipes_along_splines_are_made_in_map_coordinates() {
    let points = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [95.0, 35.0, 10.0], [70.0, 75.0, 30.0], [20.0, 70.0, 45.0]];
    let volume = |place: [f64; 3], kind: &str, body: &str| {
        let moved = points.map(|[x, y, z]| format!("[{}, {}, {}]", x + place[0], y + place[1], z + place[2])).join(",");
        let way = format!(r#""w": {{"type": "{kind}", "points": [{moved}]}}"#);
        let made = surface(&build(&format!(r#"{way}, "t": {{"of": "w", "tolerance": 0.01, {body}}}"#)).unwrap());
        assert!(made.closed, "{kind} {body}");
        made.volume.unwrap()
    };
    for kind in ["fair-spline", "circle-spline"] {
        for body in
            [r#""type": "tube", "radius": 4"#, r#""type": "tube", "radius": [4, 5]"#, r#""type": "pipe", "radius": 4"#]
        {
            let here = volume([0.0; 3], kind, body);
            for place in [[5e5, 5.4e6, 300.0], [3.5e6, 5.4e6, 300.0]] {
                // The tolerance, of which there may be other uses, moves the skin by 0.01 of 4 at most.
                assert!((volume(place, kind, body) / here - 1.0).abs() < 5e-3, "{kind} {body}");
            }
        }
    }
    // A corner that is one is told of there too.
    let corner = "[[500000, 5400000], [500060, 5400000], [500060, 5400001]]";
    let bent = format!(
        r#""w": {{"type": "polyline", "points": {corner}}}, "t": {{"type": "tube", "of": "w", "radius": 0.1}}"#
    );
    assert!(build(&bent).unwrap_err().contains("[corner-not-mitred]"));
}

#[test]
fn tubes_that_are_none_are_refused_in_their_place() {
    for (fields, place, reason) in [
        (r#""balls": [[0, 0, 0, 3], [1, 0, 0, 1]]"#, "balls[1]", "[balls-nested]"),
        (r#""balls": [[0, 0, 0, 1], [9, 0, 0, 1], [5, 0, 0, 1]]"#, "balls[1]", "[tube-turns-back]"),
        (r#""balls": [[0, 0, 0, 3], [2, 2, 0, 3], [4, 0, 0, 3]]"#, "balls[", "[tube-folds]"),
        (r#""balls": [[0, 0, 0, 3], [9, 0, 0, -1]]"#, "balls", "[radius-not-positive]"),
        (&format!(r#"{BALLS}, "wall": 1.5"#), "wall", "[parameter-out-of-range]"),
        (&format!(r#"{BALLS}, "radius": 1"#), "", "a tube requires either a curve"),
        (r#""of": "nothing""#, "", "nothing"),
    ] {
        let error = tube(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{error}");
    }
    let circle = r#""c": {"type": "circle", "center": [0, 0], "radius": 9}, "#;
    let along = |rest: &str| build(&format!(r#"{circle}"t": {{"type": "tube", "of": "c", {rest}}}"#)).unwrap_err();
    for (rest, reason) in [
        (r#""radius": [1, 2]"#, "[radius-not-closed]"),
        (r#""radius": 10"#, "[tube-folds]"),
        (
            r#""radius_of": "balls", "radius": [{"at": 0, "radius": 0.1}, {"at": 0.02, "radius": 4}, {"at": 1, "radius": 0.1}]"#,
            "[radius-grows-too-fast]",
        ),
        (r#""radius": [1, {"at": 0.5, "radius": 2}]"#, "evenly spaced"),
        (r#""radius": [{"at": 0.5, "radius": 1}, {"at": 0.5, "radius": 2}]"#, "[empty-interval]"),
    ] {
        let error = along(rest);
        assert!(error.contains(reason), "{error}");
    }
}
