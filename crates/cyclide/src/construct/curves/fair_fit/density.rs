//! Where the nodes of the first fit go: denser where the curvature bends more (`docs/math/fair-fits.md#nodes`).
//!
//! ```text
//! w_j = jump of the derivative of curvature at a smoothed point / mean chord, smoothed 1-2-1
//! density = (w/(384 T))^(1/4), not below a quarter of its mean;   nodes = 2 integral + 1
//! ```
//! (the cubic between nodes `h` apart misses a curve by `h⁴ w/384`).

use super::fit::fewest_nodes;
use crate::base::vector::{Point3, Vec3};

/// Nodes per unit of the integral of the density.
const NODES_PER_UNIT: f64 = 2.0;

/// Places along smoothed points, as positions `index + fraction`, for the nodes of the first fit.
pub(super) fn places(z: &[Point3], closed: bool, tolerance: f64) -> Vec<f64> {
    let least = fewest_nodes(closed);
    let n = z.len();
    let m = if closed { n } else { n - 1 };
    let chords: Vec<f64> = (0..m).map(|j| (z[(j + 1) % n] - z[j]).length()).collect();
    let density = density(z, &chords, closed, tolerance);
    // Trapezia of the density over each chord.
    let mut sums = vec![0.0];
    for j in 0..m {
        sums.push(sums[j] + 0.5 * (density[j] + density[(j + 1) % n]) * chords[j]);
    }
    let total = sums[m];
    let intervals = ((NODES_PER_UNIT * total) as usize).clamp(if closed { least } else { least - 1 }, m.max(least));
    let mut j = 0;
    let place = |i: usize| {
        let goal = total * i as f64 / intervals as f64;
        while j + 1 < m && sums[j + 1] < goal {
            j += 1;
        }
        // The density is linear over the chord; its integral is inverted exactly enough by the trapezium's line.
        let width = sums[j + 1] - sums[j];
        j as f64 + if width > 0.0 { ((goal - sums[j]) / width).clamp(0.0, 1.0) } else { 0.0 }
    };
    (0..if closed { intervals } else { intervals + 1 }).map(place).collect()
}

fn density(z: &[Point3], chords: &[f64], closed: bool, tolerance: f64) -> Vec<f64> {
    let (n, m) = (z.len(), chords.len());
    let inner = |i: usize| closed || (i > 0 && i + 1 < n);
    let unit = |j: usize| (z[(j + 1) % n] - z[j]) / chords[j].max(f64::MIN_POSITIVE);
    let curvature: Vec<Vec3> = (0..n)
        .map(|i| {
            if !inner(i) {
                return Vec3::ZERO;
            }
            let before = (i + m - 1) % m;
            (unit(i) - unit(before)) * (2.0 / (chords[i] + chords[before]))
        })
        .collect();
    // Open ends: curvature constant, as the arcs of the spline.
    let end = |i: usize| match i {
        0 if !closed && n > 2 => curvature[1],
        i if !closed && n > 2 && i == n - 1 => curvature[n - 2],
        i => curvature[i],
    };
    let variation: Vec<Vec3> = (0..m).map(|j| (end((j + 1) % n) - end(j)) / chords[j].max(f64::MIN_POSITIVE)).collect();
    let jump = |i: usize| {
        if !inner(i) {
            return 0.0;
        }
        let before = (i + m - 1) % m;
        let Some(tangent) = (unit(i) + unit(before)).unit() else { return 0.0 };
        let jump = variation[i] - variation[before];
        (jump - tangent * jump.dot(tangent)).length() / (0.5 * (chords[i] + chords[before]))
    };
    let w: Vec<f64> = (0..n).map(jump).collect();
    let at =
        |i: isize| if closed { w[i.rem_euclid(n as isize) as usize] } else { w[i.clamp(0, n as isize - 1) as usize] };
    let smoothed = (0..n as isize).map(|i| 0.25 * (at(i - 1) + 2.0 * at(i) + at(i + 1)));
    let mut density: Vec<f64> = smoothed.map(|w| (w / (384.0 * tolerance)).sqrt().sqrt()).collect();
    let total: f64 = chords.iter().sum();
    let mean = (0..m).map(|j| 0.5 * (density[j] + density[(j + 1) % n]) * chords[j]).sum::<f64>() / total;
    // Straight and circular data have no density of their own.
    let least = (0.25 * mean).max(f64::MIN_POSITIVE.sqrt());
    density.iter_mut().for_each(|d| *d = d.max(least));
    density
}

/// The point at a position of a list, on the cubic through its neighbors.
pub(super) fn point_at(z: &[Point3], closed: bool, position: f64) -> Point3 {
    let n = z.len();
    let m = if closed { n } else { n - 1 };
    let j = (position as usize).min(m - 1);
    let u = position - j as f64;
    let at = |i: isize| -> Option<Point3> {
        if closed {
            Some(z[i.rem_euclid(n as isize) as usize])
        } else {
            usize::try_from(i).ok().and_then(|i| z.get(i).copied())
        }
    };
    let j = j as isize;
    let (Some(b), Some(c)) = (at(j), at(j + 1)) else { return z[0] };
    // Hermite over the chord lengths, slopes of the parabolas through three points.
    let chord = c - b;
    let h = chord.length();
    let slope = |a: Option<Point3>, b: Point3, c: Option<Point3>| {
        let (Some(a), Some(c)) = (a, c) else { return None };
        let (ha, hc) = ((b - a).length(), (c - b).length());
        (ha > 0.0 && hc > 0.0).then(|| ((b - a) * (hc / ha) + (c - b) * (ha / hc)) / (ha + hc))
    };
    let (s0, s1) = (slope(at(j - 1), b, Some(c)), slope(Some(b), c, at(j + 2)));
    // At an open end the other slope mirrored: a parabola.
    let mirrored = |other: Option<Vec3>| other.map_or(chord, |s: Vec3| chord * 2.0 - s * h);
    let d0 = s0.map_or_else(|| mirrored(s1), |s| s * h);
    let d1 = s1.map_or_else(|| mirrored(s0), |s| s * h);
    let v = 1.0 - u;
    b + chord * (u * u * (3.0 - 2.0 * u)) + d0 * (u * v * v) - d1 * (u * u * v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_dense_where_the_curve_bends_and_few_on_lines() {
        let line: Vec<Point3> = (0..50).map(|i| Point3::new(i as f64, 0.5 * i as f64, 0.0)).collect();
        assert_eq!(places(&line, false, 0.1), [0.0, 49.0]);
        // A wave in the middle third of a straight run.
        let wave = |x: f64| {
            if (20.0..40.0).contains(&x) { ((x - 20.0) * 0.1 * std::f64::consts::PI).sin().powi(4) } else { 0.0 }
        };
        let run: Vec<Point3> =
            (0..=300).map(|i| Point3::new(0.2 * i as f64, 3.0 * wave(0.2 * i as f64), 0.0)).collect();
        let places = places(&run, false, 1e-3);
        assert!((places[0], places[places.len() - 1]) == (0.0, 300.0) && places.is_sorted());
        let inside = places.iter().filter(|p| (100.0..200.0).contains(*p)).count();
        assert!(2 * inside > places.len(), "{inside} of {}", places.len());
        for p in places {
            // On the chord's cubic: no farther from the run than the cubic of a wave of 20 sampled at 0.2.
            let at = point_at(&run, false, p);
            assert!((at.y - 3.0 * wave(at.x)).abs() < 1e-3);
        }
    }
}
