//! Points, derivatives, curvatures and the forms of one patch agree with each other.

use super::{PLACES, cross_ratio_defect};
use cyclide::{
    Point3, Quat, Vec3,
    surface::{CyclidePatch, ParamSurface},
};
use cyclide_testkit::patches::{patch, tame_patch, triangular_patch};
use proptest::prelude::*;

/// Places off the sides, for differences.
const INNER: [(f64, f64); 4] = [(0.5, 0.5), (0.1, 0.8), (0.75, 0.3), (0.95, 0.95)];

/// The second, or the third, corner next to the first: the patch is as exact as any other, and the two are each other's
/// mirror image in the parameters.
#[test]
fn corners_next_to_the_first_cost_no_digits() {
    let (v1, v2) = (Vec3::new(0.48, 0.6, 0.64), Vec3::new(0.8, 0.0, -0.6));
    let on_circle = |angle: f64| Point3::new(angle.cos(), angle.sin(), 0.0);
    for distance in [1e-3, 1e-6, 1e-9, 1e-11] {
        let [a0, a1, a3, a2] = [0.7, 0.7 + distance, 2.9, 4.1].map(on_circle);
        let near_second = CyclidePatch::from_corners_and_frame([a0, a1, a2, a3], v1, v2).unwrap();
        let near_third = CyclidePatch::from_corners_and_frame([a0, a2, a1, a3], v2, v1).unwrap();
        for (s, t) in PLACES {
            // Some ten operations on numbers of the size; rounding of the near corner turns the circle, for both alike.
            assert!(near_second.real_residual(s, t) <= 64.0 * f64::EPSILON, "{distance} {s} {t}");
            let apart = near_second.point(s, t).distance(near_third.point(t, s));
            assert!(apart <= 256.0 * f64::EPSILON, "{distance} {s} {t}: {apart:e}");
        }
    }
}

