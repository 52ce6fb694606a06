//! Stations and frames along curves, tight places, NURBS curves, and kinds of curve compared.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::Folder;
use serde_json::Value;

/// A race track of two straights of 40 and two half circles of radius 10; a knot; a square, which is a surface's profile.
const MODEL: &str = r#"{"cyclide": 1, "units": "m", "objects": {
    "stadium": {"type": "polyline", "closed": true, "points": [[0, 0], [60, 0], [60, 20], [0, 20]], "radius": 10},
    "knot": {"type": "torus-knot", "torus": {"major_radius": 3, "minor_radius": 1}, "turns": [2, 3]},
    "line": {"type": "polyline", "points": [[0, 0, 0], [0, 0, 5]]},
    "ball": {"type": "revolution", "of": "half"},
    "half": {"type": "arc", "through": [[0, 0, 1], [1, 0, 0], [0, 0, -1]], "construction": true}}}"#;

const TRACK: &str = "x_m,y_m\n0,0\n40,-5\n70,20\n60,55\n20,60\n-15,35\n";

fn rows(text: &str) -> Vec<Vec<Option<f64>>> {
    text.lines().skip(1).map(|line| line.split(',').map(|field| field.parse().ok()).collect()).collect()
}

#[test]
fn samples_stand_at_stations() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    let total = 80.0 + 20.0 * std::f64::consts::PI;
    let text = folder.ok("sample m.json --object stadium --step 7.5");
    assert!(text.starts_with("t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion\n"));
    let rows = rows(&text);
    // 142.8/7.5 = 19.04: twenty whole steps begin, the last one is short.
    assert_eq!(rows.len(), 21);
    for (i, row) in rows.iter().enumerate() {
        let station = row[8].unwrap();
        let expected = if i == 20 { total } else { 7.5 * i as f64 };
        assert!((station - expected).abs() < 1e-10 * total, "{i} {station}");
        // Counter-clockwise, seen from above: positive on the half circles.
        let signed = row[9].unwrap();
        assert!(signed.abs() < 1e-12 || (signed - 0.1).abs() < 1e-12, "{signed}");
    }
    // A step that divides the length makes no empty last one.
    let text = folder.ok(&format!("sample m.json --object stadium --step {}", total / 4.0));
    assert_eq!(text.lines().count(), 1 + 5);
}

