//! Meshes as exporters write them; how much of a surface a grid covers.

use std::fmt::Write as _;

use proptest::prelude::*;
use serde_json::Value;

use crate::case;
use crate::common::Folder;

const NET: &str = r#"{"cyclide": 1, "units": "m", "objects": {"net": {"type": "cyclidic-net", "grid": {"obj": "m.obj"}, "make_circular": true}}}"#;
const SMOOTH: &str =
    r#"{"cyclide": 1, "units": "m", "objects": {"net": {"type": "smooth-mesh", "mesh": {"obj": "m.obj"}}}}"#;
const LATTICE: &str = r#"{"cyclide": 1, "units": "m", "objects": {"net": {"type": "principal-grid", "mesh": {"obj": "m.obj"}, "edge_length": 1}}}"#;

/// The report on the object of a document over a mesh.
fn report(document: &str, obj: &str) -> Value {
    let folder = Folder::with(&[("m.json", document), ("m.obj", obj)]);
    folder.json("report m.json --json")["objects"]["net"].clone()
}

fn reasons(report: &Value) -> Vec<&str> {
    report["warnings"].as_array().expect("a list").iter().filter_map(|warning| warning["reason"].as_str()).collect()
}

#[test]
fn samples_are_welded_turned_and_counted() {
    let unwelded = report(NET, &case("unwelded.obj"));
    assert_eq!(unwelded["patches"], 192, "{unwelded}");
    assert!(reasons(&unwelded).contains(&"vertices-merged"), "{unwelded}");
    for document in [NET, SMOOTH, LATTICE] {
        let mixed = report(document, &case("mixed.obj"));
        assert!(reasons(&mixed).contains(&"faces-turned"), "{mixed}");
    }
}

