//! Symmetric data get symmetric arcs (`docs/math/arc-fitting.md#symmetry`).

use super::*;
use cyclide::Vec3;

/// A figure turned by an angle about the origin, moved, and rounded to so many decimals.
fn placed(points: &[Point3], angle: f64, decimals: i32) -> Vec<Point3> {
    let (s, c) = angle.sin_cos();
    let unit = 10_f64.powi(decimals);
    let round = |x: f64| (x * unit).round() / unit;
    points.iter().map(|p| Point3::new(round(c * p.x - s * p.y + 130.0), round(s * p.x + c * p.y - 70.0), 0.0)).collect()
}

/// Radius 40 with waves of so many to a turn, each `count` points, by a seed.
fn rosette(axes: usize, count: usize, seed: u64) -> Vec<Point3> {
    let mut random = Random(seed);
    let waves: Vec<f64> = (1..4).map(|m| 12.0 * random.next() / f64::from(m * m)).collect();
    let n = axes * count;
    let at = |i: usize| {
        let t = TAU * (i as f64 + 0.5) / n as f64;
        let r = waves.iter().enumerate().fold(40.0, |r, (m, a)| r + a * ((m + 1) as f64 * axes as f64 * t).cos());
        Point3::new(r * t.cos(), r * t.sin(), 0.0)
    };
    (0..n).map(at).collect()
}

/// A plate with two rounded and four sharp corners and a round notch, symmetric about the y axis.
fn plate(seed: u64) -> Vec<Point3> {
    let mut random = Random(seed);
    let [w, h, r] = [(30.0, 20.0), (20.0, 12.0), (6.0, 5.0)].map(|(mid, range)| mid + range * random.next());
    let arc = |x: f64, y: f64, r: f64, from: f64, to: f64, n: u32| {
        let angle = move |k: u32| from + (to - from) * f64::from(k) / f64::from(n);
        (0..=n).map(move |k| Point3::new(x + r * angle(k).cos(), y + r * angle(k).sin(), 0.0))
    };
    let mut half: Vec<Point3> = arc(w - r, r - h, r, -FRAC_PI_2, 0.0, 14).collect();
    half.extend([[w, 0.3 * h], [0.5 * w, 0.3 * h], [0.5 * w, h]].map(|[x, y]| Point3::new(x, y, 0.0)));
    half.extend(arc(0.0, h, 0.25 * w, 0.0, -FRAC_PI_2, 20));
    let image: Vec<Point3> = half.iter().rev().skip(1).map(|p| Point3::new(-p.x, p.y, 0.0)).collect();
    half.extend(image);
    half
}

/// The farthest that the mirror image of the path is from it, about the axis through the centroid along which the point at
/// half of `sum` is.
#[expect(clippy::unwrap_used, reason = "a figure without an axis is a failed test")]
fn asymmetry(points: &[Point3], fit: &ArcFit, sum: usize) -> f64 {
    let n = points.len();
    let center = points.iter().fold(Vec3::ZERO, |s, p| s + (*p - points[0])) / n as f64 + points[0].to_vec();
    let across = |i: usize| points[(sum + n - i) % n] - points[i];
    let normal = (0..n).map(across).max_by(|a, b| a.length().total_cmp(&b.length())).and_then(Vec3::unit).unwrap();
    let mirrored = |p: Point3| p - normal * (2.0 * (p.to_vec() - center).dot(normal));
    assert!((0..n).all(|i| mirrored(points[i]).distance(points[(sum + n - i) % n]) < 2e-3), "no axis: {sum}");
    let samples = fit.path().arcs().iter().flat_map(|arc| (0..9).map(move |k| arc.point_at_length(f64::from(k) / 8.0)));
    samples.map(|p| fit.path().closest_point(mirrored(p)).distance).fold(0.0, f64::max)
}

/// Neither the place of a figure nor the first of its points matters.
#[test]
fn symmetric_outlines_get_symmetric_arcs() {
    for seed in 0..30 {
        let axes = [1, 2, 3, 5][seed as usize % 4];
        let tolerance = [0.3, 0.05, 0.01][seed as usize % 3];
        let points = placed(&rosette(axes, 60, seed), 0.1 * seed as f64, 9);
        let fit = fitted(&points, &closed(tolerance));
        for k in 0..axes {
            let off = asymmetry(&points, &fit, points.len() - 1 + k * points.len() / axes);
            assert!(off < 5e-8, "{seed}, axis {k} of {axes}: {off}");
        }
        assert!(fit.certificate().max_kink < 1e-9);
        let mut turned = points.clone();
        turned.rotate_left(7);
        turned.reverse();
        assert_eq!(pieces(&fitted(&turned, &closed(tolerance))), pieces(&fit), "{seed}");
    }
}

#[test]
fn outlines_with_corners_and_open_curves_get_them_too() {
    for seed in 0..16 {
        let tolerance = [0.2, 0.05, 0.02][seed as usize % 3];
        let decimals = [9, 4][seed as usize % 2];
        let points = placed(&plate(seed), 0.2 * seed as f64, decimals);
        let fit = fitted(&points, &closed(tolerance));
        let off = asymmetry(&points, &fit, points.len() - 1);
        assert!(off < [5e-8, 3e-4][seed as usize % 2], "plate {seed}: {off}");

        let mut random = Random(seed);
        let (height, wide) = (20.0 + 20.0 * random.next(), 0.35 + 0.3 * random.next());
        let n = 61 + seed as usize;
        let bell = |i: usize| {
            let x = 2.0 * i as f64 / (n - 1) as f64 - 1.0;
            Point3::new(50.0 * x, height * (-(x / wide).powi(2)).exp(), 0.0)
        };
        let points = placed(&(0..n).map(bell).collect::<Vec<_>>(), 0.2 * seed as f64, decimals);
        let fit = fitted(&points, &ArcFitOptions::new(tolerance));
        let off = asymmetry(&points, &fit, n - 1);
        assert!(off < [5e-8, 3e-4][seed as usize % 2], "bell {seed}: {off}");
    }
}

#[test]
fn what_is_symmetric_by_less_than_the_tolerance_is_fitted_as_it_is() {
    // One point off by half the tolerance: within the tolerance of its image, and no image.
    let mut points = rosette(1, 80, 4);
    points[11] = Point3::ORIGIN + points[11].to_vec() * (1.0 + 0.025 / points[11].to_vec().length());
    let fit = fitted(&points, &closed(0.05));
    assert!(fit.certificate().deviation <= 0.05);
}