#[test]
fn frames_are_columns_and_json() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    let run = folder.run("sample m.json --object stadium --step 5 --frames up");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout
            .lines()
            .next()
            .unwrap()
            .ends_with(",torsion,normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z")
    );
    assert!(rows(&run.stdout).iter().all(|row| row[11..14] == [Some(0.0), Some(0.0), Some(1.0)]));
    // Frenet's frame does not exist on the straights: fields are empty, and that is said with the first place.
    let run = folder.run("sample m.json --object stadium --step 5 --frames frenet");
    assert!(
        run.code == 0 && run.stderr.contains("no frenet frame") && run.stderr.contains("[no-frame]"),
        "{}",
        run.stderr
    );
    let straight = rows(&run.stdout).iter().filter(|row| row[11].is_none()).count();
    assert!((14..=18).contains(&straight), "{straight}");
    // The frame of a knot comes back turned, which is said; spread, it closes.
    let run = folder.run("sample m.json --object knot --count 100 --frames rotation-minimizing -o k.json");
    assert!(run.code == 0 && run.stderr.contains("the frame is rotated by"), "{}", run.stderr);
    let found: Value = serde_json::from_slice(&folder.read("k.json")).unwrap();
    let contour = &found["contours"][0];
    assert_eq!((&found["frames"], contour["samples"].as_array().unwrap().len()), (&"rotation-minimizing".into(), 100));
    assert!(contour["holonomy"].as_f64().unwrap().abs() > 0.1 && contour["frame_error"].as_f64().unwrap() < 1e-8);
    assert!(contour["plane"].is_null() && contour["samples"][3]["signed_curvature"].is_null());
    let run = folder.run("sample m.json --object knot --count 100 --frames rotation-minimizing --spread-twist --json");
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    let samples = found["contours"][0]["samples"].as_array().unwrap();
    let normal = |i: usize| -> Vec<f64> {
        samples[i]["normal"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
    };
    assert!(normal(0).iter().zip(normal(99)).all(|(a, b)| (a - b).abs() < 1e-9));
    assert!(run.stderr.contains("spread over the length"), "{}", run.stderr);
    // To a point; with a first normal of one's own.
    let to_origin = folder.ok("sample m.json --object knot --count 9 --frames toward --toward 0,0,100");
    assert!(rows(&to_origin).iter().all(|row| row[13].unwrap() > 0.0));
    let first = folder.run("sample m.json --object stadium --count 2 --frames rotation-minimizing --up 0,1,0").stdout;
    assert!((rows(&first)[0][12].unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    let refused = |arguments: &str, words: &str| {
        let error = folder.fails(2, &format!("sample m.json --object {arguments}"));
        assert!(error.contains(words), "{arguments}: {error}");
    };
    refused("stadium", "--count");
    refused("stadium --step 0", "positive");
    refused("stadium --step 5 --count 3", "cannot be used with");
    refused("stadium --step 1e-9", "rows on 1 contours");
    refused("stadium --count 3 --up 0,0,1", "--up would have no effect");
    refused("stadium --count 3 --frames frenet --spread-twist", "--spread-twist would have no effect");
    refused("stadium --count 3 --frames toward", "--toward");
    refused("stadium --count 3 --frames up --up 0,1", "three comma-separated numbers");
    refused("ball --step 1", "--step is for curves");
    refused("ball --count 3 --frames up", "--frames is for curves");
    refused("stadium --count 3 --json -o s.csv", "--json requests JSON");
    let error = folder.fails(1, "sample m.json --object stadium --count 3 --frames up --up 0,0,0");
    assert!(error.contains("[zero-axis]"), "{error}");
    let error = folder.fails(1, "sample m.json --object line --count 3 --frames rotation-minimizing --up 0,0,1");
    assert!(error.contains("[no-frame]"), "{error}");
}

#[test]
fn tight_places_are_named_in_reports() {
    let folder = Folder::with(&[("m.json", MODEL), ("track.csv", TRACK)]);
    let run = folder.run("report m.json --min-radius 12");
    assert!(run.code == 0 && run.stderr.contains("[tighter-than-radius]"), "{}", run.stderr);
    // The half circles are two quarters each, which are one place.
    assert!(run.stdout.contains("tight      2 places with a radius below 12 m"), "{}", run.stdout);
    assert!(run.stdout.contains("radius 10 m at station"), "{}", run.stdout);
    let report: Value = serde_json::from_str(&folder.ok("report m.json --min-radius 12 --json")).unwrap();
    let stadium = &report["objects"]["stadium"];
    let places = stadium["tight"]["places"].as_array().unwrap();
    let number = |place: &Value, field: &str| place[field].as_f64().unwrap();
    assert_eq!((places.len(), stadium["warnings"].as_array().unwrap().len()), (2, 2));
    for place in places {
        assert!((number(place, "radius") - 10.0).abs() < 1e-12);
        assert!((number(place, "to") - number(place, "from") - 10.0 * std::f64::consts::PI).abs() < 1e-9);
    }
    assert!(report["objects"]["knot"]["tight"]["places"].as_array().is_some_and(|places| !places.is_empty()));
    assert!(report["objects"]["ball"].get("tight").is_none());
    // None is said too, and without the option nothing is.
    assert!(folder.ok("report m.json --min-radius 0.1").contains("no place with a radius below 0.1 m"));
    assert!(!folder.ok("report m.json").contains("tight "));
    let report = folder.json("curve track.csv --closed -o t.step --min-radius 30 --json");
    assert!(!report["objects"]["track"]["tight"]["places"].as_array().unwrap().is_empty());
}

#[test]
fn cusps_and_lines_that_turn_back_are_tight() {
    let knots = "[0, 0, 0, 1, 1, 1]";
    let cubic = "[0, 0, 0, 0, 1, 1, 1, 1]";
    let model = format!(
        r#"{{"cyclide": 1, "units": "m", "objects": {{
        "back": {{"type": "nurbs", "degree": 2, "knots": {knots}, "control_points": [[0, 0], [4, 0], [2, 0]]}},
        "slanted": {{"type": "nurbs", "degree": 2, "knots": {knots}, "control_points": [[1, 2, 0], [5, 5, 7], [3, 3.5, 3.5]]}},
        "cusp": {{"type": "nurbs", "degree": 3, "knots": {cubic}, "control_points": [[0, 0], [1, 1], [0, 1], [1, 0]]}},
        "folded": {{"type": "polyline", "points": [[0, 0], [4, 0], [2, 0]]}},
        "straight": {{"type": "nurbs", "degree": 2, "knots": {knots}, "control_points": [[0, 0], [1, 0], [4, 0]]}}}}}}"#
    );
    let folder = Folder::with(&[("f.json", &model)]);
    let report: Value = serde_json::from_str(&folder.ok("report f.json --min-radius 1e-3 --json")).unwrap();
    let places = |object: &str| report["objects"][object]["tight"]["places"].as_array().unwrap().clone();
    // It turns where the derivative 8 (1 - s) - 4 s vanishes, at s = 2/3, x = 8/3; the cusp is in the middle.
    for (object, place) in [("back", [8.0 / 3.0, 0.0, 0.0]), ("cusp", [0.5, 0.75, 0.0]), ("folded", [4.0, 0.0, 0.0])] {
        let found = places(object);
        assert_eq!(found.len(), 1, "{object}: {found:?}");
        assert_eq!(found[0]["radius"].as_f64(), Some(0.0), "{object}");
        for (k, expected) in place.into_iter().enumerate() {
            // Where the speed vanishes the place is known to the root of a rounding, the point to that of its square.
            assert!((found[0]["point"][k].as_f64().unwrap() - expected).abs() < 1e-9, "{object}: {found:?}");
        }
    }
    assert_eq!(places("slanted").len(), 1);
    assert!(places("straight").is_empty());
}

