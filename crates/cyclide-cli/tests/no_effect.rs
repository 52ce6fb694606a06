//! Options and fields without effect say so: by an error where the command line alone tells, else by a warning.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::Folder;

/// A straight run, a bend of 45 degrees, and points on no line.
const BEND: &str = "0,0\n10,0\n20,0\n30,10\n40,0\n47,-20\n";
/// A right angle between two straight runs.
const CORNER: &str = "0,0\n10,0\n20,0\n30,0\n30,10\n30,20\n30,30\n";
const LINE: &str = "0,0\n10,0\n20,0\n35,0\n";
const CIRCLE: &str = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;
const OPEN: &str =
    r#"{"cyclide": 1, "objects": {"l": {"type": "circle-spline", "points": [[0, 0, 0], [2, 1, 0], [3, 3, 1]]}}}"#;
const TORUS: &str = r#"{"cyclide": 1, "objects": {"t": {"type": "cyclide", "a": 3, "mu": 1}}}"#;

fn folder() -> Folder {
    Folder::with(&[
        ("bend.csv", BEND),
        ("corner.csv", CORNER),
        ("line.csv", LINE),
        ("c.json", CIRCLE),
        ("t.json", TORUS),
        ("l.json", OPEN),
    ])
}

#[test]
fn what_the_command_line_tells_is_an_error() {
    let folder = folder();
    let formats = [
        ("--dxf-splines", "DXF", "a.step"),
        ("--dxf-version r12", "DXF", "a.step"),
        ("--step-edges circle", "STEP", "a.png"),
        ("--step-products one", "STEP", "a.svg"),
        ("--svg-comb", "SVG", "a.step"),
        ("--svg-points", "SVG", "a.dxf"),
        ("--glb-edges", "GLB", "a.obj"),
        ("--png-plain", "PNG", "a.step"),
        ("--width 400", "PNG", "a.step"),
        ("--height 400", "PNG", "a.step"),
        ("--colour mean", "PNG", "a.step"),
        ("--labels", "PNG", "a.glb"),
        ("--camera top", "PNG", "a.svg"),
        ("--axes", "PNG", "a.step"),
    ];
    for (option, format, output) in formats {
        for command in ["build c.json", "curve bend.csv"] {
            let error = folder.fails(2, &format!("{command} -o {output} {option}"));
            let name = option.split(' ').next().unwrap();
            assert!(error.starts_with(&format!("error: {name} applies only to {format} output")), "{error}");
        }
    }
    for (options, message) in [
        ("--ends free --closed", "--ends would have no effect: a --closed curve has no ends"),
        ("--smooth 1 --fix-ends --closed", "--fix-ends would have no effect: a --closed curve has no ends"),
        ("--smooth 1 --max-fits 0 --nodes 4", "--nodes would have no effect: --max-fits 0 removes no nodes"),
        ("--smooth 1 --max-fits 0 --budget 1", "--budget would have no effect"),
        ("-o a.png --axes --png-plain", "cannot be used with"),
        ("-o a.png --labels --png-plain", "cannot be used with"),
        ("--corner-angle-deg 181", "must be at most 180 degrees"),
    ] {
        let error = folder.fails(2, &format!("curve bend.csv -o a.step {options}"));
        assert!(error.contains(message), "{options}: {error}");
    }
    for options in ["-o a.dxf", "-o a.png --png-plain"] {
        let error = folder.fails(2, &format!("build c.json {options} --title Ring"));
        assert!(error.contains("--title would have no effect"), "{error}");
    }
    let error = folder.fails(2, "build t.json -o a.png --colour rainbow");
    assert!(error.contains("gaussian") && error.contains("deviation"), "{error}");
    assert_eq!(folder.count(), 6, "nothing was written");
}

