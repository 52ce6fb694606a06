//! A patch on a grid, for measuring: a quarter by a quarter of the torus with radii 2 and 1/2.

#![allow(dead_code, reason = "each program takes what it needs")]

use cyclide::{Point3, Result, Vec3, surface::CyclidePatch};

/// From the outer equator up, s about the z axis.
pub fn patch() -> Result<CyclidePatch> {
    let corners = [[2.5, 0.0, 0.0], [0.0, 2.5, 0.0], [2.0, 0.0, 0.5], [0.0, 2.0, 0.5]].map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)
}

/// Parameters at equal distances.
pub fn parameters(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

/// The x, y and z of one row of n points after another.
fn lanes(row: &mut [f64], n: usize) -> [&mut [f64]; 3] {
    let mut lanes = row.chunks_mut(n);
    std::array::from_fn(|_| lanes.next().unwrap_or_default())
}

/// The points of a grid: x, y and z of one row after another, s fastest.
pub fn points(patch: &CyclidePatch, s: &[f64], out: &mut [f64]) {
    let n = s.len();
    for (t, row) in s.iter().zip(out.chunks_mut(3 * n)) {
        patch.row(*t).points(s, lanes(row, n));
    }
}

/// As [`points`], with the unit normals in a buffer of the same kind.
pub fn points_and_normals(patch: &CyclidePatch, s: &[f64], points: &mut [f64], normals: &mut [f64]) {
    let n = s.len();
    for ((t, p), q) in s.iter().zip(points.chunks_mut(3 * n)).zip(normals.chunks_mut(3 * n)) {
        patch.row(*t).points_and_normals(s, lanes(p, n), lanes(q, n));
    }
}

/// Space for one more row at the end of a vector that has room for it. Growing a fresh buffer row by row writes zeros
/// where the cache still holds them when the points come; zeros for the whole grid would go to memory and back.
fn next_row(grown: &mut Vec<f64>, n: usize) -> [&mut [f64]; 3] {
    let start = grown.len();
    grown.resize(start + 3 * n, 0.0);
    lanes(&mut grown[start..], n)
}

/// [`points`] into a fresh buffer.
pub fn fresh_points(patch: &CyclidePatch, s: &[f64]) -> Vec<f64> {
    let n = s.len();
    let mut points = Vec::with_capacity(3 * n * n);
    for t in s {
        patch.row(*t).points(s, next_row(&mut points, n));
    }
    points
}

/// [`points_and_normals`] into two fresh buffers.
pub fn fresh_points_and_normals(patch: &CyclidePatch, s: &[f64]) -> [Vec<f64>; 2] {
    let n = s.len();
    let [mut points, mut normals] = [0, 1].map(|_| Vec::with_capacity(3 * n * n));
    for t in s {
        patch.row(*t).points_and_normals(s, next_row(&mut points, n), next_row(&mut normals, n));
    }
    [points, normals]
}
