//! Where a fit of closed data starts, and which way round fits go: at a datum and in a direction that the data themselves
//! single out, so that the curve does not depend on the point that happens to be first in a list, nor on the direction.
//! Taking nodes out is a chain of choices: a last digit may lead to another curve, as good, with a tenth more nodes.
//!
//! It is the datum farthest from the center `c` of all; of several the one farthest along `sum |p - c|² (p - c)`, where the
//! data are not alike on both sides of their center; of several the one whose neighbors 1, 2, 4, … places away on both
//! sides are farthest from each other. Data that none of this tells apart are, but for freaks, copies of each other by a
//! symmetry: of those the one with the largest `x`, `y`, `z`.

use crate::base::vector::{Point3, Vec3};
use std::cmp::Ordering;

/// Measures that differ by less than this part of their scale are equal: rounding must not choose.
const EQUAL: f64 = 1e-9;

/// The number of the datum to start at.
pub(super) fn canonical_start(points: &[Point3]) -> usize {
    let n = points.len();
    let Some(first) = points.first() else { return 0 };
    let centre = points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - *first)) / n as f64;
    let out = |i: usize| points[i] - *first - centre;
    let size = (0..n).map(|i| out(i).length_squared()).fold(0.0, f64::max);
    let mut candidates: Vec<usize> = (0..n).collect();
    keep_largest(&mut candidates, size, |i| out(i).length_squared());
    let lean = (0..n).map(|i| out(i) * out(i).length_squared()).fold(Vec3::ZERO, |sum, v| sum + v) / n as f64;
    keep_largest(&mut candidates, size * size, |i| lean.dot(out(i)));
    let mut away = 1;
    while candidates.len() > 1 && 2 * away < n {
        let apart = |i: usize| (points[(i + away) % n] - points[(i + n - away) % n]).length_squared();
        keep_largest(&mut candidates, size, apart);
        away *= 2;
    }
    candidates.into_iter().max_by(|a, b| in_axes(points[*a], points[*b])).unwrap_or(0)
}

/// True if the data are fitted from their last point to their first, closed ones the other way round: away from the start
/// the first neighbors that differ in distance are farther that way; where none do, the way with the larger coordinates.
pub(super) fn runs_backwards(points: &[Point3], closed: bool) -> bool {
    let n = points.len();
    let pairs = |ends: [usize; 2], k: usize| {
        let [ahead, back] = [points[(ends[0] + k) % n], points[(ends[1] + n - k) % n]];
        [ahead.distance(points[ends[0]]), back.distance(points[ends[1]])]
    };
    let ends = if closed { [canonical_start(points); 2] } else { [0, n.saturating_sub(1)] };
    for k in 1..=n / 2 {
        let [ahead, back] = pairs(ends, k);
        if (back - ahead).abs() > EQUAL * ahead.max(back) {
            return back > ahead;
        }
    }
    let [ahead, back] = if closed { [(ends[0] + 1) % n, (ends[0] + n - 1) % n] } else { ends };
    in_axes(points[back], points[ahead]).is_gt()
}

/// By `x`, of equal ones by `y`, then by `z`.
pub(super) fn in_axes(a: Point3, b: Point3) -> Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z))
}

/// Keeps those with the largest measure.
fn keep_largest(candidates: &mut Vec<usize>, scale: f64, measure: impl Fn(usize) -> f64) {
    let largest = candidates.iter().map(|i| measure(*i)).fold(f64::NEG_INFINITY, f64::max);
    candidates.retain(|i| measure(*i) >= largest - EQUAL * scale);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_datum_from_every_start_and_both_ways() {
        // A triangle whose corners are equally far from its center, sampled unevenly.
        let at = |i: usize| {
            let a = std::f64::consts::TAU * i as f64 / 60.0;
            let r = 5.0 + (3.0 * a).cos();
            Point3::new(r * a.cos() + if i == 7 { 0.01 } else { 0.0 }, r * a.sin(), 0.0)
        };
        let points: Vec<Point3> = (0..60).map(at).collect();
        let chosen = points[canonical_start(&points)];
        let backwards = runs_backwards(&points, true);
        for start in 0..60 {
            let mut turned = points.clone();
            turned.rotate_left(start);
            assert_eq!(turned[canonical_start(&turned)], chosen, "{start}");
            assert_eq!(runs_backwards(&turned, true), backwards, "{start}");
            turned.reverse();
            assert_eq!(turned[canonical_start(&turned)], chosen, "{start} back");
            assert_ne!(runs_backwards(&turned, true), backwards, "{start} back");
        }
    }
}
