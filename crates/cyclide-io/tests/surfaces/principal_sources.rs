//! Grids along lines of curvature of surfaces that are no meshes: B-spline surfaces and grids of heights.

use std::path::Path;

use cyclide_io::document::BuiltObject;

use super::principal_grids::{NET, build_reading, obj, report};

/// The hypar of the mesh, as a surface of degree (1, 1).
const HYPAR: &str = r#""degrees": [1, 1], "control_points": [[[-4, -4, 1], [4, -4, -1]], [[-4, 4, -1], [4, 4, 1]]]"#;
const CLAMPED: &str = r#""knots": [[0, 0, 1, 1], [0, 0, 1, 1]]"#;
/// Heights of the second roof of the mathematics, bicubic over 20 by 20: its rows of control points.
const ROOF: [[f64; 4]; 4] = [
    [-0.954, -0.806, 1.257, -1.632],
    [0.4, 3.914, 1.752, -1.779],
    [-0.9, 3.63, 3.249, -1.4],
    [-0.269, 0.677, -0.309, 0.533],
];

/// The heights of the hypar over the vertices of the mesh, from x = y = -4.
fn hypar_rows() -> Vec<Vec<f64>> {
    let at = |k: usize| 0.5 * k as f64 - 4.0;
    (0..17).map(|j| (0..17).map(|i| at(i) * at(j) / 16.0).collect()).collect()
}

fn csv(separator: &str, blank: &str) -> Vec<u8> {
    let line = |row: &Vec<f64>| row.iter().map(|z| format!("{z}{blank}")).collect::<Vec<_>>().join(separator);
    hypar_rows().iter().map(line).collect::<Vec<_>>().join("\n").into_bytes()
}

fn build(fields: &str, others: &[&str]) -> Result<Vec<BuiltObject>, String> {
    let read = |path: &Path| match path.to_str() {
        Some("a.obj") => Ok(obj()),
        Some("comma.csv") => Ok(csv(",", "")),
        Some("blank.csv") => Ok(csv(" ", "")),
        Some("ragged.csv") => Ok(b"1,2,3\n4,5\n".to_vec()),
        Some("word.csv") => Ok(b"1,2,3\n4,five,6\n".to_vec()),
        Some("one.csv") => Ok(b"1,2,3\n".to_vec()),
        Some("apart.csv") => Ok(b"1,2,nan\n4,5,nan\nnan,nan,nan\n1,2,3\n2,3,5\n".to_vec()),
        _ => Err(std::io::ErrorKind::NotFound.into()),
    };
    build_reading(fields, others, &read, &mut |_| ())
}

