//! Grids along lines of curvature in documents: every source of a mesh, the nets that take them, the report, what is refused.

use std::fmt::Write as _;
use std::path::Path;

use cyclide::model::{Model, Units};
use cyclide_io::{
    Document, ExportOptions, Exporter, Format, ModelBuilder,
    document::BuiltObject,
    export::VtuCells,
    report::{GeometryReport, ObjectReport, PrincipalReport},
};

const COUNT: usize = 17;
/// A net over the largest grid.
pub(super) const NET: &str = r#""n": {"type": "cyclidic-net", "grid": {"of": "g"}, "make_circular": true}"#;

/// A hypar along its straight lines: vertices in half units, and quads.
fn hypar() -> (Vec<[f64; 3]>, Vec<[usize; 4]>) {
    let at = |k: usize| [0.5 * (k % COUNT) as f64 - 4.0, 0.5 * (k / COUNT) as f64 - 4.0];
    let vertices = (0..COUNT * COUNT).map(at).map(|[x, y]| [x, y, x * y / 16.0]).collect();
    let quads = (0..(COUNT - 1) * (COUNT - 1)).map(|k| k / (COUNT - 1) * COUNT + k % (COUNT - 1));
    (vertices, quads.map(|a| [a, a + 1, a + COUNT + 1, a + COUNT]).collect())
}

