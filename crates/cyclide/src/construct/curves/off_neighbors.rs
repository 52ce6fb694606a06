//! How far a point is off the polynomial through its neighbors, by lengths along their chords: little where they are samples of a
//! smooth curve (`docs/math/arc-fitting.md#outlines`, `docs/math/fair-fits.md#noise`).

use crate::base::vector::{Point3, Vec3};

/// How far the middle one of some points in a row is across from the polynomial through others of them, and what that is as a
/// multiple of the deviation where each has noise of its own.
pub(super) fn off_neighbors(points: &[Point3], of: &[usize]) -> (f64, f64) {
    let middle = points.len() / 2;
    let mut at = vec![0.0; points.len()];
    for k in 1..points.len() {
        at[k] = at[k - 1] + points[k - 1].distance(points[k]);
    }
    let (mut from, mut spread) = (Vec3::ZERO, 1.0);
    for j in of {
        let factor = |l: &usize| (at[middle] - at[*l]) / (at[*j] - at[*l]);
        let weight: f64 = of.iter().filter(|l| *l != j).map(factor).product();
        from += (points[*j] - points[middle]) * weight;
        spread += weight * weight;
    }
    let along = (points[middle + 1] - points[middle - 1]).unit();
    let across = along.map_or(from, |u| from - u * from.dot(u));
    (across.length(), spread.sqrt())
}
