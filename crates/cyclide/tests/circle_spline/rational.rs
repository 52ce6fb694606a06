//! The rational forms: exact for the rational variant, certified for the trigonometric one.

use crate::data::{self, infinity_distance_squared, least_infinity_distance_squared, p, reach, rounding_of, spline};
use cyclide::{
    Point3, Vec3,
    construct::{FairEnd, FairSplineOptions, RationalRun},
    curve::{BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, ParamCurve, SplineEnds, joints},
    model::{ChainPiece, Exactness, Lower},
    rational::NurbsCurve,
};
use proptest::prelude::*;

/// Largest distance between a closed or open spline without kinks and its rational form at equal parameters, each
/// divided by its own allowance.
fn worst_ratio(s: &CircleSpline, nurbs: &NurbsCurve, allowed: impl Fn(usize) -> f64) -> f64 {
    let total: f64 = s.segments().iter().map(|x| x.chord_length() * (x.range()[1] - x.range()[0])).sum();
    let (mut from, mut worst) = (0.0, 0.0_f64);
    for (i, segment) in s.segments().iter().enumerate() {
        let width = segment.chord_length() * (segment.range()[1] - segment.range()[0]);
        for j in 1..16 {
            let l = f64::from(j) / 16.0;
            let there = nurbs.point_at_knot((from + l * width) / total);
            worst = worst.max(segment.point(l).distance(there) / allowed(i));
        }
        from += width;
    }
    worst
}

fn only_spline(s: &CircleSpline, tolerance: f64) -> Option<(NurbsCurve, f64)> {
    let (mut runs, bound) = s.to_rational_runs(tolerance).unwrap();
    match runs.pop() {
        Some(RationalRun::Spline(nurbs)) if runs.is_empty() => Some((nurbs, bound)),
        _ => None,
    }
}

