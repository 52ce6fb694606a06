//! Surfaces on the command line: reports, samples, refusals, the gallery.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{Folder, project};

const MODEL: &str = r#"{"cyclide": 1, "units": "m", "objects": {
  "ring": {"type": "cyclide", "a": 3, "c": 1, "mu": 2},
  "patch": {"type": "cyclide-patch", "corners": [[0,0],[1,0],[0,1],[1,1]], "frame": [[1,0,1],[0,1,0]]},
  "base": {"type": "circle", "center": [0,0], "radius": 1, "construction": true}
}}"#;

#[test]
fn reports_on_surfaces() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    let report = folder.json("report m.json --json");
    let ring = &report["objects"]["ring"];
    assert_eq!(
        (ring["patches"].as_u64(), ring["bodies"].as_u64(), ring["closed"].as_bool()),
        (Some(16), Some(1), Some(true))
    );
    for key in ["area", "volume", "residual", "orthogonality"] {
        assert!(ring[key].is_number(), "{key}: {ring}");
    }
    for path in
        ["/joints/count", "/joints/gap", "/joints/angle", "/curvature_s/min", "/curvature_t/max", "/weights/min"]
    {
        assert!(ring.pointer(path).is_some_and(serde_json::Value::is_number), "{path}");
    }
    assert!(ring["singular"].as_array().unwrap().is_empty() && ring["warnings"].as_array().unwrap().is_empty());
    assert!(report["objects"]["patch"]["volume"].is_null());
    assert_eq!(report["objects"]["base"]["construction"], true);
    let text = folder.ok("report m.json");
    assert!(text.starts_with("ring: cyclide, solid, 16 patches\n  area  "), "{text}");
    assert!(text.contains("\nbase: circle, closed, 1 piece, construction\n"), "{text}");
}

#[test]
fn samples_surfaces() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    let text = folder.ok("sample m.json --object ring --count 4");
    assert_eq!(text.lines().count(), 1 + 16 * 16);
    assert!(text.starts_with("patch,s,t,x,y,z,normal_x,normal_y,normal_z,curvature_s,curvature_t\n0,0,0,"));
    let error = folder.fails(2, "sample m.json --object ring --count 4 --equal-length");
    assert!(error.contains("--equal-length is for curves"), "{error}");
    let error = folder.fails(2, "sample m.json --object ring --count 10000000");
    assert!(error.contains("rows on 16 patches"), "{error}");
    assert!(folder.ok("sample m.json --object base --count 3").starts_with("t,x,y,z,tangent_x,"));
}

#[test]
fn construction_geometry_is_in_no_file() {
    let only =
        r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0,0], "radius": 1, "construction": true}}}"#;
    let folder = Folder::with(&[("m.json", only)]);
    assert!(folder.fails(1, "build m.json -o a.step").contains("the model has nothing to write [empty-model]"));
    assert_eq!(folder.count(), 1);
}

