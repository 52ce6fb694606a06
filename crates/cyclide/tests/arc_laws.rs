//! Laws of single arcs (`docs/math/arcs.md#images-under-maps`) on random, near-degenerate and badly scaled arcs.
//!
//! Bounds are in units of the last place of the arc's size, times the amplification near a full circle (see
//! `ArcCase::rounding`); the factors are some tens of operations, each rounded once.

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    curve::{Arc, ParamCurve},
};
use cyclide_testkit::generators::{ArcCase, arc, direction, point, scale, tame_arc, with_rounding};
use proptest::prelude::*;

/// Parameters that include both ends and the switch of the formula at 1/2.
const PARAMETERS: [f64; 9] = [0.0, 1e-9, 0.125, 0.4, 0.5, 0.625, 0.875, 1.0 - 1e-9, 1.0];

/// Fails unless two points agree to `units` of rounding.
fn close(a: Point3, b: Point3, case: &ArcCase, units: f64, what: &str) -> Result<(), TestCaseError> {
    let (error, allowed) = (a.distance(b), case.rounding(units));
    prop_assert!(error <= allowed, "{what}: {error:e} > {allowed:e} for {:?}", case.arc);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2 * ProptestConfig::default().cases, ..ProptestConfig::default() })]

    #[test]
    fn ends_are_exact_and_points_are_in_the_plane_on_the_circle(case in arc()) {
        let a = case.arc;
        prop_assert_eq!((a.point(0.0), a.point(1.0)), (a.start(), a.end()));
        for t in PARAMETERS {
            let p = a.point(t);
            if let Some(n) = a.normal() {
                let off = (p - a.start()).dot(n).abs();
                prop_assert!(off <= case.rounding(16.0), "off the plane by {off:e}");
            }
            // On the circle, said without a radius so that it holds for lines: |v|² kappa = 2 <v, inward normal>.
            let (v, t0) = (p - a.start(), a.start_tangent().unwrap());
            let inward = a.normal().map_or(Vec3::ZERO, |n| n.cross(t0));
            let error = (v.length() * (v.length() * a.curvature()) - 2.0 * v.dot(inward)).abs();
            prop_assert!(error <= case.rounding(32.0), "off the circle by {error:e}");
            if let (Some(center), Some(radius)) = (a.center(), a.radius()) {
                let error = (p.distance(center) - radius).abs();
                let allowed = case.rounding(16.0).max(16.0 * f64::EPSILON * radius * case.condition);
                prop_assert!(error <= allowed, "radius off by {error:e} > {allowed:e}");
            }
        }
    }

    #[test]
    fn parts_of_a_split_are_the_arc(case in arc(), t in 1e-6..1.0 - 1e-6_f64, s in 0.0..=1.0_f64) {
        let (left, right) = case.arc.split(t).unwrap();
        close(left.point(s), case.arc.point(t * s), &case, 64.0, "left")?;
        close(right.point(s), case.arc.point(t + s * (1.0 - t)), &case, 64.0, "right")?;
        prop_assert_eq!(left.end(), right.start());
        let (whole, sum) = (case.arc.length(), left.length() + right.length());
        prop_assert!((whole - sum).abs() <= case.rounding(64.0) + 64.0 * f64::EPSILON * whole * case.condition, "{whole:e} {sum:e}");
    }

    #[test]
    fn reversed_runs_backwards_and_back(case in arc()) {
        let back = case.arc.reversed();
        for t in PARAMETERS {
            close(back.point(t), case.arc.point(1.0 - t), &case, 32.0, "reversed")?;
            close(back.reversed().point(t), case.arc.point(t), &case, 32.0, "twice")?;
        }
        prop_assert!((back.length() - case.arc.length()).abs() <= 16.0 * f64::EPSILON * case.arc.length() * case.condition);
    }

    #[test]
    fn the_homogeneous_rows_are_the_quaternion_form(case in arc(), t in 0.0..=1.0_f64) {
        let rows = case.arc.bezier_rows();
        let basis = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
        let h: [f64; 4] = std::array::from_fn(|i| (0..3).map(|k| basis[k] * rows[k][i]).sum());
        // The sum for the weight cancels beyond a half turn: rounding of its terms over what is left.
        let w = case.arc.weight_ratio();
        let terms = basis[0] + basis[1] * w.w.abs() + basis[2] * w.norm_squared();
        let amplified = ArcCase { condition: case.condition * terms / h[3], ..case };
        close(Point3::new(h[0] / h[3], h[1] / h[3], h[2] / h[3]), case.arc.point(t), &amplified, 32.0, "rows")?;
    }

    #[test]
    fn exact_splines_are_the_arc(case in arc()) {
        let nurbs = case.arc.to_nurbs(cyclide::curve::DEFAULT_PIECE_ANGLE).unwrap();
        prop_assert!(nurbs.weights().iter().all(|w| *w > 0.7));
        for i in 0..=24 {
            let p = nurbs.point_at_knot(f64::from(i) / 24.0);
            let nearest = case.arc.closest_point(p);
            prop_assert!(nearest.distance <= case.rounding(64.0), "{:e} {:e}", nearest.distance, case.rounding(64.0));
        }
    }

    #[test]
    fn a_common_right_factor_of_the_weights_changes_nothing(case in arc(), q in direction(), r in -2.0..2.0_f64) {
        let (w, q) = (case.arc.weight_ratio(), Quat::from_parts(r, q));
        let same = Arc::from_weights(case.arc.start(), case.arc.end(), q, w * q).unwrap();
        for t in PARAMETERS {
            close(same.point(t), case.arc.point(t), &case, 64.0 * case.condition, "gauge")?;
        }
    }

    #[test]
    fn derivatives_are_limits_of_differences(case in tame_arc(), t in 0.1..0.9_f64) {
        let h = 1e-5;
        let [before, here, after] = [t - h, t, t + h].map(|t| case.arc.piece_jet(0, t));
        let size = case.arc.chord().length() * case.condition.powi(4);
        let pairs = [
            (after.point - before.point, here.d1),
            (after.d1 - before.d1, here.d2),
            (after.d2 - before.d2, here.d3),
        ];
        for (k, (difference, derivative)) in pairs.into_iter().enumerate() {
            // Truncation h²/6 times the derivative two orders higher, and rounding of the values over 2h.
            let growth = (12.0_f64 * case.condition).powi(k as i32 + 2);
            let allowed = h * h * growth * size * 12.0 + case.rounding(16.0) / h * growth;
            let error = (difference / (2.0 * h) - derivative).length();
            prop_assert!(error <= allowed, "order {}: {error:e} > {allowed:e}", k + 1);
        }
    }

    #[test]
    fn constant_speed_parameter_inverts_the_length(case in arc(), l in 0.0..=1.0_f64) {
        let (a, t) = (case.arc, case.arc.parameter_at_length(l));
        prop_assert!((0.0..=1.0).contains(&t));
        close(a.point(t), a.point_at_length(l), &case, 64.0, "point at length")?;
        let error = (a.length_to(t) - l * a.length()).abs();
        prop_assert!(error <= 64.0 * f64::EPSILON * a.length() * case.condition, "{error:e}");
        let middle = a.midpoint().distance(a.point_at_length(0.5));
        prop_assert!(middle <= case.rounding(32.0), "midpoint off by {middle:e}");
    }

    #[test]
    fn uniform_points_are_uniform(case in arc()) {
        let points = case.arc.uniform_points(4).unwrap();
        prop_assert_eq!((points[0], points[16]), (case.arc.start(), case.arc.end()));
        for (i, p) in points.iter().enumerate() {
            close(*p, case.arc.point_at_length(i as f64 / 16.0), &case, 64.0, "uniform")?;
        }
    }

    #[test]
    fn closest_point_is_not_beaten_by_a_dense_search(case in arc(), p in point(), reach in prop_oneof![Just(1e-3), Just(1.0), Just(30.0)]) {
        let size = case.size.min(2.0 * case.arc.length());
        let p = case.arc.point_at_length(0.3) + p.to_vec() * (reach * size);
        let nearest = case.arc.closest_point(p);
        prop_assert!(nearest.point.distance(case.arc.point(nearest.t)) <= case.rounding(8.0));
        let allowed = case.rounding(64.0) + 16.0 * f64::EPSILON * reach * size;
        for i in 0..=400 {
            let found = case.arc.point_at_length(f64::from(i) / 400.0).distance(p);
            prop_assert!(nearest.distance <= found + allowed, "{:e} beaten by {found:e} at {i}", nearest.distance);
        }
    }

    #[test]
    fn bounds_hold_the_arc_and_touch_it(case in arc()) {
        let bounds = case.arc.bounds();
        let mut reached = cyclide::Aabb::of_point(case.arc.start());
        for i in 0..=400 {
            reached = reached.including(case.arc.point_at_length(f64::from(i) / 400.0));
        }
        let length = case.arc.length();
        for i in 0..3 {
            let slack = case.rounding(64.0);
            prop_assert!(bounds.min[i] <= reached.min[i] + slack && bounds.max[i] >= reached.max[i] - slack);
            // 400 steps: between two samples an extreme rises by at most (step)²/(8 R), R at least length/(2 pi).
            let gap = length * (std::f64::consts::TAU / (8.0 * 400.0 * 400.0)) + slack;
            prop_assert!(bounds.min[i] >= reached.min[i] - gap && bounds.max[i] <= reached.max[i] + gap);
        }
    }

    #[test]
    fn similarities_keep_the_parameter(case in arc(), axis in direction(), angle in -3.0..3.0_f64, factor in 0.1..10.0_f64, shift in point()) {
        let shift = shift.to_vec() * case.size;
        let map = Mobius::similarity(Quat::from_axis_angle(axis, angle), factor, shift).unwrap();
        let image = case.arc.transformed(&map).unwrap();
        let larger = ArcCase { size: case.size * (factor + 1.0), ..case };
        for t in PARAMETERS {
            let expected = map.map_point(case.arc.point(t)).unwrap();
            close(image.point(t), expected, &larger, 64.0, "similarity")?;
        }
    }

    #[test]
    fn inversions_keep_the_parameter_and_map_the_weight(case in tame_arc(), d in direction(), distance in 0.2..3.0_f64) {
        let extent = case.arc.chord().length() * case.condition;
        let o = case.arc.point_at_length(0.5) + d * (distance * extent);
        // Centers off the arc by a tenth of its size, or the image is too large to compare.
        prop_assume!(case.arc.closest_point(o).distance > 0.1 * extent);
        let map = Mobius::inversion(o, extent).unwrap();
        let image = case.arc.transformed(&map).unwrap();
        let allowed = case.rounding(4e3) * case.condition;
        for t in PARAMETERS {
            let y = case.arc.point(t) - o;
            let expected = o + y * (extent / y.length() * (extent / y.length()));
            let error = image.point(t).distance(expected);
            prop_assert!(error <= allowed, "{error:e} > {allowed:e}");
        }
        let unit = |v: Vec3| Quat::from(v * (1.0 / extent));
        let weight = unit(case.arc.end() - o) * case.arc.weight_ratio() * unit(case.arc.start() - o).inverse().unwrap();
        let error = (image.weight_ratio() - weight).norm() / weight.norm();
        prop_assert!(error <= 1e-11, "weight off by {error:e}");
    }

    #[test]
    fn scaling_by_powers_of_two_is_exact(case in arc(), power in -20..20_i32) {
        let f = 2.0_f64.powi(power);
        let scaled = |p: Point3| Point3::ORIGIN + p.to_vec() * f;
        let same = Arc::from_weight_ratio(scaled(case.arc.start()), scaled(case.arc.end()), case.arc.weight_ratio()).unwrap();
        for t in PARAMETERS {
            close(same.point(t), scaled(case.arc.point(t)), &with_rounding(same), 4.0, "scaled")?;
        }
    }

    #[test]
    fn tangent_constructors_keep_their_tangent(a in point(), c in direction(), v in direction(), s in scale(), speed in 0.01..100.0_f64) {
        let (p0, p1) = (Point3::ORIGIN + a.to_vec() * s, Point3::ORIGIN + (a.to_vec() + c) * s);
        let v = v * (speed * s);
        let by_start = Arc::from_start_tangent(p0, p1, v);
        let by_end = Arc::from_end_tangent(p0, p1, v);
        for (arc, got) in [(by_start, by_start_derivative as fn(&Arc) -> Vec3), (by_end, by_end_derivative)] {
            let Ok(arc) = arc else { continue };
            let error = (got(&arc) - v).length();
            prop_assert!(error <= 16.0 * f64::EPSILON * v.length() * with_rounding(arc).condition, "{error:e}");
        }
    }
}

