//! Whether points are where their neighbors say: samples of a smooth curve are (`docs/math/arc-fitting.md#outlines`).

use crate::base::vector::Point3;
use crate::construct::curves::off_neighbors::off_neighbors;

/// How far points are from where the two neighbors on either side say, as a part of how far they are from where only the next
/// ones do: root mean squares over all windows of five points in a row, less what noise of up to a tolerance explains. 0 of none, and
/// of points on a line.
///
/// Of samples of a smooth curve this is small; of points that follow no curve it is about 1.
pub(super) fn unpredicted(windows: impl Iterator<Item = [Point3; 5]>, tolerance: f64) -> f64 {
    let (mut off, mut all) = (0.0, 0.0);
    for points in windows {
        let (nearest, _) = off_neighbors(&points, &[1, 3]);
        let (two, spread) = off_neighbors(&points, &[0, 1, 3, 4]);
        // Of uneven points the nearest may say more.
        off += (two.min(nearest) - spread * tolerance).max(0.0).powi(2);
        all += nearest.powi(2);
    }
    if all > 0.0 { (off / all).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(at: impl Fn(usize) -> [f64; 2]) -> f64 {
        let points: Vec<Point3> = (0..40).map(|i| Point3::new(at(i)[0], at(i)[1], 0.0)).collect();
        unpredicted(points.windows(5).map(|w| [w[0], w[1], w[2], w[3], w[4]]), 0.0)
    }

    #[test]
    fn samples_of_a_circle_are_predicted_and_scattered_points_are_not() {
        let circle = |step: f64| of(move |i| [(step * i as f64).cos(), (step * i as f64).sin()]);
        assert!(circle(0.1) < 0.01 && circle(0.5) < 0.1, "{} {}", circle(0.1), circle(0.5));
        let scattered = of(|i| [i as f64, ((i * i) as f64 * 0.77).sin()]);
        assert!(scattered > 0.8, "{scattered}");
        assert!(of(|i| [i as f64, 2.0 * i as f64]) < 0.5);
    }
}
