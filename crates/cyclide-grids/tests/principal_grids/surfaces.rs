//! Meshes of surfaces with known lines of curvature.

use cyclide::{Point3, Vec3};
use std::f64::consts::TAU;

/// Triangles over vertices.
#[derive(Clone)]
pub struct Mesh {
    pub points: Vec<Point3>,
    pub triangles: Vec<[usize; 3]>,
}

/// A number in `[-1, 1]` that depends on its index without a pattern.
fn noise(index: usize) -> f64 {
    let x = (index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ (x >> 31)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((x ^ (x >> 29)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

impl Mesh {
    /// Quads of a grid cut along alternating diagonals; along the first direction it may come back to itself.
    pub fn of_grid(size: [usize; 2], round: bool, point: impl Fn(f64, f64) -> Point3) -> Self {
        let columns = if round { size[0] } else { size[0] + 1 };
        let points = (0..columns * (size[1] + 1))
            .map(|k| point((k % columns) as f64 / size[0] as f64, (k / columns) as f64 / size[1] as f64))
            .collect();
        let mut triangles = Vec::new();
        for (j, i) in (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (j, i))) {
            let at = |i: usize, j: usize| i % columns + j * columns;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend(if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
        Self { points, triangles }
    }

    /// Heights over a rectangle.
    pub fn roof(x: [f64; 2], y: [f64; 2], size: [usize; 2], height: impl Fn(f64, f64) -> f64) -> Self {
        Self::of_grid(size, false, |u, v| {
            let (x, y) = (x[0] + (x[1] - x[0]) * u, y[0] + (y[1] - y[0]) * v);
            Point3::new(x, y, height(x, y))
        })
    }

    /// Without the triangles whose middle is at some places.
    pub fn without(mut self, hole: impl Fn(Point3) -> bool) -> Self {
        let points = &self.points;
        self.triangles.retain(|t| {
            let [a, b, c] = t.map(|v| points[v]);
            !hole(a + ((b - a) + (c - a)) / 3.0)
        });
        self
    }

    /// With its vertices moved by up to this much along every axis.
    pub fn noisy(mut self, amplitude: f64) -> Self {
        for (k, p) in self.points.iter_mut().enumerate() {
            *p += Vec3::new(noise(3 * k), noise(3 * k + 1), noise(3 * k + 2)) * amplitude;
        }
        self
    }
}

pub fn hypar(size: usize) -> Mesh {
    Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [size; 2], |x, y| 0.05 * x * y)
}

/// Its mesh runs along the lines of curvature.
pub fn hypar_along(size: usize) -> Mesh {
    Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [size; 2], |x, y| 0.025 * (x * x - y * y))
}

pub fn shear(size: usize) -> Mesh {
    Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [size; 2], |x, y| 0.04 * x * x - 0.02 * y * y + 0.035 * x * y)
}

pub fn paraboloid(size: usize) -> Mesh {
    Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [size; 2], |x, y| 4.0 - 0.06 * x * x - 0.03 * y * y)
}

fn sine(x: f64, y: f64) -> f64 {
    1.8 * (0.4 * x).sin() * (0.5 * y).cos()
}

pub fn saddle() -> Mesh {
    Mesh::roof([-3.0, 3.0], [1.0, 5.2], [48, 40], sine)
}

/// A vault with a hole in its crown.
pub fn vault(size: [usize; 2]) -> Mesh {
    let height = |x: f64, y: f64| 3.0 * (TAU * y / 24.0).cos() * (1.0 + 0.15 * (TAU * x / 24.0).cos()) + 0.009 * x * y;
    Mesh::roof([-9.0, 9.0], [-5.0, 5.0], size, height).without(|p| (p.x - 1.0).abs() < 2.0 && p.y.abs() < 1.2)
}

/// Bicubic heights over a square 20 wide.
pub fn nurbs(which: usize, size: usize) -> Mesh {
    const HEIGHTS: [[[f64; 4]; 4]; 3] = [
        [
            [0.047, 1.802, -1.423, 1.795],
            [-0.753, 2.693, 4.311, -0.363],
            [0.198, 1.11, 4.014, 0.153],
            [-0.681, 1.154, -0.787, -0.186],
        ],
        [
            [-0.954, -0.806, 1.257, -1.632],
            [0.4, 3.914, 1.752, -1.779],
            [-0.9, 3.63, 3.249, -1.4],
            [-0.269, 0.677, -0.309, 0.533],
        ],
        [
            [-1.657, -1.053, 1.205, 0.329],
            [-1.623, 2.733, 2.916, -1.361],
            [0.938, 1.455, 2.565, 0.067],
            [-0.277, 0.347, 0.951, 1.825],
        ],
    ];
    let basis = |t: f64| {
        let s = 1.0 - t;
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
    };
    Mesh::roof([-10.0, 10.0], [-10.0, 10.0], [size; 2], |x, y| {
        let (u, v) = (basis((x + 10.0) / 20.0), basis((y + 10.0) / 20.0));
        (0..16).map(|k| HEIGHTS[which - 1][k / 4][k % 4] * u[k % 4] * v[k / 4]).sum()
    })
}

/// An elliptic tower that turns and narrows.
pub fn tower(a: f64, b: f64, turn: f64, height: f64, size: [usize; 2]) -> Mesh {
    Mesh::of_grid(size, true, |u, v| {
        let r = 1.0 - v / 4.0;
        let (x, y) = (0.5 * r * a * (TAU * u).cos(), 0.5 * r * b * (TAU * u).sin());
        let (sine, cosine) = (turn * v).sin_cos();
        Point3::new(x * cosine - y * sine, x * sine + y * cosine, height * v)
    })
}

pub fn hyperboloid(size: [usize; 2]) -> Mesh {
    Mesh::of_grid(size, true, |u, v| {
        let z = 2.0 * v - 1.0;
        let r = (1.0 + z * z).sqrt();
        Point3::new(3.0 * r * (TAU * u).cos(), 2.0 * r * (TAU * u).sin(), 4.0 * z)
    })
}

pub fn bump_cylinder(size: [usize; 2]) -> Mesh {
    Mesh::of_grid(size, true, |u, v| {
        let wave = 0.1 * (3.0 * TAU * u).cos() * (TAU * v / 2.0).sin() + 0.05 * (2.0 * TAU * u + 1.0).sin() * v;
        let r = 2.0 * (1.0 + wave);
        Point3::new(r * (TAU * u).cos(), r * (TAU * u).sin(), 5.0 * v)
    })
}