#[test]
fn one_surface_from_every_source_carries_the_same_net() {
    let place = r#""spacing": [0.5, 0.5], "origin": [-4, -4]"#;
    let rows = hypar_rows();
    // The far row first: as rasters have them.
    let backwards: Vec<&Vec<f64>> = rows.iter().rev().collect();
    let sources = [
        r#""mesh": {"obj": "a.obj"}"#.to_owned(),
        format!(r#""nurbs": {{{HYPAR}, {CLAMPED}}}"#),
        // Not clamped, over another domain; weights that are all alike.
        format!(r#""nurbs": {{{HYPAR}, "knots": [[-7, 2, 4, 5], [0, 0, 3, 3]], "weights": [[3, 3], [3, 3]]}}"#),
        format!(r#""heights": {{"csv": "comma.csv", {place}}}"#),
        format!(r#""heights": {{"csv": "blank.csv", {place}}}"#),
        format!(r#""heights": {{"z": {rows:?}, {place}}}"#),
        format!(r#""heights": {{"z": {backwards:?}, "spacing": [0.5, -0.5], "origin": [-4, 4]}}"#),
    ];
    let mut coverage = Vec::new();
    for source in sources {
        let built = build(&format!(r#"{source}, "edge_length": 0.7"#), &[NET]).unwrap();
        let found = report(&built[0]);
        assert!(found.pieces.len() == 1 && found.umbilics.is_empty(), "{source}: {found:?}");
        let made = built[1].facts.net().unwrap().circular.as_ref().unwrap();
        let silent = built[0].remarks.iter().all(|remark| remark.reason == "partly-covered");
        assert!(made.moves.max < 0.03 * 0.7 && silent, "{source}: {:?}", built[0].remarks);
        // On the surface, up to what chords of half an edge are off it.
        let off = built[0].item.grids().unwrap().grids()[0]
            .points()
            .iter()
            .map(|p| (p.z - p.x * p.y / 16.0).abs())
            .fold(0.0, f64::max);
        assert!(off < 5e-3, "{source}: {off}");
        coverage.push(found.coverage);
    }
    // A row more or less at each border.
    assert!(coverage.iter().all(|part| (part - coverage[0]).abs() < 0.1), "{coverage:?}");
}

#[test]
fn a_bicubic_surface_keeps_its_umbilics() {
    let x = |i: usize| -10.0 + 20.0 / 3.0 * i as f64;
    let points: Vec<Vec<[f64; 3]>> = (0..4).map(|j| (0..4).map(|i| [x(i), x(j), ROOF[j][i]]).collect()).collect();
    let knots = "[0, 0, 0, 0, 1, 1, 1, 1]";
    let nurbs = format!(
        r#""nurbs": {{"degrees": [3, 3], "knots": [{knots}, {knots}], "control_points": {points:?}}}, "edge_length": 0.8"#
    );
    let basis = |t: f64| [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
    let height = |i: usize, j: usize| {
        let (u, v) = (basis(i as f64 / 50.0), basis(j as f64 / 50.0));
        (0..16).map(|k| ROOF[k / 4][k % 4] * u[k % 4] * v[k / 4]).sum::<f64>()
    };
    let rows: Vec<Vec<f64>> = (0..=50).map(|j| (0..=50).map(|i| height(i, j)).collect()).collect();
    let heights =
        format!(r#""heights": {{"z": {rows:?}, "spacing": [0.4, 0.4], "origin": [-10, -10]}}, "edge_length": 0.8"#);
    let found = [nurbs, heights].map(|fields| {
        let built = build(&fields, &[NET]).unwrap();
        let made = built[1].facts.net().unwrap().circular.as_ref().unwrap();
        // The acceptance of the mathematics for this surface.
        assert!(made.moves.max <= 0.3 * 0.8, "{}", made.moves.max);
        let found = report(&built[0]);
        assert!(found.pieces[0].coverage >= 0.3 && found.umbilics.len() == 2, "{found:?}");
        built[0].facts.principal_grid().unwrap().umbilics.iter().map(|u| (u.point, u.halves)).collect::<Vec<_>>()
    });
    // Two meshes of one surface: umbilics are found to about an edge of them.
    for (point, halves) in &found[0] {
        let near = found[1].iter().any(|(other, same)| same == halves && other.distance(*point) < 0.8);
        assert!(near && *halves == -1, "{found:?}");
    }
}

/// The turn of an ellipse, its points beside each other as `[x, y]`, and their weights.
fn ellipse() -> ([[f64; 2]; 9], [f64; 9]) {
    let unit: [[f64; 2]; 9] =
        [[1., 0.], [1., 1.], [0., 1.], [-1., 1.], [-1., 0.], [-1., -1.], [0., -1.], [1., -1.], [1., 0.]];
    let weight = |k: usize| if k % 2 == 1 { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 };
    (unit.map(|[x, y]| [3.0 * x, 2.0 * y]), std::array::from_fn(weight))
}

const TURN: &str = "[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]";

#[test]
fn a_tube_gets_a_closed_grid_in_either_direction() {
    let (ring, weights) = ellipse();
    let row = |z: f64| ring.map(|[x, y]| [x, y, z]);
    let along = format!(
        r#""nurbs": {{"degrees": [2, 1], "knots": [{TURN}, [0, 0, 1, 1]], "control_points": {:?}, "weights": {:?}}}"#,
        [row(0.0), row(6.0)],
        [weights, weights]
    );
    let across = format!(
        r#""nurbs": {{"degrees": [1, 2], "knots": [[0, 0, 1, 1], {TURN}], "control_points": {:?}, "weights": {:?}}}"#,
        ring.map(|[x, y]| [[x, y, 0.0], [x, y, 6.0]]),
        weights.map(|w| [w, w])
    );
    for fields in [along, across] {
        let built = build(&format!(r#"{fields}, "edge_length": 0.6"#), &[NET]).unwrap();
        let grid = &built[0].item.grids().unwrap().grids()[0];
        assert!(
            built[0].item.grids().unwrap().grids().len() == 1 && grid.closed()[0] && report(&built[0]).coverage > 0.8
        );
        let off = |p: &cyclide::Point3| ((p.x / 3.0).hypot(p.y / 2.0) - 1.0).abs();
        // Chords of 0.3 are off the vertices of the ellipse, of radius 4/3, by 0.0085, of 3.
        assert!(grid.points().iter().map(off).fold(0.0, f64::max) < 5e-3);
        assert!(built[1].facts.net().unwrap().circular.as_ref().unwrap().moves.max < 0.03 * 0.6);
    }
}

#[test]
fn holes_of_heights_are_holes_of_the_surface() {
    let cell = |i: usize, j: usize, z: f64| if (i, j) == (8, 8) { "null".to_owned() } else { z.to_string() };
    let row = |(j, row): (usize, &Vec<f64>)| {
        format!("[{}]", row.iter().enumerate().map(|(i, z)| cell(i, j, *z)).collect::<Vec<_>>().join(", "))
    };
    let rows = hypar_rows().iter().enumerate().map(row).collect::<Vec<_>>().join(", ");
    let fields =
        format!(r#""heights": {{"z": [{rows}], "spacing": [0.5, 0.5], "origin": [-4, -4]}}, "edge_length": 0.7"#);
    let built = build(&fields, &[]).unwrap();
    // The four quads about the origin, which the grid of the whole goes through, are left out.
    let mut places = built[0].item.grids().unwrap().grids().iter().flat_map(|grid| grid.points());
    assert!(places.all(|p| p.x.abs().max(p.y.abs()) > 0.4));
}

#[test]
fn what_is_refused_is_shown_in_the_document_or_the_file() {
    let edge = r#""edge_length": 0.7"#;
    let surface = |more: &str| format!(r#""nurbs": {{{HYPAR}, {more}}}, {edge}"#);
    let heights = |more: &str| format!(r#""heights": {{{more}, "spacing": [1, 1]}}, {edge}"#);
    let pole = |degrees: &str, points: &str| {
        format!(r#""nurbs": {{"degrees": {degrees}, {CLAMPED}, "control_points": {points}}}, {edge}"#)
    };
    let cases = [
        (
            format!(r#""nurbs": {{{HYPAR}, {CLAMPED}}}, "edge_length": 0.001"#),
            "objects.g.edge_length",
            "[too-many-pieces]",
        ),
        (
            format!(r#""nurbs": {{{HYPAR}, {CLAMPED}}}, "edge_length": -1"#),
            "objects.g.edge_length",
            "[parameter-out-of-range]",
        ),
        (
            surface(r#""knots": [[0, 0, 1], [0, 0, 1, 1]]"#),
            "objects.g.nurbs.knots[0]: ",
            "repeat them) [count-differs]",
        ),
        (surface(r#""knots": [[0, 0, 1, 1], [0, 0, 1, 0.5]]"#), "objects.g.nurbs.knots[1][3]", "[knots-decrease]"),
        (surface(r#""knots": [[0, 0, 0, 1], [0, 0, 1, 1]]"#), "objects.g.nurbs.knots[0]", "[empty-interval]"),
        (
            surface(&format!(r#"{CLAMPED}, "weights": [[1, 1], [1, 0]]"#)),
            "objects.g.nurbs.weights[1][1]",
            "[weight-not-positive]",
        ),
        (surface(&format!(r#"{CLAMPED}, "weights": [[1, 1]]"#)), "objects.g.nurbs.weights", "[count-differs]"),
        (surface(&format!(r#"{CLAMPED}, "weights": [[1, 1], [1]]"#)), "objects.g.nurbs.weights[1]", "[count-differs]"),
        (
            pole("[1, 1]", "[[[0, 0, 0], [1, 0, 0]], [[0, 1, 0]]]"),
            "objects.g.nurbs.control_points[1]",
            "[count-differs]",
        ),
        (pole("[1, 1]", "[[[0, 0, 0], [1, 0, 0]]]"), "objects.g.nurbs.control_points", "[too-few-points]"),
        (
            pole("[0, 1]", "[[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]]"),
            "objects.g.nurbs.degrees[0]",
            "[parameter-out-of-range]",
        ),
        (
            pole("[1, 1]", "[[[0, 0, 0], [0, 0, 0]], [[0, 1, 0], [1, 1, 0]]]"),
            "objects.g.nurbs.control_points",
            "of the first row of control points is a single point",
        ),
        (
            pole("[1, 1]", "[[[0, 0, 0], [1, 1, 0]], [[0, 2, 0], [1, 1, 0]]]"),
            "split the surface near the pole",
            "where the rows of control points end is a single point",
        ),
        (
            format!(r#""nurbs": {{{HYPAR}, {CLAMPED}}}, "mesh": {{"obj": "a.obj"}}, {edge}"#),
            "objects.g",
            "exactly one of",
        ),
        (edge.to_owned(), "objects.g", "exactly one of"),
        (heights(r#""csv": "ragged.csv""#), "ragged.csv:2:4", "[count-differs]"),
        (heights(r#""csv": "word.csv""#), "word.csv:2:3", "`five` is not a number"),
        (heights(r#""csv": "one.csv""#), "objects.g.heights", "(of one.csv) [too-few-points]"),
        (heights(r#""csv": "apart.csv""#), "objects.g.heights", "[not-a-surface]"),
        (heights(r#""csv": "none.csv""#), "objects.g.heights.csv", "cannot read"),
        (
            heights(r#""csv": "one.csv", "z": [[1, 2], [2, 3]]"#),
            "objects.g.heights",
            "exactly one of `csv` (a file) and `z`",
        ),
        (heights(r#""z": [[1, 2], [2, 3], [4]]"#), "objects.g.heights.z[2]", "[count-differs]"),
        (heights(r#""z": [[1, null], [2, 3]]"#), "objects.g.heights", "[too-few-points]"),
        (
            format!(r#""heights": {{"z": [[1, 2], [2, 3]], "spacing": [1, 0]}}, {edge}"#),
            "objects.g.heights.spacing[1]",
            "[parameter-out-of-range]",
        ),
    ];
    for (fields, place, words) in cases {
        let message = build(&fields, &[]).map(|_| ()).unwrap_err();
        assert!(message.contains(place) && message.contains(words), "{place}, {words}: {message}");
        assert!(message.starts_with("m.json:2:") || message.contains(".csv:2:"), "{message}");
    }
}
