//! Meshes for the tests.

use cyclide::{Point3, Vec3};
use std::collections::HashMap;
use std::f64::consts::TAU;

pub(crate) type Mesh = (Vec<Point3>, Vec<[usize; 3]>);

pub(crate) fn icosahedron() -> Mesh {
    let g = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([Vec3::new(0.0, a, b), Vec3::new(a, b, 0.0), Vec3::new(b, 0.0, a)]);
    }
    let points: Vec<Point3> = points.into_iter().map(|v| Point3::ORIGIN + v.unit().unwrap()).collect();
    let edge = |a: usize, b: usize| (points[a].distance(points[b]) - 2.0 / (g * g + 1.0).sqrt()).abs() < 1e-9;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if edge(a, b) && edge(b, c) && edge(c, a) {
                    let [p, q, r] = [a, b, c].map(|i| points[i].to_vec());
                    triangles.push(if p.dot(q.cross(r)) > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    (points, triangles)
}

/// Each triangle in four, the new vertices moved by `place`.
pub(crate) fn quartered((mut points, triangles): Mesh, place: impl Fn(Point3) -> Point3) -> Mesh {
    let mut middles = HashMap::new();
    let mut middle = |a: usize, b: usize| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            points.push(place(points[a].midpoint(points[b])));
            points.len() - 1
        })
    };
    let mut out = Vec::new();
    for [a, b, c] in triangles {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        out.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    (points, out)
}

pub(crate) fn on_sphere(p: Point3) -> Point3 {
    Point3::ORIGIN + p.to_vec().unit().unwrap()
}

pub(crate) fn icosphere() -> Mesh {
    quartered(icosahedron(), on_sphere)
}

/// An icosphere of 320 triangles whose radius waves.
pub(crate) fn bumpy() -> Mesh {
    let (points, triangles) = quartered(icosphere(), on_sphere);
    let wave = |p: Point3| 1.0 + 0.2 * (3.0 * p.x).sin() * (4.0 * p.y + 1.0).cos() + 0.1 * (5.0 * p.z).sin();
    (points.into_iter().map(|p| Point3::ORIGIN + p.to_vec() * wave(p)).collect(), triangles)
}

/// The torus of radii 1 and 0.4, `m` vertices round the axis and `n` round the tube.
pub(crate) fn torus(m: usize, n: usize) -> Mesh {
    let at = |i: usize, j: usize| {
        let (u, v) = (TAU * i as f64 / m as f64, TAU * j as f64 / n as f64);
        let r = 1.0 + 0.4 * v.cos();
        Point3::new(r * u.cos(), r * u.sin(), 0.4 * v.sin())
    };
    let points = (0..m * n).map(|k| at(k / n, k % n)).collect();
    let index = |i: usize, j: usize| (i % m) * n + j % n;
    let quads = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    let triangles = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    (points, triangles.collect())
}

/// A flat disc: the center and `n` points of the unit circle.
pub(crate) fn disc(n: usize) -> Mesh {
    let circle = (0..n).map(|k| {
        let a = TAU * k as f64 / n as f64;
        Point3::new(a.cos(), a.sin(), 0.0)
    });
    (circle.chain([Point3::ORIGIN]).collect(), (0..n).map(|k| [n, k, (k + 1) % n]).collect())
}

/// A square of `n` by `n` cells on the graph of a function.
pub(crate) fn graph(n: usize, height: impl Fn(f64, f64) -> f64) -> Mesh {
    let points = (0..=n).flat_map(|i| (0..=n).map(move |j| [i, j].map(|k| k as f64 / n as f64)));
    let points = points.map(|[x, y]| Point3::new(x, y, height(x, y))).collect();
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| i * (n + 1) + j));
    (points, cells.flat_map(|a| [[a, a + n + 1, a + n + 2], [a, a + n + 2, a + 1]]).collect())
}

pub(crate) fn cube() -> Mesh {
    let points = (0..8_i32).map(|k| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)));
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (points.collect(), quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// A closed cylinder of radius 1 and height 1: two discs of `n` triangles and `2 n` between them.
pub(crate) fn cylinder(n: usize) -> Mesh {
    let ring = |z: f64| {
        (0..n).map(move |k| {
            let a = TAU * k as f64 / n as f64;
            Point3::new(a.cos(), a.sin(), z)
        })
    };
    let points = ring(0.0).chain(ring(1.0)).chain([Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0)]).collect();
    let triangles = (0..n).flat_map(|k| {
        let l = (k + 1) % n;
        [[k, l, n + l], [k, n + l, n + k], [2 * n, l, k], [2 * n + 1, n + k, n + l]]
    });
    (points, triangles.collect())
}

pub(crate) fn tetrahedron() -> Mesh {
    let points = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Point3::from);
    (points.to_vec(), vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
}

pub(crate) fn octahedron() -> Mesh {
    let points = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z].map(|v| Point3::ORIGIN + v);
    let triangles = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    (points.to_vec(), triangles.to_vec())
}

/// All of them, with their names; closed ones first.
pub(crate) fn all() -> Vec<(&'static str, Mesh)> {
    vec![
        ("icosahedron", icosahedron()),
        ("icosphere", icosphere()),
        ("torus", torus(16, 10)),
        ("bumpy", bumpy()),
        ("cube", cube()),
        ("tetrahedron", tetrahedron()),
        ("octahedron", octahedron()),
        ("cylinder", cylinder(9)),
        ("disc", disc(7)),
        ("graph", graph(5, |x, y| 0.3 * (4.0 * x).sin() * (3.0 * y).cos())),
    ]
}
