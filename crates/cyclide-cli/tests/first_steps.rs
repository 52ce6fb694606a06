//! What a newcomer meets: documents to start from, manuals, and answers to what was meant otherwise.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::{Folder, project};
use cyclide_io::document::ObjectSpec;
use serde_json::Value;

const CIRCLE: &str = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 1}}}"#;

#[test]
fn every_warning_and_every_refusal_is_explained() {
    let page = include_str!("../../../docs/report.md");
    let warnings: Vec<_> = cyclide::Warning::reasons().collect();
    let refusals: Vec<_> = cyclide::Error::reasons().collect();
    assert!(warnings.len() > 30 && refusals.len() > 150, "{warnings:?} {refusals:?}");
    for word in warnings {
        assert!(page.contains(&format!("`{word}`")), "{word}");
    }
    let (_, rows) = page.split_once("\n## Refusals\n").expect("the tables of refusals");
    for word in refusals {
        assert!(rows.contains(&format!("\n| `{word}` | ")), "{word} has no row");
    }
}

/// The types of the published schema: the constants of the fields `type` of its definitions.
fn types_of_the_schema() -> BTreeSet<String> {
    let schema = std::fs::read_to_string(project("docs/schema/cyclide-1.schema.json")).unwrap();
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let definitions = schema["$defs"].as_object().unwrap().values();
    definitions.filter_map(|d| d.pointer("/properties/type/const")?.as_str().map(str::to_owned)).collect()
}

#[test]
fn every_type_has_a_document_to_start_from_that_builds_and_is_drawn() {
    let types = types_of_the_schema();
    assert!(types.len() >= 12 && types.contains("cyclidic-net"), "{types:?}");
    assert_eq!(types, ObjectSpec::TYPES.iter().map(|kind| (*kind).to_owned()).collect());
    // Pictures take most of the time, and are drawn side by side.
    let types: Vec<&str> = types.iter().map(String::as_str).collect();
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(kind) = types.get(next.fetch_add(1, Ordering::Relaxed)) {
                    builds_and_is_drawn(kind);
                }
            });
        }
    });
}

fn builds_and_is_drawn(kind: &str) {
    let folder = Folder::with(&[]);
    let document = folder.ok(&format!("new {kind}"));
    let read: Value = serde_json::from_str(&document).unwrap();
    let objects = read["objects"].as_object().unwrap();
    assert!(objects.values().any(|object| object["type"] == kind), "{document}");
    assert!(read["comment"][0].is_string(), "it says what it makes: {document}");
    assert!(objects.values().all(|object| object["comment"].is_array()), "it says what the fields mean: {document}");
    assert!(document.lines().all(|line| line.chars().count() <= 190), "{kind}: {document}");
    folder.write("m.json", &document);
    // A motion is an animation, and no picture.
    if kind == "motion" {
        let run = folder.run("build m.json -o m.glb --json");
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{kind}");
        assert!(folder.read("m.glb").windows(12).any(|bytes| bytes == b"\"animations\""), "it is animated");
        return;
    }
    // Of what has no exact form, meshes.
    let exact = !["smooth-mesh", "sphere-blend"].contains(&kind);
    let outputs = if exact { "-o m.step -o m.png -o m.svg" } else { "-o m.glb -o m.png -o m.stl" };
    let run = folder.run(&format!("build m.json {outputs} --width 480 --json"));
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{kind}");
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let files = report["files"].as_array().unwrap();
    // An exact file, a picture that is more than an empty page.
    let bound = if exact { 1e-9 } else { files[0]["bound"].as_f64().unwrap() };
    assert!(files[0]["deviation"].as_f64().unwrap() <= bound, "{kind}: {}", files[0]);
    assert!(folder.read("m.png").starts_with(b"\x89PNG") && folder.read("m.png").len() > 10_000, "{kind}");
}

#[test]
fn new_lists_the_kinds_and_keeps_what_exists() {
    let folder = Folder::with(&[("old.json", CIRCLE)]);
    let listed = folder.ok("new");
    assert!(ObjectSpec::TYPES.iter().all(|kind| listed.contains(&format!("\n  {kind} "))), "{listed}");
    let made = folder.ok("new circle -o ring.json");
    assert_eq!(made, "ring.json written. Build it with: cyclide build ring.json -o ring.step -o ring.png\n");
    assert_eq!(String::from_utf8(folder.read("ring.json")).unwrap(), folder.ok("new circle"));
    folder.ok("build ring.json -o ring.step -o ring.png");
    assert!(folder.ok("new sphere-blend -o sail.json").ends_with("cyclide build sail.json -o sail.glb -o sail.png\n"));
    assert!(folder.fails(2, "new circle -o old.json").contains("old.json exists and will not be overwritten"));
    assert_eq!(folder.read("old.json"), CIRCLE.as_bytes());
    assert!(
        folder.fails(2, "new circle -o a.step").contains("documents are JSON; for this format see 'cyclide build'")
    );
    assert!(folder.fails(2, "new arcfit").contains("a similar value exists: 'arc-fit'"));
}

