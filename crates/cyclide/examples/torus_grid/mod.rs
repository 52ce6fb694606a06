//! A patch on a grid, for measuring: a quarter by a quarter of the torus with radii 2 and 1/2.

#![allow(dead_code, reason = "each program takes what it needs")]

use cyclide::{CyclidePatch, Point3, Result, Vec3};

/// From the outer equator up, s about the z axis.
pub fn patch() -> Result<CyclidePatch> {
    let corners = [[2.5, 0.0, 0.0], [0.0, 2.5, 0.0], [2.0, 0.0, 0.5], [0.0, 2.0, 0.5]].map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)
}

/// Parameters at equal distances.
pub fn parameters(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

/// The points of a grid, coordinate by coordinate: all x, all y, all z, s fastest.
pub fn points(patch: &CyclidePatch, s: &[f64], out: &mut [f64]) {
    let n = s.len();
    let (x, rest) = out.split_at_mut(n * n);
    let (y, z) = rest.split_at_mut(n * n);
    for (((t, x), y), z) in s.iter().zip(x.chunks_mut(n)).zip(y.chunks_mut(n)).zip(z.chunks_mut(n)) {
        patch.row(*t).points(s, [x, y, z]);
    }
}

/// The points and unit normals of a grid, row by row: x, y, z and the coordinates of the normal of one row after
/// another.
pub fn points_and_normals(patch: &CyclidePatch, s: &[f64], out: &mut [f64]) {
    let n = s.len();
    for (t, row) in s.iter().zip(out.chunks_mut(6 * n)) {
        let mut lanes = row.chunks_mut(n);
        let mut three = || std::array::from_fn(|_| lanes.next().unwrap_or_default());
        patch.row(*t).points_and_normals(s, three(), three());
    }
}
