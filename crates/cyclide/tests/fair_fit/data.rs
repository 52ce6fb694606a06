//! The data of `docs/math/fair-fits.md#data-and-figures`: one generator, so that figures can be compared.

use cyclide::{
    Point3,
    construct::{FairFit, FairFitOptions},
    curve::{CircleSpline, ParamCurve},
};
use std::f64::consts::TAU;

/// Normal deviates: a linear congruential generator, the upper 53 bits, Box-Muller in pairs.
pub fn deviates(seed: u64, count: usize) -> Vec<f64> {
    let mut state = seed;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    let mut all = Vec::with_capacity(count + 1);
    while all.len() < count {
        let (a, b) = (uniform(), uniform());
        let radius = (-2.0 * a.ln()).sqrt();
        all.push(radius * (TAU * b).cos());
        all.push(radius * (TAU * b).sin());
    }
    all
}

/// Points moved by noise in the first `dimension` coordinates.
pub fn noisy(points: &[Point3], seed: u64, sigma: f64, dimension: usize) -> Vec<Point3> {
    let g = deviates(seed, points.len() * dimension);
    let z = |i: usize| if dimension == 3 { sigma * g[3 * i + 2] } else { 0.0 };
    let moved = |(i, p): (usize, &Point3)| {
        Point3::new(p.x + sigma * g[dimension * i], p.y + sigma * g[dimension * i + 1], p.z + z(i))
    };
    points.iter().enumerate().map(moved).collect()
}

pub fn outline() -> Vec<Point3> {
    let at = |i: usize| {
        let a = TAU * i as f64 / 400.0;
        let r = 40.0 + 8.0 * (3.0 * a).cos() + 3.0 * (5.0 * a).sin();
        Point3::new(1.4 * r * a.cos(), r * a.sin(), 0.0)
    };
    (0..400).map(at).collect()
}

pub fn noisy_outline() -> Vec<Point3> {
    noisy(&outline(), 7, 0.1, 2)
}

pub fn cable() -> Vec<Point3> {
    let at = |i: usize| {
        let s = i as f64 / 299.0;
        Point3::new(40.0 * s, 6.0 * (5.0 * s).sin(), 4.0 * (7.0 * s).cos() + 3.0 * s * s)
    };
    noisy(&(0..300).map(at).collect::<Vec<_>>(), 3, 0.02, 3)
}

pub fn gps() -> Vec<Point3> {
    let at = |i: usize| {
        let s = i as f64 / 239.0;
        let x = 900.0 * s + 60.0 * (9.0 * s).sin();
        Point3::new(x, 250.0 * (6.0 * s + 1.0).sin() + 80.0 * (14.0 * s).sin(), 0.0)
    };
    noisy(&(0..240).map(at).collect::<Vec<_>>(), 5, 2.0, 2)
}

pub fn trefoil() -> Vec<Point3> {
    let at = |i: usize| {
        let t = TAU * i as f64 / 240.0;
        let r = 2.0 + (3.0 * t).cos();
        Point3::new(r * (2.0 * t).cos(), r * (2.0 * t).sin(), (3.0 * t).sin())
    };
    (0..240).map(at).collect()
}

pub fn circle() -> Vec<Point3> {
    (0..90).map(|i| TAU * f64::from(i) / 90.0).map(|t| Point3::new(10.0 * t.cos(), 10.0 * t.sin(), 0.0)).collect()
}

/// Two legs that meet in a corner: its index is 100.
pub fn legs() -> Vec<Point3> {
    let g = deviates(9, 402);
    let noise = |i: usize| (0.02 * g[2 * i], 0.02 * g[2 * i + 1]);
    let mut points: Vec<Point3> = (0..=100)
        .map(|i| {
            let (x, y) = noise(i);
            Point3::new(i as f64 / 10.0 + x, 0.5 * (i as f64 / 20.0).sin() + y, 0.0)
        })
        .collect();
    let corner = points[100];
    points.extend((1..=100).map(|i| {
        let (x, y) = noise(100 + i);
        Point3::new(corner.x + 0.3 * (i as f64 / 25.0).sin() + x, corner.y + i as f64 / 10.0 + y, 0.0)
    }));
    points
}

