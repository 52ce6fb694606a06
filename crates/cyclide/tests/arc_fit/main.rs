//! Laws of arc fitting (`docs/math/arc-fitting.md`): certificates against sampling, intervals from inside and outside,
//! symmetry, counts on true arcs, and the data that tempt a fit into rogue arcs.

mod circuits;
mod fits;
mod one_arc;
mod outlines;
mod symmetry;

use cyclide::{
    Error, Point2, Point3, Warning,
    construct::{ArcFit, ArcFitOptions, Effort, FitTarget, certify_arc, curvature_intervals, feasible_bulges},
    curve::ParamCurve,
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const MAX_SWEEP: f64 = 350.0 / 180.0 * PI;

fn flat(points: &[Point2]) -> Vec<Point3> {
    points.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect()
}

/// Points along a tangent-continuous chain of arcs given by (length, curvature), `per_arc` samples each.
fn chain(arcs: &[(f64, f64)], per_arc: usize) -> Vec<Point3> {
    let (mut x, mut y, mut angle) = (0.0, 0.0, 0.3_f64);
    let mut points = vec![Point3::new(x, y, 0.0)];
    for (length, curvature) in arcs {
        let step = length / per_arc as f64;
        for _ in 0..per_arc {
            let half = 0.5 * curvature * step;
            // The chord of an arc of turn 2 half is sinc(half) times its length, at the angle half.
            let chord = if half == 0.0 { step } else { step * half.sin() / half };
            x += chord * (angle + half).cos();
            y += chord * (angle + half).sin();
            angle += 2.0 * half;
            points.push(Point3::new(x, y, 0.0));
        }
    }
    points
}

fn closed(tolerance: f64) -> ArcFitOptions {
    ArcFitOptions { closed: true, ..ArcFitOptions::new(tolerance) }
}

fn polyline(tolerance: f64) -> ArcFitOptions {
    ArcFitOptions { target: FitTarget::Polyline, ..ArcFitOptions::new(tolerance) }
}

fn pieces(fit: &ArcFit) -> usize {
    fit.path().arcs().len()
}

/// Distance of a point from the nearest edge.
fn to_polyline(p: Point3, points: &[Point3], closed: bool) -> f64 {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let edge = |i: usize| {
        let (a, b) = (points[i], points[(i + 1) % n]);
        let e = b - a;
        p.distance(a.lerp(b, ((p - a).dot(e) / e.dot(e)).clamp(0.0, 1.0)))
    };
    (0..edges).map(edge).fold(f64::INFINITY, f64::min)
}

/// Everything the certificate claims, measured again by sampling.
fn check(points: &[Point3], options: &ArcFitOptions, fit: &ArcFit) {
    let (certificate, path) = (fit.certificate(), fit.path());
    let tolerance = options.tolerance;
    // Sampling and certificate each round at the size of the coordinates.
    let largest = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let rounding = 1e-12 * tolerance + 16.0 * f64::EPSILON * largest;
    assert!(certificate.deviation <= tolerance);
    assert!(certificate.monotone);
    assert_eq!(certificate.arcs + certificate.lines, pieces(fit));
    // Nearest to the whole path is at most as far as nearest to the part that stands for the point.
    for p in points {
        assert!(path.closest_point(*p).distance <= certificate.vertex_deviation * (1.0 + 1e-9) + rounding);
    }
    let mut sampled = 0.0_f64;
    for arc in path.arcs() {
        for i in 0..=40 {
            let p = arc.point_at_length(f64::from(i) / 40.0);
            sampled = sampled.max(to_polyline(p, points, options.closed));
        }
    }
    let n = points.len();
    for i in 0..if options.closed { n } else { n - 1 } {
        for k in 0..10 {
            let p = points[i].lerp(points[(i + 1) % n], f64::from(k) / 10.0);
            sampled = sampled.max(path.closest_point(p).distance);
        }
    }
    assert!(
        sampled <= certificate.polyline_deviation * (1.0 + 1e-9) + rounding,
        "sampled {sampled:e}, certified {:e}",
        certificate.polyline_deviation
    );
    // Joints are smooth or corners; one that is asked for may turn by anything.
    let arcs = path.arcs();
    for i in usize::from(!options.closed)..arcs.len() {
        let (before, after) = (&arcs[(i + arcs.len() - 1) % arcs.len()], &arcs[i]);
        let turn = before.end_tangent().zip(after.start_tangent()).map_or(0.0, |(from, to)| from.angle(to));
        assert!(!options.corners.is_empty() || !(1e-9..1e-3).contains(&turn), "joint {i} turns by {turn:e}");
    }
    if options.closed {
        assert_eq!(path.point(0.0), path.point(1.0));
    } else {
        assert_eq!(path.point(0.0), points[0]);
        assert_eq!(path.point(1.0), points[n - 1]);
    }
}

#[expect(clippy::unwrap_used, reason = "a fit that fails is a failed test")]
fn fitted(points: &[Point3], options: &ArcFitOptions) -> ArcFit {
    let fit = ArcFit::new(points, options).unwrap();
    check(points, options, &fit);
    fit
}

fn circle(n: usize, turn: f64, radius: f64, center: Point3) -> Vec<Point3> {
    let at = |i: usize| {
        let (s, c) = (turn * i as f64 / n as f64).sin_cos();
        Point3::new(center.x + radius * c, center.y + radius * s, center.z)
    };
    (0..n).map(at).collect()
}

/// Uniform in [-1/2, 1/2); the point is a fixed sequence, not its quality.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    }
}
