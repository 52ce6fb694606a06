//! The curves that the benches share.

#![allow(dead_code, reason = "each bench takes what it needs")]

use cyclide::{
    Point3,
    construct::ArcSplineOptions,
    curve::{ArcPath, BlendVariant, CircleSpline, CircleSplineOptions},
};

/// `n` samples of a closed track of about 1000 by 700 meters with bends of every radius; not repeated at the end.
pub fn track(n: usize) -> Vec<Point3> {
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / n as f64;
        let r = 1.0 + 0.25 * (3.0 * a).cos() + 0.1 * (7.0 * a + 1.0).sin();
        Point3::new(500.0 * r * a.cos(), 350.0 * r * a.sin(), 0.0)
    };
    (0..n).map(at).collect()
}

/// Arcs through the samples: two per span.
pub fn arcs(n: usize) -> ArcPath {
    ArcPath::spline(&track(n), &ArcSplineOptions { closed: true, ..Default::default() }).unwrap()
}

/// The circle spline of order 2 through the samples.
pub fn blends(n: usize, variant: BlendVariant) -> CircleSpline {
    let options = CircleSplineOptions { closed: true, variant, ..Default::default() };
    CircleSpline::from_points(&track(n), &options).unwrap()
}
