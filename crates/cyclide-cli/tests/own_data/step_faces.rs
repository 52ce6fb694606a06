//! One face in STEP for each surface of a body.

use crate::common::Folder;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Entities of a kind in the STEP file of a document.
struct File(String);

impl File {
    /// The file of the document's objects, which agrees with the model to rounding.
    fn of(objects: &Value, options: &str) -> Self {
        let document = json!({"cyclide": 1, "units": "mm", "objects": objects});
        let folder = Folder::with(&[("model.json", &document.to_string())]);
        let report = folder.ok(&format!("build model.json -o model.step --json {options}"));
        let report: Value = serde_json::from_str(&report).unwrap();
        let file = &report["files"][0];
        assert_eq!(file["exact"], true, "{file}");
        assert!(file["deviation"].as_f64().unwrap() < 1e-9, "{file}");
        Self(String::from_utf8(folder.read("model.step")).unwrap())
    }

    fn count(&self, entity: &str) -> usize {
        self.0.matches(&format!("={entity}(")).count()
    }

    /// Faces, planes, cylinders and tori.
    fn faces(&self) -> [usize; 4] {
        ["ADVANCED_FACE", "PLANE", "CYLINDRICAL_SURFACE", "TOROIDAL_SURFACE"].map(|entity| self.count(entity))
    }
}

fn pipe(points: &[[f64; 3]], radius: f64, wall: Option<f64>) -> Value {
    let mut pipe = json!({"type": "pipe", "of": "run", "radius": radius});
    if let Some(wall) = wall {
        pipe["wall"] = wall.into();
    }
    json!({"run": {"type": "polyline", "points": points, "radius": 20.0, "construction": true}, "pipe": pipe})
}

const LEGS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [100.0, 80.0, 0.0], [100.0, 80.0, 60.0]];

#[test]
fn a_pipe_of_three_legs_and_two_bends_has_seven_faces_and_hollow_twelve() {
    let solid = File::of(&pipe(&LEGS, 8.0, None), "");
    assert_eq!(solid.faces(), [7, 2, 3, 2]);
    // Six circles, one vertex on each, and five seams.
    assert_eq!(["EDGE_CURVE", "VERTEX_POINT"].map(|entity| solid.count(entity)), [11, 6]);
    assert_eq!(File::of(&pipe(&LEGS, 8.0, Some(2.0)), "").faces(), [12, 2, 6, 4]);
    // The old form: quarters.
    assert_eq!(File::of(&pipe(&LEGS, 8.0, None), "--step-faces split").faces(), [28, 8, 12, 8]);
    // Rational edges make planes only.
    assert_eq!(File::of(&pipe(&LEGS, 8.0, None), "--step-edges rational").faces()[1], 2);
}

/// A round section on bends is a pipe, and a section with rounded corners has one torus for each of them on a bend.
#[test]
fn a_sweep_of_three_legs_and_two_bends_has_a_face_for_each_surface() {
    let swept = |section: Value| {
        let run = json!({"type": "polyline", "points": LEGS, "radius": 20.0, "construction": true});
        File::of(
            &json!({"run": run, "section": section, "bar": {"type": "sweep", "of": "run", "section": "section"}}),
            "",
        )
    };
    let round = swept(json!({"type": "circle", "center": [0, 0], "radius": 8, "construction": true}));
    assert_eq!(round.faces(), [7, 2, 3, 2]);
    let corners = [[-8, -4], [8, -4], [8, 4], [-8, 4]];
    let slot = swept(json!({"type": "polyline", "points": corners, "radius": 3, "closed": true, "construction": true}));
    assert_eq!(slot.count("TOROIDAL_SURFACE"), 8);
    assert_eq!(slot.count("B_SPLINE_SURFACE_WITH_KNOTS"), 0);
}

/// Numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

