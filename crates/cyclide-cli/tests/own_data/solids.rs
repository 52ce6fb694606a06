//! Tubes and swept sections as solids; ellipses and helices; what is said of what cannot be made.

use crate::case;
use crate::common::Folder;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// The report on a document of these objects, in millimeters.
fn report(objects: &Value) -> Value {
    let folder = Folder::with(&[("d.json", &json!({"cyclide": 1, "units": "mm", "objects": objects}).to_string())]);
    folder.json("report d.json --json")
}

/// Standard error of a document that is refused.
fn refused(name: &str) -> String {
    Folder::with(&[("d.json", &case(name))]).fails(1, "build d.json -o d.step")
}

/// The extents of the vertices of an OBJ file.
fn extents(obj: &str) -> [[f64; 2]; 3] {
    let mut all = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for line in obj.lines().filter_map(|line| line.strip_prefix("v ")) {
        for (range, word) in all.iter_mut().zip(line.split_whitespace()) {
            let x: f64 = word.parse().unwrap();
            *range = [range[0].min(x), range[1].max(x)];
        }
    }
    all
}

fn frustum(a: f64, b: f64, height: f64) -> f64 {
    PI / 3.0 * height * (a * a + a * b + b * b)
}

#[test]
fn a_reducer_is_the_frustum_between_the_ends_of_its_path() {
    let folder = Folder::with(&[("t.json", &case("tube_reducer.json"))]);
    let built = folder.json("build t.json -o t.step -o t.obj --json");
    let volume = built["objects"]["solid"]["volume"].as_f64().unwrap();
    assert!((volume / frustum(60.0, 30.0, 100.0) - 1.0).abs() < 1e-12, "{volume}");
    let [x, _, z] = extents(&String::from_utf8(folder.read("t.obj")).unwrap());
    assert!(z[0].abs() < 1e-9 && (z[1] - 100.0).abs() < 1e-9 && (x[1] - 60.0).abs() < 1e-9, "{x:?} {z:?}");
    let tube = &built["objects"]["solid"]["tubes"][0];
    assert_eq!((&tube["proof"], &tube["radius_of"]), (&json!("exact"), &json!("sections")));
    // Hollow: the bore ends in the same planes, and nothing is said of rims.
    let hollow = case("tube_reducer.json").replace(r#""radius":[60,30]"#, r#""radius":[60,30],"wall":3"#);
    folder.write("h.json", &hollow);
    let built = folder.json("build h.json -o h.step -o h.obj --json");
    let object = &built["objects"]["solid"];
    let wanted = frustum(60.0, 30.0, 100.0) - frustum(57.0, 27.0, 100.0);
    assert!((object["volume"].as_f64().unwrap() / wanted - 1.0).abs() < 1e-12);
    assert!(!hollow.is_empty() && !object.to_string().contains("rims-not-flat"));
    let [_, _, z] = extents(&String::from_utf8(folder.read("h.obj")).unwrap());
    assert!(z[0].abs() < 1e-9 && (z[1] - 100.0).abs() < 1e-9, "{z:?}");
}

/// Of a linear radius the volume is that of the frustum, however the path bends: each circle has its middle on it.
#[test]
fn a_hundred_random_tubes_have_the_volume_of_pappus() {
    let mut seed = 5_u64;
    let mut number = |from: f64, to: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let (mut objects, mut wanted) = (serde_json::Map::new(), Vec::new());
    for k in 0..100 {
        let [far, turn, lift] = [number(40.0, 90.0), number(-2.0, 2.0), number(-40.0, 40.0)];
        let points = [[0.0, 0.0, 0.0], [far, 0.0, 0.0], [far + far * turn.cos(), far * turn.sin(), lift]];
        let radius = [number(1.0, 9.0), number(1.0, 9.0)];
        let wall = 0.3 * radius[0].min(radius[1]);
        objects
            .insert(format!("p{k}"), json!({"type": "polyline", "points": points, "radius": 12, "construction": true}));
        objects.insert(
            format!("t{k}"),
            json!({"type": "tube", "of": format!("p{k}"), "radius": radius, "wall": wall, "tolerance": 1e-3}),
        );
        wanted.push((radius, wall));
    }
    let report = report(&Value::Object(objects));
    for (k, ([a, b], wall)) in wanted.into_iter().enumerate() {
        let length = report["objects"][format!("p{k}")]["contours"][0]["length"].as_f64();
        let length = length.or_else(|| report["objects"][format!("p{k}")]["length"].as_f64()).unwrap();
        let volume = report["objects"][format!("t{k}")]["volume"].as_f64().unwrap();
        let wanted = frustum(a, b, length) - frustum(a - wall, b - wall, length);
        // The bound on both skins.
        let allowed = 1e-3 * 2.0 * PI * (a + b) * length + 1e-9 * wanted;
        assert!((volume - wanted).abs() < allowed, "{k}: {volume} {wanted}");
    }
}

#[test]
fn sections_that_do_not_lie_across_their_path_are_told() {
    let folder = Folder::with(&[("s.json", &case("section_not_across.json"))]);
    let run = folder.run("build s.json -o s.step");
    assert!(run.stderr.contains("[section-not-across]") && run.stderr.contains("`sweep`"), "{}", run.stderr);
    // What is named works, and has the area of the section times the length: 0.4 by 0.5 by 21.217 m.
    let sweep = case("section_not_across.json").replace(
        r#""type": "swept-surface", "of": "way", "profile": "section""#,
        r#""type": "sweep", "of": "fit", "section": "section""#,
    );
    folder.write("w.json", &sweep);
    let built = folder.json("build w.json -o w.step --json");
    let length = built["objects"]["fit"]["length"].as_f64().unwrap();
    let volume = built["objects"]["conductor"]["volume"].as_f64().unwrap();
    assert!((volume / (0.2 * length) - 1.0).abs() < 1e-6, "{volume} {length}");
}

#[test]
fn swept_sections_are_solids_unless_their_ends_are_open() {
    let objects = |ends: &str| {
        json!({
            "m": {"type": "motion", "poses": [{"position": [0, 0, 0]}, {"position": [0, 0, 50]}], "construction": true},
            "p": {"type": "polyline", "points": [[0, 0], [4, 0], [4, 3], [0, 3]], "closed": true, "construction": true},
            "s": {"type": "swept-surface", "of": "m", "profile": "p", "ends": ends},
            "w": {"type": "polyline", "points": [[0, 0, 0], [30, 0, 0], [30, 0, 40]], "construction": true},
            "t": {"type": "sweep", "of": "w", "section": "p", "ends": ends}
        })
    };
    let solid = report(&objects("flat"));
    assert!((solid["objects"]["s"]["volume"].as_f64().unwrap() / 600.0 - 1.0).abs() < 1e-12);
    // y of the section is up at first, and the path bends up: its middle is 1.5 on the inner side.
    let volume = solid["objects"]["t"]["volume"].as_f64().unwrap();
    assert!((volume / (12.0 * (70.0 - 2.0 * 1.5)) - 1.0).abs() < 1e-12, "{volume}");
    let open = report(&objects("open"));
    assert!(open["objects"]["s"]["volume"].is_null() && open["objects"]["t"]["volume"].is_null());
    assert_eq!(open["objects"]["s"]["closed"], json!(false));
}

#[test]
fn the_corner_where_a_rail_should_start_is_named_and_makes_the_surface() {
    let error = refused("ruled_shifted.json");
    assert!(
        error.contains("2 of its 4 pieces later, at (-12, -12, 30)") && error.contains(r#"`"shift": 2`"#),
        "{error}"
    );
    let mended = case("ruled_shifted.json").replace(r#""rails":["low","top"]"#, r#""rails":["low","top"],"shift":2"#);
    let folder = Folder::with(&[("r.json", &mended)]);
    let built = folder.json("build r.json -o r.step --json");
    // Four trapezoids of 40 and 24 at the slant height.
    let area = 4.0 * 32.0 * 30.0_f64.hypot(8.0);
    assert!((built["objects"]["loft"]["total_area"].as_f64().unwrap() / area - 1.0).abs() < 1e-12);
}

/// A closed curve that runs the other way makes no surface that crosses itself, from wherever it starts, and the remedy makes the right one.
#[test]
fn a_rail_that_runs_the_other_way_is_refused_with_what_mends_it() {
    let ring = |radius: f64, height: f64, count: usize, first: usize, sense: f64| {
        let corner = |k: usize| {
            let angle = sense * std::f64::consts::TAU * ((k + first) % count) as f64 / count as f64;
            format!("[{}, {}, {height}]", radius * angle.cos(), radius * angle.sin())
        };
        (0..count).map(corner).collect::<Vec<_>>().join(", ")
    };
    let folder = Folder::with(&[]);
    for count in [4, 5, 6, 9] {
        // Frusta between regular polygons: the slant height is that of the sides.
        let apothem = (PI / count as f64).cos();
        let side = (PI / count as f64).sin();
        let area = count as f64 * (20.0 + 12.0) * side * 30.0_f64.hypot(8.0 * apothem);
        for first in 0..count {
            let curve = |points: &str| {
                format!(r#"{{"type": "polyline", "points": [{points}], "closed": true, "construction": true}}"#)
            };
            let document = |fields: &str| {
                format!(
                    r#"{{"cyclide": 1, "units": "mm", "objects": {{"low": {}, "top": {},
                    "turned": {{"type": "transform", "of": "top", "steps": ["reverse"], "construction": true}}, "loft": {{"type": "ruled", {fields}}}}}}}"#,
                    curve(&ring(20.0, 0.0, count, 0, 1.0)),
                    curve(&ring(12.0, 30.0, count, first, -1.0))
                )
            };
            for given in [0, 2] {
                folder.write("r.json", &document(&format!(r#""rails": ["low", "top"], "shift": {given}"#)));
                let run = folder.run("report r.json");
                assert!(run.code == 1 && run.stderr.contains("[rulings-cross]"), "{count} {first}: {}", run.stderr);
                assert!(run.stderr.contains(r#"`["reverse"]`"#), "{}", run.stderr);
                let shift =
                    run.stderr.split(r#"`"shift": "#).nth(1).map_or("0", |rest| rest.split('`').next().unwrap());
                folder.write("m.json", &document(&format!(r#""rails": ["low", "turned"], "shift": {shift}"#)));
                let made = folder.json("report m.json --json");
                let found = made["objects"]["loft"]["total_area"].as_f64().unwrap();
                assert!((found / area - 1.0).abs() < 1e-9, "{count} {first} {given} {shift}: {found} {area}");
            }
        }
    }
}

/// Twisted on purpose: rulings of a hyperboloid and of a saddle make their surfaces, the saddle the long way round with a remark.
#[test]
fn twisted_ruled_surfaces_are_made() {
    let circle = |height: f64, turn: f64| {
        format!(
            r#"{{"type": "transform", "of": "c", "steps": [{{"rotation": {{"axis": [0, 0, 1], "angle": {turn}}}}}, {{"translation": [0, 0, {height}]}}], "construction": true}}"#
        )
    };
    let line =
        |from: &str, to: &str| format!(r#"{{"type": "polyline", "points": [[{from}], [{to}]], "construction": true}}"#);
    for (objects, warned) in [
        (
            format!(
                r#""c": {{"type": "circle", "center": [0, 0, 0], "radius": 5, "construction": true}}, "a": {}, "b": {}"#,
                circle(0.0, 0.0),
                circle(8.0, 2.0)
            ),
            false,
        ),
        (format!(r#""a": {}, "b": {}"#, line("0, 0, 0", "10, 0, 4"), line("0, 10, 4", "10, 10, 0")), false),
        (format!(r#""a": {}, "b": {}"#, line("0, 0, 0", "10, 0, 4"), line("10, 3, 0", "0, 3, 4")), true),
    ] {
        let text =
            format!(r#"{{"cyclide": 1, "objects": {{{objects}, "s": {{"type": "ruled", "rails": ["a", "b"]}}}}}}"#);
        let folder = Folder::with(&[("s.json", &text)]);
        let run = folder.run("report s.json");
        assert!(run.code == 0, "{}", run.stderr);
        assert_eq!((run.stdout + &run.stderr).contains("rails-opposite"), warned, "{text}");
    }
}

/// A loft between outlines of which the second begins one or more corners later says so, and the shift that it names takes the twist away.
#[test]
fn lofts_that_begin_at_another_corner_say_so() {
    let outline = |count: usize, first: usize, size: f64, z: f64| {
        let at = |k: usize| {
            let (sin, cos) = (std::f64::consts::TAU * (k + first) as f64 / count as f64).sin_cos();
            format!("[{}, {}, {z}]", 1.5 * size * cos, size * sin)
        };
        let points: Vec<String> = (0..count).map(at).collect();
        format!(r#"{{"type": "polyline", "closed": true, "points": [{}], "construction": true}}"#, points.join(", "))
    };
    for (count, first, size) in [(4, 1, 20.0), (4, 3, 12.0), (6, 2, 20.0), (6, 1, 30.0), (9, 2, 20.0), (3, 1, 9.0)] {
        let document = |shift: &str| {
            format!(
                r#"{{"cyclide": 1, "objects": {{"low": {}, "top": {}, "loft": {{"type": "ruled", "rails": ["low", "top"]{shift}}}}}}}"#,
                outline(count, 0, 20.0, 0.0),
                outline(count, first, size, 30.0)
            )
        };
        let folder =
            Folder::with(&[("t.json", &document("")), ("s.json", &document(&format!(r#", "shift": {first}"#)))]);
        let run = folder.run("report t.json");
        let remedy = format!(r#"with `"shift": {}`"#, count - first);
        assert!(
            run.stderr.contains("[rails-twisted]") && run.stderr.contains(&remedy),
            "{count} {first}: {}",
            run.stderr
        );
        folder.write("m.json", &document(&format!(r#", "shift": {}"#, count - first)));
        let mended = folder.run("report m.json");
        assert!(mended.code == 0 && !mended.stderr.contains("rails-"), "{count} {first}: {}", mended.stderr);
        // One that is typed is obeyed.
        assert!(!folder.run("report s.json").stderr.contains("rails-twisted"), "{count} {first}");
    }
}

/// A helix far from the origin says by how much its coordinates are rounded.
#[test]
fn helices_say_how_they_are_rounded() {
    let helix = |center: &str, tolerance: f64| {
        let fields = format!(
            r#""type": "helix", "radius": 15, "pitch": 8, "turns": 5, "tolerance": {tolerance:e}, "center": [{center}]"#
        );
        let folder = Folder::with(&[("h.json", &format!(r#"{{"cyclide": 1, "objects": {{"h": {{{fields}}}}}}}"#))]);
        folder.json("report h.json --json")["objects"]["h"]["within"].as_f64().unwrap()
    };
    assert!((helix("0, 0, 0", 1e-9) - 1e-9).abs() < 1e-13);
    assert!((1e-9..1e-8).contains(&helix("5334000, 5334000, 100", 1e-12)));
}

#[test]
fn remedies_that_are_named_work() {
    // A noisy run: the fit and both tolerances that are named build.
    let error = refused("noisy_run.json");
    let number = |after: &str| {
        let (_, rest) = error.rsplit_once(after).unwrap_or_else(|| panic!("{error}"));
        rest.trim_start().split([',', '`']).next().unwrap().trim().parse::<f64>().unwrap()
    };
    let (fit, arcs) = (number(r#""fair-fit", "tolerance": "#), number(r#"set `"tolerance": "#));
    let mended = case("noisy_run.json")
        .replace(r#""type":"polyline""#, &format!(r#""type":"fair-fit","tolerance":{fit}"#))
        .replace(r#""radius":0.008"#, &format!(r#""radius":0.008,"tolerance":{arcs}"#));
    let folder = Folder::with(&[("n.json", &mended)]);
    let built = folder.json("build n.json -o n.step --json");
    let volume = built["objects"]["rod"]["volume"].as_f64().unwrap();
    assert!((volume / (PI * 0.008_f64.powi(2) * 1.4) - 1.0).abs() < 0.05, "{volume}");
    // A wedge that begins on its axis: the order of the corners that is named makes it.
    let document: Value = serde_json::from_str(&case("wedge_on_axis.json")).unwrap();
    folder.write("w.json", &document.to_string());
    let error = folder.fails(1, "build w.json -o w.vtu");
    let (_, order) = error.split_once("in the order ").unwrap_or_else(|| panic!("{error}"));
    let order: Vec<usize> =
        order.split(" [").next().unwrap().split(", ").map(|word| word.trim().parse().unwrap()).collect();
    let mut mended = document;
    let corners = mended["objects"]["b"]["corners"].as_array().unwrap().clone();
    mended["objects"]["b"]["corners"] = order.iter().map(|k| corners[*k].clone()).collect();
    folder.write("w.json", &mended.to_string());
    folder.ok("build w.json -o w.vtu");
}

#[test]
fn radii_are_not_called_their_sum() {
    // Strands that cross 9 apart.
    let points = [[0, 0, 0], [60, 0, 0], [60, 40, 9], [30, 40, 9], [30, -40, 9]];
    let document = json!({"cyclide": 1, "units": "mm", "objects": {
        "p": {"type": "polyline", "points": points, "radius": 12, "construction": true},
        "u": {"type": "pipe", "of": "p", "radius": 5}}});
    let folder = Folder::with(&[("d.json", &document.to_string())]);
    let error = folder.fails(1, "build d.json -o d.step");
    assert!(error.contains("[pipe-meets-itself]") && error.contains("minimum 10, the sum of their radii"), "{error}");
    let mesh = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "faces": [[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}}}"#;
    folder.write("m.json", mesh);
    let run = folder.run("build m.json -o m.step");
    assert!(run.stderr.contains("`principal-grid`") || !run.stderr.contains("[no-exact-form]"), "{}", run.stderr);
}

#[test]
fn ellipses_and_helices_are_curves_of_their_own() {
    let report = report(&json!({
        "e": {"type": "ellipse", "center": [1, 2], "semi_axes": [5, 3]},
        "a": {"type": "ellipse", "center": [1, 2], "semi_axes": [5, 3], "start": {"degrees": 90}, "sweep": {"degrees": -90}},
        "h": {"type": "helix", "radius": 10, "pitch": 5, "turns": 4, "hand": "left"},
        "g": {"type": "helix", "radius": 10, "height": 20, "turns": 4}
    }));
    let length = |name: &str| report["objects"][name]["length"].as_f64().unwrap();
    // The complete elliptic integral to ten digits.
    assert!((length("e") - 25.526_998_863_4).abs() < 1e-9 && (length("a") - 0.25 * length("e")).abs() < 1e-9);
    let helix = 4.0 * (20.0 * PI).hypot(5.0);
    assert!((length("h") - helix).abs() < 1e-6 && (length("g") - helix).abs() < 1e-6);
}
