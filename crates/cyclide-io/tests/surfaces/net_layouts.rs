//! Nets round extraordinary vertices, from documents.

use std::path::Path;

use cyclide_io::{
    Document, ModelBuilder,
    document::BuiltObject,
    report::{GeometryReport, ObjectReport},
};

/// A dome of sectors of 5 x 5 quads round one vertex, whose edges cross at right angles from above.
fn dome(sectors: usize, height: f64) -> String {
    let (k, bend) = (5, 4.0 / sectors as f64);
    let (mut points, mut faces) = (Vec::<[f64; 3]>::new(), String::new());
    for q in 0..sectors * k * k {
        let (i, a, b) = (q / (k * k), q % k, q / k % k);
        faces += "f";
        for (a, b) in [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)] {
            let r = ((a as f64).hypot(b as f64) / k as f64).powf(bend);
            let angle = bend * (b as f64).atan2(a as f64) + std::f64::consts::TAU * i as f64 / sectors as f64;
            let (x, y) = (r * angle.cos(), r * angle.sin());
            let p = [x, y, -height * (x * x + y * y)];
            let near = |q: &[f64; 3]| (q[0] - x).hypot(q[1] - y) < 1e-9;
            let number = points.iter().position(near).unwrap_or_else(|| {
                points.push(p);
                points.len() - 1
            });
            faces += &format!(" {}", number + 1);
        }
        faces += "\n";
    }
    points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect::<String>() + &faces
}

/// The last object of a document over the mesh `m.obj`.
fn build(objects: &str, mesh: &str) -> Result<BuiltObject, String> {
    let text = format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#);
    let document = Document::parse("m.json", text.as_bytes()).map_err(|e| e.to_string())?;
    let read = |_: &Path| Ok(mesh.as_bytes().to_vec());
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|e| e.to_string())?;
    let built = (0..document.objects.len()).map(|k| builder.build(k, &mut |_| ()));
    built.last().unwrap().map_err(|e| e.to_string())
}