/// The points of a file of the examples.
pub fn example(text: &str) -> Vec<Point3> {
    let point = |line: &str| {
        let mut numbers = line.split(',').map(str::trim).map(str::parse::<f64>);
        Some(Point3::new(numbers.next()?.ok()?, numbers.next()?.ok()?, 0.0))
    };
    text.lines().filter_map(point).collect()
}

pub fn closed(tolerance: f64) -> FairFitOptions {
    FairFitOptions { closed: true, ..FairFitOptions::new(tolerance) }
}

/// Fits and checks what must hold of every fit: the tolerance, by an independent search for the nearest points, and
/// continuous curvature where the curve is smooth.
pub fn fitted(points: &[Point3], options: &FairFitOptions) -> FairFit {
    let fit = FairFit::new(points, options).unwrap();
    let curve = fit.spline();
    let certificate = fit.certificate();
    assert!(certificate.deviation <= options.tolerance);
    assert!(certificate.rms <= certificate.deviation);
    for (i, p) in points.iter().enumerate().step_by(points.len().div_ceil(100)) {
        let nearest = cyclide::curve::closest_point(curve, *p).distance;
        // The certificate's feet may be farther than the nearest point, never nearer, but for the rounding of coordinates.
        let rounding = 16.0 * f64::EPSILON * p.to_vec().max_abs();
        assert!(nearest <= certificate.deviation * (1.0 + 1e-9) + rounding, "point {i}: {nearest}");
    }
    let nodes = curve.segments().len() + usize::from(!options.closed);
    assert_eq!(certificate.nodes, nodes);
    assert_eq!(curve.is_closed(), options.closed);
    // The bound of `docs/math/fair-fits.md#data-and-figures`; rounding of the nodes themselves adds eps |x|/d per chord
    // d.
    let largest = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    for (i, joint) in cyclide::curve::joints(curve).iter().enumerate() {
        if joint.angle > 1e-6 {
            assert!(!curve.kinks().is_empty(), "joint {i}");
            continue;
        }
        let n = curve.segments().len();
        let d = |j: usize| curve.segments()[j % n].chord_length();
        let shortest = (0..n).map(d).fold(f64::INFINITY, f64::min);
        let rounding = 64.0 * f64::EPSILON * largest / (shortest * shortest);
        assert!(joint.curvature_jump <= 2e-11 / shortest + rounding, "joint {i}: {}", joint.curvature_jump);
    }
    fit
}

/// `int k'² ds L³` of a curve by 48 samples a segment, and the sign changes of its curvature seen against z.
pub fn variation(curve: &CircleSpline) -> (f64, usize) {
    let (mut sum, mut length) = (0.0, 0.0);
    let mut signs = Vec::new();
    for segment in curve.segments() {
        for k in 0..48 {
            let jet = segment.jet((f64::from(k) + 0.5) / 48.0);
            let speed = jet.d1.length();
            let bend = jet.d1.cross(jet.d2);
            let size = bend.length();
            let k = size / speed.powi(3);
            let rate = if size > 0.0 { bend.dot(jet.d1.cross(jet.d3)) / size / speed.powi(3) } else { 0.0 };
            let slope = (rate - 3.0 * k * jet.d1.dot(jet.d2) / (speed * speed)) / speed;
            sum += slope * slope * speed / 48.0;
            length += speed / 48.0;
            if bend.z != 0.0 {
                signs.push(bend.z > 0.0);
            }
        }
    }
    let changes = signs.windows(2).filter(|w| w[0] != w[1]).count();
    let seam = curve.is_closed() && signs.first() != signs.last();
    (sum * length.powi(3), changes + usize::from(seam))
}

/// The certificate's bound on the distance between curve and polyline against samples of the curve.
pub fn sampled_distance_from_polyline(curve: &CircleSpline, points: &[Point3], closed: bool) -> f64 {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let to_edge = |p: Point3, i: usize| {
        let (a, b) = (points[i], points[(i + 1) % n]);
        let e = b - a;
        let s = ((p - a).dot(e) / e.dot(e)).clamp(0.0, 1.0);
        p.distance(a.lerp(b, s))
    };
    let nearest = |p: Point3| (0..edges).map(|i| to_edge(p, i)).fold(f64::INFINITY, f64::min);
    let samples = curve.segments().iter().flat_map(|s| (0..16).map(|k| s.point(f64::from(k) / 16.0)));
    samples.map(nearest).fold(0.0, f64::max)
}