fn by_start_derivative(arc: &Arc) -> Vec3 {
    arc.start_derivative()
}

fn by_end_derivative(arc: &Arc) -> Vec3 {
    arc.end_derivative()
}

#[test]
fn nearly_full_circles_are_refused_with_their_limit() {
    let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
    // What a bulge of ten millions leaves of a full turn.
    let rest = 3.9e-7;
    let by_bulge = |bulge: f64| Arc::from_bulge(a, b, Vec3::Z, bulge);
    let by_sweep = |rest: f64| Arc::from_center(a, Vec3::Z, b, std::f64::consts::TAU - rest);
    let by_tangent = |rest: f64| Arc::from_start_tangent(a, b, Vec3::new(-1.0, -0.5 * rest, 0.0));
    for exponent in [8, 9, 12, 15] {
        let bulge = 10.0_f64.powi(exponent);
        for arc in [by_bulge(bulge), by_bulge(-bulge), by_sweep(4.0 / bulge), by_tangent(4.0 / bulge)] {
            // At 1e15 the sweep is a full turn in doubles, or the tangent the chord itself.
            let reason = arc.unwrap_err().reason();
            let pole = ["sweep-out-of-range", "tangent-opposes-chord", "coincident-points"];
            assert!(
                reason == "nearly-full-circle" || (exponent == 15 && pole.contains(&reason)),
                "{bulge:e}: {reason}"
            );
        }
    }
    for arc in [by_bulge(1e7), by_sweep(1.01 * rest), by_tangent(1.01 * rest)] {
        let arc = arc.unwrap();
        let (center, radius) = (arc.center().unwrap(), arc.radius().unwrap());
        for i in 0..=100 {
            // The circle itself keeps its digits.
            let p = arc.point_at_length(f64::from(i) / 100.0);
            assert!((p.distance(center) / radius - 1.0).abs() < 1e-9, "{i}");
        }
    }
    let message = by_bulge(1e8).unwrap_err().to_string();
    assert!(
        message.contains("4e-8 radians short of a full circle, minimum 3.9e-7") && message.contains("use a circle"),
        "{message}"
    );
}

#[test]
fn images_below_rounding_are_segments() {
    // Of radius 1e-12 at 1, brought to where coordinates are 8: the center would be the same doubles as the points.
    let small = Arc::from_center(Point3::new(1.0, 2.0, 0.0), Vec3::Z, Point3::new(1.0 + 1e-15, 2.0, 0.0), 3.0).unwrap();
    let moved = small.transformed(&Mobius::translation(Vec3::new(7.0, 0.5, 0.0)).unwrap()).unwrap();
    assert!(moved.is_straight() && moved.center().is_none());
    let large = Arc::from_center(Point3::new(1.0, 2.0, 0.0), Vec3::Z, Point3::new(1.0 + 1e-13, 2.0, 0.0), 3.0).unwrap();
    assert!(!large.transformed(&Mobius::translation(Vec3::new(7.0, 0.5, 0.0)).unwrap()).unwrap().is_straight());
}
