//! Every command does its job: files, reports, samples, schema.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "what is compared is printed exactly, to the bit")]

mod common;

use common::{Folder, project};
use serde_json::Value;

const TRACK: &str = "# x_m,y_m,w_right_m\n0,0,5\n40,-5,5\n70,20,5\n60,55,5\n20,60,5\n-15,35,5\n0,0,5\n";

/// Two contours and a corner, in the plane.
const LOGO: &str = "contour,x,y,corner\n\
    outer,0,0,1\nouter,5,-1,0\nouter,10,0,1\nouter,10,10,1\nouter,0,10,1\n\
    hole,3,3,0\nhole,3,6,0\nhole,6,6,0\nhole,6,3,0\n";

/// A document with an object of every type.
const ALL: &str = r#"{
  "cyclide": 1, "units": "in",
  "objects": {
    "three points": {"type": "arc", "through": [[0, 0], [1, 1], [2, 0]]},
    "tangent": {"type": "arc", "from": [3, 0], "to": [4, 1], "tangent": [1, 0]},
    "end": {"type": "arc", "from": [5, 0], "to": [6, 1], "end_tangent": [0, 1]},
    "weights": {"type": "arc", "from": [7, 0], "to": [8, 0], "weights": [[1, 0, 0, 0], [0, 0, 0, 1]]},
    "bulge": {"type": "arc", "from": [9, 0], "to": [10, 0, 1], "bulge": 0.5, "normal": [0, 1, 0]},
    "ring": {"type": "circle", "center": [0, 5], "normal": [0, 0, 1], "radius": 2},
    "s": {"type": "biarc", "from": [4, 5], "from_tangent": [1, 0], "to": [6, 6], "to_tangent": [1, 0],
          "rule": "equal-chord"},
    "arcs": {"type": "arc-spline", "points": [[0, 10], [2, 12], [5, 11]], "tangents": [[1, 0], [1, 0], [0, -1]],
             "closed": false, "rule": "auto"},
    "fit": {"type": "arc-fit", "points": [[0, 20], [1, 20.5], [2, 20.7], [3, 20.6], [4, 20.1]], "closed": false,
            "tolerance": 0.05, "target": "polyline", "effort": "best", "corner_angle": 1.0},
    "spline": {"type": "circle-spline", "points": {"csv": "logo.csv", "columns": ["x", "y"], "contour": "contour"},
               "closed": true, "order": 3, "variant": "trigonometric", "ends": "natural", "corner_angle": 2.5},
    "fair": {"type": "fair-spline", "points": [[0, 30], [1, 31], [3, 31], [4, 30]], "closed": false, "tension": 0.25,
             "tight": 0.2, "ends": {"start": "free", "end": [1, -1]}, "straight": "off", "corner_angle": 2.5}
  }
}"#;

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} of {value:#}"))
}

#[test]
fn curve_writes_every_format_and_reports_on_it() {
    let folder = Folder::with(&[("track.csv", TRACK)]);
    let report = folder.json(
        "curve track.csv --closed --units m -o a.step -o b.dxf -o c.svg -o d.csv -o e.json -o f.png -o g.STP --json",
    );
    let track = &report["objects"]["track"];
    assert_eq!(track["type"], "fair-spline");
    assert_eq!((&track["closed"], &track["pieces"], &track["points"]), (&true.into(), &6.into(), &6.into()));
    let length = number(track, "/length");
    // The chords are 226.7 long in all, the circle around the points has 250.
    assert!((227.0..260.0).contains(&length), "{length}");
    // Order 2: neither gap nor angle nor jump of curvature beyond rounding.
    assert_eq!(number(track, "/joints/gap"), 0.0);
    assert!(number(track, "/joints/angle") < 1e-12 && number(track, "/joints/curvature_jump") < 1e-12);
    assert!(number(track, "/curvature/max") > 1.0 / 60.0);
    assert!((0.0..=1.0).contains(&number(track, "/curvature/t")));
    assert!(number(track, "/weights/min") > 0.0 && number(track, "/weights/max") >= number(track, "/weights/min"));
    assert_eq!(track["warnings"][0]["reason"], "closing-point-merged");
    assert_eq!(track["warnings"][0]["place"], "track.csv:8");

    let files = report["files"].as_array().unwrap();
    let names: Vec<_> = files.iter().map(|f| f["path"].as_str().unwrap()).collect();
    assert_eq!(names, ["a.step", "b.dxf", "c.svg", "d.csv", "e.json", "f.png", "g.STP"]);
    for file in files {
        let path = file["path"].as_str().unwrap();
        assert_eq!(file["bytes"], folder.read(path).len(), "{path}");
        let (exact, bound) = (file["exact"].as_bool().unwrap(), number(file, "/bound"));
        if path == "f.png" {
            assert!(file["deviation"].is_null());
        } else {
            // 1e-9 of the size is what rounding may cost.
            assert!(number(file, "/deviation") <= bound + 1e-7, "{file}");
        }
        assert_eq!(exact, bound == 0.0, "{file}");
        assert_eq!(exact, ["a.step", "e.json", "g.STP"].contains(&path), "{file}");
    }
    assert_eq!(folder.read("a.step"), folder.read("g.STP"));
}