#[test]
fn images_of_images_double_the_degree_once() {
    let map = |of: &str, steps: &str| format!(r#"{{"type": "transform", "of": "{of}", "steps": [{steps}]}}"#);
    let (first, second) =
        (r#"{"inversion": {"center": [3, 1], "radius": 2}}"#, r#"{"inversion": {"center": [-1, 5], "radius": 1}}"#);
    let turn = r#"{"rotation": {"angle": 0.5}}"#;
    let model = format!(
        r#"{{"cyclide": 1, "objects": {{
        "curve": {{"type": "nurbs", "degree": 3, "knots": [0, 0, 0, 0, 1, 1, 1, 1], "control_points": [[0, 0], [1, 2], [2, -2], [2, 3, 1]]}},
        "once": {}, "twice": {}, "turned": {}, "together": {}, "back": {}, "cut": {}}}}}"#,
        map("curve", first),
        map("once", second),
        map("twice", turn),
        map("curve", &format!("{first}, {second}, {turn}")),
        map("once", first),
        map("once", r#"{"cut": {"parameters": [0, 0.5]}}, "reverse""#),
    );
    let folder = Folder::with(&[("t.json", &model)]);
    let points = |object: &str| rows(&folder.ok(&format!("sample t.json --object {object} --count 9")));
    folder.ok("build t.json -o t.step");
    let degrees: Vec<usize> = String::from_utf8(folder.read("t.step"))
        .unwrap()
        .split("B_SPLINE_CURVE(")
        .skip(1)
        .filter_map(|text| text.split(',').next()?.parse().ok())
        .collect();
    // The curve and the one that is back have degree 3, all images twice that, and up to 3 more for smooth knots where spans were halved.
    assert_eq!((degrees.len(), degrees.iter().max()), (7, Some(&9)), "{degrees:?}");
    assert_eq!(degrees.iter().filter(|degree| **degree == 3).count(), 2, "{degrees:?}");
    let apart = |a: &str, b: &str| {
        let (a, b) = (points(a), points(b));
        assert_eq!((a.len(), b.len()), (9, 9));
        let off = |(a, b): (&Vec<Option<f64>>, &Vec<Option<f64>>)| {
            (1..4).map(|k| (a[k].unwrap() - b[k].unwrap()).abs()).fold(0.0, f64::max)
        };
        a.iter().zip(&b).map(off).fold(0.0, f64::max)
    };
    // Printed to the last digit; the maps are a few roundings of coordinates up to 5.
    assert!(apart("back", "curve") < 1e-13 && apart("turned", "together") < 1e-13 && apart("turned", "curve") > 0.1);
}

#[test]
fn all_points_of_an_interpolation_are_drawn() {
    let folder = Folder::with(&[("p.csv", "x,y\n0,0\n1,2\n3,2\n5,1\n6,0\n")]);
    folder.ok("curve p.csv --kind qb-interpolation -o p.svg -o p.png --svg-points");
    let drawing = String::from_utf8(folder.read("p.svg")).unwrap();
    let (_, joints) = drawing.split_once("<g id=\"joints\"").unwrap();
    let (joints, _) = joints.split_once("</g>").unwrap();
    assert_eq!(joints.matches("<circle").count(), 5, "{joints}");
}