#[test]
fn help_is_the_manual_of_commands_and_kinds() {
    let folder = Folder::with(&[]);
    assert_eq!(folder.ok("help"), folder.ok("--help"));
    assert_eq!(folder.ok("help build"), folder.ok("build --help"));
    assert!(ObjectSpec::TYPES.iter().all(|kind| folder.ok("help kinds").contains(&format!("\n  {kind} "))));
    let page = folder.ok("help pipe-tee");
    for line in [
        "pipe-tee: A main pipe",
        "\nFields\n  main (required): object\n",
        "\n  ends (default \"flat\"): ",
        "\"wall\": 3",
    ] {
        assert!(page.contains(line), "{line} in {page}");
    }
    assert!(
        folder
            .fails(2, "help pipe-te")
            .contains("there is no command or kind of object `pipe-te`; did you mean `pipe-tee`?")
    );
    assert!(folder.fails(2, "help biuld").contains("did you mean `build`?"));
    assert!(folder.fails(2, "help xyzzy").contains("'cyclide help kinds' lists the kinds"));
}

#[test]
fn completions_know_every_command() {
    let folder = Folder::with(&[]);
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = folder.ok(&format!("completions {shell}"));
        for word in ["build", "curve", "gallery", "tolerance", "units"] {
            assert!(script.contains(word), "{shell} completes {word}");
        }
    }
    assert!(folder.fails(2, "completions fisch").contains("a similar value exists: 'fish'"));
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = Folder::with(&[]);
    let said = folder.ok("man -o pages");
    assert!(said.contains(" pages; read them with: man -l pages"), "{said}");
    let page = |name: &str| String::from_utf8(folder.read(&format!("pages/{name}.1"))).unwrap();
    let program = page("cyclide");
    assert!(program.starts_with(".ie") && program.contains(".TH cyclide 1"), "{program}");
    for command in ["build", "curve", "sample", "report", "new", "gallery", "schema", "completions", "man"] {
        let text = page(&format!("cyclide-{command}"));
        assert!(text.contains(".SH SYNOPSIS") && text.contains(".SH EXAMPLES"), "{text}");
        assert!(program.contains(&format!("cyclide\\-{command}(1)")), "{command} in {program}");
    }
    // The same pages again: no date in them.
    folder.ok("man -o again");
    assert_eq!(folder.read("pages/cyclide.1"), folder.read("again/cyclide.1"));
}

#[test]
fn near_words_are_suggested() {
    let object = |fields: &str| format!("{{\"cyclide\": 1, \"objects\": {{\"a\": {{{fields}}}}}}}");
    let circle = |more: &str| object(&format!("\"type\": \"circle\", \"center\": [0, 0], \"radius\": 1{more}"));
    let folder = Folder::with(&[
        ("type.json", &object("\"type\": \"arcfit\"")),
        ("part.json", &object("\"type\": \"spline\"")),
        ("field.json", &object("\"type\": \"circle\", \"centre\": [0, 0], \"radius\": 1")),
        ("outer.json", "{\"cyclide\": 1, \"unit\": \"mm\", \"objects\": {}}"),
        ("units.json", "{\"cyclide\": 1, \"units\": \"inn\", \"objects\": {}}"),
        (
            "word.json",
            &object("\"type\": \"arc-fit\", \"points\": [[0, 0], [1, 0]], \"tolerance\": 1, \"effort\": \"fats\""),
        ),
        (
            "name.json",
            "{\"cyclide\": 1, \"objects\": {\"outer skin\": {\"type\": \"cyclide\", \"a\": 3, \"mu\": 1}, \"b\": {\"type\": \"offset\", \"of\": \"outer_skin\", \"distance\": 1}}}",
        ),
        ("far.json", &object("\"type\": \"teapot\"")),
        ("torus.json", &object("\"type\": \"torus\", \"R\": 3")),
        ("line.json", &object("\"type\": \"line\"")),
        ("step.json", &object("\"type\": \"transform\", \"of\": \"a\", \"steps\": [{\"rotate\": {\"angle\": 1}}]")),
        ("inner.json", &circle(", \"units\": \"mm\"")),
        ("other.json", &circle(", \"effort\": \"best\"")),
        ("metres.json", "{\"cyclide\": 1, \"units\": \"meters\", \"objects\": {}}"),
        ("inches.json", "{\"cyclide\": 1, \"units\": \"inches\", \"objects\": {}}"),
        ("good.json", &circle("")),
        ("p.csv", "east_m,north_m\n0,0\n1,0\n1,1\n"),
    ]);
    for (code, command, hint) in [
        (1, "report type.json", "; did you mean `arc-fit`?\n"),
        (1, "report part.json", "; use a `fair-spline` for a smooth curve through points\n"),
        (1, "report field.json", "; did you mean `center`?\n"),
        (1, "report outer.json", "; did you mean `units`?\n"),
        (1, "report units.json", "; did you mean `in`?\n"),
        (1, "report metres.json", "`us-ft`; did you mean `m`?\n"),
        (1, "report inches.json", "; did you mean `in`?\n"),
        (1, "report word.json", "; did you mean `fast`?\n"),
        (1, "report step.json", "; did you mean `rotation`?\n"),
        // What other programs call it, and where it belongs.
        (1, "report torus.json", "; use a `cyclide` with the radii `a` and `mu` for a torus\n"),
        (1, "report line.json", "; use an `arc` with bulge 0 for a straight segment\n"),
        (1, "report inner.json", "; `units` belongs to the document, before its objects\n"),
        (1, "report other.json", "; `effort` is a field of `arc-fit`\n"),
        (1, "report name.json", "there is no object `outer_skin`; did you mean `outer skin`?\n"),
        (1, "curve p.csv --columns est_m,north_m -o a.step", "; did you mean `east_m`?\n"),
        (2, "sample good.json --count 2 --object A", "its objects are 'a'; did you mean `a`?\n"),
        (2, "build good.json -o a.setp", "; did you mean `step` or `stp`?\n"),
        // The argument parser's own.
        (2, "biuld good.json -o a.step", "'build'"),
        (2, "build good.json -o a.step --tolerence 1", "'--tolerance'"),
        (2, "build good.json -o a.step --dxf-version r13", "'r12'"),
        (2, "curve p.csv -o a.step --kind arcfit", "'arc-fit'"),
    ] {
        let error = folder.fails(code, command);
        assert!(error.contains(hint), "{command}\n{error}");
    }
    assert!(!folder.fails(1, "report far.json").contains("did you mean"));
}