#[test]
fn build_knows_every_type_and_the_report_every_key() {
    let folder = Folder::with(&[("all.json", ALL), ("logo.csv", LOGO)]);
    let report = folder.json("build all.json -o all.step -o all.dxf --tolerance 1e-3 --json");
    let objects = report["objects"].as_object().unwrap();
    let names: Vec<_> = objects.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        ["three points", "tangent", "end", "weights", "bulge", "ring", "s", "arcs", "fit", "spline", "fair"]
    );
    for (name, object) in objects {
        for key in ["type", "length", "pieces", "closed", "joints", "curvature", "weights", "warnings"] {
            assert!(!object[key].is_null(), "{name} has {key}");
        }
        for path in ["/joints/gap", "/joints/angle", "/joints/curvature_jump", "/curvature/max", "/curvature/t"] {
            number(object, path);
        }
        assert!(number(object, "/weights/min") <= number(object, "/weights/max"));
        assert!(number(object, "/length") > 0.0);
    }
    // Half circles of radius 1 and 1/2, the circle of radius 2.
    assert!((number(&report, "/objects/three points/length") - std::f64::consts::PI).abs() < 1e-13);
    assert!((number(&report, "/objects/weights/length") - std::f64::consts::FRAC_PI_2).abs() < 1e-13);
    assert!((number(&report, "/objects/ring/length") - 4.0 * std::f64::consts::PI).abs() < 1e-13);
    assert!((number(&report, "/objects/ring/curvature/max") - 0.5).abs() < 1e-15);
    assert_eq!(report["objects"]["s"]["pieces"], 2);
    assert_eq!(report["objects"]["spline"]["contours"], 2);
    assert_eq!(report["objects"]["spline"]["joints"]["corners"], 4);
    assert!(number(&report, "/objects/fit/fit/deviation") <= 0.05);
    assert_eq!(report["units"], "in");
    assert!(number(&report, "/files/0/bound") <= 1e-3);

    // The same without files, from `report`, and as text.
    let alone = folder.json("report all.json --json");
    assert_eq!(alone["files"], Value::Array(Vec::new()));
    assert_eq!(alone["objects"]["ring"], report["objects"]["ring"]);
    let text = folder.ok("report all.json");
    assert!(text.contains("ring: circle, closed, 1 piece\n  length     12.566 in\n"), "{text}");
    assert!(!text.contains('\x1b'));
}

#[test]
fn curve_offers_every_kind() {
    let folder = Folder::with(&[("track.csv", TRACK), ("logo.csv", LOGO)]);
    let run = |options: &str| folder.json(&format!("curve track.csv --closed --units m -o t.step --json {options}"));
    let fair = run("--tension 0.5 --tight 0.2 --straight off");
    assert_eq!((&fair["objects"]["track"]["type"], &fair["files"][0]["exact"]), (&"fair-spline".into(), &true.into()));
    let spline = run("--kind circle-spline --order 4 --variant trigonometric --tolerance 0.01");
    assert_eq!(spline["files"][0]["exact"], false);
    let bound = number(&spline, "/files/0/bound");
    assert!(bound > 0.0 && bound <= 0.01, "a certified bound within the tolerance: {bound}");
    let arcs = run("--kind arc-spline --rule auto");
    assert_eq!(arcs["objects"]["track"]["pieces"], 12);
    let fit = run("--kind arc-fit --tolerance 2 --target polyline --effort fast --corner-angle-deg 170");
    assert_eq!(fit["objects"]["track"]["fit"]["tolerance"], 2.0);
    assert!(number(&fit, "/objects/track/fit/deviation") <= 2.0);
    let logo = folder.json("curve logo.csv --closed -o l.step --json");
    assert_eq!(logo["objects"]["logo"]["contours"], 2);
    assert_eq!(logo["objects"]["logo"]["joints"]["corners"], 4);
    let angle = folder.json("curve logo.csv --closed --corner-angle-deg 80 -o l.step --json");
    assert_eq!(angle["objects"]["logo"]["joints"]["corners"], 8, "the square hole has corners too");
    let columns = folder.json("curve logo.csv --closed --columns y,x --contour-column contour -o l.step --json");
    assert_eq!(columns["objects"]["logo"]["length"], logo["objects"]["logo"]["length"]);
}