#[test]
fn knots_and_parameters_are_options() {
    let folder = Folder::with(&[("p.csv", "x,y\n0,0\n1,2\n3,2\n5,1\n9,0\n")]);
    let parameters = |options: &str| {
        let report = folder.json(&format!("curve p.csv --kind qb-interpolation {options} -o p.step --json"));
        serde_json::from_value::<Vec<f64>>(report["objects"]["p"]["qb"]["parameters"][0].clone()).unwrap()
    };
    assert_eq!(parameters("--parameters 0,0.2,0.4,0.5,1"), [0.0, 0.2, 0.4, 0.5, 1.0]);
    assert_eq!(parameters("--parameters uniform"), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(parameters("--parameters auto"), parameters("--parameters centripetal"));
    let length = |options: &str| {
        let report = folder.json(&format!("curve p.csv --kind moebius-spline {options} -o p.step --json"));
        report["objects"]["p"]["length"].as_f64().unwrap()
    };
    let (chord, given, g1) = (length("--knots chord"), length("--knots 0,1,4,5,6"), length("--continuity g1"));
    assert!((chord - given).abs() > 1e-4 && (chord - g1).abs() > 1e-4, "{chord} {given} {g1}");
    for (options, words) in [
        ("--kind fair-spline --knots chord", "--knots requires --kind moebius-spline"),
        ("--kind moebius-spline --parameters chord", "--parameters requires --kind qb-interpolation"),
        ("--kind moebius-spline --knots chords", "comma-separated list of numbers"),
        ("--kind moebius-spline --continuity g1 --knots chord", "--knots would have no effect"),
    ] {
        let error = folder.fails(2, &format!("curve p.csv {options} -o p.step"));
        assert!(error.contains(words), "{options}: {error}");
    }
    let error = folder.fails(1, "curve p.csv --kind moebius-spline --knots 0,1,1,2,3 -o p.step");
    assert!(error.contains("[parameters-not-increasing]"), "{error}");
}

#[test]
fn nurbs_documents_are_measured_mapped_and_written() {
    let circle = r#"{"cyclide": 1, "objects": {
        "circle": {"type": "nurbs", "degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
            "control_points": [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]],
            "weights": [1, 0.7071067811865476, 1, 0.7071067811865476, 1, 0.7071067811865476, 1, 0.7071067811865476, 1]},
        "image": {"type": "transform", "of": "circle", "steps": [{"inversion": {"center": [3, 0], "radius": 1}}]},
        "periodic": {"type": "nurbs", "degree": 3, "knots": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
            "control_points": [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0], [4, 0], [4, 4]]}}}"#;
    let folder = Folder::with(&[("n.json", circle)]);
    let run = folder.run("build n.json -o n.step -o n.dxf -o n.svg -o n.csv -o n.out.json --json");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("[knots-clamped]"), "{}", run.stderr);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let of = |object: &str, field: &str| report["objects"][object][field].clone();
    assert!((of("circle", "length").as_f64().unwrap() - std::f64::consts::TAU).abs() < 1e-12);
    // The image has the diameter 1/2 - 1/4.
    assert!((of("image", "length").as_f64().unwrap() - 0.25 * std::f64::consts::PI).abs() < 1e-12);
    assert_eq!((of("circle", "closed"), of("periodic", "closed")), (true.into(), true.into()));
    let files = report["files"].as_array().unwrap();
    let exact: Vec<&str> = files.iter().filter(|f| f["exact"] == true).map(|f| f["format"].as_str().unwrap()).collect();
    assert_eq!(exact, ["step", "json"]);
    // Smooth knots stay: the cubic is one still.
    assert!(String::from_utf8(folder.read("n.step")).unwrap().contains("B_SPLINE_CURVE(3,"));
    // What is wrong is shown at its place.
    for (from, to, words) in [
        ("2, 2, 3, 3", "2, 1.5, 3, 3", "knot 6 is 1.5, less than the previous one, 2"),
        ("1, 1, 2, 2", "1, 1, 1, 2", "has multiplicity 3, maximum 2"),
        ("\"degree\": 2", "\"degree\": 26", "[parameter-out-of-range]"),
        ("[0, 0, 0, 1", "[0, 0, 1", "11 knots given, 12 needed"),
        ("[1, 0.7071", "[1, -0.7071", "weight 1 is -0.70711"),
        ("\"center\": [3, 0]", "\"center\": [1, 0]", "[point-at-infinity]"),
    ] {
        assert!(circle.contains(from), "{from}");
        folder.write("bad.json", &circle.replacen(from, to, 1));
        let error = folder.fails(1, "report bad.json");
        assert!(error.contains(words), "{words}: {error}");
    }
}

