//! What smoothing leaves of each point, across and along the curve, and what stands out from its neighbors
//! (`docs/math/fair-fits.md#noise`).

use super::chords::median;
use crate::base::vector::{Point3, Vec3};

/// Neighbors on either side that a residual is compared with.
const NEIGHBORS: isize = 3;

/// The residual of a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Residual {
    /// Length across the curve, and along it.
    pub across: f64,
    pub along: f64,
    /// The same after the median of the neighbors' residuals is taken off, which a bend that is smoothed too much has
    /// in common with them and a wrong point has not.
    pub alone: [f64; 2],
    /// Median length of the neighbors' residuals.
    pub around: f64,
}

/// Residuals of points from their smoothed places. `axis_only`: there is no direction along.
pub(super) fn residuals(points: &[Point3], smoothed: &[Point3], closed: bool, axis_only: bool) -> Vec<Residual> {
    let n = points.len() as isize;
    let place = |k: isize| {
        if closed {
            k.rem_euclid(n) as usize
        } else {
            // Mirrored at the ends.
            let k = k.abs();
            (if k >= n { 2 * (n - 1) - k } else { k }).clamp(0, n - 1) as usize
        }
    };
    let rest = |k: isize| points[place(k)] - smoothed[place(k)];
    let split = |v: Vec3, tangent: Vec3| {
        let along = v.dot(tangent);
        [(v - tangent * along).length(), along.abs()]
    };
    let at = |k: isize| {
        let ahead = if closed { k + 1 } else { (k + 1).min(n - 1) };
        let back = if closed { k - 1 } else { (k - 1).max(0) };
        let tangent = (smoothed[place(ahead)] - smoothed[place(back)]).unit().filter(|_| !axis_only);
        let tangent = tangent.unwrap_or(Vec3::ZERO);
        let around: Vec<Vec3> = (-NEIGHBORS..=NEIGHBORS).filter(|o| *o != 0).map(|o| rest(k + o)).collect();
        let axis = |get: fn(&Vec3) -> f64| median(&mut around.iter().map(get).collect::<Vec<_>>());
        let common = Vec3::new(axis(|v| v.x), axis(|v| v.y), axis(|v| v.z));
        let [across, along] = split(rest(k), tangent);
        let alone = split(rest(k) - common, tangent);
        Residual { across, along, alone, around: median(&mut around.iter().map(|v| v.length()).collect::<Vec<_>>()) }
    };
    (0..n).map(at).collect()
}

/// The standard deviation that the median of lengths says, of normal errors in one direction or in two.
pub(super) fn scale(lengths: impl Iterator<Item = f64>, directions: usize) -> f64 {
    // The medians of |x| and of the length of a plane normal vector, over the deviation in one direction.
    let of_one = if directions == 1 { 0.674_489_75 } else { 1.177_410_02 };
    median(&mut lengths.collect::<Vec<_>>()) / of_one
}