#[test]
fn points_on_a_circle_give_the_circle() {
    let circle: String = (0..12)
        .map(|i| std::f64::consts::TAU * f64::from(i) / 12.0)
        .map(|a| format!("{} {} 7\n", 3.0 * a.cos(), 3.0 * a.sin()))
        .collect();
    let folder = Folder::with(&[("ring.txt", &circle)]);
    for kind in ["fair-spline", "circle-spline", "arc-spline", "arc-fit --tolerance 1e-6"] {
        let report = folder.json(&format!("curve ring.txt --closed --kind {kind} -o r.step --json"));
        let length = number(&report, "/objects/ring/length");
        // Points computed in double precision; a fit may use its tolerance.
        let limit = if kind.starts_with("arc-fit") { 2e-5 } else { 1e-12 };
        assert!((length - 6.0 * std::f64::consts::PI).abs() < limit, "{kind}: {length}");
    }
}

#[test]
fn sample_prints_points_tangents_and_curvature() {
    let folder = Folder::with(&[("all.json", ALL), ("logo.csv", LOGO)]);
    let text = folder.ok("sample all.json --object ring --count 9");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion"));
    let rows: Vec<Vec<f64>> = lines.map(|l| l.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 9);
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(row[0], i as f64 / 8.0);
        let (x, y) = (row[1], row[2] - 5.0);
        assert!((x.hypot(y) - 2.0).abs() < 1e-15 * 8.0);
        assert!((row[4] * x + row[5] * y).abs() < 1e-14 && (row[4].hypot(row[5]) - 1.0).abs() < 1e-15 * 4.0);
        assert!((row[7] - 0.5).abs() < 1e-15);
    }
    // Several contours, equal steps of length, into a file.
    assert_eq!(folder.ok("sample all.json --object spline --count 50 --equal-length -o s.csv"), "");
    let text = String::from_utf8(folder.read("s.csv")).unwrap();
    assert!(text.starts_with("contour,t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,"));
    let points = |contour: &str| -> Vec<(f64, f64)> {
        let rows = text.lines().filter(|l| l.starts_with(contour));
        rows.map(|l| l.split(',').map(|v| v.parse().unwrap_or(0.0)).collect::<Vec<f64>>())
            .map(|r| (r[2], r[3]))
            .collect()
    };
    for contour in ["0,", "1,"] {
        let points = points(contour);
        assert_eq!(points.len(), 50);
        assert_eq!(points[0], points[49]);
    }
    let hole = points("1,");
    let steps: Vec<f64> = hole.windows(2).map(|w| (w[1].0 - w[0].0).hypot(w[1].1 - w[0].1)).collect();
    // Chords of equal arcs of a circle: the hole's four points lie on one.
    assert!(steps.iter().all(|s| (s - steps[0]).abs() < 1e-9), "{steps:?}");
    // What was sampled can be read again.
    folder.ok("curve s.csv --closed -o again.step");
}

#[test]
fn the_only_object_needs_no_name() {
    let one = r#"{"cyclide": 1, "objects": {"a b": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;
    let folder = Folder::with(&[("one.json", one), ("all.json", ALL), ("logo.csv", LOGO)]);
    assert_eq!(folder.ok("sample one.json --count 2").lines().count(), 3);
    assert!(
        folder
            .fails(2, "sample all.json --count 2")
            .contains("--object is required: the objects of the model are 'three points', ")
    );
    assert!(folder.fails(2, "sample one.json --count 2 --object c").contains("no object 'c'; its objects are 'a b'"));
}

#[test]
fn schema_is_the_published_one() {
    let folder = Folder::with(&[]);
    let published = std::fs::read_to_string(project("docs/schema/cyclide-1.schema.json")).unwrap();
    assert_eq!(folder.ok("schema"), published);
}

#[test]
fn equal_runs_write_equal_bytes() {
    let folder = Folder::with(&[("track.csv", TRACK)]);
    let files = ["step", "dxf", "svg", "csv", "json", "png"];
    let outputs = |name: &str| files.map(|suffix| format!("-o {name}.{suffix}")).join(" ");
    let first = folder.ok(&format!("curve track.csv --closed {}", outputs("a")));
    let second = folder.ok(&format!("curve track.csv --closed {}", outputs("b")));
    for suffix in files {
        assert_eq!(folder.read(&format!("a.{suffix}")), folder.read(&format!("b.{suffix}")), "{suffix}");
    }
    assert_eq!(first.replace("a.", "b."), second);
}

#[test]
fn help_has_examples_and_exit_codes() {
    let folder = Folder::with(&[]);
    let help = folder.ok("--help");
    assert!(help.contains("Exit codes:") && help.contains("Examples:"), "{help}");
    for command in ["build", "curve", "sample", "report", "schema"] {
        let help = folder.ok(&format!("{command} --help"));
        assert!(help.contains("Example") && help.contains(&format!("cyclide {command}")), "{help}");
    }
    assert!(folder.ok("--version").starts_with("cyclide 0."));
}