#[test]
fn kinds_are_compared_on_one_page() {
    let folder = Folder::with(&[("track.csv", TRACK), ("zigzag.csv", "0,0\n1,1\n2,0\n1,1\n")]);
    let text = folder.ok("compare track.csv --closed -o t.html -o t.csv -o t.json");
    let kinds = ["fair-spline", "circle-spline", "moebius-spline", "arc-spline", "arc-fit", "fair-fit"];
    let page = String::from_utf8(folder.read("t.html")).unwrap();
    let table = String::from_utf8(folder.read("t.csv")).unwrap();
    for kind in kinds {
        assert!(
            text.contains(kind) && table.contains(kind) && page.contains(&format!("<article id=\"{kind}\">")),
            "{kind}"
        );
    }
    // A file of its own: nothing is loaded from anywhere.
    assert!(!page.contains("http") && !page.contains("<script") && !page.contains("<img") && !page.contains("url("));
    assert_eq!(page.matches("<svg").count(), 2 * kinds.len());
    assert!(!page.contains("NaN") && !page.contains("inf"));
    let found: Value = serde_json::from_slice(&folder.read("t.json")).unwrap();
    let named = |kind: &str| {
        let found = found["kinds"].as_array().unwrap().iter().find(|found| found["kind"] == kind);
        found.unwrap_or_else(|| panic!("{kind}"))["measures"].clone()
    };
    let of = |kind: &str, field: &str| named(kind)[field].as_f64().unwrap();
    assert_eq!((&found["units"], &found["points"], &found["closed"]), (&"m".into(), &6.into(), &true.into()));
    // The fair spline varies less than the circle spline; arcs have no finite variation, and jumps.
    assert!(
        of("fair-spline", "variation") < of("circle-spline", "variation") && named("arc-spline")["variation"].is_null()
    );
    assert!(of("arc-spline", "jumps") > 0.0 && of("fair-spline", "jumps") == 0.0);
    assert!(of("fair-spline", "off_points") < 1e-12);
    // The table that is printed has what the page has to choose by; curves in space have no sides to change.
    let columns = ["length", "bending", "variation", "sign changes", "largest curvature", "overshoot"];
    assert!(columns.iter().all(|column| text.lines().next().unwrap().contains(column)), "{text}");
    folder.write("space.csv", "0,0,0\n4,1,2\n5,4,1\n2,6,3\n");
    assert!(folder.ok("compare space.csv").lines().nth(1).unwrap().contains(" – "));
    // What cannot be closed says so.
    assert!(page.contains("this kind cannot be closed") && named("qb-interpolation").is_null());
    // A smooth closed curve of one turn bends by more than a circle of its length.
    assert!(of("fair-spline", "bending_energy") * of("fair-spline", "length") >= 4.0 * std::f64::consts::PI.powi(2));
    let columns = |line: &str| line.split(',').count();
    assert!(table.lines().all(|line| columns(line) == columns(table.lines().next().unwrap())));
    // A kind that cannot be made says why, in every form, and the others stand.
    let run = folder.run("compare zigzag.csv");
    let line = run.stdout.lines().find(|line| line.starts_with("qb-interpolation")).unwrap();
    assert!(line.contains("refused: ") && line.contains("[even-point-count]"), "{line}");
    assert_eq!(run.stdout.lines().count(), 1 + kinds.len() + 1);
    folder.ok("compare zigzag.csv -o zigzag.json");
    let refused: Value = serde_json::from_slice(&folder.read("zigzag.json")).unwrap();
    assert!(refused["kinds"].as_array().unwrap().iter().any(|kind| {
        kind["refused"]
            .as_str()
            .is_some_and(|why| kind["kind"] == "qb-interpolation" && why.contains("[even-point-count]"))
    }));
    let run = folder.run("compare zigzag.csv -o zigzag.html");
    assert!(run.code == 0 && run.stderr.contains("not available"), "{} {}", run.code, run.stderr);
    assert!(String::from_utf8(folder.read("zigzag.html")).unwrap().contains("Not available"));
    assert!(folder.fails(2, "compare track.csv -o t.pdf").contains("a comparison is written as .html, .csv or .json"));
    assert!(folder.fails(2, "compare track.csv -o track.csv").contains("is an input"));
}