proptest! {
    #[test]
    fn bezier_form_is_the_rational_segment(points in data::tame_points(), closed in any::<bool>(), order in 1_u32..=4) {
        let options = CircleSplineOptions { closed, order, ..CircleSplineOptions::default() };
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for segment in s.segments() {
            let bezier = segment.to_bezier().unwrap();
            prop_assert_eq!(bezier.degree() as u32, 2 * order + 2);
            prop_assert_eq!((bezier.rows()[0][3], bezier.rows()[bezier.degree()][3]), (1.0, 1.0));
            let largest = bezier.rows().iter().map(|r| r[3].abs()).fold(0.0, f64::max);
            for j in 0..=16 {
                let l = f64::from(j) / 16.0;
                let weight = weight_at(bezier.rows(), l);
                prop_assert!(weight > 0.0);
                // The quotient has the rounding of its rows: size times largest weight over weight.
                let allowed = 1e-14 * (reach(&points) + segment.chord_length()) * largest / weight;
                prop_assert!(segment.point(l).distance(bezier.point(l)) <= allowed);
                let (a, b) = (segment.jet(l), bezier.jet(l));
                // Derivatives of the rational form carry 4, 16, 64 times degree and weight ratio each.
                let grow = f64::from(2 * order + 2) * largest / weight;
                prop_assert!((a.d1 - b.d1).length() <= allowed * 8.0 * grow);
                prop_assert!((a.d2 - b.d2).length() <= allowed * 64.0 * grow * grow);
                prop_assert!((a.d3 - b.d3).length() <= allowed * 512.0 * grow * grow * grow);
            }
        }
    }

    #[test]
    fn splines_are_exact_with_positive_weights(points in data::points(), closed in any::<bool>(), order in 1_u32..=4) {
        let options = CircleSplineOptions { closed, order, ..CircleSplineOptions::default() };
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        prop_assume!(s.kinks().is_empty());
        let (chain, exactness) = match s.to_chain(1e-3 * reach(&points)) {
            Ok(done) => done,
            // Back along a line: a circle that has lost its digits next to infinity, within 5e-7.
            Err(error) => {
                prop_assert_eq!(error.reason(), "arc-through-infinity");
                // At the distance w from infinity a segment runs 1/w chords out, where |N| = w/2 at l = 1/2; its box holds
                // that place and the start. (A blend that turns past infinity runs out on both sides, one circle on one.)
                let farthest = s.segments().iter().map(|x| x.bounds().diagonal() / x.chord_length()).fold(0.0, f64::max);
                prop_assert!(farthest > 1.0 / 5.1e-7, "{farthest:e}");
                return Ok(());
            }
        };
        prop_assert_eq!(exactness, Exactness::Exact);
        prop_assert!(chain.weight_range().0 > 0.0);
        prop_assert_eq!(chain.piece_point(0, 0.0), points[0]);
        let Some((nurbs, bound)) = only_spline(&s, 1.0) else { return Ok(()) };
        prop_assert_eq!(bound, 0.0);
        // Knots of very short segments are rounded against the whole length, and with them the parameter.
        let total: f64 = s.segments().iter().map(|x| x.chord_length()).sum();
        let rounding = rounding_of(&points, &s);
        let allowed = |i: usize| {
            let segment = &s.segments()[i];
            let speed = 1.0 + 4.0 / infinity_distance_squared(segment);
            256.0 * rounding[i] + 64.0 * f64::EPSILON * total * speed
        };
        prop_assert!(worst_ratio(&s, &nurbs, allowed) <= 1.0, "{}", worst_ratio(&s, &nurbs, allowed));
        // C1 in the chord lengths, unless the weights are so uneven that points would be lost: only one segment has nothing
        // to join.
        let smooth = nurbs.with_c1_knots();
        let uneven = nurbs.weights().iter().any(|w| *w < 1e-4);
        prop_assert!(smooth.is_some() || nurbs.span_count() == 1 || uneven);
        prop_assert!(smooth.is_none_or(|c| worst_ratio(&s, &c, allowed) <= 1.0));
    }

    #[test]
    fn approximation_of_the_trigonometric_variant_keeps_its_bound(
        points in data::tame_points(), closed in any::<bool>(), order in 1_u32..=4, digits in 1.0_f64..9.0
    ) {
        let variant = BlendVariant::Trigonometric;
        let Some(s) = spline(&points, &CircleSplineOptions { closed, order, variant, ..Default::default() }) else { return Ok(()) };
        let tolerance = 10.0_f64.powf(-digits);
        if let Err(error) = s.to_rational_runs(tolerance) {
            // Refused is what needs more than 4096 parts of a segment: theta (0.0046 L/(T w²))^(1/3), by its turn (a whole one at most), its
            // chord, and how near its circles come to infinity (w², a tenth more for what is between the places looked at).
            prop_assert_eq!(error.reason(), "too-many-pieces");
            let part = std::f64::consts::TAU / 4096.0;
            let limit = |x: &BlendSegment| 1.1 * 0.0046 * x.chord_length() / tolerance * part.powi(3);
            prop_assert!(s.segments().iter().any(|x| least_infinity_distance_squared(x) < limit(x)));
            return Ok(());
        }
        let Some((nurbs, bound)) = only_spline(&s, tolerance) else { return Ok(()) };
        prop_assert!(bound <= tolerance);
        prop_assert!(nurbs.weights().iter().all(|w| *w > 0.0));
        let rounding = rounding_of(&points, &s);
        let worst = worst_ratio(&s, &nurbs, |i| bound + 1024.0 * rounding[i]);
        prop_assert!(worst <= 1.0, "{worst} of {bound:e}");
        prop_assert_eq!(nurbs.degree() as u32, 4 * order);
        // G1 at every joint, inner ones of a segment included.
        let kink = joints(&nurbs).iter().map(|j| j.angle).fold(0.0, f64::max);
        prop_assert!(kink < 1e-8, "{kink:e}");
    }
}

fn weight_at(rows: &[[f64; 4]], l: f64) -> f64 {
    let mut w: Vec<f64> = rows.iter().map(|r| r[3]).collect();
    while w.len() > 1 {
        w = w.windows(2).map(|x| (1.0 - l) * x[0] + l * x[1]).collect();
    }
    w[0]
}

