//! Laws that every curve obeys, on one list of every implementor of [`ParamCurve`].
//!
//! Lengths in the laws are measured against the curve's own size; each bound states where it comes from.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod curves;

use curves::{Case, cases};
use cyclide::{ParamCurve, Point3, bounds, extreme_curvature, flatten, joints, length};

/// Runs a law on every curve of the list.
fn each(law: impl Fn(&Case, &dyn ParamCurve)) {
    for case in cases() {
        law(&case, case.curve.as_ref());
    }
}

/// Distance from a point to a segment.
fn segment_distance(p: Point3, a: Point3, b: Point3) -> f64 {
    let c = b - a;
    let l2 = c.length_squared();
    let t = if l2 > 0.0 { ((p - a).dot(c) / l2).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a.lerp(b, t))
}

#[test]
fn pieces_meet_at_their_joints() {
    each(|case, curve| {
        let n = curve.piece_count();
        for joint in joints(curve) {
            assert!(joint.gap <= 4.0 * f64::EPSILON * case.reach, "{}: {joint:?}", case.name);
            assert!(joint.piece < n && joint.next < n);
        }
        let want = if curve.is_closed() { n } else { n - 1 };
        assert_eq!(joints(curve).len(), want, "{}", case.name);
    });
}

#[test]
fn flattening_stays_within_the_tolerance() {
    each(|case, curve| {
        for relative in [1e-1, 1e-3, 1e-5] {
            let tolerance = relative * case.size;
            let polyline = flatten(curve, tolerance).unwrap();
            assert_eq!(polyline[0], (0.0, curve.eval(0.0)));
            assert_eq!(polyline[polyline.len() - 1].0, 1.0);
            for w in polyline.windows(2) {
                let ((t0, a), (t1, b)) = (w[0], w[1]);
                assert!(t1 > t0, "{}: {t0} {t1}", case.name);
                for j in 1..16 {
                    let p = curve.eval(t0 + (t1 - t0) * f64::from(j) / 16.0);
                    let d = segment_distance(p, a, b);
                    assert!(
                        d <= tolerance * (1.0 + 1e-9) + 8.0 * f64::EPSILON * case.reach,
                        "{} at tolerance {tolerance:e}: {d:e}",
                        case.name
                    );
                }
            }
        }
    });
}

/// Points so dense that the tangent turns by less than 0.01 between neighbours.
fn dense_points(curve: &dyn ParamCurve) -> Vec<Point3> {
    fn fill(curve: &dyn ParamCurve, piece: usize, a: f64, b: f64, points: &mut Vec<Point3>) {
        let m = 0.5 * (a + b);
        let tangent = |s: f64| curve.piece_jet(piece, s).tangent().unwrap();
        let turn = tangent(a).angle(tangent(m)) + tangent(m).angle(tangent(b));
        if turn < 0.01 && b - a < 0.1 {
            points.push(curve.piece_point(piece, b));
        } else {
            fill(curve, piece, a, m, points);
            fill(curve, piece, m, b, points);
        }
    }
    let mut points = vec![curve.eval(0.0)];
    for piece in 0..curve.piece_count() {
        fill(curve, piece, 0.0, 1.0, &mut points);
    }
    points
}

#[test]
fn length_is_that_of_a_dense_polyline() {
    each(|case, curve| {
        let points = dense_points(curve);
        let chords: f64 = points.windows(2).map(|w| w[0].distance(w[1])).sum();
        let got = length(curve);
        // A chord is short of its arc by (turn)²/24 of itself.
        let rounding = 1e-12 * got + points.len() as f64 * f64::EPSILON * case.reach;
        assert!(got >= chords - rounding, "{}: {got} {chords}", case.name);
        assert!(got <= chords * (1.0 + 0.01_f64.powi(2) / 24.0 * 1.01) + rounding, "{}: {got} {chords}", case.name);
    });
}

#[test]
fn bounds_contain_the_curve_and_touch_it() {
    each(|case, curve| {
        let b = bounds(curve);
        let n = 1000 * curve.piece_count();
        let points: Vec<Point3> = (0..=n).map(|i| curve.eval(i as f64 / n as f64)).collect();
        let sampled = cyclide::Aabb::of_points(points.iter().copied()).unwrap();
        let rounding = 1e-12 * case.size + 4.0 * f64::EPSILON * case.reach;
        for axis in 0..3 {
            assert!(b.min[axis] <= sampled.min[axis] + rounding, "{} axis {axis}", case.name);
            assert!(b.max[axis] >= sampled.max[axis] - rounding, "{} axis {axis}", case.name);
            // Samples miss an extreme by at most the sagitta of one step, below (step)² times curvature.
            let step = points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
            let sagitta = step * (step * extreme_curvature(curve).max).min(1.0);
            assert!(b.min[axis] >= sampled.min[axis] - sagitta - rounding, "{} axis {axis}", case.name);
            assert!(b.max[axis] <= sampled.max[axis] + sagitta + rounding, "{} axis {axis}", case.name);
        }
    });
}

#[test]
fn largest_curvature_is_not_exceeded_by_samples() {
    each(|case, curve| {
        let e = extreme_curvature(curve);
        let n = 1000 * curve.piece_count();
        let samples = (0..=n).filter_map(|i| curve.jet(i as f64 / n as f64).curvature());
        let sampled = samples.fold(0.0, f64::max);
        // Curvature by derivatives loses the digits that the position spends on the distance from the origin.
        let rounding = 1e-9 * e.max + 1e-9 / case.size;
        assert!(e.max >= sampled - rounding, "{}: {} {sampled}", case.name, e.max);
        let there = curve.jet(e.t);
        assert!((there.curvature().unwrap_or(0.0) - e.max).abs() <= rounding, "{}", case.name);
        assert_eq!(there.point, e.point, "{}", case.name);
    });
}
