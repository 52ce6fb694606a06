//! In how many directions across a curve its points are noisy: two of points in space, one where they lie in a surface or where
//! one direction has most of the noise (`docs/math/fair-fits.md#noise`).

use super::Run;
use crate::base::vector::{Point3, Vec3};

/// Third differences so far apart have no point in common.
const APART: usize = 4;
/// Fewer of them tell nothing.
const FEWEST: usize = 24;
/// The squared cosine between two of them is 1/2 on average where noise is the same in two directions, and 1 where it has
/// one; the limit is where the lesser has a third of the greater.
const ONE: f64 = 0.8;

/// The number of directions of points that lie in no plane.
pub(super) fn directions(data: &[Point3], runs: &[Run]) -> usize {
    let (mut along, mut whole, mut count) = (0.0, 0.0, 0);
    for run in runs {
        let at = |i: usize| data[run.numbers[i % run.numbers.len()]];
        let third = |i: usize| {
            let v = (at(i + 3) - at(i)) - (at(i + 2) - at(i + 1)) * 3.0;
            let tangent = (at(i + 3) - at(i)).unit().unwrap_or(Vec3::ZERO);
            v - tangent * v.dot(tangent)
        };
        let pairs = run.numbers.len().saturating_sub(if run.closed { 0 } else { APART + 3 });
        for i in 0..pairs {
            let (u, v) = (third(i), third(i + APART));
            along += u.dot(v).powi(2);
            whole += u.length_squared() * v.length_squared();
            count += 1;
        }
    }
    if count >= FEWEST && along > ONE * whole { 1 } else { 2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_in_heights_alone_has_one_direction() {
        let noise = |i: usize, k: usize| ((i * i * 7 + k * i * 13) as f64 * 0.731 + k as f64).sin();
        let data = |across: f64, up: f64| -> Vec<Point3> {
            let at = |i: usize| {
                let (sin, cos) = (std::f64::consts::TAU * i as f64 / 300.0).sin_cos();
                let r = 50.0 + across * noise(i, 1);
                Point3::new(r * cos, r * sin, 5.0 * sin + up * noise(i, 2))
            };
            (0..300).map(at).collect()
        };
        let runs = [Run { numbers: (0..300).collect(), closed: true, fixed: [false; 2] }];
        let found = |across: f64, up: f64| directions(&data(across, up), &runs);
        assert_eq!(
            [found(0.1, 0.1), found(0.0, 0.1), found(0.1, 0.0), found(0.1, 0.01), found(0.1, 0.08)],
            [2, 1, 1, 1, 2]
        );
    }
}
