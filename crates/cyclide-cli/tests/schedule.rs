//! `cyclide schedule` as it is run: files, messages, exit codes.

#![allow(clippy::expect_used, reason = "a test fails by panicking")]

mod common;

use common::{Folder, project};

const FILES: [&str; 8] =
    ["beams.csv", "beams.dxf", "edges.csv", "nodes.csv", "panels.csv", "patterns.dxf", "plan.dxf", "schedule.json"];

fn canopy() -> String {
    std::fs::read_to_string(project("examples/canopy.json")).expect("the example is read")
}

fn names(folder: &Folder, name: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder.path(name)).expect("the folder is read");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_folder_of_lists_and_drawings() {
    let folder = Folder::with(&[("canopy.json", &canopy())]);
    let run = folder.run("schedule canopy.json -o workshop --beam-depth -0.25");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(names(&folder, "workshop"), FILES);
    for line in ["skin: 6 rows of 8 panels", "panels      48, area 120.8", "edges       110, length 174.0"] {
        assert!(run.stdout.contains(line), "{}", run.stdout);
    }
    assert!(run.stderr.contains("glass (offset) is not scheduled: the solid between `skin` and its offset"));
    assert!(run.stderr.contains("ribs (support-structure) is not scheduled: its arcs are the edges of `skin`"));
    // The area that a person reads in both places is the same.
    let report = folder.json("report canopy.json --json");
    let lists: serde_json::Value =
        serde_json::from_slice(&folder.read("workshop/schedule.json")).expect("the schedule is JSON");
    let area = |value: &serde_json::Value| value.as_f64().expect("a number");
    let (ours, theirs) = (area(&lists["totals"]["area"]), area(&report["objects"]["skin"]["total_area"]));
    assert!((ours / theirs - 1.0).abs() < 1e-12, "{ours} {theirs}");
    assert_eq!(lists["format"], "cyclide-schedule/1");
    // Equal runs write equal bytes, and -.25 is -0.25.
    let before: Vec<Vec<u8>> = FILES.iter().map(|name| folder.read(&format!("workshop/{name}"))).collect();
    folder.ok("schedule canopy.json -o workshop --beam-depth -.25");
    let after: Vec<Vec<u8>> = FILES.iter().map(|name| folder.read(&format!("workshop/{name}"))).collect();
    assert!(before == after, "the same input gives the same files");
}

#[test]
fn offsets_on_both_sides_are_listed_apart_with_a_note() {
    let document = r#"{"cyclide": 1, "objects": {"skin": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]},
        "out": {"type": "offset", "of": "skin", "distance": 0.1}, "in": {"type": "offset", "of": "skin", "distance": -0.1}}}"#;
    let folder = Folder::with(&[("m.json", document)]);
    let run = folder.run("schedule m.json -o w");
    assert!(run.code == 0 && run.stderr.contains("`out`, `in` are offsets of `skin`"), "{}", run.stderr);
    assert!(run.stdout.contains("panels      144"), "{}", run.stdout);
    // What the note advises counts the panels once.
    let run = folder.run("schedule m.json -o w --object skin --thickness 0.1");
    assert!(run.code == 0 && !run.stderr.contains("offsets of") && !run.stdout.contains("144"), "{}", run.stderr);
}

#[test]
fn what_is_refused_writes_nothing() {
    let circle = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
    let folder = Folder::with(&[("canopy.json", &canopy()), ("circle.json", circle), ("plain", "")]);
    assert!(folder.fails(1, "schedule circle.json -o out").contains("`circle` is not a net of panels"));
    assert!(folder.fails(1, "schedule canopy.json -o out --thickness -40").contains("[offset-not-regular]"));
    let unknown = folder.fails(2, "schedule canopy.json -o out --object skim");
    assert!(unknown.contains("no object 'skim'") && unknown.contains("skin"), "{unknown}");
    assert!(folder.fails(2, "schedule canopy.json -o out.csv").contains("a folder name is required"));
    assert!(folder.fails(2, "schedule canopy.json -o -").contains("a folder name is required"));
    assert!(folder.fails(2, "schedule canopy.json -o out --thickness 0").contains("not 0"));
    assert!(folder.fails(2, "schedule canopy.json -o out --thickness -.1x").contains("not a number"));
    assert!(folder.fails(3, "schedule canopy.json -o plain").contains("plain"));
    assert!(!folder.has("out"), "no folder either");
    assert!(!folder.has("-"), "standard output is no folder");
}

#[test]
fn beams_are_asked_for() {
    let skin = canopy()
        .replace("\"glass\": {\"type\": \"offset\", \"of\": \"skin\", \"distance\": 0.04, \"thick\": true},", "");
    let folder = Folder::with(&[("skin.json", &skin)]);
    let run = folder.run("schedule skin.json -o out");
    assert!(run.code == 0 && run.stderr.contains("--beam-depth"), "{}", run.stderr);
    let beams = String::from_utf8(folder.read("out/beams.csv")).expect("text");
    assert_eq!(beams.lines().count(), 1, "the names of the columns alone");
}