proptest! {
    #[test]
    fn corners_are_reached_and_the_quotient_is_in_space(case in patch()) {
        for (k, (s, t)) in PLACES[..4].iter().enumerate() {
            prop_assert!(case.patch.point(*s, *t).distance(case.data.corners[k]) <= case.rounding(64.0));
        }
        for (s, t) in PLACES {
            prop_assert!(case.patch.real_residual(s, t) <= case.rounding(64.0));
        }
    }

    #[test]
    fn speeds_are_real_multiples_of_the_constant_frame(case in patch()) {
        // Line by line what is proved at `PatchRow`.
        let (a, w, [v1, v2, v3]) = (case.patch.corners(), case.patch.weights(), case.patch.frame());
        let k = |i: usize, j: usize| w[i].conj() * Quat::from(a[j] - a[i]) * w[j];
        let inverse = |i: usize| (a[i] - a[0]) / -(a[i] - a[0]).length_squared();
        let (e, side) = (inverse(1) - inverse(2), inverse(1) - inverse(3));
        let x = side.dot(e) / e.length_squared();
        // (9) is (C) with these factors of w1 and w2.
        let (lam, mu) = (a[0].distance(a[1]), a[0].distance(a[2]));
        let e = e * (lam * mu);
        let squared = e.length_squared() / (lam * mu);
        let expected = [
            (k(0, 1), v1 * lam, 0.0),
            (k(0, 2), v2 * mu, 0.0),
            (k(0, 3), v1 * e.dot(v2) - v2 * e.dot(v1), -e.dot(v3)),
            (k(1, 2), v1 * -e.dot(v2) - v2 * e.dot(v1), e.dot(v3)),
            (k(1, 3), v2 * (x * squared * lam), 0.0),
            (k(2, 3), v1 * ((1.0 - x) * squared * mu), 0.0),
        ];
        // Lengths times two weights, with the rounding of the corners.
        let largest = w.iter().map(|w| w.norm_squared()).fold(0.0, f64::max);
        let bound = case.rounding(64.0) / case.reach * case.aspect * largest;
        for (got, vector, real) in expected {
            prop_assert!((got - Quat::from_parts(real, vector)).norm() <= bound, "{got:?} {vector:?} {real}");
        }
        let middle = [k(0, 3) + k(1, 2).conj(), k(0, 3) + k(1, 2)];
        let (q1, q2) = (case.patch.q1(), case.patch.q2());
        for (got, direction, speeds) in [([k(0, 1), middle[0], k(2, 3)], v1, q1), ([k(0, 2), middle[1], k(1, 3)], v2, q2)] {
            for (got, speed) in got.into_iter().zip([speeds[0], 2.0 * speeds[1], speeds[2]]) {
                prop_assert!((got - Quat::from(direction * speed)).norm() <= bound, "{got:?} {speed}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_point(case in tame_patch()) {
        let (patch, h) = (&case.patch, 1e-5);
        for (s, t) in INNER {
            let jet = patch.jet(s, t);
            let along = |f: &dyn Fn(f64, f64) -> Vec3| {
                ((f(s + h, t) - f(s - h, t)) / (2.0 * h), (f(s, t + h) - f(s, t - h)) / (2.0 * h))
            };
            let (ds, dt) = along(&|s, t| patch.point(s, t) - patch.corners()[0]);
            let (dss, dst) = along(&|s, t| patch.jet(s, t).ds);
            let (dts, dtt) = along(&|s, t| patch.jet(s, t).dt);
            // Central differences: h² = 1e-10 of the third derivative, which the quotient can make reach² as large as the
            // patch, and rounding over h.
            let first = 1e-9 * patch.size() * case.reach.powi(2) + case.rounding(64.0) / h;
            let second = 1e-8 * patch.size() * case.reach.powi(3) + case.reach * case.rounding(64.0) / h;
            prop_assert!((jet.ds - ds).length() <= first && (jet.dt - dt).length() <= first);
            for (got, want) in [(jet.dss, dss), (jet.dst, dst), (jet.dst, dts), (jet.dtt, dtt)] {
                prop_assert!((got - want).length() <= second, "{got:?} {want:?}");
            }
        }
    }

    #[test]
    fn curvatures_are_those_of_the_fundamental_forms(case in tame_patch()) {
        let patch = &case.patch;
        for (s, t) in INNER {
            let jet = patch.jet(s, t);
            // Next to a line of one point there is no normal to speak of.
            let slow = jet.ds.length().min(jet.dt.length()) < 1e-3 * patch.size();
            let (Some([l, m, n]), [e, f, g]) = (jet.second_form(), jet.first_form()) else { continue };
            if slow {
                continue;
            }
            let normal = patch.normal(s, t).unwrap();
            prop_assert!((jet.normal().unwrap() - normal).length() <= 1e-13);
            let side = normal.dot(patch.unit_normal(s, t));
            prop_assert!((side.abs() - 1.0).abs() <= 1e-14);
            // Lines of curvature: orthogonal, no torsion of the normal; k1 depends on t only, k2 on s only.
            let cosine = case.rounding(1e3) / patch.size() * case.reach;
            prop_assert!(f.abs() <= cosine * (e * g).sqrt());
            let bend = |k: f64| k.abs() + 1.0 / patch.size();
            prop_assert!(m.abs() <= cosine * (e * g).sqrt() * (bend(l / e) + bend(n / g)));
            // The second derivative loses what the first has less than the patch's size.
            let magnified = |square: f64| cosine * (patch.size() * patch.size() / square).max(1.0);
            prop_assert!((l / e * side - patch.k1(t)).abs() <= magnified(e) * bend(patch.k1(t)));
            prop_assert!((n / g * side - patch.k2(s)).abs() <= magnified(g) * bend(patch.k2(s)));
        }
    }

    #[test]
    fn parameter_lines_and_sub_quads_are_concircular(case in tame_patch()) {
        let at = |s: f64, t: f64| case.patch.point(s, t);
        for x in [0.0, 0.35, 1.0] {
            let lines = [[0.0, 0.3, 0.6, 1.0].map(|y| at(y, x)), [0.0, 0.3, 0.6, 1.0].map(|y| at(x, y))];
            let quad = [at(0.2, x * 0.5), at(0.7, x * 0.5), at(0.7, 0.9), at(0.2, 0.9)];
            for points in [lines[0], lines[1], quad] {
                let shortest = (0..4).map(|i| points[i].distance(points[(i + 1) % 4])).fold(f64::INFINITY, f64::min);
                // Near a line of one point the four points are one.
                if shortest > 1e-3 * case.patch.size() {
                    let defect = cross_ratio_defect(points).unwrap();
                    prop_assert!(defect <= case.rounding(256.0) / shortest, "{defect:e}");
                }
            }
        }
    }

    #[test]
    fn sub_patches_and_the_biquadratic_form_have_the_same_points(case in patch()) {
        let part = case.patch.sub_patch([0.25, 0.75], [0.1, 1.0]).unwrap();
        let form = case.patch.to_rational();
        // Homogeneous coordinates are relative to the origin: their quotient is rounded like the farthest of them.
        let far = case.data.corners.iter().map(|a| a.to_vec().max_abs()).fold(case.patch.size(), f64::max);
        let bound = case.rounding(256.0) + 64.0 * f64::EPSILON * far * case.reach;
        for (u, v) in PLACES {
            let p = case.patch.point(u, v);
            prop_assert!(form.point(u, v).distance(p) <= bound);
            let (s, t) = (0.25 + 0.5 * u, 0.1 + 0.9 * v);
            prop_assert!(part.point(u, v).distance(case.patch.point(s, t)) <= case.rounding(256.0));
            prop_assert!((part.unit_normal(u, v) - case.patch.unit_normal(s, t)).length() <= 1e-13 * case.reach);
        }
    }

    #[test]
    fn weights_have_a_gauge(case in tame_patch(), q in [0.3..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0], lam in 0.3..3.0, mu in 0.3..3.0) {
        let q = Quat::from(q);
        let factors = [1.0, lam, mu, lam * mu];
        let w = case.patch.weights();
        let weights = std::array::from_fn(|k| w[k] * q * factors[k]);
        let turned = [0, 1].map(|i| (q.conj() * (1.0 / q.norm())).rotate(case.patch.frame()[i]));
        let other = CyclidePatch::from_weights(case.patch.corners(), weights, turned[0], turned[1]).unwrap();
        for (s, t) in PLACES {
            let (u, v) = (s / (lam * (1.0 - s) + s), t / (mu * (1.0 - t) + t));
            prop_assert!(other.point(u, v).distance(case.patch.point(s, t)) <= case.rounding(512.0));
            prop_assert!((other.unit_normal(u, v) - case.patch.unit_normal(s, t)).length() <= 1e-12 * case.reach);
        }
    }

    #[test]
    fn exchanging_the_families_transposes(case in tame_patch()) {
        let ([a0, a1, a2, a3], [v1, v2]) = (case.data.corners, case.data.frame);
        let other = CyclidePatch::from_corners_and_frame([a0, a2, a1, a3], v2, v1).unwrap();
        for (s, t) in PLACES {
            prop_assert!(other.point(t, s).distance(case.patch.point(s, t)) <= case.rounding(256.0));
            prop_assert!((other.unit_normal(t, s) + case.patch.unit_normal(s, t)).length() <= 1e-12 * case.reach);
        }
    }

    #[test]
    fn lines_shrink_exactly_where_the_corner_circle_says(case in tame_patch()) {
        let (c, d) = (case.data.corners, |i: usize, j: usize| case.data.corners[i].distance(case.data.corners[j]));
        let cos2 = d(0, 1) * d(2, 3) / (d(1, 2) * d(0, 3));
        let sin2 = d(0, 2) * d(1, 3) / (d(1, 2) * d(0, 3));
        prop_assert!((cos2 + sin2 - 1.0).abs() <= 1e-12, "Ptolemy");
        let unit = |i: usize, j: usize| Quat::from((c[i] - c[j]).unit().unwrap());
        let tau = (unit(0, 1) * unit(1, 3) * unit(3, 0)).vector();
        let [v1, v2] = case.data.frame;
        let margins = [tau.dot(v2) + cos2.sqrt(), sin2.sqrt() - tau.dot(v1)];
        // At the equality a line shrinks on a side of the patch.
        if margins.iter().all(|m| m.abs() > 1e-9) {
            prop_assert_eq!(case.patch.is_regular(), margins.iter().all(|m| *m > 0.0));
        }
        // And there the line is one point.
        for t in case.patch.singular_t() {
            prop_assert!(case.patch.point(0.0, t).distance(case.patch.point(1.0, t)) <= case.rounding(1e4));
        }
        for s in case.patch.singular_s() {
            prop_assert!(case.patch.point(s, 0.0).distance(case.patch.point(s, 1.0)) <= case.rounding(1e4));
        }
    }

    #[test]
    fn a_side_of_one_point_is_no_singular_line(case in triangular_patch()) {
        let patch = &case.patch;
        let [_, a1, a2, a3] = patch.corners();
        let (speed, roots) = if a3 == a1 { (patch.q2()[2], patch.singular_s()) } else { (patch.q1()[2], patch.singular_t()) };
        prop_assert_eq!(speed.abs().to_bits(), 0, "zero, of either sign");
        prop_assert!(roots.iter().all(|x| *x < 1.0 - 1e-9), "{:?}", roots);
        for x in [0.0, 0.3, 0.7, 1.0] {
            let (p, tip) = if a3 == a1 { (patch.point(1.0, x), a1) } else { (patch.point(x, 1.0), a2) };
            prop_assert!(p.distance(tip) <= case.rounding(64.0));
        }
        for (s, t) in PLACES {
            prop_assert!(patch.normal(s, t).unwrap().is_finite());
        }
    }
}
