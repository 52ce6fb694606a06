use super::*;
use cyclide::{Point3, surface::GridCell};

fn read(text: &str) -> Result<ObjGrid, String> {
    read_quad_grid("m.obj", text.as_bytes()).map_err(|d| d.to_string())
}

/// Text of a grid of `m` times `n` quads, open or closed, at the points `(i, j, 0)`.
fn text([m, n]: [usize; 2], closed: [bool; 2], faces: impl Fn(usize, usize) -> [usize; 4]) -> String {
    let size = [m + usize::from(!closed[0]), n + usize::from(!closed[1])];
    let number = |i: usize, j: usize| 1 + i % size[0] + (j % size[1]) * size[0];
    let mut text = String::new();
    for k in 0..size[0] * size[1] {
        text += &format!("v {} {} 0\n", k % size[0], k / size[0]);
    }
    for j in 0..n {
        for i in 0..m {
            let around = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            let [a, b, c, d] = faces(i, j).map(|k| around[k]);
            text += &format!("f {a} {b} {c} {d}\n");
        }
    }
    text
}

fn straight(_: usize, _: usize) -> [usize; 4] {
    [0, 1, 2, 3]
}

#[test]
fn all_topologies_keep_the_order_of_their_points() {
    for (size, closed) in [
        ([3, 2], [false; 2]),
        ([1, 1], [false; 2]),
        ([4, 2], [true, false]),
        ([2, 3], [false, true]),
        ([3, 5], [true; 2]),
    ] {
        let read = read(&text(size, closed, straight)).unwrap();
        assert_eq!((read.grid.quads(), read.grid.closed()), (size, closed));
        let in_order = (1..=read.grid.points().len()).collect::<Vec<_>>();
        assert_eq!((read.numbers, read.unused), (in_order, vec![]));
    }
}

#[test]
fn the_first_face_sets_the_directions_whatever_the_others_do() {
    // Every face starts elsewhere and some are turned over.
    let mixed = |i: usize, j: usize| {
        let k = i + 2 * j;
        let order = [k % 4, (k + 1) % 4, (k + 2) % 4, (k + 3) % 4];
        if (i + j) % 2 == 1 { [order[3], order[2], order[1], order[0]] } else { order }
    };
    let [mixed, same] = [read(&text([3, 3], [false; 2], mixed)), read(&text([3, 3], [false; 2], straight))];
    let (mixed, same) = (mixed.unwrap(), same.unwrap());
    assert_eq!((&mixed.grid, &mixed.numbers), (&same.grid, &same.numbers));
    assert!(!mixed.mended.turned.is_empty() && same.mended.turned.is_empty());
    // The last face of the file first, beginning at its second corner: s runs up, t to the left.
    let straight = text([3, 2], [false; 2], straight);
    let mut lines: Vec<&str> = straight.lines().collect();
    lines.pop();
    lines.insert(12, "f 8 12 11 7");
    let turned = read(&lines.join("\n")).unwrap();
    assert_eq!(turned.grid.size(), [3, 4]);
    assert_eq!(turned.grid.point(0, 0), Point3::new(3.0, 0.0, 0.0));
    assert_eq!(turned.grid.point(2, 0), Point3::new(3.0, 2.0, 0.0));
    assert_eq!(turned.grid.point(0, 3), Point3::new(0.0, 0.0, 0.0));
}

#[test]
fn every_form_of_a_line_is_read() {
    let text = "# roof\r\nmtllib a.mtl\no roof\nv 0 0 0 1\nv 1 0 0 # corner\nv 9 9 9\nv 1 1 0.5 0.1 0.2 0.3\n\
                vn 0 0 1\nvt 0 0\nv 0 1 -1e-1\ns off\nf 1/1 2//1 \\\n -2/1/1 5\n";
    let read = read(text).unwrap();
    assert_eq!(read.numbers, [1, 2, 5, 4]);
    assert_eq!(read.unused, [3]);
    assert_eq!(read.grid.point(1, 1), Point3::new(1.0, 1.0, 0.5));
    assert_eq!(read.grid.point(0, 1), Point3::new(0.0, 1.0, -0.1));
}

