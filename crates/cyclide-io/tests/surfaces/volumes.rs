//! Volumes: grids of blocks, layers, cells, the outer boundary, and what is refused of them.

use cyclide::volume::ParamVolume as _;
use cyclide_io::report::{GeometryReport, ObjectReport, VolumeReport, sample_cells};

use super::build;

/// Three planes of an uneven box of 2 by 1 by 2 blocks, with one point of the plane t = 0 moved.
fn planes(moved: f64) -> String {
    let (x, y, z) = ([0.0, 1.0, 3.0], [0.0, 2.0], [0.0, 0.5, 1.5]);
    let rows = |outer: &[f64], inner: &[f64], point: &dyn Fn(f64, f64) -> [f64; 3]| -> Vec<Vec<[f64; 3]>> {
        outer.iter().map(|o| inner.iter().map(|i| point(*i, *o)).collect()).collect()
    };
    let st = rows(&y, &x, &|x, y| [x, y, 0.0]);
    let mut su = rows(&z, &x, &|x, z| [x, 0.0, z]);
    su[2][2][0] += moved;
    let tu = rows(&z, &y, &|y, z| [0.0, y, z]);
    format!(r#""planes": {{"st": {st:?}, "su": {su:?}, "tu": {tu:?}}}"#)
}

fn report(objects: &str) -> VolumeReport {
    match ObjectReport::new(&build(objects).unwrap(), None).geometry {
        GeometryReport::Volume(report) => *report,
        other => panic!("no volume: {other:?}"),
    }
}

/// The reason of a refusal, and all that is said.
fn refused(objects: &str) -> (Option<String>, String) {
    let message = build(objects).unwrap_err();
    let reason = message.lines().next().and_then(|line| line.rsplit_once(" [")).map(|(_, word)| word.replace(']', ""));
    (reason, message)
}

#[test]
fn grids_come_from_three_planes() {
    let grid = format!(r#""g": {{"type": "cyclide-grid", {}, "cells": [2, 3, 4]}}"#, planes(0.0));
    let found = report(&grid);
    assert!(found.blocks == 4 && (found.volume - 9.0).abs() < 1e-12);
    let cells = found.cells.unwrap();
    // (2 x 2 + 1) (1 x 3 + 1) (2 x 4 + 1) nodes: neighbors share theirs.
    assert_eq!((cells.count, cells.nodes, cells.inverted), (96, 5 * 4 * 9, 0));
    assert!((cells.scaled_jacobian - 1.0).abs() < 1e-14 && (cells.shortest_side - 0.125).abs() < 1e-14);
    let (reason, message) = refused(&format!(r#""g": {{"type": "cyclide-grid", {}}}"#, planes(0.1)));
    assert_eq!(reason.as_deref(), Some("not-concircular"));
    assert!(message.contains("block 3"), "{message}");
    let both = format!(r#""g": {{"type": "cyclide-grid", {}, "whole": {{"a": 3, "mu": [0.5, 1]}}}}"#, planes(0.0));
    assert!(refused(&both).1.contains("either `planes` or `whole`"));
}

fn block(corners: &[[f64; 3]], fields: &str) -> String {
    format!(r#""b": {{"type": "cyclide-volume", "corners": {corners:?}{fields}}}"#)
}

/// The corners of a box, turned and moved: as many as are asked for, four of them the first and its neighbors.
fn turned_box(sides: [f64; 3], place: [f64; 3], count: usize) -> Vec<[f64; 3]> {
    // Rows of an orthonormal matrix, in thirds.
    let ways = [[2.0, -1.0, 2.0], [2.0, 2.0, -1.0], [-1.0, 2.0, 2.0]];
    let at = |k: usize| {
        std::array::from_fn(|x| {
            place[x] + (0..3).map(|axis| (k >> axis & 1) as f64 * sides[axis] * ways[axis][x] / 3.0).sum::<f64>()
        })
    };
    let places = if count == 4 { vec![0, 1, 2, 4] } else { (0..count).collect() };
    places.into_iter().map(at).collect()
}

#[test]
fn four_corners_of_a_cuboid_are_a_cuboid() {
    for sides in [[1.0, 1.0, 1.0], [1.0, 1.0, 0.01], [10.0, 1.0, 1.0], [3e6, 4e2, 5.0], [2e-7, 3e-7, 1e-9]] {
        let found = report(&block(&turned_box(sides, [0.0; 3], 4), ""));
        let [a, b, c] = sides;
        // Corners are rounded to 2^-53 of the longest side.
        let limit = 1e-13 + 4.0 * f64::EPSILON * a.max(b).max(c) / a.min(b).min(c);
        assert!((found.volume / (a * b * c) - 1.0).abs() < limit, "{sides:?}: {}", found.volume);
        assert!((found.area / (2.0 * (a * b + b * c + c * a)) - 1.0).abs() < limit, "{sides:?}: {}", found.area);
    }
    // Equal weights are not those of a flat one.
    let flat = report(&block(&turned_box([1.0, 1.0, 0.01], [0.0; 3], 4), r#", "inside": [1, 1, 1]"#));
    assert!((flat.volume - 0.450_840_256_24).abs() < 1e-11, "{}", flat.volume); // by the flux through its faces
    // Corners that coincide are named.
    let one = block(&[[0.0; 3], [0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "");
    assert_eq!(refused(&one).0.as_deref(), Some("coincident-points"));
}

#[test]
fn the_eighth_corner_may_be_rounded_where_it_is() {
    let far = [1e7, -3e7, 2e7];
    let cases = [([1.0, 1.0, 1.0], far), ([1.0, 1e-3, 1e-3], [1e4, 2e4, -3e4]), ([1.0, 1.0, 1e-4], [5e4, 0.0, 0.0])];
    for (sides, place) in cases {
        let [a, b, c] = sides;
        for count in [7, 8] {
            let found = report(&block(&turned_box(sides, place, count), ""));
            // Roundings of coordinates over the shortest side.
            let size = place.into_iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            let limit = 10.0 * f64::EPSILON * size / a.min(b).min(c);
            assert!((found.volume / (a * b * c) - 1.0).abs() < limit, "{sides:?} {count}: {}", found.volume);
        }
        let mut off = turned_box(sides, place, 8);
        off[7][0] += 1e-4 * a;
        assert_eq!(refused(&block(&off, "")).0.as_deref(), Some("not-concircular"), "{sides:?}");
    }
}

#[test]
fn directions_of_two_sides_are_a_frame_of_left_handed_corners_too() {
    let corners = [
        [0.0; 3],
        [-2.0, 0.0, 0.0],
        [0.0, 3.0, 0.0],
        [-2.0, 3.0, 0.0],
        [0.0, 0.0, 1.0],
        [-2.0, 0.0, 1.0],
        [0.0, 3.0, 1.0],
    ];
    let found = report(&block(&corners, r#", "frame": [[-1, 0, 0], [0, 1, 0]]"#));
    assert!((found.volume - 6.0).abs() < 1e-13 && found.jacobian.max < 0.0, "{}", found.volume);
}

#[test]
fn what_comes_too_near_infinity_is_right_or_not_known() {
    let unit = block(&turned_box([1.0; 3], [0.0; 3], 7), "");
    // Below the middle of a face by a thousandth.
    let [x, y, z] = [2.0 / 3.0 + 1e-3 / 3.0, 1.0 / 6.0 - 2e-3 / 3.0, 1.0 / 6.0 - 2e-3 / 3.0];
    let steps = format!(r#"[{{"inversion": {{"center": [{x}, {y}, {z}], "radius": 1}}}}]"#);
    let near = format!(r#"{unit}, "i": {{"type": "transform", "of": "b", "steps": {steps}}}"#);
    let found = report(&near);
    // A ball of diameter 1000 but for what five faces of the box are.
    assert!((found.volume / (std::f64::consts::PI / 6.0 * 1e9) - 1.0).abs() < 1e-7, "{}", found.volume);
    assert!(found.not_known.is_empty());
    // A picture has a coarser mesh where the right one has too many pieces.
    #[cfg(feature = "png")]
    is_drawn(build(&near).unwrap().item);
}

#[cfg(feature = "png")]
fn is_drawn(item: cyclide::model::Item) {
    let model = cyclide::model::Model { units: cyclide::model::Units::Millimetre, items: vec![item] };
    let options = cyclide_io::ExportOptions { max_pieces: Some(200_000), ..cyclide_io::ExportOptions::default() };
    let drawn = cyclide_io::formats::export(&model, cyclide_io::Format::Png, &options);
    assert!(drawn.is_ok_and(|picture| picture.bytes.len() > 1000));
}

#[test]
fn planes_agree_on_their_common_lines() {
    let text = planes(0.0).replace(r#""tu": [[[0.0, 0.0, 0.0]"#, r#""tu": [[[0.0, 0.1, 0.0]"#);
    let (reason, message) = refused(&format!(r#""g": {{"type": "cyclide-grid", {text}}}"#));
    assert!(
        reason.as_deref() == Some("not-concircular") && message.contains("must coincide with that of `st`"),
        "{message}"
    );
    let text = planes(0.0).replace(r#""st": [[[0.0, 0.0, 0.0], "#, r#""st": [["#);
    assert!(refused(&format!(r#""g": {{"type": "cyclide-grid", {text}}}"#)).1.contains("points along s"));
}

#[test]
fn whole_cyclides_close_and_their_skin_is_one_solid() {
    let whole = r#""w": {"type": "cyclide-grid", "whole": {"a": 4, "c": 1, "mu": [1.2, 1.5, 2], "segments": [6, 4]}, "cells": 2}"#;
    let found = report(whole);
    let cells = found.cells.unwrap();
    assert_eq!((found.blocks, cells.nodes), (48, 12 * 8 * 5));
    let skin =
        build(&format!(r#"{whole}, "skin": {{"type": "coordinate-surfaces", "of": "w", "outer": true}}"#)).unwrap();
    let [body] = skin.bodies.as_slice() else { panic!("{} bodies", skin.bodies.len()) };
    let volume: f64 = body.shells().map(cyclide::topology::Shell::volume).sum();
    assert!(body.voids.len() == 1 && (volume - found.volume).abs() < 1e-9 * volume);
    // An image has the cells of its object.
    let steps = r#"[{"scale": {"factor": 2}}]"#;
    let moved = format!(r#"{whole}, "m": {{"type": "transform", "of": "w", "steps": {steps}}}"#);
    let moved = report(&moved).cells.unwrap();
    assert!(moved.nodes == cells.nodes && (moved.shortest_side - 2.0 * cells.shortest_side).abs() < 1e-12);
    let falling = whole.replace("[1.2, 1.5, 2]", "[1.2, 1.7, 1.5]");
    assert_eq!(refused(&falling).0.as_deref(), Some("parameters-not-increasing"));
    let folded = whole.replace("[1.2, 1.5, 2]", "[0.5, 4.5]");
    assert_eq!(refused(&folded).0.as_deref(), Some("offset-not-regular"));
}

#[test]
fn layers_fold_nowhere() {
    let wall = r#""w": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}"#;
    let layers = |fields: &str| format!(r#"{wall}, "l": {{"type": "layers", "of": "w", {fields}}}"#);
    // To the nearest center of curvature it is mu - c = 1 inwards.
    assert_eq!(report(&layers(r#""first": -0.1, "growth": 1.5, "count": 4"#)).blocks, 64); // 0.81 together
    for fields in [r#""first": -0.1, "growth": 1.5, "count": 5"#, r#""distances": [-1.2, 0]"#] {
        let (reason, message) = refused(&layers(fields));
        assert_eq!(reason.as_deref(), Some("offset-not-regular"), "{message}");
        let field = if fields.contains("count") { "first" } else { "distances" };
        assert!(message.contains(field), "{message}");
    }
    assert_eq!(refused(&layers(r#""distances": [0, 0.2, 0.1]"#)).0.as_deref(), Some("parameters-not-increasing"));
    assert_eq!(refused(&layers(r#""first": 0, "count": 3"#)).0.as_deref(), Some("parameters-not-increasing"));
    assert_eq!(refused(&layers(r#""first": 1e300, "growth": 1e10, "count": 9"#)).0.as_deref(), Some("not-finite"));
}

#[test]
fn cells_have_a_law_that_fits() {
    let wall = |cells: &str| {
        format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 3, "mu": [0.5, 1]}}, "cells": {cells}}}"#)
    };
    let graded = wall(r#"[1, 1, {"count": 10, "law": "tanh", "first": 0.01, "fine": "both"}]"#);
    let rows = sample_cells(&build(&graded).unwrap()).unwrap();
    assert_eq!(rows.lines().count(), 1 + 16 * 4 * 11);
    // The first line across of the first block: the inner equator, from the radius 2.5 of the inner skin to 2.
    let first = rows.lines().skip(1).step_by(4).take(11);
    let across: Vec<f64> = first.map(|row| row.split(',').nth(4).unwrap().parse().unwrap()).collect();
    // The stretch is found to 1e-9 of the first cell.
    let wanted = [(0, 2.5), (1, 2.49), (5, 2.25), (9, 2.01), (10, 2.0)];
    assert!(wanted.iter().all(|(k, x)| (across[*k] - x).abs() < 1e-10), "{across:?}");
    for (cells, word) in [
        (r#"[1, 1, {"count": 4, "ratio": 1.2, "first": 0.1}]"#, "exactly one of"),
        (r#"[1, 1, {"count": 4, "law": "uniform", "ratio": 1.2}]"#, "exactly one of"),
        (r#"[1, 1, {"count": 4, "law": "tanh"}]"#, "exactly one of"),
        (r#"[1, 1, {"count": 4, "first": 0.6}]"#, "first cell"),
        (r#"[1, 1, {"count": 4, "law": "tanh", "first": 0.3}]"#, "first cell = 0.3"),
        (r#"[1, 1, {"count": 4, "ratio": 0}]"#, "ratio"),
        (r#"[1, 1, {"count": 0}]"#, "number of cells"),
        ("0", "w.cells: number of cells"),
        ("[1, 1]", "3 are needed"),
        ("-1", "a number of cells"),
        ("[4096, 4096, 2]", "grid of cells"),
    ] {
        let message = refused(&wall(cells)).1;
        assert!(message.contains(word), "{cells}: {message}");
    }
}

/// Of a horn the first mu is the base: along its outer part all of them are regular.
#[test]
fn horns_have_blocks_along_their_outer_part() {
    for (mu, kind) in [([0.3, 0.45], "horns"), ([0.3, 0.7], "a horn and a ring"), ([0.0, 0.3], "two arcs and a horn")] {
        let whole = format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 1, "c": 0.5, "mu": {mu:?}}}}}"#);
        let built = build(&whole).unwrap();
        for block in built.item.volumes() {
            assert_eq!(block.folds(), cyclide::volume::FoldVerdict::Regular, "{kind}");
            for (u, mu) in [0.0, 1.0].into_iter().zip(mu) {
                for at in [[0.1, 0.3, u], [0.6, 0.9, u], [1.0, 0.5, u]] {
                    let [x, y, z] = block.point(at).to_array();
                    let (b, left) = (0.75, x * x + y * y + z * z + 0.75 - mu * mu);
                    let right = 4.0 * (x - 0.5 * mu).powi(2) + 4.0 * b * y * y;
                    assert!((left * left - right).abs() < 1e-13, "{kind}: {left} {right}");
                }
            }
        }
        let skin = format!(r#"{whole}, "skin": {{"type": "coordinate-surfaces", "of": "w", "outer": true}}"#);
        let [body] = build(&skin).unwrap().bodies.try_into().unwrap();
        let volume: f64 = body.shells().map(cyclide::topology::Shell::volume).sum();
        assert!((volume - report(&whole).volume).abs() < 1e-8 * volume, "{kind}");
    }
}

#[test]
fn what_is_said_of_parallel_cyclides_is_said_of_mu() {
    let whole = |a: f64, c: f64, mu: [f64; 2]| {
        refused(&format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": {a}, "c": {c}, "mu": {mu:?}}}}}"#))
    };
    for ([a, c], mu, reason, words) in [
        ([4.0, 1.0], [0.5, 4.5], "offset-not-regular", "w.whole.mu[1]: mu = 4.5: between this value and mu = 0.5 "),
        ([1.0, 0.5], [0.3, 1.5], "offset-not-regular", "w.whole.mu[1]: mu = 1.5: between this value and mu = 0.3 "),
        ([3.0, 0.0], [0.0, 1.0], "offset-not-regular", "w.whole.mu[0]: mu = 0: between this value and mu = 1 "),
        ([3.0, 0.0], [2.0, 1.0], "parameters-not-increasing", "w.whole.mu[1]: "),
    ] {
        let (found, message) = whole(a, c, mu);
        assert!(found.as_deref() == Some(reason) && message.contains(words), "{message}");
        assert!(!message.contains("distance"), "{message}");
    }
}

#[test]
fn more_blocks_than_memory_holds_are_refused_before_they_are_made() {
    let ring = r#""r": {"type": "cyclide", "a": 4, "c": 1, "mu": 2, "segments": [64, 32]}"#;
    let layers = |fields: &str| format!(r#"{ring}, "l": {{"type": "layers", "of": "r", {fields}}}"#);
    let mu: Vec<f64> = (0..42).map(|k| 1.1 + 0.05 * f64::from(k)).collect();
    let many = [
        layers(r#""first": 1e-4, "count": 4096"#),
        layers(&format!(r#""distances": {:?}"#, (0..60).collect::<Vec<_>>())),
        format!(
            r#""w": {{"type": "cyclide-grid", "whole": {{"a": 4, "c": 1, "mu": {mu:?}, "segments": [700, 700]}}}}"#
        ),
    ];
    for (objects, needed) in many.iter().zip(["8388608", "120832", "2.01e7"]) {
        let (reason, message) = refused(objects);
        assert_eq!(reason.as_deref(), Some("too-many-pieces"), "{message}");
        assert!(message.contains(&format!("needs {needed} pieces, the limit is 100000")), "{message}");
    }
}

#[test]
fn numbers_that_ask_for_nothing_are_named() {
    let wall = r#""w": {"type": "cyclide", "a": 4, "c": 1, "mu": 2}"#;
    let none = refused(&format!(r#"{wall}, "l": {{"type": "layers", "of": "w", "first": 0.1, "count": 0}}"#));
    assert!(none.0.as_deref() == Some("parameter-out-of-range") && none.1.contains("l.count: 0 layers"), "{}", none.1);
    let one = r#""w": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}, "cells": [1, 1, {"count": 1, "first": 0.5}]}"#;
    assert!(refused(one).1.contains("a single cell is as long as its block"), "{}", refused(one).1);
    let twice = format!(
        r#"{wall}, "l": {{"type": "layers", "of": "w", "distances": [0, 0.1]}}, "s": {{"type": "coordinate-surfaces", "of": "l", "t": [0.2, 0.5, 0.2]}}"#
    );
    let (reason, message) = refused(&twice);
    assert!(
        reason.as_deref() == Some("parameters-not-increasing") && message.contains("s.t[2]: t[2] = 0.2 equals t[0]"),
        "{message}"
    );
    // Falling values are other surfaces: each of four rows round the tube twice.
    assert_eq!(build(&twice.replace("0.5, 0.2]", "0.1]")).unwrap().item.surfaces().len(), 8);
}

/// Cells whose ends are one point but for rounding are refused; inverted ones are told, with what helps.
#[test]
fn cells_are_there_and_inverted_ones_are_told() {
    let corners = "[[0,0,0], [6,1,-0.6], [-1,5,0.5], [0.5,-0.6,4.5]]";
    let block = |cells: &str| {
        format!(r#""b": {{"type": "cyclide-volume", "corners": {corners}, "inside": [1, 1.2, 0.8], "cells": {cells}}}"#)
    };
    let (reason, message) = refused(&block(r#"[2, 2, {"count": 20, "ratio": 10}]"#));
    assert_eq!(reason.as_deref(), Some("below-rounding-of-place"), "{message}");
    assert!(message.contains("b.cells[2]") && message.contains("cells are as short as"), "{message}");
    let reasons = |objects: &str| build(objects).unwrap().remarks.iter().map(|r| r.reason).collect::<Vec<_>>();
    assert!(reasons(&block(r#"[2, 2, {"count": 20, "ratio": 4}]"#)).is_empty());
    // Inverted a ninth of its size below a face the block is too round for cells of a third of it.
    let image = |cells: &str| {
        let steps = r#"[{"inversion": {"center": [2.7, 2.9, -0.5], "radius": 5}}]"#;
        format!(r#"{}, "i": {{"type": "transform", "of": "b", "steps": {steps}}}"#, block(cells))
    };
    let coarse = build(&image("[3, 4, 6]")).unwrap();
    let told = coarse.remarks.iter().find(|remark| remark.reason == "cells-inverted").unwrap();
    assert!(told.place.as_deref() == Some("objects.i.of") && told.message.contains("use more cells"), "{told:?}");
    let inverted = report(&image("[3, 4, 6]")).cells.unwrap().inverted;
    assert!(inverted > 0 && told.message.starts_with(&format!("{inverted} of 72 cells are inverted")), "{told:?}");
    assert!(!reasons(&image("[24, 24, 24]")).contains(&"cells-inverted"));
    let folded = r#""f": {"type": "cyclide-volume", "corners": [[0,0,0], [2,0,0], [0,3,0], [0,0,1]], "frame": [[0,1,0], [0,0,1]], "cells": 3}"#;
    let built = build(folded).unwrap();
    let told = built.remarks.iter().find(|remark| remark.reason == "cells-inverted").unwrap();
    assert!(told.message.contains("the block folds there"), "{told:?}");
}

/// Beside an axis far from the origin cells are as short as rounding: more of them help nothing, and it is said.
#[test]
fn cells_that_rounding_inverts_say_so() {
    let at = |x: f64, y: f64, z: f64| format!("[{}, {}, {}]", x + 1e6, y + 1e6, z + 1e6);
    let (c, s) = 1.0_f64.sin_cos();
    let floor = |z: f64| [at(1.0, 0.0, z), at(0.0, 0.0, z), at(s, c, z), at(0.0, 0.0, z)].join(", ");
    let cells = r#"[{"count": 30, "first": 1e-7, "fine": "end"}, 1000, 1]"#;
    let wedge =
        format!(r#""b": {{"type": "cyclide-volume", "corners": [{}, {}], "cells": {cells}}}"#, floor(0.0), floor(1.0));
    let built = build(&wedge).unwrap();
    let told = built.remarks.iter().find(|remark| remark.reason == "cells-inverted").unwrap();
    assert!(told.message.contains("as short as the rounding of their coordinates; use fewer cells"), "{told:?}");
    let lines = |s: &str| format!(r#"{wedge}, "x": {{"type": "coordinate-surfaces", "of": "b", "s": {s}}}"#);
    let built = build(&lines("[0, 1]")).unwrap();
    assert!(built.bodies.len() == 1 && built.remarks.iter().any(|remark| remark.reason == "no-effect"));
    let (reason, message) = refused(&lines("[1]"));
    assert_eq!(reason.as_deref(), Some("collapsed-side"), "{message}");
    assert!(
        message.contains("x.s[0]") && message.contains("s = 1 is not a surface but a line or a point of every block"),
        "{message}"
    );
}

/// The table of the cells holds the nodes of the grid, bit for bit: those that blocks share are one.
#[test]
fn the_table_of_cells_holds_the_nodes() {
    let ring = r#""w": {"type": "cyclide-grid", "whole": {"a": 4, "c": 1, "mu": [1.3, 1.6, 2], "segments": [6, 4]}, "cells": [3, 3, 2]}"#;
    let table = sample_cells(&build(ring).unwrap()).unwrap();
    let points: std::collections::BTreeSet<Vec<&str>> =
        table.lines().skip(1).map(|row| row.split(',').skip(4).take(3).collect()).collect();
    let cells = report(ring).cells.unwrap();
    assert_eq!(points.len(), cells.nodes);
    // As many rows as nodes of all blocks.
    assert_eq!(table.lines().count() - 1, 6 * 4 * 2 * 4 * 4 * 3);
}

/// The place of a fold is among those whose Jacobian is reported.
#[test]
fn the_range_of_the_jacobian_has_the_fold() {
    let found = report(r#""b": {"type": "cyclide-volume", "corners": [[0,0,0], [1,0,0], [2,0,0], [0,0,1]]}"#);
    assert!(matches!(found.folds, cyclide_io::report::FoldsReport::Folded { .. }), "{:?}", found.folds);
    assert!(found.jacobian.min <= 1e-12, "{:?}", found.jacobian);
}

#[test]
fn what_is_wrong_with_a_block_is_said_of_its_field() {
    let block = |fields: &str| {
        format!(r#""b": {{"type": "cyclide-volume", "corners": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]{fields}}}"#)
    };
    let ring = r#""w": {"type": "cyclide", "a": 3, "c": 1, "mu": 1.5}"#;
    let layers = |fields: &str| format!(r#"{ring}, "l": {{"type": "layers", "of": "w", {fields}}}"#);
    let inverted = |center: &str| {
        let steps = format!(r#"[{{"inversion": {{"center": {center}, "radius": 1}}}}]"#);
        format!(r#"{}, "i": {{"type": "transform", "of": "b", "steps": {steps}}}"#, block(""))
    };
    for (objects, reason, words) in [
        (
            block(r#", "inside": [1, 0, 1]"#),
            "parameter-out-of-range",
            "b.inside[1]: the weights that determine the last corner must be positive, and 0 is not",
        ),
        (block(r#", "inside": [1, 2, -1]"#), "parameter-out-of-range", "b.inside[2]: "),
        (
            block(r#", "inside": [1e308, 1e308, 1]"#),
            "parameter-out-of-range",
            "b.inside: the sum of the weights is too large",
        ),
        (
            block(r#", "frame": [[0,0,0], [0,1,0]]"#),
            "frame-not-orthonormal",
            "b.frame: the directions of the frame must not be zero",
        ),
        (block(r#", "frame": [[1,0,0], [0.1,1,0]]"#), "frame-not-orthonormal", "must be perpendicular"),
        (
            layers(r#""distances": [0, 0.2, 0.1]"#),
            "parameters-not-increasing",
            "l.distances[2]: 0.1 does not exceed 0.2",
        ),
        (
            layers(r#""first": 0, "count": 3"#),
            "parameters-not-increasing",
            "l.first: the height of a layer must not be 0",
        ),
        (
            layers(r#""first": 0.1, "growth": 1e-9, "count": 3"#),
            "parameters-not-increasing",
            "l.growth: layer 2 is too thin",
        ),
        (layers(r#""distances": [0, 1e-17, 0.2]"#), "below-rounding-of-place", "the layer has size 1e-17"),
        (layers(r#""first": 1e-12, "count": 2"#), "below-rounding-of-place", "l.first: "),
        (
            inverted("[0.4, 0.5, 0.5]"),
            "volume-through-infinity",
            "the center of the inversion is in the block, or closer",
        ),
        (inverted("[0.4, 0.5, -1e-7]"), "volume-through-infinity", "near s = 0.4, t = 0.49999, u = "),
    ] {
        let (found, message) = refused(&objects);
        assert!(found.as_deref() == Some(reason) && message.contains(words), "{message}");
    }
    let (_, message) = refused(&block(r#", "cells": [2, 2, {"count": 2, "first": 0.1, "fine": "both"}]"#));
    assert!(message.contains("b.cells[2]: two cells refined at both ends are equal"), "{message}");
    let solid = r#""o": {"type": "offset", "of": "w", "distance": 0.1, "thick": true}, "l": {"type": "layers", "of": "o", "distances": [0, 0.1]}"#;
    assert!(refused(&format!("{ring}, {solid}")).1.contains("the offset itself has layers without `thick`"));
    let huge =
        report(r#""b": {"type": "cyclide-volume", "corners": [[0,0,0], [1e120,0,0], [0,1e120,0], [0,0,1e120]]}"#);
    assert!(huge.not_known.iter().any(|reason| reason.contains("volume = ")), "{:?}", huge.not_known);
    let flat = refused(r#""b": {"type": "cyclide-volume", "corners": [[0,0,0], [1,0,0], [0,1,0], [1,1,1e-9]]}"#);
    assert!(flat.1.contains("nearly on one circle"), "{}", flat.1);
}

/// Wedges and parts of balls by their corners go into STEP, and a slice of a pie needs no frame.
#[test]
fn slices_of_pies_and_parts_of_balls_are_solids() {
    let pie = "[[1,0,0],[0,0,0],[0,1,0],[0,0,0],[1,0,1],[0,0,1],[0,1,1],[0,0,1]]";
    let ball = "[[1,0,0],[0,0,0],[0,1,0],[0,0,0],[0,0,1],[0,0,0],[0,0,1],[0,0,0]]";
    let quarter = std::f64::consts::FRAC_PI_4;
    for (corners, frame, volume, points) in [
        (pie, r#", "frame": [[-1,0,0], [0,1,0]]"#, quarter, 2),
        (pie, "", quarter, 2),
        (ball, r#", "frame": [[-1,0,0], [0,1,0]]"#, quarter * 2.0 / 3.0, 5),
    ] {
        let block = format!(r#""b": {{"type": "cyclide-volume", "corners": {corners}, "cells": 4{frame}}}"#);
        let built = build(&block).unwrap();
        assert!(built.remarks.is_empty() && built.bodies[0].is_solid(), "{:?}", built.remarks);
        let found = report(&block);
        assert!((found.volume - volume).abs() < 1e-13 && found.point_sides == points, "{found:?}");
        assert_eq!(found.cells.unwrap().inverted, 0);
        let model = cyclide::model::Model { units: cyclide::model::Units::Millimetre, items: vec![built.item] };
        let exporter = cyclide_io::Exporter::new(&model).unwrap();
        for format in [cyclide_io::Format::Step, cyclide_io::Format::Stl, cyclide_io::Format::Vtu] {
            let file = exporter.export(format, &cyclide_io::ExportOptions::default()).unwrap();
            assert!(exporter.check("b".as_ref(), format, &file).is_ok());
        }
    }
}

/// A frame far from the sides: what folds has no outer boundary, and no object is empty.
#[test]
fn the_outer_boundary_of_a_fold_is_refused() {
    let corners = "[[0,0,0], [2,0,0], [0,3,0], [2,3,0], [0,0,1], [2,0,1], [0,3,1]]";
    let block = format!(r#""b": {{"type": "cyclide-volume", "corners": {corners}, "frame": [[0,1,0], [0,0,1]]}}"#);
    let (reason, message) =
        refused(&format!(r#"{block}, "o": {{"type": "coordinate-surfaces", "of": "b", "outer": true}}"#));
    assert!(
        reason.as_deref() == Some("folded-volume") && message.contains("block 0: lines of the volume run backwards"),
        "{message}"
    );
}

/// An eighth of a shell: what is one point at the pole is left out, and told.
#[test]
fn sides_of_one_point_are_counted_and_not_measured() {
    let pole = r#""p": {"type": "cyclide-patch", "corners": [[1,0,0], [0,1,0], [0,0,1], [0,0,1]], "frame": [[0,1,0], [0,0,1]]}"#;
    let found = report(&format!(r#"{pole}, "w": {{"type": "layers", "of": "p", "distances": [0, 0.1], "cells": 4}}"#));
    assert!(found.point_sides == 2 && (found.shortest_side - 0.1).abs() < 1e-14, "{found:?}");
    // Beside the pole a line round it, an eighth of the range away, is a hundredth of one across the shell, or a line along a meridian.
    assert!(found.aspect_ratio < 100.0, "{}", found.aspect_ratio);
    let cells = found.cells.unwrap();
    assert_eq!((cells.nodes, cells.inverted, cells.collapsed), (105, 0, 16));
}

/// Surfaces run on from block to block: skins of a ring are closed, a face between two blocks is there once.
#[test]
fn coordinate_surfaces_are_sewn() {
    let whole = r#""w": {"type": "cyclide-grid", "whole": {"a": 4, "mu": [1, 1.5, 2], "segments": [8, 6]}}"#;
    let surfaces = |fields: &str| {
        let made = build(&format!(r#"{whole}, "x": {{"type": "coordinate-surfaces", "of": "w", {fields}}}"#)).unwrap();
        (made.bodies, made.provenance.names)
    };
    let (bodies, names) = surfaces(r#""u": [0, 1]"#);
    assert_eq!(names, ["u=0 0", "u=0 1", "u=1"]);
    for (body, mu) in bodies.iter().zip([1.0_f64, 1.5, 2.0]) {
        // Pappus, to the quadrature.
        let volume = 2.0 * std::f64::consts::PI.powi(2) * 4.0 * mu * mu;
        assert!(body.is_solid() && body.outer.faces().len() == 48);
        assert!((body.outer.volume() / volume - 1.0).abs() < 1e-9, "{mu}: {}", body.outer.volume());
    }
    // Eight walls across the tube, each a ring of twelve faces: s = 0 and s = 1 of neighbors are one.
    for fields in [r#""s": [0]"#, r#""s": [0, 1]"#, r#""s": [0.3]"#] {
        let (bodies, names) = surfaces(fields);
        assert_eq!((bodies.len(), names.len()), (8, 8), "{fields}");
        for body in &bodies {
            let area = std::f64::consts::PI * (2.0 * 2.0 - 1.0);
            assert!(body.outer.faces().len() == 12 && (body.outer.area() / area - 1.0).abs() < 1e-9, "{fields}");
        }
    }
    // A single patch is one, of which there are offsets.
    let block = block(&turned_box([1.0, 2.0, 3.0], [0.0; 3], 7), "");
    let inside = format!(r#"{block}, "m": {{"type": "coordinate-surfaces", "of": "b", "s": [0.25], "u": [1, 0]}}"#);
    let made = build(&inside).unwrap();
    assert_eq!(made.provenance.names, ["s=0.25", "u=1", "u=0"]);
    assert!(made.item.surfaces().iter().all(|surface| matches!(surface, cyclide::model::SurfaceObject::Patch(_))));
    let steps = r#"[{"translation": [1, 0, 0]}]"#;
    let image = build(&format!(r#"{inside}, "i": {{"type": "transform", "of": "m", "steps": {steps}}}"#)).unwrap();
    assert_eq!(image.provenance.names, made.provenance.names);
    let offset = build(&format!(r#"{inside}, "o": {{"type": "offset", "of": "m", "distance": 0.5}}"#)).unwrap();
    assert_eq!(offset.item.surfaces().len(), 3);
}

/// Meridians of a wedge meet in its axis and are not sewn there; what is a line is left out.
#[test]
fn coordinate_surfaces_of_wedges_end_at_the_axis() {
    // A quarter of a cylinder of two wedges: s from the axis outwards, t round it.
    let radii = [0.0, 1.0];
    let place = |s: usize, t: usize| {
        let (sin, cos) = (std::f64::consts::FRAC_PI_4 * t as f64).sin_cos();
        [radii[s] * cos, radii[s] * sin]
    };
    let at = |s: usize, t: usize, u: usize| {
        let [x, y] = place(s, t);
        [x, y, u as f64]
    };
    let st: Vec<Vec<[f64; 3]>> = (0..3).map(|t| (0..2).map(|s| at(s, t, 0)).collect()).collect();
    let su: Vec<Vec<[f64; 3]>> = (0..2).map(|u| (0..2).map(|s| at(s, 0, u)).collect()).collect();
    let tu: Vec<Vec<[f64; 3]>> = (0..2).map(|u| (0..3).map(|t| at(0, t, u)).collect()).collect();
    let planes = format!(r#"{{"st": {st:?}, "su": {su:?}, "tu": {tu:?}}}"#);
    let grid = format!(r#""g": {{"type": "cyclide-grid", "planes": {planes}}}"#);
    let (reason, message) = refused(&grid);
    // Grids from planes have no sides of one point; wedges come from layers over patches with a pole.
    assert_eq!(reason.as_deref(), Some("coincident-points"), "{message}");
    let pole = r#""p": {"type": "cyclide-patch", "corners": [[1,0,0], [0,1,0], [0,0,1], [0,0,1]], "frame": [[0,1,0], [0,0,1]]}"#;
    let layers = format!(r#"{pole}, "l": {{"type": "layers", "of": "p", "distances": [0, 1, 2]}}"#);
    let walls = |fields: &str| {
        build(&format!(r#"{layers}, "x": {{"type": "coordinate-surfaces", "of": "l", {fields}}}"#)).unwrap().bodies
    };
    // Both sides of the octant, in two layers each, meet along the pole's axis.
    let sides = walls(r#""s": [0, 1]"#);
    assert!(sides.len() == 2 && sides.iter().all(|side| side.outer.faces().len() == 2));
    let area = std::f64::consts::FRAC_PI_4 * (9.0 - 1.0);
    assert!(sides.iter().all(|side| (side.outer.area() - area).abs() < 1e-12));
    // At the pole there is only the side at the equator: t = 1 is a line.
    assert_eq!(walls(r#""t": [0, 1]"#).len(), 1);
}

/// The law that is found for a first cell is told, and so is what it is measured on.
#[test]
fn laws_of_first_cells_are_told() {
    let block = block(
        &turned_box([1.0, 2.0, 3.0], [0.0; 3], 7),
        r#", "cells": [3, {"count": 3, "first": 0.2}, {"count": 4, "law": "tanh", "first": 0.1, "fine": "both"}]"#,
    );
    let cells = report(&block).cells.unwrap();
    let [s, t, u] = &cells.laws[..] else { panic!("{:?}", cells.laws) };
    assert_eq!((s.law, s.ratio, s.fine), ("uniform", None, None));
    // 1 + r + r² = 10 of a first cell that is a tenth.
    let ratio = t.ratio.unwrap();
    assert!((1.0 + ratio + ratio * ratio - 10.0).abs() < 1e-8 && t.fine == Some("start"), "{ratio}");
    assert!(u.law == "tanh" && u.stretch.is_some_and(|stretch| stretch > 0.0) && u.fine == Some("both"));
    // At the pole of a sphere sides round it are one point: the first cell is that of the others.
    let pole = r#""p": {"type": "cyclide-patch", "corners": [[1,0,0], [0,1,0], [0,0,1], [0,0,1]], "frame": [[0,1,0], [0,0,1]]}"#;
    let wedge = |first: f64| {
        format!(
            r#"{pole}, "l": {{"type": "layers", "of": "p", "distances": [0, 1], "cells": [{{"count": 4, "first": {first}}}, 1, 1]}}"#
        )
    };
    let rows = sample_cells(&build(&wedge(0.1)).unwrap()).unwrap();
    let nodes: Vec<Vec<f64>> =
        rows.lines().skip(1).map(|row| row.split(',').filter_map(|x| x.parse().ok()).collect()).collect();
    // Of two arcs about the axis of the equator, of radius 1 and 2, the outer one is the longer: its first cell is 0.1 long.
    let header: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|word| *word == name).unwrap();
    let [x, y, z] = ["x", "y", "z"].map(column);
    let outer = nodes.iter().filter(|row| row[z].abs() < 1e-12 && row[x].hypot(row[y]) > 1.5);
    let angles: Vec<f64> = outer.map(|row| row[y].atan2(row[x])).collect();
    assert!(angles.len() == 5 && (2.0 * (angles[1] - angles[0]) - 0.1).abs() < 1e-9, "{angles:?}");
    assert!(refused(&wedge(2.0)).1.contains("first cell"));
}