/// A closed track of `n` points with detail at every scale.
fn track(n: usize, radius: f64) -> Vec<Point3> {
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / n as f64;
        let r = radius * (1.0 + 0.3 * (3.0 * a).sin() + 0.05 * (17.0 * a).cos());
        p(r * a.cos(), r * a.sin(), 0.1 * radius * (5.0 * a).sin())
    };
    (0..n).map(at).collect()
}

#[test]
fn closed_tracks_become_one_smooth_spline_with_c1_knots() {
    for radius in [1e-3, 500.0, 1e6] {
        let points = track(1000, radius);
        for order in 1..=4 {
            let options = CircleSplineOptions { closed: true, order, ..CircleSplineOptions::default() };
            let s = CircleSpline::from_points(&points, &options).unwrap();
            let (chain, _) = s.to_chain(1e-6 * radius).unwrap();
            let [ChainPiece::Spline(nurbs)] = chain.pieces() else { panic!("one spline per closed smooth curve") };
            assert!(chain.is_closed());
            let smooth = nurbs.with_c1_knots().expect("C1 in the chord lengths");
            assert!(smooth.weights().iter().all(|w| *w > 0.0));
            let degree = smooth.degree();
            let multiplicities = smooth.knot_multiplicities();
            let inner = &multiplicities[1..multiplicities.len() - 1];
            assert!(inner.iter().all(|(_, m)| *m == degree - 1), "C1 at every inner knot, order {order}");
            // 1e-13 of the size: rounding of a product and a knot vector of 1000 spans.
            assert!(worst_ratio(&s, nurbs, |_| 1e-13 * radius) <= 1.0);
            assert!(worst_ratio(&s, &smooth, |_| 1e-13 * radius) <= 1.0);
        }
    }
}

#[test]
fn wild_data_become_splines_with_positive_weights_and_c1_knots() {
    // Tangents that lead away from the chord make Bernstein weights negative: halved pieces must join smoothly too.
    let points =
        [[0.2, -1.0, 0.1], [-0.6, 0.9, 0.2], [0.5, 0.8, 0.0], [0.1, 0.2, 1.0], [-0.9, -0.2, -0.1]].map(Point3::from);
    for order in 1..=4 {
        let options = CircleSplineOptions { closed: true, order, ..CircleSplineOptions::default() };
        let s = CircleSpline::from_points(&points, &options).unwrap();
        assert!(s.segments().iter().any(|x| !x.to_bezier().unwrap().has_positive_weights()), "order {order}");
        let (nurbs, _) = only_spline(&s, 1.0).unwrap();
        let smooth = nurbs.with_c1_knots().expect("C1 in the chord lengths");
        let multiplicities = smooth.knot_multiplicities();
        assert!(multiplicities[1..multiplicities.len() - 1].iter().all(|(_, m)| *m == smooth.degree() - 1));
        assert!(worst_ratio(&s, &smooth, |_| 1e-13) <= 1.0, "{}", worst_ratio(&s, &smooth, |_| 1e-13));
    }
}

#[test]
fn parts_of_a_spline_are_exact_too() {
    let points = track(12, 1.0);
    for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
        let options = CircleSplineOptions { closed: true, variant, ..CircleSplineOptions::default() };
        let part = CircleSpline::from_points(&points, &options).unwrap().restricted(0.13, 0.77).unwrap();
        let (nurbs, bound) = only_spline(&part, 1e-9).unwrap();
        assert!(worst_ratio(&part, &nurbs, |_| bound + 1e-14) <= 1.0);
        assert!(nurbs.control_points()[0].distance(part.point(0.0)) <= 4e-16);
    }
}

#[test]
fn runs_of_arcs_stay_arcs_and_hopeless_tolerances_are_refused() {
    let arc = [p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 0.0, 0.5)];
    let s = CircleSpline::from_points(&arc, &CircleSplineOptions::default()).unwrap();
    let (chain, exactness) = s.to_chain(1e-3).unwrap();
    assert!(chain.pieces().iter().all(|x| matches!(x, ChainPiece::Arc(_))) && exactness == Exactness::Exact);
    let options = CircleSplineOptions { closed: true, variant: BlendVariant::Trigonometric, ..Default::default() };
    let s = CircleSpline::from_points(&track(8, 1.0), &options).unwrap();
    assert_eq!(s.to_chain(1e-15).unwrap_err().reason(), "too-many-pieces");
    let not_positive = [0.0, -1.0, f64::NAN].map(|t| (t, "tolerance-not-positive"));
    for (tolerance, reason) in not_positive.into_iter().chain([(f64::INFINITY, "not-finite")]) {
        assert_eq!(s.to_chain(tolerance).unwrap_err().reason(), reason);
        assert_eq!(s.to_arcs(tolerance).unwrap_err().reason(), reason);
    }
}

