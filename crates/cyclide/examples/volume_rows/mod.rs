//! A block on a grid, for measuring.

#![allow(dead_code, reason = "each program takes what it needs")]

use cyclide::{
    Point3, Result,
    volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame},
};

/// A curved block without folds: four corners, the others found.
pub fn block() -> Result<CyclideVolume> {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
    CyclideVolume::new(&SphericalCube::from_barycentric(corners, [1.0, 1.2, 0.8], 0.5)?, VolumeFrame::Auto)
}

/// Parameters at equal distances.
pub fn parameters(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

/// Points and Jacobians of a grid: x, y, z and the Jacobian of one row after another, s fastest.
pub fn rows(block: &CyclideVolume, s: &[f64], out: &mut [f64]) {
    let n = s.len();
    let mut lines = out.chunks_mut(4 * n);
    for &u in s {
        for &t in s {
            let Some(line) = lines.next() else { return };
            let (x, rest) = line.split_at_mut(n);
            let (y, rest) = rest.split_at_mut(n);
            let (z, jacobians) = rest.split_at_mut(n);
            block.row([t, u]).points_and_jacobians(s, [x, y, z], jacobians);
        }
    }
}

/// The same one by one.
pub fn one_by_one(block: &CyclideVolume, s: &[f64]) -> f64 {
    let mut sum = 0.0;
    for &u in s {
        for &t in s {
            for &s in s {
                sum += block.point([s, t, u]).x + block.jacobian([s, t, u]);
            }
        }
    }
    sum
}