#[test]
fn refusals_name_line_and_reason() {
    let four = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let six = format!("{four}v 2 0 0\nv 2 1 0\n");
    // Three quads about point 1, and six points around.
    let tripod = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 1 0\nv -1 0 0\nv 1 -1 0\nf 1 2 3 4\nf 1 4 5 6\nf 1 6 7 2\n";
    let shifted = {
        // A torus of 3 x 3 whose last row is joined one place on.
        let place = |i: usize, j: usize| 1 + (i + usize::from(j == 3)) % 3 + (j % 3) * 3;
        let mut text = (0..9).map(|k| format!("v {} {} 0\n", k % 3, k / 3)).collect::<String>();
        for (i, j) in (0..9).map(|k| (k % 3, k / 3)) {
            text += &format!("f {} {} {} {}\n", place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1));
        }
        text
    };
    let mobius = {
        let mut text = (0..10).map(|k| format!("v {k} 0 {}\n", k % 2)).collect::<String>();
        for i in 0..5 {
            let (a, b) = if i == 4 { (2, 1) } else { (2 * i + 3, 2 * i + 4) };
            text += &format!("f {} {a} {b} {}\n", 2 * i + 1, 2 * i + 2);
        }
        text
    };
    let cases = [
        (
            format!("{four}f 1 2 3\n"),
            "m.obj:5:1: a face of 3 corners, not a quad: a `principal-grid` computes a grid of quads on a mesh of any polygons [not-a-quad]",
        ),
        (format!("{four}f 1 2 3 1\n"), "m.obj:5:1: the face contains a point twice [not-a-quad]"),
        (format!("{four}f 1 2 3 5\n"), "m.obj:5:9: there is no such point: the file has only 4"),
        (format!("{four}f 1 2 3 -5\n"), "m.obj:5:9: there is no such point: only 4 precede this line"),
        (format!("{four}f 0 2 3 4\n"), "m.obj:5:3: points are numbered from 1"),
        (format!("{four}f 1 x 3 4\n"), "m.obj:5:5: `x` does not start with"),
        (format!("{four}f 1 2\n"), "m.obj:5:1: a face needs at least three corners"),
        ("v 0 0\n".to_owned(), "m.obj:1:1: a point needs three coordinates"),
        ("v 0 0 nan\n".to_owned(), "m.obj:1:7: `nan` is not a finite number"),
        ("v 0 0 1,5\n".to_owned(), "m.obj:1:7: `1,5` is not a number"),
        ("v 0 0 0\n".to_owned(), "m.obj:1:1: the file contains no faces"),
        (
            format!("{six}f 1 2 3 4\nf 2 5 6 3\nf 2 3 4 5\n"),
            "m.obj:9:1: the edge between points 2 and 3 belongs to a third face",
        ),
        (
            format!("{four}{four}f 1 2 3 4\nf 5 6 7 8\n"),
            "m.obj:10:1: this face has the same vertices as the one in line 9",
        ),
        (
            format!("{four}v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nf 1 2 3 4\nf 5 6 7 8\n"),
            "m.obj:10:1: this face is not connected to the first one",
        ),
        (
            tripod.to_owned(),
            "m.obj:1:1: point 1 is an inner vertex of 3 quads: inner vertices of a grid have 4 [extraordinary-vertex]",
        ),
        (shifted, "the rows through this face do not close"),
        (mobius, "[not-a-grid]"),
        (format!("{}f 1 2 3 4\n", four.replace("v 1 1 0", "v 1 1e200 0")), "m.obj:1:1: coordinate = "),
    ];
    for (text, expected) in cases {
        let message = read(&text).unwrap_err();
        assert!(message.contains(expected), "{message}\nexpected {expected}");
    }
}

#[test]
fn a_border_may_run_in_steps() {
    let full = text([2, 2], [false; 2], straight);
    let without_last: Vec<&str> = full.lines().take(9 + 3).collect();
    let found = read(&without_last.join("\n")).unwrap();
    assert_eq!((found.grid.size(), found.grid.cell(1, 1)), ([3, 3], GridCell::Outside));
    assert_eq!((&found.numbers[..], &found.unused[..]), (&[1, 2, 3, 4, 5, 6, 7, 8, 0][..], &[9][..]));
    // A hole of four quads, whose point in the middle no face uses.
    let full = text([4, 4], [false; 2], straight);
    let hole = [5, 6, 9, 10].map(|quad| 25 + quad);
    let ring: Vec<&str> = full.lines().enumerate().filter(|(k, _)| !hole.contains(k)).map(|(_, line)| line).collect();
    let message = read(&ring.join("\n")).unwrap_err();
    assert!(message.contains("the mesh has a hole") && message.contains("[cells-unfit]"), "{message}");
}