fn inline() -> String {
    let (vertices, faces) = hypar();
    format!(r#""vertices": {vertices:?}, "faces": {faces:?}"#)
}

pub(super) fn obj() -> Vec<u8> {
    let (vertices, faces) = hypar();
    let mut text = String::new();
    vertices.iter().for_each(|[x, y, z]| writeln!(text, "v {x} {y} {z}").unwrap());
    faces.iter().map(|f| f.map(|v| v + 1)).for_each(|[a, b, c, d]| writeln!(text, "f {a} {b} {c} {d}").unwrap());
    text.into_bytes()
}

fn stl() -> Vec<u8> {
    let (vertices, faces) = hypar();
    let triangles: Vec<[usize; 3]> = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mut bytes = vec![0; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        bytes.extend([0; 12]);
        t.iter().flat_map(|v| vertices[*v]).for_each(|x| bytes.extend((x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn ply() -> Vec<u8> {
    let (vertices, faces) = hypar();
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        vertices.len(),
        faces.len()
    );
    vertices.iter().for_each(|[x, y, z]| writeln!(text, "{x} {y} {z}").unwrap());
    faces.iter().for_each(|[a, b, c, d]| writeln!(text, "4 {a} {b} {c} {d}").unwrap());
    text.into_bytes()
}

/// Builds all objects: a grid `g` with these fields, and others.
fn build_all(fields: &str, others: &[&str], hears: &mut dyn FnMut(String)) -> Result<Vec<BuiltObject>, String> {
    let read = |path: &Path| match path.to_str() {
        Some("a.obj") => Ok(obj()),
        Some("a.stl") => Ok(stl()),
        Some("a.ply") => Ok(ply()),
        _ => Err(std::io::ErrorKind::NotFound.into()),
    };
    build_reading(fields, others, &read, hears)
}

/// As [`build_all`], of other files.
pub(super) fn build_reading(
    fields: &str,
    others: &[&str],
    read: &dyn Fn(&Path) -> std::io::Result<Vec<u8>>,
    hears: &mut dyn FnMut(String),
) -> Result<Vec<BuiltObject>, String> {
    // What covers most by itself has tests of its own: here rectangles are asked for, unless a test says otherwise.
    let layout = |field: &str, word: &str| {
        if fields.contains(&format!("\"{field}\"")) { String::new() } else { format!(r#""{field}": "{word}", "#) }
    };
    let (border, umbilics) = (layout("border", "inside"), layout("umbilics", "pieces"));
    let grid = format!(r#""g": {{"type": "principal-grid", {border}{umbilics}{fields}}}"#);
    let objects: Vec<&str> = std::iter::once(grid.as_str()).chain(others.iter().copied()).collect();
    let text = format!("{{\"cyclide\": 1, \"objects\": {{\n{}\n}} }}", objects.join(",\n"));
    let document = Document::parse("m.json", text.as_bytes()).map_err(|d| d.to_string())?;
    let mut builder = ModelBuilder::new(&document, Path::new(""), read).map_err(|e| e.to_string())?;
    (0..document.objects.len()).map(|k| builder.build(k, hears).map_err(|e| e.to_string())).collect()
}

fn build(fields: &str, others: &[&str]) -> Result<Vec<BuiltObject>, String> {
    build_all(fields, others, &mut |_| ())
}

pub(super) fn report(built: &BuiltObject) -> PrincipalReport {
    match ObjectReport::new(built, None).geometry {
        GeometryReport::Curves(curves) => *curves.principal.unwrap(),
        _ => panic!("curves"),
    }
}

#[test]
fn every_source_of_a_mesh_carries_a_net() {
    let mut heard = Vec::new();
    let sources = [
        inline(),
        r#""mesh": {"obj": "a.obj"}"#.to_owned(),
        r#""mesh": {"stl": "a.stl"}"#.to_owned(),
        r#""mesh": {"ply": "a.ply"}"#.to_owned(),
    ];
    for source in sources {
        let fields = format!(r#"{source}, "edge_length": 0.7"#);
        let built = build_all(&fields, &[NET], &mut |words| heard.push(words)).unwrap();
        let found = report(&built[0]);
        assert!(found.pieces.len() == 1 && found.coverage > 0.4 && found.umbilics.is_empty(), "{found:?}");
        // The lines of the grid are the curves, and the grid of the net.
        let piece = &found.pieces[0];
        assert_eq!(built[0].item.curves().len(), piece.columns + piece.rows);
        let faces = built[1].bodies[0].outer.faces().len();
        assert_eq!(faces, (piece.columns - 1) * (piece.rows - 1));
        let made = built[1].facts.net().unwrap().circular.as_ref().unwrap();
        assert!(made.moves.max < 0.03 * 0.7 && built[1].remarks.is_empty(), "{:?}", built[1].remarks);
    }
    assert!(heard.iter().any(|words| words.contains("lines of curvature")), "{heard:?}");
}

#[test]
fn the_report_says_what_was_laid() {
    let fields = format!(r#"{}, "edge_length": 0.7"#, inline());
    let built = build(&fields, &[]).unwrap();
    let text = cyclide_io::Report::new(Units::Metre, &built, None).to_string();
    for words in ["grid 0", " points, edges 0.", "% of the surface", "directions", "smoothed by 1,"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let json = serde_json::to_value(ObjectReport::new(&built[0], None)).unwrap();
    assert!(json["principal"]["pieces"][0]["edges"]["max"].as_f64().unwrap() < 0.75, "{json}");
}

#[test]
fn fields_without_effect_are_told() {
    let fields = format!(r#"{}, "edge_length": 0.7, "columns": 12, "closed": true"#, inline());
    let built = build(&fields, &[]).unwrap();
    let told: Vec<_> = built[0].remarks.iter().map(|r| (r.reason, r.place.as_deref().unwrap_or_default())).collect();
    assert_eq!(told, [("partly-covered", ""), ("no-effect", "objects.g.columns"), ("no-effect", "objects.g.closed")]);
}

/// Steps and openings of laid grids and of rows of points, through to a solid.
#[test]
fn grids_in_steps_make_nets_and_solids() {
    let laid = format!(r#"{}, "edge_length": 0.7, "border": "staircase""#, inline());
    let net = r#""n": {"type": "cyclidic-net", "grid": {"of": "g"}, "make_circular": true, "openings": [[7, 7]]}"#;
    let wall = r#""w": {"type": "offset", "of": "n", "distance": 0.1, "thick": true}"#;
    let layers = r#""l": {"type": "layers", "of": "n", "distances": [0, 0.04, 0.1], "cells": 2}"#;
    let built = build(&laid, &[net, wall, layers]).unwrap();
    let shell = &built[1].bodies[0].outer;
    let cells = shell.faces().len();
    assert!(cells > 40 && !shell.is_closed() && built[2].bodies[0].outer.is_closed());
    let joints = cyclide::topology::surface_joints(shell);
    assert!(joints.iter().all(|joint| joint.angle < 1e-7)); // rounding of normals
    // Twice the skin, and a rim over each free edge.
    let wall = &built[2].bodies[0].outer;
    let free = 4 * cells - 2 * joints.len();
    assert_eq!(wall.faces().len(), 2 * cells + free);
    // Blocks over every patch fill it, and the files of them are read back.
    let blocks = built[3].item.volumes();
    assert_eq!(blocks.len(), 2 * cells);
    let volume: f64 = blocks.iter().map(|block| block.measure().volume).sum();
    assert!((volume / wall.volume() - 1.0).abs() < 1e-9, "{volume}"); // quadrature to 1e-12 each
    let model = Model { items: vec![built[3].item.clone()], units: Units::Metre };
    let exporter = Exporter::with_provenance(&model, std::slice::from_ref(&built[3].provenance)).unwrap();
    for vtu_cells in [VtuCells::Bezier, VtuCells::Linear] {
        exporter.export(Format::Vtu, &ExportOptions { vtu_cells, ..ExportOptions::default() }).unwrap();
    }

    let row = |y: f64, n: usize| {
        let at = |k: usize| if k < n { format!("[{k}, {y}, 0]") } else { "null".to_owned() };
        format!("[{}]", (0..4).map(at).collect::<Vec<_>>().join(", "))
    };
    let steps = |more: &str| {
        let rows = [row(0.0, 4), row(1.0, 4), row(2.0, 3), row(3.0, 2)].join(", ");
        build(
            &laid,
            &[&format!(r#""n": {{"type": "cyclidic-net", "grid": [{rows}], "frame": [[1, 0, 0], [0, 1, 0]]{more}}}"#)],
        )
    };
    let flat = steps("").unwrap();
    // Three quads, two and one.
    assert!((flat[1].bodies[0].outer.area() - 6.0).abs() < 1e-12);
    for (more, words) in [
        (r#", "openings": [[2, 1]]"#, ["objects.n.openings[0]", "there is no quad in column 2, row 1"]),
        (r#", "openings": [[0, 1]]"#, ["objects.n.openings", "is not connected to the first one"]),
        (r#", "closed": [true, false]"#, ["objects.n", "`null` is for open grids"]),
        (r#", "make_circular": {"border": {"first_row": "g"}}"#, ["objects.n", "`g`"]),
    ] {
        let message = steps(more).map(|_| ()).unwrap_err();
        assert!(words.iter().all(|w| message.contains(w)), "{message}");
    }
}

#[test]
fn what_is_refused_is_shown_at_its_place() {
    let with = |more: &str| format!("{}, {more}", inline());
    let cases: [(String, &[&str], &[&str]); 12] = [
        (with(r#""edge_length": 0"#), &[], &["objects.g.edge_length", "[parameter-out-of-range]"]),
        (with(r#""edge_length": 2.6"#), &[], &["objects.g.edge_length", "[no-grid]", "shorter edges"]),
        (with(r#""edge_length": 0.7, "most_pieces": 9"#), &[], &["objects.g.most_pieces", "outside 1 to 4"]),
        (with(r#""edge_length": 0.7, "columns": 2"#), &[], &["objects.g.columns", "[parameter-out-of-range]"]),
        (with(r#""edge_length": 0.7, "umbilics": "piece""#), &[], &["did you mean `pieces`"]),
        (
            r#""edge_length": 0.7, "mesh": {"obj": "a.obj"}, "vertices": []"#.to_owned(),
            &[],
            &["exactly one of `mesh` (a file), `nurbs`, `heights`, or `vertices` with `faces`"],
        ),
        (
            r#""edge_length": 0.7, "vertices": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,3]]"#.to_owned(),
            &[],
            &["objects.g.faces[0][2]", "[no-such-vertex]"],
        ),
        (
            r#""edge_length": 0.1, "vertices": [[0,0,0],[1,0,0],[0,1,0],[-1,0,0],[0,-1,0]], "faces": [[0,1,2],[0,3,4]]"#
                .to_owned(),
            &[],
            &["objects.g.faces[", "[not-a-surface]", "meets others only at a vertex"],
        ),
        (r#""edge_length": 9, "mesh": {"obj": "none.obj"}"#.to_owned(), &[], &["objects.g.mesh.obj", "cannot read"]),
        (
            with(r#""edge_length": 0.7"#),
            &[r#""n": {"type": "cyclidic-net", "grid": {"of": "g", "piece": 1}}"#],
            &["objects.n.grid.piece", "there is no grid 1: `g` has 1 grid(s), numbered from 0"],
        ),
        (
            with(r#""edge_length": 0.7"#),
            &[r#""c": {"type": "circle", "center": [0, 0], "radius": 1}"#, r#""n": {"type": "cyclidic-net", "grid": {"of": "c"}}"#],
            &["objects.n.grid.of", "`c` is of type `circle`: grids come from a `principal-grid`"],
        ),
        (
            with(r#""edge_length": 0.7"#),
            &[r#""n": {"type": "cyclidic-net", "grid": {"of": "g", "obj": "a.obj"}}"#],
            &["a grid is `{\"obj\": \"FILE\"}` or `{\"of\": \"NAME\"}`"],
        ),
    ];
    for (fields, others, wanted) in cases {
        let message = build(&fields, others).unwrap_err();
        for words in wanted {
            assert!(message.contains(words), "{words}: {message}");
        }
    }
    // Not circular yet: the place is a row and a column of the grid, which stands in no text.
    let bare = r#""n": {"type": "cyclidic-net", "grid": {"of": "g"}}"#;
    let message = build(&with(r#""edge_length": 0.7"#), &[bare]).unwrap_err();
    assert!(message.contains("objects.n.grid") && message.contains("of grid 0 of `g`"), "{message}");
}
