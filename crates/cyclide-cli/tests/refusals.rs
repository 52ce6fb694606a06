//! What cannot be done is refused with its place and its exit code, and nothing is lost.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::io::Read as _;
use std::process::Stdio;

use common::{Folder, Run};

const CIRCLE: &str = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;
const POINTS: &str = "x,y\n0,0\n1,0\n1,1\n";

#[test]
fn limits_say_whether_they_are_excluded_and_what_to_do_instead() {
    let folder = Folder::with(&[]);
    let run = r#""r": {"type": "polyline", "points": [[0, 0, 0], [400, 0, 0], [400, 250, 0]], "radius": 60, "construction": true}"#;
    let plate =
        r#""type": "plate-with-neck", "pipe_radius": 20, "ball_radius": 5, "plate": {"radius": 60}, "thickness": 4"#;
    let motion = r#""type": "motion", "poses": [{"position": [0, 0]}, {"position": [1, 0]}]"#;
    let circle = r#""c": {"type": "circle", "center": [0, 0], "radius": 5}"#;
    let fair = r#""c": {"type": "fair-spline", "points": [[0, 0], [5, 1], [7, 5], [4, 9]]}"#;
    for (objects, message) in [
        (
            format!(r#"{run}, "t": {{"type": "pipe", "of": "r", "radius": 21.3, "wall": 21.3}}"#),
            "wall = 21.3 is outside 0 to 21.3, the ends excluded",
        ),
        (format!(r#""n": {{{plate}, "height": 5}}"#), "height = 5 is out of range: must be above 5 "),
        (format!(r#""n": {{{plate}, "height": -5}}"#), "height = -5 is out of range: must be above 5 "),
        (format!(r#""m": {{{motion}, "duration": 0}}"#), "duration = 0 is out of range: must be above 0 "),
        (format!(r#""m": {{{motion}, "duration": -2}}"#), "duration = -2 is out of range: must be above 0 "),
        (
            format!(
                r#"{circle}, "t": {{"type": "transform", "of": "c", "steps": [{{"cut": {{"parameters": [0.2, 1.2]}}}}]}}"#
            ),
            "there is no part between the parameters 0.2 and 1.2",
        ),
        (
            format!(
                r#"{circle}, "t": {{"type": "transform", "of": "c", "steps": [{{"cut": {{"parameters": [0, 1]}}}}]}}"#
            ),
            "the cut would keep the full circle, but an arc must be shorter: remove the cut",
        ),
        (
            format!(
                r#"{fair}, "t": {{"type": "transform", "of": "c", "steps": [{{"inversion": {{"center": [0, -9], "radius": 6}}}}]}}"#
            ),
            "steps[0]: the map is not a similarity: fair and circle splines can only be moved, rotated, scaled and mirrored; a `moebius-spline`",
        ),
        (
            r#""q": {"type": "qb-interpolation", "points": [[1, 2]]}"#.to_owned(),
            "too few points: 1 given, at least 3 needed",
        ),
        (
            r#""q": {"type": "qb-interpolation", "points": [[1, 2], [1, 2], [3, 4]]}"#.to_owned(),
            "points 0 and 1 coincide [coincident-points]",
        ),
    ] {
        folder.write("m.json", &format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#));
        let error = folder.fails(1, "report m.json");
        assert!(error.contains(message), "{message}\n{error}");
    }
}

#[test]
fn refused_input_shows_file_line_and_column() {
    let folder = Folder::with(&[
        ("json.json", "{\"cyclide\": 1,\n \"objects\": {\n}"),
        ("version.json", "{\"cyclide\": 3, \"objects\": {}}"),
        ("field.json", "{\"cyclide\": 1, \"objects\": {\n  \"c\": {\"type\": \"circle\", \"size\": 1}}}"),
        (
            "kernel.json",
            "{\"cyclide\": 1, \"objects\": {\n  \"c\": {\"type\": \"circle\", \"center\": [0,0], \"radius\": 0}}}",
        ),
        (
            "csv.json",
            "{\"cyclide\": 1, \"objects\": {\"c\": {\"type\": \"arc-spline\", \"points\": {\"csv\": \"bad.csv\"}}}}",
        ),
        ("empty.json", "{\"cyclide\": 1, \"objects\": {}}"),
        ("bad.csv", "x,y\n0,0\n1,nan\n"),
        ("few.csv", "0,0\n"),
        ("twice.csv", "0,0\n0,0\n"),
        ("none.csv", "x,y\n"),
        ("bytes.csv", "0,0\n1,1\n"),
    ]);
    std::fs::write(folder.path("bytes.csv"), b"0,0\n1,\xff\n").unwrap();
    let before = folder.count();
    for (command, message) in [
        ("build json.json", "error: json.json:3:1: the file ends inside an object: a `}` is missing\n  3 | }\n    | ^"),
        ("build version.json", "error: version.json:1:13: cyclide: unknown document version 3"),
        ("report field.json", "error: field.json:2:27: objects.c: unknown field `size`, expected one of"),
        (
            "build kernel.json",
            "error: kernel.json:2:54: objects.c.radius: the radius 0 is not positive [radius-not-positive]",
        ),
        (
            "sample csv.json --count 5",
            "error: bad.csv:3:3: `nan` is not a finite number; remove the line if it is no point\n  3 | 1,nan\n    |   ^^^",
        ),
        ("build empty.json", "error: o.step: the model has nothing to write [empty-model]"),
        ("curve bad.csv", "error: bad.csv:3:3: `nan` is not a finite number"),
        (
            "curve few.csv",
            "error: few.csv:1:1: objects.few: too few points: 1 given, at least 2 needed [too-few-points]",
        ),
        (
            "curve twice.csv",
            "error: twice.csv:1:1: objects.twice: too few points: 1 given, at least 2 needed (repeated points count once) [too-few-points]",
        ),
        ("curve none.csv", "error: none.csv:1:1: the file has no points"),
        ("curve bytes.csv", "error: bytes.csv:2:3: `ÿ` is not a number"),
        ("curve few.csv --columns a,b", "error: few.csv:1:1: no column `a`: the file has no header line"),
    ] {
        let output = if command.starts_with("build") || command.starts_with("curve") { " -o o.step" } else { "" };
        let error = folder.fails(1, &format!("{command}{output}"));
        assert!(error.starts_with(message), "{command}\n{error}");
    }
    assert_eq!(folder.count(), before, "nothing was written");
}

#[test]
fn usage_that_makes_no_sense_is_refused() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("p.csv", POINTS)]);
    for (command, message) in [
        ("", "Usage:"),
        ("paint", "unrecognized subcommand"),
        ("build c.json", "--output <FILE>"),
        ("build c.json -o a.iges", "a.iges: no format with this suffix; known suffixes are .step"),
        ("build c.json -o a", "no format with this suffix"),
        ("build c.json -o a.step -o a.step", "a.step is given twice"),
        ("build c.json -o a.step b.step", "unexpected argument 'b.step'"),
        ("build c.json -o a.step --tolerance 0", "must be positive and finite"),
        ("build c.json -o a.step --tolerance -1", "must be positive and finite"),
        ("build c.json -o a.step --tolerance x", "not a number"),
        ("build c.json -o ./c.json", "./c.json is an input and will not be overwritten"),
        ("curve p.csv -o p.csv", "p.csv is an input"),
        ("build p.csv -o a.step", "p.csv seems to be a list of points, not a model document"),
        ("report p.csv", "see 'cyclide curve'"),
        ("build m.obj -o a.step", "m.obj seems to be a mesh, not a model document: 'cyclide new cyclidic-net' prints"),
        ("curve m.obj -o a.step", "m.obj seems to be a mesh, not a list of points"),
        ("curve c.json -o a.step", "c.json seems to be a model document, not a list of points"),
        ("sample c.json --count 5 -o c.json", "c.json is an input"),
        ("curve p.csv -o a.step --order 5", "5 is not in 1..=4"),
        ("curve p.csv -o a.step --kind arc-fit", "--kind arc-fit needs --tolerance"),
        ("curve p.csv -o a.step --kind arc-spline --order 3", "--order requires --kind circle-spline, not arc-spline"),
        (
            "curve p.csv -o a.step --kind arc-spline --corner-angle-deg 3",
            "fair-spline or circle-spline or moebius-spline or arc-fit or fair-fit, not arc-spline",
        ),
        ("curve p.csv -o a.step --order 3", "--order requires --kind circle-spline, not fair-spline"),
        (
            "curve p.csv -o a.step --kind circle-spline --tension 0.5",
            "--tension requires --kind fair-spline, not circle-spline",
        ),
        ("curve p.csv -o a.step --kind arc-fit --tolerance 1 --ends free", "--ends requires --kind fair-spline"),
        ("curve p.csv -o a.step --kind arc-spline --straight off", "--straight requires --kind fair-spline"),
        ("curve p.csv -o a.step --tension 1.5", "must be from 0 to 1"),
        ("curve p.csv -o a.step --tension -0.5", "must be from 0 to 1"),
        ("curve p.csv -o a.step --tight 0.5", "must be below 0.5"),
        ("curve p.csv -o a.step --tight 0", "must be positive and finite"),
        ("curve p.csv -o a.step --ends natural", "possible values: circle, arc, free"),
        ("curve p.csv -o a.step --effort best", "--effort requires --kind arc-fit"),
        ("curve p.csv -o a.step --kind fair-fit", "--kind fair-fit needs --smooth"),
        ("curve p.csv -o a.step --kind arc-fit --tolerance 1 --smooth 1", "--smooth requires --kind fair-fit"),
        ("curve p.csv -o a.step --centre 1", "--centre requires --kind fair-fit, not fair-spline"),
        ("curve p.csv -o a.step --smooth 1 --order 2", "--order requires --kind circle-spline, not fair-fit"),
        ("curve p.csv -o a.step --smooth 0", "must be positive and finite"),
        ("curve p.csv -o a.step --smooth 1 --centre -1", "must be finite and non-negative"),
        ("curve p.csv -o a.step --smooth 1 --fast --nodes 9", "cannot be used with"),
        ("curve p.csv -o a.step --smooth 1 --nodes 1", "1 is not in 2..="),
        ("curve p.csv -o a.step --smooth 1 --polyline 101", "101 is not in 0..=100"),
        ("curve p.csv -o a.step --units yd", "possible values: mm, cm, m, in, ft"),
        ("sample c.json --count 1", "1 is not in 2..="),
        // Negative numbers are numbers, however they are written.
        ("sample c.json --count -1", "-1 is not in 2..="),
        ("sample c.json --step -.5", "must be positive and finite"),
        ("curve p.csv -o a.step --smooth 1 --centre -.5e1", "must be finite and non-negative"),
    ] {
        let error = folder.fails(2, command);
        assert!(error.contains(message), "{command}\n{error}");
    }
    assert_eq!(folder.count(), 2);
    assert_eq!((folder.read("c.json"), folder.read("p.csv")), (CIRCLE.into(), POINTS.into()));
}

#[test]
fn a_point_file_of_the_model_is_not_written_over() {
    let model = r#"{"cyclide": 1, "objects": {"c": {"type": "arc-spline", "points": {"csv": "p.csv"}}}}"#;
    let folder = Folder::with(&[("m.json", model), ("p.csv", POINTS)]);
    assert!(folder.fails(2, "build m.json -o a.step -o p.csv").contains("p.csv is an input"));
    assert!(folder.fails(2, "sample m.json --count 3 -o p.csv").contains("p.csv is an input"));
    assert_eq!(folder.read("p.csv"), POINTS.as_bytes());
    assert!(!folder.has("a.step"));
}

#[test]
fn files_that_cannot_be_read_or_written() {
    let missing = r#"{"cyclide": 1, "objects": {"c": {"type": "arc-spline", "points": {"csv": "none.csv"}}}}"#;
    let folder = Folder::with(&[("c.json", CIRCLE), ("m.json", missing)]);
    for (command, message) in [
        ("build none.json -o a.step", "error: cannot read none.json: "),
        ("build m.json -o a.step", "error: m.json:1:74: objects.c.points.csv: cannot read none.csv: "),
        ("curve none.csv -o a.step", "error: cannot read none.csv: "),
        ("curve none.csv -o a.step", "error: cannot read none.csv: "),
        ("build . -o a.step", "error: cannot read .: "),
        (
            "build c.json -o no/such/folder/a.step",
            "error: cannot write no/such/folder/a.step: the folder no does not exist\n",
        ),
        ("sample c.json --count 3 -o no/a.csv", "error: cannot write no/a.csv: the folder no does not exist\n"),
        ("build c.json -o c.json/a.step", "error: cannot write c.json/a.step: c.json is not a folder\n"),
    ] {
        let error = folder.fails(3, command);
        assert!(error.starts_with(message), "{command}\n{error}");
    }
    assert_eq!(folder.count(), 2);
}

#[test]
fn a_failed_run_leaves_the_old_files() {
    let folder = Folder::with(&[("c.json", CIRCLE), ("a.step", "old"), ("bad.json", "{")]);
    folder.fails(1, "build bad.json -o a.step");
    assert_eq!(folder.read("a.step"), b"old");
    // A later output that cannot be made keeps an earlier one from being written.
    let space = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [1e200, 0], "radius": 1}}}"#;
    folder.write("far.json", space);
    folder.fails(1, "build far.json -o a.step -o b.svg");
    assert_eq!(folder.read("a.step"), b"old");
    assert!(!folder.has("b.svg"));
    // So does one that cannot be written.
    for second in ["no/such/folder/b.svg", "folder.svg"] {
        std::fs::create_dir_all(folder.path("folder.svg")).expect("a folder is made");
        folder.fails(3, &format!("build c.json -o a.step -o {second}"));
        assert_eq!(folder.read("a.step"), b"old");
    }
    std::fs::remove_dir(folder.path("folder.svg")).expect("the folder is empty");
    // And a good run replaces the file.
    folder.ok("build c.json -o a.step");
    assert!(folder.read("a.step").starts_with(b"ISO-10303-21;"));
    assert_eq!(folder.count(), 4, "no temporary files are left");
}

#[test]
fn warnings_are_on_standard_error_with_their_place() {
    let folder = Folder::with(&[
        ("track.csv", "# x_m,y_m,w_m\n0,0,1\n4,0,1\n4,0,1\n4,4,1\n0,4,1\n0,0,1\n"),
        ("mm.csv", "x [mm],y [mm]\n0,0\n4,0\n4,4\n"),
    ]);
    let run = folder.run("curve track.csv --kind fair-spline --closed --units mm -o a.step");
    assert_eq!(run.code, 0);
    let expected = [
        "warning: track.csv: track: the unit in the columns x_m, y_m is m, but that of the model is mm; coordinates are not converted [units-differ]",
        "warning: track.csv:4: track: point 2 repeats the previous one (closer than ",
        "warning: track.csv:7: track: point 5 repeats the first point of the closed curve: merged with it [closing-point-merged]",
    ];
    let lines: Vec<&str> = run.stderr.lines().collect();
    assert_eq!(lines.len(), expected.len(), "{}", run.stderr);
    for (line, start) in lines.iter().zip(expected) {
        assert!(line.starts_with(start), "{line}");
    }
    assert!(run.stdout.contains("  warnings   3\n"), "{}", run.stdout);
    assert!(!run.stderr.contains('\x1b'), "no colour where there is no terminal");
    // The right unit, and columns without one that is wrong.
    assert_eq!(folder.run("curve mm.csv -o b.step").stderr, "");
    let note = folder.run("curve track.csv --closed -o a.step").stderr;
    assert!(
        note.starts_with(
            "note: track.csv: the unit is m, taken from the columns x_m, y_m (change it with --units)\nwarning: "
        ),
        "{note}"
    );
    assert!(!note.contains("units-differ"), "{note}");
    let open = folder.run("curve track.csv --units m -o c.step");
    assert!(open.stderr.contains("set `closed` if it should be [ends-meet]"), "{}", open.stderr);
    assert!(!open.stderr.contains("units-differ"));
}

#[test]
fn many_warnings_of_a_kind_are_counted() {
    let zigzag: String = (0..40).map(|i| format!("{},{}\n{0},{1}\n", i, i % 3)).collect();
    let folder = Folder::with(&[("z.csv", &zigzag)]);
    let stderr = folder.run("curve z.csv -o z.step").stderr;
    assert_eq!(stderr.matches("[points-merged]").count(), 4, "{stderr}");
    assert!(stderr.contains("37 more of these warnings (--json lists all) [points-merged]"), "{stderr}");
    let report = folder.json("curve z.csv -o z.step --json");
    assert_eq!(report["objects"]["z"]["warnings"].as_array().unwrap().len(), 40);
}

#[test]
fn a_reader_that_stops_early_is_no_failure() {
    let folder = Folder::with(&[("c.json", CIRCLE)]);
    let mut child = folder
        .command()
        .args(["sample", "c.json", "--count", "200000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut start = [0; 10];
    child.stdout.take().unwrap().read_exact(&mut start).unwrap();
    assert_eq!(&start, b"t,x,y,z,ta");
    // The pipe is closed now, long before megabytes of samples are through.
    let run = Run::new(child.wait_with_output().unwrap());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
}

/// A document with one object.
fn document(object: &str) -> String {
    format!(r#"{{"cyclide": 1, "units": "m", "objects": {{"o": {object}}}}}"#)
}

#[test]
fn surfaces_below_the_rounding_of_their_place_are_named() {
    let folder = Folder::with(&[]);
    for object in [
        r#"{"type": "cyclide", "a": 2, "mu": 1, "center": [1e17, 1e17, 1e17]}"#,
        r#"{"type": "cyclide", "a": 2, "mu": 1, "center": [1e15, 1e15, 1e15]}"#,
        r#"{"type": "cyclide", "a": 1e-50, "mu": 1e-50, "center": [1, 1, 1]}"#,
        r#"{"type": "cyclide", "a": 1e-14, "mu": 1e-15, "center": [1, 1, 1]}"#,
        r#"{"type": "cyclide", "a": 2.8e-14, "mu": 1.5e-14, "center": [1, -7e-07, -2], "axis": [1, -1, -1]}"#,
    ] {
        folder.write("m.json", &document(object));
        for command in ["report m.json", "build m.json -o m.step", "sample m.json --count 3"] {
            let error = folder.fails(1, command);
            assert!(error.contains("objects.o: the surface "), "{object}: {error}");
            assert!(error.contains("or move it to the origin [below-rounding-of-place]"), "{object}: {error}");
        }
    }
}

#[test]
fn a_small_ring_in_a_national_grid_is_written() {
    let folder = Folder::with(&[]);
    let ring = r#"{"type": "cyclide", "a": 0.02, "c": 0.005, "mu": 0.01, "center": [4512345.678, 5412345.678, 312.5]}"#;
    folder.write("m.json", &document(ring));
    folder.ok("build m.json -o m.step -o m.json.json -o m.svg -o m.png");
    folder.ok("build m.json --tolerance 1e-4 -o m.obj");
}

#[test]
fn refinements_stop_at_their_cap() {
    let folder = Folder::with(&[]);
    folder.write("m.json", &document(r#"{"type": "cyclide", "a": 2, "c": 1, "mu": 1.5, "segments": [4096, 4096]}"#));
    let error = folder.fails(1, "report m.json");
    assert!(error.contains("the limit is 500000: use fewer segments [too-many-pieces]"), "{error}");
    let plane = "[[[0,0,0],[1,0,0],[2,0,0]],[[0,1,0],[1,1,0],[2,1,0]],[[0,2,0],[1,2,0],[2,2,0]]]";
    let bent = format!(r#"{{"type": "cyclidic-net", "grid": {plane}, "frame": [[1, 0, 1], [0, 1, 0]]}}"#);
    folder.write("m.json", &document(&bent));
    for file in ["m.svg", "m.obj", "m.glb"] {
        let error = folder.fails(1, &format!("build m.json --tolerance 1e-13 -o {file}"));
        assert!(error.contains("or raise the limit with --max-pieces [too-many-pieces]"), "{error}");
        let error = folder.fails(1, &format!("build m.json --tolerance 1e-5 --max-pieces 100 -o {file}"));
        assert!(error.contains(", the limit is 100: "), "{error}");
        folder.ok(&format!("build m.json --tolerance 1e-5 --max-pieces 100000 -o {file}"));
    }
    folder.fails(2, "build m.json --max-pieces 0 -o m.obj");
    let circle = document(r#"{"type": "circle", "center": [0, 0], "radius": 1}"#);
    folder.write("c.json", &circle);
    assert!(folder.fails(1, "build c.json --tolerance 1e-15 -o c.csv").contains("[too-many-pieces]"));
    assert!(folder.fails(2, "sample c.json --count 10000001").contains("--count"));
}

/// A list that several contours share is refused with the contour it does not fit.
#[test]
fn shared_lists_name_the_contour() {
    let table = "contour,x,y\n0,0,0\n0,1,0\n0,2,1\n1,0,5\n1,1,5\n1,2,6\n1,3,9\n";
    let document = r#"{"cyclide": 1, "objects": {"c": {"type": "moebius-spline", "points": {"csv": "p.csv", "contour": "contour"}, "knots": [0, 1, 2]}}}"#;
    let folder = Folder::with(&[("p.csv", table), ("d.json", document)]);
    for command in
        ["curve p.csv --kind moebius-spline --knots 0,1,2 --contour-column contour -o a.step", "build d.json -o a.step"]
    {
        let run = folder.run(command);
        assert_eq!(run.code, 1, "{command}");
        assert!(run.stderr.contains("contour 1: ") && run.stderr.contains("[count-differs]"), "{}", run.stderr);
    }
}