/// From the origin to x = 1 with tangents that lean by `lean` and `lean * sign` from straight back.
fn back_along_the_chord(lean: f64, sign: f64, law: Option<(u32, BlendVariant)>) -> CircleSpline {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)];
    let ends = [lean, sign * lean].map(|y| Vec3::new(-1.0, y, 0.0));
    match law {
        Some((order, variant)) => {
            let ends = SplineEnds::Clamped { start: Some(ends[0]), end: Some(ends[1]) };
            let options = CircleSplineOptions { order, variant, ends, ..Default::default() };
            CircleSpline::from_points(&points, &options)
        }
        None => {
            let options = FairSplineOptions { ends: ends.map(FairEnd::Clamped), ..Default::default() };
            CircleSpline::fair(&points, &options)
        }
    }
    .unwrap()
}

const NEAR_INFINITY: [Option<(u32, BlendVariant)>; 4] = [
    None,
    Some((1, BlendVariant::Rational)),
    Some((2, BlendVariant::Rational)),
    Some((1, BlendVariant::Trigonometric)),
];

#[test]
fn curves_next_to_infinity_keep_their_points_in_rational_form() {
    // Weights down to 1e-14: points a million chords away. What counts is where the points are, not how small weights are.
    for law in NEAR_INFINITY {
        for (lean, sign) in (2..=6).flat_map(|e| [1.0, -1.0, 0.6].map(|sign| (10.0_f64.powi(-e), sign))) {
            let s = back_along_the_chord(lean, sign, law);
            let Ok((runs, bound)) = s.to_rational_runs(1e-3) else {
                assert_eq!(law.map(|(_, v)| v), Some(BlendVariant::Trigonometric), "{law:?} {lean:e} {sign}");
                continue; // too many pieces for the tolerance
            };
            let [RationalRun::Spline(nurbs)] = &runs[..] else { continue };
            // The parameter of the form is that of the curve, both over a chord of 1; these places are exact in doubles.
            let places = |form: &NurbsCurve| -> Vec<(Point3, Point3)> {
                let breaks = form.breaks().to_vec();
                let near_ends = (1..40).flat_map(|k| [0.5_f64.powi(k), 1.0 - 0.5_f64.powi(k)]);
                let at = |(span, x): (usize, f64)| {
                    let l = breaks[span] + x * (breaks[span + 1] - breaks[span]);
                    (form.span_point(span, x), s.point(l / breaks[breaks.len() - 1]))
                };
                (0..form.span_count()).flat_map(|span| near_ends.clone().map(move |x| (span, x))).map(at).collect()
            };
            let size = places(nurbs).iter().map(|(_, p)| p.to_vec().max_abs()).fold(1.0, f64::max);
            for form in [Some(nurbs), nurbs.with_c1_knots().as_ref()].into_iter().flatten() {
                for (there, here) in places(form) {
                    let d = there.distance(here);
                    // Half of what the check of a file forgives, relative to the curve.
                    assert!(d <= bound + 5e-10 * size, "{law:?} {lean:e} {sign}: {d:e} of {size:e} at {here:?}");
                }
            }
        }
    }
}

#[test]
fn what_has_lost_its_digits_is_refused_by_name() {
    for law in NEAR_INFINITY {
        for sign in [1.0, 0.6] {
            let s = back_along_the_chord(1e-7, sign, law);
            assert_eq!(s.to_rational_runs(1.0).unwrap_err().reason(), "arc-through-infinity", "{law:?} {sign}");
            assert_eq!(s.to_g1_arcs(1.0).unwrap_err().reason(), "arc-through-infinity", "{law:?} {sign}");
        }
    }
}