fn net(fields: &str) -> String {
    format!(r#""n": {{"type": "cyclidic-net", "grid": {{"obj": "m.obj"}}{fields}}}"#)
}

const CIRCULAR: &str = r#", "make_circular": true"#;

#[test]
fn a_dome_of_five_sectors() {
    let built = build(&net(CIRCULAR), &dome(5, 0.3)).unwrap();
    let GeometryReport::Surface(report) = ObjectReport::new(&built, None).geometry else { panic!("it is a surface") };
    assert_eq!((report.patches, report.bodies, report.joints.creases), (5 * 24, 1, 0));
    // The border and the opening.
    assert_eq!(report.free_edges, 50 + 10);
    assert!(report.joints.angle < 1e-12 && report.joints.gap < 1e-12 && report.singular.is_empty());
    let round = report.circular.unwrap().round.unwrap();
    assert!(round.vertices == 1 && round.angle_before > 0.1 && round.angle_after < 1e-12);
    let remark = built.remarks.iter().find(|remark| remark.reason == "extraordinary-vertices").unwrap();
    assert_eq!(remark.index, Some(0));
    assert!(
        remark.message.contains("point 1 of") && remark.message.contains("5 quads stay open"),
        "{}",
        remark.message
    );
}

#[test]
fn what_is_made_of_it_follows() {
    let mesh = dome(3, 0.3);
    let with = |more: &str| build(&format!("{}, {more}", net(CIRCULAR)), &mesh);
    let thick = with(r#""t": {"type": "offset", "of": "n", "distance": 0.02, "thick": true}"#).unwrap();
    assert!(thick.bodies[0].is_solid() && thick.bodies[0].outer.faces().len() == 2 * 72 + 30 + 6);
    let offset = with(r#""o": {"type": "offset", "of": "n", "distance": -0.02}"#).unwrap();
    assert_eq!(offset.bodies[0].outer.faces().len(), 72);
    let image =
        with(r#""i": {"type": "transform", "of": "n", "steps": [{"inversion": {"center": [0, 0, 3], "radius": 2}}]}"#);
    assert_eq!(image.unwrap().bodies[0].outer.faces().len(), 72);
    let arcs = with(r#""a": {"type": "support-structure", "of": "n"}"#).unwrap();
    // 3 x (2 x 5 x 6) edges of three grids, less 15 that two of them share, less 3 that end at the vertex: each is one of those 15.
    assert_eq!(arcs.item.curves().len(), 3 * 60 - 15 - 3);
}

#[test]
fn what_does_not_go_is_said() {
    let mesh = dome(5, 0.3);
    let refused = |fields: &str, mesh: &str| build(&net(fields), mesh).unwrap_err();
    let message = refused("", &mesh);
    assert!(message.contains("[not-concircular]") && message.contains("`make_circular`, which moves"), "{message}");
    assert!(message.contains("(points "), "{message}");
    for (fields, words) in [
        (r#", "openings": [[0, 0]]"#, "`openings` are columns and rows of a single grid"),
        (r#", "frame": [[1, 0, 0], [0, 1, 0]]"#, "remove `frame`"),
        (r#", "closed": [true, false]"#, "`closed` requires an inline grid"),
    ] {
        let message = refused(&format!("{fields}{CIRCULAR}"), &mesh);
        assert!(message.contains(words), "{message}");
    }
    let message = refused(r#", "make_circular": {"border": "free", "max_steps": 1}"#, &mesh);
    assert!(message.contains("[not-converged]"), "{message}");
    // A saddle and five sectors: the lines of curvature would change places.
    let saddle: String = mesh
        .lines()
        .map(|line| {
            match line
                .strip_prefix("v ")
                .map(|xyz| xyz.split(' ').map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>())
            {
                Some(p) => format!("v {} {} {}\n", p[0], p[1], 0.3 * (p[0] * p[0] - p[1] * p[1])),
                None => format!("{line}\n"),
            }
        })
        .collect();
    assert!(refused(CIRCULAR, &saddle).contains("[shape-lost]"));
    let allowed = r#", "make_circular": {"allow_shape_change": true}"#;
    let built = build(&net(allowed), &saddle).unwrap();
    assert!(built.remarks.iter().any(|remark| remark.reason == "shape-changed"));
    // Held at its border it closes too.
    let pinned = build(&net(r#", "make_circular": {"border": "pinned", "allow_shape_change": true}"#), &dome(5, 0.1));
    assert!(pinned.is_ok() || pinned.unwrap_err().contains("[not-converged]"));
}

#[test]
fn corners_of_flat_faces_are_refused() {
    // Three planes that meet in the vertex: their nets would bulge.
    for slope in [0.5, 1.0, std::f64::consts::SQRT_2] {
        let corner: String = dome(3, 0.0)
            .lines()
            .map(|line| match line.strip_prefix("v ") {
                Some(xyz) => {
                    let p: Vec<f64> = xyz.split(' ').map(|x| x.parse().unwrap()).collect();
                    let towards = |k: usize| std::f64::consts::TAU * (k as f64 + 0.5) / 3.0;
                    let down = (0..3).map(|k| p[0] * towards(k).cos() + p[1] * towards(k).sin()).fold(0.0, f64::max);
                    format!("v {} {} {}\n", p[0], p[1], -slope * down)
                }
                None => format!("{line}\n"),
            })
            .collect();
        let message = build(&net(CIRCULAR), &corner).unwrap_err();
        assert!(
            ["[shape-lost]", "[ring-does-not-close]", "[not-converged]"].iter().any(|word| message.contains(word)),
            "{message}"
        );
    }
}

/// Blocks between offsets of all pieces, whose cells meet if they are alike along s and t.
#[test]
fn layers_of_a_dome() {
    let with = |cells: &str| {
        let layers = format!(r#""l": {{"type": "layers", "of": "n", "distances": [0, 0.02, 0.05], "cells": {cells}}}"#);
        build(&format!("{}, {layers}", net(CIRCULAR)), &dome(5, 0.3))
    };
    let built = with("[2, 2, 1]").unwrap();
    let blocks = built.item.volumes();
    assert_eq!((blocks.len(), built.facts.cells().is_some()), (2 * 5 * 24, true));
    let solid = r#""w": {"type": "offset", "of": "n", "distance": 0.05, "thick": true}"#;
    let solid = build(&format!("{}, {solid}", net(CIRCULAR)), &dome(5, 0.3)).unwrap();
    let volume: f64 = blocks.iter().map(|block| block.measure().volume).sum();
    // Each is known to 1e-12 or better.
    assert!((volume / solid.bodies[0].outer.volume() - 1.0).abs() < 1e-9);
    let message = with("[2, 3, 1]").unwrap_err();
    assert!(message.contains("[cells-unfit]") && message.contains("objects.l.cells"), "{message}");
}

/// A roof round an umbilic of index -1/2, as a mesh in a file.
fn monkey() -> String {
    let n = 41_usize;
    let place = |k: usize| [0.3 * (k % n) as f64 - 6.0, 0.3 * (k / n) as f64 - 6.0];
    let height = |x: f64, y: f64| 0.01 * (x * x * x - 3.0 * x * y * y) + 0.02 * (x * x + y * y);
    let points: String = (0..n * n).map(place).map(|[x, y]| format!("v {x} {y} {}\n", height(x, y))).collect();
    let quads = (0..n - 1).flat_map(|j| (0..n - 1).map(move |i| i + j * n + 1));
    points + &quads.map(|a| format!("f {a} {} {} {}\n", a + 1, a + n + 1, a + n)).collect::<String>()
}

fn lattice(fields: &str) -> String {
    format!(
        r#""g": {{"type": "principal-grid", "mesh": {{"obj": "m.obj"}}, "edge_length": 0.6, "umbilics": "joined"{fields}}}"#
    )
}

#[test]
fn one_mesh_round_an_umbilic() {
    let of_all = format!(r#"{}, "n": {{"type": "cyclidic-net", "grid": {{"of": "g"}}{CIRCULAR}}}"#, lattice(""));
    let built = build(&of_all, &monkey()).unwrap();
    let GeometryReport::Surface(report) = ObjectReport::new(&built, None).geometry else { panic!("it is a surface") };
    assert_eq!((report.bodies, report.joints.creases, report.singular.len()), (1, 0, 0));
    assert_eq!(report.circular.unwrap().round.unwrap().vertices, 1);
    let remark = built.remarks.iter().find(|remark| remark.reason == "extraordinary-vertices").unwrap();
    assert!(remark.message.contains("the point of `g` at") && remark.message.contains("6 quads"), "{}", remark.message);
    // One of its grids alone.
    let of_one = format!(r#"{}, "n": {{"type": "cyclidic-net", "grid": {{"of": "g", "piece": 2}}}}"#, lattice(""));
    let of_one = of_one.replace(r#""piece": 2}"#, &format!(r#""piece": 2}}{CIRCULAR}"#));
    let one = build(&of_one, &monkey()).unwrap();
    assert!(one.bodies[0].outer.faces().len() < report.patches / 2);
}

/// The lines of the grids are drawn once each, also on the borders that they share.
#[test]
fn lines_of_joined_grids_are_drawn_once() {
    let built = build(&lattice(""), &monkey()).unwrap();
    let mut edges = std::collections::BTreeSet::new();
    for curve in built.item.curves() {
        let curve = curve.as_curve();
        for piece in 0..curve.piece_count() {
            let ends = [0.0, 1.0].map(|s| curve.piece_point(piece, s).to_array().map(|x| (x * 1e6).round() as i64));
            let [a, b] = ends;
            assert!(edges.insert((a.min(b), a.max(b))), "{ends:?} is drawn twice");
        }
    }
    assert_eq!(edges.len(), count_of_edges(&built));
}

/// The edges of the grids of an object, each once.
fn count_of_edges(built: &BuiltObject) -> usize {
    let mesh = built.item.grids().unwrap().layout().unwrap();
    let sides = |[a, b, c, d]: [usize; 4]| [[a, b], [c, d], [a, c], [b, d]];
    let edges: std::collections::BTreeSet<[usize; 2]> =
        mesh.quads().into_iter().flat_map(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.len()
}

#[test]
fn what_goes_with_joined_grids() {
    let built = build(&lattice(r#", "most_pieces": 2"#), &monkey()).unwrap();
    assert!(built.remarks.iter().any(|remark| remark.reason == "no-effect"));
    let net =
        |fields: &str| format!(r#"{}, "n": {{"type": "cyclidic-net", "grid": {{"of": "g"}}{fields}}}"#, lattice(""));
    for (fields, words) in [
        (r#", "closed": [true, false]"#, "`closed` requires an inline grid"),
        (r#", "frame": [[1, 0, 0], [0, 1, 0]]"#, "remove `frame`"),
        (r#", "openings": [[0, 0]]"#, "`openings` are columns and rows of a single grid"),
        ("", "not-concircular"),
    ] {
        let error = build(&net(fields), &monkey()).unwrap_err();
        assert!(error.contains(words), "{fields}: {error}");
    }
    let cover = build(&lattice(r#", "border": "cover""#), &monkey()).unwrap_err();
    assert!(cover.contains("umbilics-remain") && cover.contains("joined"), "{cover}");
}