#[test]
fn what_belongs_to_another_command_is_answered_with_it() {
    let folder = Folder::with(&[
        ("c.json", CIRCLE),
        ("p.csv", "x,y\n0,0\n1,0\n1,1\n"),
        ("p.txt", "0 0\n1 0\n1 1\n"),
        ("d.txt", CIRCLE),
        ("m.txt", "# a mesh\nv 0 0 0\nv 1 0 0\n"),
        ("list.txt", "[[0, 0], [1, 0]]"),
        ("i.csv", "i,j,x,y,z\n0,0,0,0,0\n1,0,1,0,0\n0,1,0,1,0\n"),
    ]);
    folder.ok("build c.json -o c.step -o nurbs.json");
    std::fs::copy(folder.path("c.step"), folder.path("step.txt")).unwrap();
    for (command, message) in [
        // Inputs of other commands, by their suffix or by what is in them.
        ("build p.csv -o a.step", "p.csv seems to be a list of points, not a model document: see 'cyclide curve'"),
        ("report p.txt", "p.txt seems to be a list of points, not a model document: see 'cyclide curve'"),
        ("sample list.txt --count 2", "'cyclide new fair-spline' prints a document that can contain it"),
        ("curve d.txt -o a.step", "d.txt seems to be a model document, not a list of points: see 'cyclide build'"),
        ("build m.txt -o a.step", "'cyclide new cyclidic-net' prints a document for it"),
        ("curve m.txt -o a.step", "m.txt seems to be a mesh, not a list of points: 'cyclide new cyclidic-net'"),
        ("curve i.csv -o a.step", "its columns name rows or patches"),
        ("build c.step -o a.dxf", "c.step is STEP, which cyclide writes but does not read: it reads model documents"),
        ("curve step.txt -o a.dxf", "step.txt is STEP, which cyclide writes"),
        ("curve none.dxf -o a.step", "none.dxf is DXF, which cyclide writes but does not read"),
        (
            "build none.ply -o a.step",
            "none.ply seems to be a mesh, not a model document: 'cyclide new smooth-mesh' prints",
        ),
        ("build none.stl -o a.step", "'cyclide new smooth-polyhedron' one that rounds a convex mesh"),
        ("curve none.glb -o a.step", "none.glb seems to be a mesh, not a list of points"),
        ("none.ply", "'cyclide new smooth-mesh'"),
        ("report none.iges", "export points of its curves as CSV"),
        ("build nurbs.json -o a.step", "nurbs.json is a file of exact B-splines, which cyclide writes"),
        ("curve none.xlsx -o a.step", "save it as CSV"),
        // Files in the place of a command.
        ("p.csv -o a.step", "make a curve from points with 'cyclide curve p.csv -o FILE'"),
        ("c.json", "build a model document with 'cyclide build c.json -o FILE'"),
        ("none.obj", "'cyclide new cyclidic-net'"),
        // Outputs of other commands.
        ("build c.json -o a.pdf", ".svg is a drawing at true size"),
        ("build c.json -o a.iges", ".step transfers curves and surfaces to CAD"),
        ("sample c.json --count 3 -o a.step", "samples are CSV or JSON; for this format see 'cyclide build'"),
        ("gallery -o page.html", "a folder name is required"),
        ("man -o cyclide.json", "a folder name is required"),
        // Options of other commands.
        ("build c.json -o a.step --closed", "'--closed' is an option of 'cyclide curve'"),
        ("report c.json --tolerance 1", "'--tolerance' is an option of 'cyclide build', 'cyclide curve'"),
        ("report c.json -o a.txt", "'-o' is an option of 'cyclide build'"),
    ] {
        let error = folder.fails(2, command);
        assert!(error.contains(message), "{command}\n{error}");
    }
    // Files in the wrong place of a document.
    for (file, fields, message) in [
        (
            "a.json",
            r#""type": "arc-spline", "points": {"csv": "m.txt"}"#,
            "m.txt is a mesh, not a list of points: use it in the field `grid`",
        ),
        ("b.json", r#""type": "arc-spline", "points": {"csv": "step.txt"}"#, "step.txt is STEP, not a list of points"),
        (
            "d.json",
            r#""type": "cyclidic-net", "grid": {"obj": "p.csv"}"#,
            "p.csv is a list of points, not a mesh (OBJ)",
        ),
    ] {
        folder.write(file, &format!("{{\"cyclide\": 1, \"objects\": {{\"a\": {{{fields}}}}}}}"));
        let error = folder.fails(1, &format!("report {file}"));
        assert!(error.starts_with(&format!("error: {file}:1:")) && error.contains(message), "{error}");
    }
    // A curve all the same.
    folder.ok("curve i.csv --columns x,y,z -o a.step");
    // Samples of a surface are not a curve, those of a curve are.
    folder.write("ring.json", r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}}}"#);
    folder.ok("sample ring.json --count 3 -o s.csv");
    assert!(folder.fails(2, "curve s.csv -o b.step").contains("s.csv seems to be points of a surface"));
    assert!(!folder.has("b.step"));
}