#[test]
fn names_that_lead_nowhere_are_refused_at_their_place() {
    let model = |objects: &str| format!("{{\"cyclide\": 1, \"objects\": {{\n{objects}}}}}");
    let folder = Folder::with(&[
        ("a.json", &model(r#""a": {"type": "offset", "of": "b", "distance": 1}"#)),
        (
            "b.json",
            &model(
                r#""a": {"type": "transform", "of": "b", "steps": []}, "b": {"type": "support-structure", "of": "a"}"#,
            ),
        ),
    ]);
    let error = folder.fails(1, "report a.json");
    assert!(error.starts_with("error: a.json:2:31: objects.a.of: there is no object `b`\n"), "{error}");
    // Also where only another object is asked for.
    let error = folder.fails(1, "sample b.json --object a --count 3");
    assert!(error.contains("refers to itself"), "{error}");
}

/// A saddle of 9 by 9 points as OBJ; its quads have no circles.
fn saddle() -> String {
    let at = |k: usize| k as f64 / 4.0 - 1.0;
    let mut text = "# a saddle\n".to_owned();
    for (i, j) in (0..81).map(|k| (k % 9, k / 9)) {
        let (u, v) = (at(i), at(j));
        text += &format!("v {u} {v} {}\n", 0.4 * (u * u - v * v) + 0.05 * u * u * v);
    }
    for (i, j) in (0..64).map(|k| (k % 8, k / 8)) {
        let first = 1 + i + 9 * j;
        text += &format!("f {} {} {} {}\n", first, first + 1, first + 10, first + 9);
    }
    text
}

#[test]
fn meshes_become_smooth_surfaces() {
    let net = |rest: &str| {
        format!(r#"{{"cyclide": 1, "objects": {{"n": {{"type": "cyclidic-net", "grid": {{"obj": "s.obj"}}{rest}}}}}}}"#)
    };
    let side = r#""make_circular": {"border": {"first_row": "edge"}}}, "edge": {"type": "arc", "through": [[-1,-1,0], [0,-1,-0.4], [1,-1,0]], "construction": true"#;
    let folder = Folder::with(&[
        ("s.obj", &saddle()),
        ("as_given.json", &net("")),
        ("moved.json", &net(r#", "make_circular": true"#)),
        ("pinned.json", &net(r#", "make_circular": {"border": "pinned"}"#)),
        ("side.json", &net(&format!(", {side}"))),
        ("closed.json", &net(r#", "closed": [false, false]"#)),
        ("steps.json", &net(r#", "make_circular": {"max_steps": 1}"#)),
    ]);
    let error = folder.fails(1, "report as_given.json");
    assert!(
        error.contains("as_given.json:1:") && error.contains("objects.n.grid: quad 0: the corners do not"),
        "{error}"
    );
    assert!(error.contains("`make_circular`, which moves the vertices"), "{error}");
    assert!(error.contains("(points 1, 2, 10, 11 of s.obj) [not-concircular]"), "{error}");
    for file in ["moved", "side"] {
        let report = folder.json(&format!("report {file}.json --json"));
        let net = &report["objects"]["n"];
        assert_eq!((net["patches"].as_u64(), net["joints"]["count"].as_u64()), (Some(64), Some(112)));
        let circular = &net["circular"];
        // The search ends at 1e-12.
        assert!(circular["residual_after"].as_f64().unwrap() < 1e-12 && circular["steps"].as_u64().unwrap() > 0);
        assert!(circular["move_max"].as_f64().unwrap() > 0.0);
        assert!(net["joints"]["gap"].as_f64().unwrap() < 1e-13);
    }
    assert!(folder.ok("report moved.json").contains("\n  circular "));
    assert!(folder.fails(1, "report closed.json").contains("`closed` requires an inline grid"));
    // So coarse a grid has no solution near a border that stays.
    for file in ["pinned", "steps"] {
        let error = folder.fails(1, &format!("report {file}.json"));
        assert!(error.contains("objects.n.make_circular: the grid is not circular after"), "{error}");
        assert_eq!(error.contains("a border that may move gives more freedom"), file == "pinned", "{error}");
    }
    // The mesh is an input, and is not written over.
    assert!(folder.fails(2, "sample moved.json --count 2 -o s.obj").contains("samples are CSV"));
    assert!(folder.fails(2, "build moved.json -o s.obj").contains("s.obj is an input"));
    assert_eq!(folder.read("s.obj"), saddle().as_bytes());
}

#[test]
fn refused_meshes_show_their_line() {
    let model = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": {"obj": "s.obj"}}}}"#;
    let folder = Folder::with(&[("m.json", model), ("s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]);
    let error = folder.fails(1, "report m.json");
    assert!(error.starts_with("error: s.obj:4:") && error.contains("[not-a-quad]"), "{error}");
    std::fs::remove_file(folder.path("s.obj")).unwrap();
    let error = folder.fails(3, "report m.json");
    let place = "error: m.json:1:74: objects.n.grid.obj: cannot read s.obj: ";
    assert!(error.starts_with(place) && error.ends_with("^^^^^^^\n"), "{error}");
}

#[test]
fn edges_of_patches_in_glb_on_demand() {
    let folder = Folder::with(&[("m.json", MODEL)]);
    folder.ok("build m.json -o plain.glb");
    folder.ok("build m.json --glb-edges -o lines.glb");
    // The primitives drawn as lines (mode 1): none, or one for each of the two surfaces.
    let lines = |name: &str| String::from_utf8_lossy(&folder.read(name)).matches("\"mode\":1").count();
    assert_eq!((lines("plain.glb"), lines("lines.glb")), (0, 2));
}

#[test]
fn the_help_names_what_holds_for_surfaces() {
    let folder = Folder::with(&[]);
    let help = folder.ok("build --help");
    for piece in ["1e-4 for meshes", "cyclidic-net", "--glb-edges", "pictures of surfaces have none"] {
        assert!(help.contains(piece), "{piece}\n{help}");
    }
    // The document that is shown can be built.
    let start = help.find("{\"cyclide\"").unwrap();
    let document = &help[start..start + help[start..].find("}}}").unwrap() + 3];
    folder.write(
        "m.json",
        &document.replace("\"obj\": \"roof.obj\"", &format!("\"obj\": {:?}", project("examples/roof-20.obj"))),
    );
    assert!(folder.ok("report m.json").contains("inner: offset, open, 400 patches"));
}

#[test]
fn a_gallery_that_cannot_be_written() {
    let folder = Folder::with(&[("taken", "a file")]);
    assert!(folder.fails(3, "gallery -o taken").starts_with("error: cannot write taken"));
    assert!(folder.fails(2, "gallery").contains("--output <DIR>"));
    assert_eq!(folder.read("taken"), b"a file");
}

/// Where parameter lines are nearly one line, as all across a flat ring are, the check finds the feet of points all the same.
#[test]
fn rings_between_flat_ellipses_are_meshed() {
    let bridge = r#"{"cyclide": 1, "objects": {"a": {"type": "ellipse-bridge", "ellipses": [[1.088, 4e-6], [2.176, 8e-6]], "depth": 4.4e-6}}}"#;
    let folder = Folder::with(&[("b.json", bridge)]);
    let report = folder.json("build b.json -o b.stl -o b.glb --tolerance 1e-3 --json");
    for file in report["files"].as_array().unwrap() {
        assert!(file["deviation"].as_f64().unwrap() <= 1e-3, "{file}");
    }
}
