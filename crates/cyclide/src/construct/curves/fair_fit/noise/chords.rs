//! Lengths between measured points that single wrong points do not rule (`docs/math/fair-fits.md#noise`).

use crate::base::vector::{Point3, Vec3};

/// Points on either side whose median says how far the data go on.
const WINDOW: usize = 5;
/// An edge up to this many times the median of its neighbors is believed.
const BELIEVED: f64 = 2.0;
/// No edge is shorter than this part of the mean: the third differences divide by it.
pub(super) const SHORTEST: f64 = 0.02;

/// Lengths of the edges of a list.
pub(super) fn chords(points: &[Point3], closed: bool) -> Vec<f64> {
    let n = points.len();
    (0..if closed { n } else { n.saturating_sub(1) }).map(|j| points[j].distance(points[(j + 1) % n])).collect()
}

/// Lengths of the edges, where one that is long because a single point is far off counts as what the medians of the points
/// before and after it are apart. A real gap in the data stays as long as it is.
pub(super) fn robust_chords(points: &[Point3], closed: bool) -> Vec<f64> {
    let raw = chords(points, closed);
    let (n, m) = (points.len(), raw.len());
    let window = |from: isize, to: isize, count: usize| -> Vec<usize> {
        let inside = |k: isize| if closed { true } else { k >= 0 && (k as usize) < count };
        (from..to).filter(|k| inside(*k)).map(|k| k.rem_euclid(count as isize) as usize).collect()
    };
    let reach = WINDOW as isize;
    let lengths = (0..m).map(|j| {
        let at = j as isize;
        let mut around: Vec<f64> = window(at - reach, at + reach + 1, m).into_iter().map(|k| raw[k]).collect();
        let usual = BELIEVED * median(&mut around);
        if raw[j] <= usual {
            return raw[j];
        }
        let before = middle(points, &window(at + 1 - reach, at + 1, n));
        let after = middle(points, &window(at + 1, at + 1 + reach, n));
        raw[j].min(after.distance(before).max(usual))
    });
    let lengths: Vec<f64> = lengths.collect();
    above_shortest(lengths)
}

/// None of them below the shortest that is allowed.
pub(super) fn above_shortest(mut lengths: Vec<f64>) -> Vec<f64> {
    let mean = lengths.iter().sum::<f64>() / lengths.len().max(1) as f64;
    let least = (SHORTEST * mean).max(f64::MIN_POSITIVE);
    lengths.iter_mut().for_each(|h| *h = h.max(least));
    lengths
}

/// The medians of the coordinates.
fn middle(points: &[Point3], of: &[usize]) -> Point3 {
    let axis = |get: fn(Vec3) -> f64| median(&mut of.iter().map(|k| get(points[*k].to_vec())).collect::<Vec<_>>());
    Point3::new(axis(|v| v.x), axis(|v| v.y), axis(|v| v.z))
}

/// The middle of values, the mean of the two in the middle of an even number; 0 of none.
pub(super) fn median(values: &mut [f64]) -> f64 {
    let n = values.len();
    if n == 0 {
        return 0.0;
    }
    let (below, upper, _) = values.select_nth_unstable_by(n / 2, f64::total_cmp);
    let upper = *upper;
    if n % 2 == 1 {
        return upper;
    }
    0.5 * (upper + below.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gap_stays_long_and_a_point_far_off_does_not_count() {
        let mut points: Vec<Point3> = (0..40).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
        points[12].y = 500.0;
        // A gap of 300 in the data.
        points[25..].iter_mut().for_each(|p| p.x += 300.0);
        let lengths = robust_chords(&points, false);
        assert!(lengths[11] < 10.0 && lengths[12] < 10.0 && (lengths[24] - 301.0).abs() < 1e-9, "{lengths:?}");
        assert!((lengths[3] - 1.0).abs() < 1e-12);
        assert!(
            (median(&mut [3.0, 1.0, 2.0]) - 2.0).abs() < 1e-12
                && (median(&mut [4.0, 1.0, 2.0, 3.0]) - 2.5).abs() < 1e-12
        );
    }
}
