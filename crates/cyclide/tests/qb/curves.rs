//! Laws of single curves, on invariant spans whose derivatives point forward: their weights are positive, so they keep their digits.

use crate::data::{PARAMETERS, forward, outside_inversion};
use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, HPoint},
    curve::{ParamCurve, QbCurve},
};
use proptest::prelude::*;

/// Points of curves in the cube whose pairs differ in size by 25² at most, a few dozen operations, each rounded once.
const ROUNDING: f64 = 1e-12;

proptest! {
    #[test]
    fn spans_have_their_data_and_stay_in_their_ball(data in forward()) {
        let span = data.span();
        prop_assert!(span.defect() < 1e-15);
        prop_assert_eq!([span.point(0.0), span.point(1.0)], data.ends);
        for (t, v) in [0.0, 1.0].into_iter().zip(data.velocities) {
            prop_assert!((span.jet(t).d1 - v).length() < ROUNDING * v.length());
        }
        prop_assert!(span.to_bezier().has_positive_weights());
        let radius = 0.5 * data.chord().length();
        let middle = data.ends[0].midpoint(data.ends[1]);
        prop_assert!(span.excursions(middle, radius * (1.0 + 1e-9)).is_empty());
        let (distance, _) = span.reach(middle).farthest.unwrap();
        prop_assert!((distance - radius).abs() < ROUNDING);
    }

    /// `x(1/2) = a0 + inv(inv(g) + inv(d))`, with `g` halfway in direction and geometric mean of length.
    #[test]
    fn the_middle_is_that_of_the_vector_formula(data in forward()) {
        let inverse = |v: Vec3| v / v.length_squared();
        let (d, [v0, v1]) = (data.chord(), data.velocities);
        let c = (d * (2.0 * d.dot(v1)) - v1 * d.length_squared()) / v1.length_squared();
        let sum = v0.unit().unwrap() + c.unit().unwrap();
        let g = sum.unit().unwrap() * (v0.length() * c.length()).sqrt();
        let middle = data.ends[0] + inverse(inverse(g) + inverse(d));
        // Nearly opposite tangents lose digits by their sum.
        prop_assert!(data.span().point(0.5).distance(middle) < ROUNDING / sum.length().min(1.0));
    }

    #[test]
    fn the_rational_form_is_the_curve(data in forward()) {
        let span = data.span();
        let bezier = span.to_bezier();
        prop_assert_eq!(bezier.degree(), 4);
        for t in PARAMETERS {
            let (a, b) = (span.jet(t), bezier.jet(t));
            prop_assert!(a.point.distance(b.point) < ROUNDING);
            // Each order divides by the weight again.
            let w: Vec<f64> = bezier.rows().iter().map(|r| r[3]).collect();
            let u = 1.0 - t;
            let here = w[0] * u.powi(4) + 4.0 * w[1] * t * u.powi(3) + 6.0 * w[2] * (t * u).powi(2) + 4.0 * w[3] * t.powi(3) * u + w[4] * t.powi(4);
            let loss = w.iter().fold(0.0, |m: f64, w| m.max(*w)) / here;
            for (k, (x, y)) in [(a.d1, b.d1), (a.d2, b.d2), (a.d3, b.d3)].into_iter().enumerate() {
                let allowed = 1e-14 * (8.0 * loss).powi(k as i32 + 2);
                prop_assert!((x - y).length() < allowed, "order {}: {:e}, {allowed:e}", k + 1, (x - y).length());
            }
        }
        for (part, from, to) in span.to_positive_beziers().unwrap() {
            prop_assert!(part.has_positive_weights());
            for s in [0.0, 0.4, 1.0] {
                prop_assert!(part.point(s).distance(span.point(from + s * (to - from))) < ROUNDING);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_differences(data in forward(), t in 0.1..0.9_f64) {
        let span = data.span();
        let all = span.derivatives(t, 4);
        let jet = span.jet(t);
        for (a, b) in [(all[0], jet.d1), (all[1], jet.d2), (all[2], jet.d3)] {
            prop_assert!((a - b).length() <= 1e-10 * (1.0 + b.length()));
        }
        let h = 1e-4;
        let difference = (span.jet(t + h).d3 - span.jet(t - h).d3) / (2.0 * h);
        // The next two orders over h², and rounding of third derivatives over h.
        let sizes = span.derivatives(t, 6);
        let allowed = h * h * (sizes[5].length() + 1e3 * sizes[3].length()) + 1e-6 * (1.0 + jet.d3.length());
        prop_assert!((difference - all[3]).length() <= allowed, "{:?} {:?}", difference, all[3]);
    }

    #[test]
    fn every_form_has_the_same_points(data in forward(), cut in 0.01..0.99_f64, c in 0.2..5.0_f64) {
        let span = data.span();
        let (left, right) = span.split(cut).unwrap();
        prop_assert_eq!(left.point(1.0), right.point(0.0));
        let (raised, back, other) = (span.elevated(), span.reversed(), span.reparametrized(c).unwrap());
        let part = span.restricted(0.5 * cut, cut).unwrap();
        for t in PARAMETERS {
            let p = span.point(t);
            prop_assert!(raised.point(t).distance(p) < ROUNDING);
            prop_assert!(back.point(1.0 - t).distance(p) < ROUNDING);
            prop_assert!(left.point(t).distance(span.point(t * cut)) < ROUNDING);
            prop_assert!(right.point(t).distance(span.point(cut + t * (1.0 - cut))) < ROUNDING);
            prop_assert!(part.point(t).distance(span.point(cut * (0.5 + 0.5 * t))) < ROUNDING);
            prop_assert!(other.point(t).distance(span.point(c * t / (1.0 - t + c * t))) < ROUNDING);
        }
        let [a, b] = data.ends;
        let reversed = QbCurve::invariant_span([b, a], [-data.velocities[1], -data.velocities[0]]).unwrap();
        for t in PARAMETERS {
            prop_assert!(reversed.point(1.0 - t).distance(span.point(t)) < 10.0 * ROUNDING);
        }
    }

    #[test]
    fn a_common_right_factor_changes_nothing(data in forward(), q in prop::array::uniform4(-1.0..1.0_f64)) {
        let factor = Quat::from(q);
        prop_assume!(factor.norm() > 0.1);
        let span = data.span();
        let pairs: Vec<HPoint> = span.pairs().iter().map(|p| HPoint { n: p.n * factor, d: p.d * factor }).collect();
        let same = QbCurve::new(&pairs).unwrap();
        for t in PARAMETERS {
            prop_assert!(same.point(t).distance(span.point(t)) < 10.0 * ROUNDING);
        }
    }

    #[test]
    fn maps_of_curves_are_curves_of_maps(data in forward(), map in outside_inversion()) {
        let span = data.span();
        let image = span.transformed(&map).unwrap();
        let ends = data.ends.map(|p| map.map_point(p).unwrap());
        let push = |i: usize| map.push_forward(data.ends[i], data.velocities[i]).unwrap();
        let same = QbCurve::invariant_span(ends, [push(0), push(1)]).unwrap();
        prop_assert_eq!([image.point(0.0), image.point(1.0)], ends);
        for t in PARAMETERS {
            let want = map.map_point(span.point(t)).unwrap();
            prop_assert!(image.point(t).distance(want) < 10.0 * ROUNDING);
            prop_assert!(same.point(t).distance(want) < 100.0 * ROUNDING);
        }
    }
}

#[test]
fn arcs_are_of_degree_one() {
    let ends = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    let turn = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
    let quarter = QbCurve::new(&[HPoint::weighted(ends[0], Quat::ONE), HPoint::weighted(ends[1], turn)]).unwrap();
    assert!(matches!(quarter.piece_form(0), cyclide::curve::PieceForm::Arc(_)));
    assert!((cyclide::curve::length(&quarter) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    // The span with the derivatives of an arc is the arc.
    let jets = [quarter.jet(0.0).d1, quarter.jet(1.0).d1];
    let span = QbCurve::invariant_span(ends, jets).unwrap();
    for t in PARAMETERS {
        assert!(span.point(t).distance(quarter.point(t)) < 1e-15);
    }
}

#[test]
fn base_points_are_found_and_passed() {
    // A quarter circle whose pairs are multiplied by 2t - 1: nothing is left of them at 1/2.
    let ends = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    let turn = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
    let [a, b] = [HPoint::weighted(ends[0], Quat::ONE), HPoint::weighted(ends[1], turn)];
    let half = |p: HPoint, q: HPoint| HPoint { n: (p.n - q.n) * 0.5, d: (p.d - q.d) * 0.5 };
    let raised = QbCurve::new(&[HPoint { n: -a.n, d: -a.d }, half(a, b), b]).unwrap();
    let reach = raised.reach(Point3::ORIGIN);
    assert_eq!(reach.base_points.len(), 1);
    assert!((reach.base_points[0] - 0.5).abs() < 1e-9 && reach.poles.is_empty());
    assert!((reach.farthest.unwrap().0 - 1.0).abs() < 1e-9);
}