#[test]
fn pipes_of_any_run_have_a_face_for_each_leg_bend_and_end() {
    let mut random = Random(37);
    let (mut objects, mut expected) = (json!({}), 0);
    for index in 0..60 {
        let legs = 2 + index % 4;
        let mut at = [0.0, 0.0, 200.0 * f64::from(index)];
        let mut points = vec![at];
        for leg in 0..legs {
            // Turns of 40 to 110 degrees, over legs that hold two bends.
            let axis = leg as usize % 3;
            at[axis] += random.next(90.0, 140.0);
            at[(axis + 1) % 3] += random.next(-30.0, 30.0);
            points.push(at);
        }
        let hollow = index % 2 == 0;
        let walls = if hollow { 2 } else { 1 };
        expected += (walls * (2 * legs - 1) + 2) as usize;
        let (run, radius) = (format!("run {index}"), random.next(3.0, 9.0));
        objects[&run] = json!({"type": "polyline", "points": points, "radius": 15.0, "construction": true});
        objects[format!("pipe {index}")] = json!({"type": "pipe", "of": run, "radius": radius});
        if hollow {
            objects[format!("pipe {index}")]["wall"] = json!(0.3 * radius);
        }
    }
    assert_eq!(File::of(&objects, "").count("ADVANCED_FACE"), expected);
}

#[test]
fn whole_tori_and_spheres_are_one_face() {
    let torus = File::of(&json!({"ring": {"type": "cyclide", "a": 30.0, "c": 0.0, "mu": 10.0}}), "");
    assert_eq!((torus.faces(), torus.count("EDGE_CURVE"), torus.count("VERTEX_POINT")), ([1, 0, 0, 1], 2, 1));
    // Spheres of profiles with one arc and with four, off the origin, about a tilted axis: one face, and a seam from pole to pole.
    let arc =
        |middle: [f64; 3]| json!({"type": "arc", "through": [[0, 0, -5], middle, [0, 0, 5]], "construction": true});
    let ball = |of: &str| json!({"type": "revolution", "of": of});
    let bow = json!({"type": "arc-spline", "points": [[0, 0, -5], [3, 0, -4], [5, 0, 0], [3, 0, 4], [0, 0, 5]],
        "tangents": [[1, 0, 0], [4, 0, 3], [0, 0, 1], [-4, 0, 3], [-1, 0, 0]], "construction": true});
    let moved = json!({"type": "transform", "of": "ball",
        "steps": [{"rotation": {"angle": {"degrees": 40}, "axis": [1, 2, 3]}}, {"translation": [70, -20, 9]}]});
    for objects in [
        json!({"a": arc([5.0, 0.0, 0.0]), "ball": ball("a")}),
        json!({"a": arc([3.0, 0.0, 4.0]), "ball": ball("a")}),
        json!({"a": bow, "ball": ball("a")}),
        json!({"a": arc([5.0, 0.0, 0.0]), "ball": {"type": "revolution", "of": "a", "construction": true}, "moved": moved}),
    ] {
        let ball = File::of(&objects, "");
        let counts = ["ADVANCED_FACE", "SPHERICAL_SURFACE", "EDGE_CURVE", "ORIENTED_EDGE", "VERTEX_POINT"];
        assert_eq!(counts.map(|entity| ball.count(entity)), [1, 1, 1, 2, 2], "{objects}");
    }
}

#[test]
fn offsets_of_polyhedra_have_a_face_for_each_face_edge_and_vertex() {
    // A box whose top is smaller than its bottom: corners that are no eighths of spheres.
    let points =
        json!([[0, 0, 0], [60, 0, 0], [60, 40, 0], [0, 40, 0], [10, 10, 30], [50, 10, 30], [50, 30, 30], [10, 30, 30]]);
    let stub = json!({"stub": {"type": "smooth-polyhedron", "points": points, "radius": 5}});
    let file = File::of(&stub, "");
    let mut found = String::new();
    for entity in ["ADVANCED_FACE", "PLANE", "CYLINDRICAL_SURFACE", "SPHERICAL_SURFACE"] {
        let _ = write!(found, "{} ", file.count(entity));
    }
    assert_eq!(found, "26 6 12 8 ");
}

#[test]
fn a_pierced_pipe_is_one_cylinder_and_each_bolt_hole_is_found_once() {
    let tee = json!({"tee": {"type": "pipe-tee", "main": {"radius": 20, "ends": [-60, 60]},
        "branches": [{"radius": 12, "length": 50, "blend": 4}]}});
    let file = File::of(&tee, "");
    // All else belongs to the blend.
    assert_eq!(file.faces()[1..], [3, 2, 0]);
    // Walls with a bore: two more, and rings for ends.
    let mut hollow = tee;
    hollow["tee"]["wall"] = json!(2);
    assert_eq!(File::of(&hollow, "").faces()[1..], [3, 4, 0]);
}