#[test]
fn what_the_model_tells_is_a_warning() {
    let folder = folder();
    for (command, warnings) in [
        (
            "curve bend.csv -o a.step --tight 0.2",
            &["`tight` has no effect: there is no corner beside a straight run"][..],
        ),
        ("curve line.csv -o a.step --tension 0.5", &["`tension` has no effect"]),
        ("curve line.csv -o a.step --ends free", &["`ends` has no effect: with `circle` the curve is the same"]),
        ("curve line.csv -o a.step --straight off", &["`straight` has no effect"]),
        (
            "curve bend.csv -o a.step --corner-angle-deg 100",
            &["`corner_angle` has no effect: the curve turns by no more at any point"],
        ),
        ("curve line.csv -o a.step --kind arc-spline --rule equal-chord", &["`rule` has no effect"]),
        ("curve bend.csv -o a.step --tolerance 0.1", &["--tolerance has no effect: no file needs an approximation"]),
        ("curve bend.csv -o a.step -o a.png --tolerance 0.1", &["--tolerance has no effect"]),
        (
            "curve bend.csv --kind arc-spline -o a.dxf -o a.glb --dxf-splines --glb-edges",
            &["--dxf-splines has no effect: all curves are arcs", "--glb-edges has no effect: there are no surfaces"],
        ),
        ("build c.json -o a.step --step-edges rational", &["--step-edges has no effect: there are no surfaces"]),
        (
            "build t.json -o a.step --step-products one",
            &["--step-products has no effect: a single object is always one product"],
        ),
        ("curve line.csv -o a.svg --svg-comb", &["--svg-comb has no effect: all curves are straight"]),
        ("build c.json -o a.svg --svg-points", &["--svg-points has no effect: no curve has joints or ends"]),
        (
            "build c.json -o a.png --colour mean --labels",
            &[
                "--colour has no effect: there are no surfaces with curvature",
                "--labels has no effect: a single object",
            ],
        ),
        (
            "build t.json -o a.png --colour deviation",
            &["--colour has no effect: no object approximates a given surface"],
        ),
        ("build t.json -o a.png --colour field", &["--colour has no effect: no drawn object is a `principal-grid`"]),
        ("report t.json --min-radius 2", &["--min-radius has no effect: there are no curves"]),
        (
            "report t.json --max-speed 2 --max-angular-speed 3",
            &["--max-speed has no effect: there are no motions", "--max-angular-speed has no effect"],
        ),
        ("build t.json -o a.step --min-radius 2", &["--min-radius has no effect: there are no curves"]),
        (
            "sample l.json --count 3 --frames rotation-minimizing --spread-twist",
            &["--spread-twist has no effect: no curve is closed"],
        ),
        (
            "sample c.json --count 3 --frames rotation-minimizing --spread-twist",
            &["--spread-twist has no effect: the frame returns to itself after one turn along the closed curve"],
        ),
    ] {
        let run = folder.run(command);
        assert_eq!(run.code, 0, "{command}\n{}", run.stderr);
        let lines: Vec<&str> = run.stderr.lines().filter(|line| line.ends_with(" [no-effect]")).collect();
        assert_eq!(lines.len(), warnings.len(), "{command}\n{}", run.stderr);
        for (line, words) in lines.iter().zip(warnings) {
            assert!(line.starts_with("warning: ") && line.contains(words), "{line}");
        }
    }
}

#[test]
fn options_with_an_effect_are_quiet() {
    let folder = folder();
    for command in [
        "curve corner.csv -o a.step --tight 0.2",
        "curve corner.csv -o a.step --straight off",
        "curve bend.csv -o a.step --tension 0.5 --ends free",
        "curve bend.csv -o a.step --corner-angle-deg 40",
        "curve bend.csv -o a.step --kind arc-spline --rule equal-chord",
        "curve bend.csv -o a.dxf --dxf-splines",
        "curve bend.csv -o a.step -o a.dxf --tolerance 0.1",
        "curve bend.csv -o a.step --kind arc-fit --tolerance 1 --corner-angle-deg 170",
        "curve bend.csv -o a.svg --svg-comb --svg-points",
        "build c.json -o a.png --width 300 --axes --camera iso",
        "build t.json -o a.png --colour gaussian --labels --width 500 --height 400 --title Ring",
        "build c.json -o a.step --title Ring",
        "build t.json -o a.step -o a.glb --step-edges rational --glb-edges",
        "report c.json --min-radius 2",
    ] {
        let run = folder.run(command);
        assert_eq!((run.code, run.stderr.contains("no-effect")), (0, false), "{command}\n{}", run.stderr);
    }
}

#[test]
fn fields_of_a_document_are_told_with_their_place() {
    let object = |fields: &str| {
        format!(r#"{{"cyclide": 1, "objects": {{"a": {{"points": [[0,0],[3,1],[5,5],[1,6]], {fields}}}}}}}"#)
    };
    let folder = Folder::with(&[
        ("ends.json", &object(r#""type": "fair-spline", "closed": true, "ends": "free""#)),
        ("clamped.json", &object(r#""type": "circle-spline", "closed": true, "ends": {"start": [1, 0]}"#)),
        ("fix.json", &object(r#""type": "fair-fit", "tolerance": 0.1, "closed": true, "fix_ends": true"#)),
        ("nodes.json", &object(r#""type": "fair-fit", "tolerance": 0.1, "max_fits": 0, "nodes": 3, "budget": 1"#)),
    ]);
    for (file, fields) in
        [("ends", &["ends"][..]), ("clamped", &["ends"]), ("fix", &["fix_ends"]), ("nodes", &["nodes", "budget"])]
    {
        let report = folder.json(&format!("report {file}.json --json"));
        let warnings = report["objects"]["a"]["warnings"].as_array().unwrap();
        let idle: Vec<_> = warnings.iter().filter(|warning| warning["reason"] == "no-effect").collect();
        assert_eq!(idle.len(), fields.len(), "{file}: {warnings:?}");
        for (warning, field) in idle.iter().zip(fields) {
            assert_eq!(warning["place"], format!("objects.a.{field}"));
        }
    }
}

#[test]
fn a_field_that_one_contour_needs_has_an_effect() {
    let both = format!("{CORNER}\n{}", BEND.replace(",0\n", ",100\n"));
    let folder = Folder::with(&[("both.csv", &both)]);
    let run = folder.run("curve both.csv -o a.step --tight 0.2");
    assert!(run.code == 0 && !run.stderr.contains("no-effect"), "{}", run.stderr);
}