#[test]
fn the_book_says_how_far_the_vertices_of_its_picture_moved() {
    let folder = Folder::with(&[]);
    let report = folder.json(&format!("report {} --json", project("examples/roof.json").display()));
    let circular = &report["objects"]["outer skin"]["circular"];
    let [mean, max, edge, off] =
        ["move_mean", "move_max", "median_edge", "off_surface_max"].map(|key| circular[key].as_f64().unwrap());
    let page = std::fs::read_to_string(project("docs/guide/facades.md")).unwrap().replace('\n', " ");
    let said = format!(
        "moved by {mean:.2} m on average and by up to {max:.2} m (at a corner; the median edge is {edge:.2} m long), and by up to {off:.2} m off the surface given"
    );
    assert!(page.contains(&said), "{said}");
}

#[test]
fn every_word_of_the_report_is_explained() {
    let guide = std::fs::read_to_string(project("docs/report.md")).unwrap();
    let folder = Folder::with(&[(
        "bent.json",
        r#"{"cyclide": 1, "objects": {
        "net": {"type": "cyclidic-net", "grid": [[[0,1,0],[1,1,0],[3,1,0]],[[0,0,1],[1,0,1],[3,0,1]]], "frame": [[1,0,0],[0,0,5]]},
        "thick": {"type": "offset", "of": "net", "distance": 0.5, "thick": true},
        "horn": {"type": "cyclide", "a": 5, "c": 3, "mu": 1},
        "torus": {"type": "cyclide", "a": 3, "mu": 1},
        "beyond": {"type": "offset", "of": "torus", "distance": -1.5}}}"#,
    )]);
    let mut reports = folder.ok("report bent.json");
    for example in ["roof", "ring", "track", "logo"] {
        reports += &folder.ok(&format!("report {}", project(&format!("examples/{example}.json")).display()));
    }
    // The labels in front of the lines.
    let labels: BTreeSet<&str> = reports
        .lines()
        .filter_map(|line| line.strip_prefix("  ").filter(|rest| !rest.starts_with(' ')))
        .filter_map(|rest| rest.split_whitespace().next())
        .collect();
    assert!(labels.len() >= 12 && labels.contains("flipped") && labels.contains("creases"), "{labels:?}");
    for word in labels.iter().copied().chain([
        "gap",
        "angle",
        "curvature jump",
        "lines orthogonal to",
        "in space to",
        "focal set",
    ]) {
        assert!(guide.contains(&format!("*{word}")), "{word} is explained in docs/report.md");
    }
}