/// A roof of `m` by `n` quads, as a program exports it: some faces turned over, all or some with vertices of their own.
fn roof([m, n]: [usize; 2], own: impl Fn(usize) -> bool, turned: impl Fn(usize) -> bool) -> String {
    let at = |i: usize, j: usize| {
        let (x, y) = (i as f64 - 0.5 * m as f64, j as f64 - 0.5 * n as f64);
        format!("v {x} {y} {}\n", 0.02 * x * x + 0.035 * y * y)
    };
    let mut text = String::from("o roof\n");
    (0..=n).for_each(|j| (0..=m).for_each(|i| text += &at(i, j)));
    let mut count = (m + 1) * (n + 1);
    for face in 0..m * n {
        let (i, j) = (face % m, face / m);
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
        let mut numbers = if own(face) {
            corners.iter().for_each(|&(i, j)| text += &at(i, j));
            count += 4;
            [count - 3, count - 2, count - 1, count]
        } else {
            corners.map(|(i, j)| j * (m + 1) + i + 1)
        };
        if turned(face) {
            numbers.reverse();
        }
        let [a, b, c, d] = numbers;
        writeln!(text, "f {a} {b} {c} {d}").expect("text");
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// However its vertices are shared and its faces are turned, a roof is the same net.
    #[test]
    fn a_roof_is_the_same_net_however_it_was_exported(m in 4_usize..8, n in 4_usize..8, seed in any::<u64>()) {
        // Bits without a pattern; less than half of the faces are turned.
        let bits = |face: usize, salt: u64| (seed ^ salt).wrapping_mul(2 * face as u64 + 0x9e37_79b9_7f4a_7c15).count_ones() % 3;
        let plain = report(NET, &roof([m, n], |_| false, |_| false));
        let turned = |face: usize| face > 0 && face % 3 == (seed % 3) as usize;
        let exported = report(NET, &roof([m, n], |face| bits(face, 1) > 0, turned));
        prop_assert_eq!(&plain["patches"], &exported["patches"]);
        // The search goes over the vertices in another order.
        let area = |report: &Value| report["area"].as_f64().unwrap();
        prop_assert!((area(&plain) - area(&exported)).abs() < 1e-6 * area(&plain));
        let (count, own) = ((0..m * n).filter(|face| turned(*face)).count(), reasons(&exported).contains(&"faces-turned"));
        prop_assert_eq!(own, count > 0);
        let message = exported["warnings"].as_array().unwrap().iter().find(|w| w["reason"] == "faces-turned");
        let message = message.map(|warning| warning["message"].as_str().unwrap().to_owned()).unwrap_or_default();
        prop_assert!(count == 0 || message.starts_with(&format!("{count} face")), "{}", message);
    }
}

#[test]
fn a_seam_cut_on_purpose_stays_open() {
    // A ring whose first and last column lie on each other with vertices of their own.
    let mut text = String::new();
    for j in 0..4 {
        for i in 0..=12 {
            let angle = f64::from(i) * std::f64::consts::TAU / 12.0;
            let (sin, cos) = if i == 12 { (0.0, 1.0) } else { angle.sin_cos() };
            writeln!(text, "v {} {} {}", 3.0 * cos, 3.0 * sin, j).expect("text");
        }
    }
    for j in 0..3 {
        for i in 1..=12 {
            let a = 13 * j + i;
            writeln!(text, "f {a} {} {} {}", a + 1, a + 14, a + 13).expect("text");
        }
    }
    let open = report(NET, &text);
    assert_eq!((&open["closed"], &open["patches"]), (&Value::Bool(false), &Value::from(36)), "{open}");
    assert!(!reasons(&open).contains(&"vertices-merged"), "{open}");
}

/// Corners that nearly coincide are named with their distance, where parts that are far apart are components.
#[test]
fn vertices_that_nearly_coincide_are_named_with_their_distance() {
    let net =
        r#"{"cyclide": 1, "objects": {"net": {"type": "cyclidic-net", "grid": {"obj": "m.obj"}, "frame": "auto"}}}"#;
    for (gap, says) in [(1e-6, "within 1e-6 of those of other faces"), (3.0, "join the components")] {
        let mut obj = String::new();
        for k in 0..4 {
            let (from, to) = (f64::from(k) + gap * f64::from(k), f64::from(k + 1) + gap * f64::from(k));
            obj += &format!("v {from} 0 0\nv {to} 0 0\nv {to} 1 0\nv {from} 1 0\nf -4 -3 -2 -1\n");
        }
        let folder = Folder::with(&[("m.json", net), ("m.obj", &obj)]);
        let run = folder.run("report m.json");
        assert!(
            run.code == 1 && run.stderr.contains("[several-components]") && run.stderr.contains(says),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn a_face_that_is_there_twice_is_named_with_both_lines() {
    let mut text = roof([4, 4], |_| false, |_| false);
    let line = text.lines().count() + 1;
    text += "f 7 8 3 2\n";
    let first = text.lines().position(|line| line == "f 2 3 8 7").expect("a face") + 1;
    for document in [NET, SMOOTH, LATTICE] {
        let folder = Folder::with(&[("m.json", document), ("m.obj", &text)]);
        let message = folder.fails(1, "report m.json");
        assert!(message.contains("doubled-face"), "{message}");
        assert!(message.contains(&format!("line {first}")) && message.contains(&line.to_string()), "{message}");
        assert!(message.contains(": delete one of them"), "{message}");
    }
    // Of several the number is known, so that nobody deletes one after the other.
    text += "f 1 2 7 6\nf 9 4 3 8\n";
    for document in [NET, SMOOTH, LATTICE] {
        let message = Folder::with(&[("m.json", document), ("m.obj", &text)]).fails(1, "report m.json");
        let more = "and 2 more faces have those of earlier ones: delete all 3 repeated faces";
        assert!(message.contains(more) && message.contains(&line.to_string()), "{message}");
    }
}

#[test]
fn a_grid_says_how_much_it_covers_and_takes_the_layout_that_covers_most() {
    let folder = Folder::with(&[("m.json", LATTICE), ("m.obj", &case("blob.obj"))]);
    let text = folder.ok("report m.json");
    assert!(text.lines().next().is_some_and(|line| line.contains("% of the surface covered")), "{text}");
    let found = report(LATTICE, &case("blob.obj"));
    let coverage = found["principal"]["coverage"].as_f64().expect("a number");
    // A rectangle covers 46 %.
    assert!(coverage > 0.6 && found["principal"]["border"] == "staircase", "{found}");
    assert_eq!(reasons(&found).contains(&"partly-covered"), coverage < 0.9);
    // What is typed is obeyed, and said.
    let inside =
        LATTICE.replace("\"edge_length\": 1", "\"edge_length\": 1, \"border\": \"inside\", \"umbilics\": \"pieces\"");
    let found = report(&inside, &case("blob.obj"));
    assert!(found["principal"]["border"] == "inside" && reasons(&found).contains(&"partly-covered"), "{found}");
}

#[test]
fn a_second_skin_is_counted_once() {
    let skin = |more: &str| {
        format!(
            r#"{{"cyclide": 1, "units": "m", "objects": {{"a": {{"type": "cyclide", "a": 5, "mu": 2, "segments": [6, 4]}}, "b": {{"type": "offset", "of": "a", "distance": 0.2}}{more}}}}}"#
        )
    };
    let rows = |document: &str, options: &str| {
        let folder = Folder::with(&[("m.json", document)]);
        folder.ok(&format!("schedule m.json -o out{options}"));
        String::from_utf8(folder.read("out/panels.csv")).expect("text").lines().count() - 1
    };
    assert_eq!(rows(&skin(""), ""), 24);
    assert_eq!(rows(&skin(""), " --object b"), 24);
    assert_eq!(rows(&skin(""), " --object a --object b"), 48);
    // Panels of another thickness: both skins are made.
    assert_eq!(rows(&skin(""), " --thickness 0.01"), 48);
    // The second skin is the near side of a third.
    assert_eq!(rows(&skin(r#", "c": {"type": "offset", "of": "b", "distance": 0.1}"#), ""), 48);
}