#[test]
fn a_ramp_that_lies_over_itself_is_no_grid() {
    // Quads round a corner and on, more than a turn, over where they began.
    let ring = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)];
    let mut lines: (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
    let mut numbers = std::collections::HashMap::new();
    for (k, (i, j)) in ring.into_iter().enumerate() {
        let mut number = |i: i32, j: i32| {
            // The last quad and the side by which it is reached are one floor up.
            let floor = i32::from(k == 8 || (k == 7 && j == 1));
            *numbers.entry((i, j, floor)).or_insert_with(|| {
                lines.0.push(format!("v {i} {j} {floor}"));
                lines.0.len()
            })
        };
        let face = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
        lines.1.push(format!("f {} {} {} {}", face[0], face[1], face[2], face[3]));
    }
    let message = read(&[lines.0, lines.1].concat().join("\n")).unwrap_err();
    assert!(message.contains("[not-a-grid]") && message.contains("overlaps itself"), "{message}");
}

#[test]
fn lone_carriage_returns_end_lines() {
    let plain = text([3, 2], [false; 2], straight);
    assert_eq!(read(&plain.replace('\n', "\r")).unwrap(), read(&plain).unwrap());
    assert!(read("v 0 0 0\rv 1 0 x\r").unwrap_err().starts_with("m.obj:2:7: `x` is not a number"));
}

#[test]
fn lines_of_any_length_are_refused_and_quoted_in_part() {
    for (text, message) in [
        (format!("v 0 0 {}", "1".repeat(10_000_000)), "m.obj:1:1: the line has more than 65536 bytes"),
        ("f 1 2 3 \\\n".repeat(100_000), "m.obj:1:1: the line has more than 65536 bytes"),
        (format!("v 0 0 {}x", "1".repeat(10_000)), "m.obj:1:7: `1111"),
        (format!("f {} 1 2", "x".repeat(10_000)), "m.obj:1:3: `xxxx"),
    ] {
        let error = read(&text).unwrap_err();
        assert!(error.starts_with(message) && error.len() < 500, "{error}");
    }
}

/// Sectors of `k` x `k` quads round one vertex, in a plane.
fn sectors(n: usize, k: usize) -> String {
    let (mut points, mut faces) = (Vec::<[i64; 2]>::new(), String::new());
    for q in 0..n * k * k {
        let (i, a, b) = (q / (k * k), q % k, q / k % k);
        faces.push('f');
        for (a, b) in [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)] {
            let turn = |step: usize| std::f64::consts::TAU * (i + step) as f64 / n as f64;
            let at = [f64::cos, f64::sin].map(|of| a as f64 * of(turn(0)) + b as f64 * of(turn(1)));
            let rounded = at.map(|x| (1e6 * x).round() as i64);
            let number = points.iter().position(|p| *p == rounded).unwrap_or_else(|| {
                points.push(rounded);
                points.len() - 1
            });
            faces += &format!(" {}", number + 1);
        }
        faces.push('\n');
    }
    points.iter().map(|[x, y]| format!("v {} {} 0\n", *x as f64 / 1e6, *y as f64 / 1e6)).collect::<String>() + &faces
}

#[test]
fn extraordinary_vertices_cut_a_mesh_into_grids() {
    for n in [3, 5, 6] {
        match read_quads("m.obj", sectors(n, 3).as_bytes()) {
            Ok(ObjQuads::Layout(read)) => {
                assert_eq!((read.layout.pieces().len(), read.layout.round()[0].vertex), (n, 0));
                assert!(read.unused.is_empty());
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(matches!(read_quads("m.obj", sectors(4, 3).as_bytes()), Ok(ObjQuads::Grid(_))));
    // A point that no face uses; the numbers of the others stay.
    let spare = "v 9 9 9\n".to_owned() + &sectors(5, 2);
    let shifted: String = spare
        .lines()
        .map(|line| match line.strip_prefix("f ") {
            Some(corners) => {
                let numbers = corners.split_whitespace().map(|k| k.parse::<usize>().unwrap() + 1);
                format!("f {}\n", numbers.map(|k| k.to_string()).collect::<Vec<_>>().join(" "))
            }
            None => format!("{line}\n"),
        })
        .collect();
    match read_quads("m.obj", shifted.as_bytes()) {
        Ok(ObjQuads::Layout(read)) => assert_eq!((&read.unused[..], read.layout.round()[0].vertex), (&[1][..], 1)),
        other => panic!("{other:?}"),
    }
    // Its quads reach the border.
    let message = read_quads("m.obj", sectors(5, 1).as_bytes()).unwrap_err().to_string();
    assert!(
        message.contains(
            "m.obj:1:1: point 1 is an extraordinary vertex (an inner vertex without four quads) whose quads reach"
        ),
        "{message}"
    );
    assert!(message.contains("[extraordinary-vertex]"), "{message}");
}
