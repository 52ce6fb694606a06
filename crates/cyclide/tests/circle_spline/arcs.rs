//! The G1 arcs of a circle spline: near it in both directions, tangent-continuous where it is, with its ends.

use crate::data::{self, infinity_distance_squared, p, spline};
use cyclide::{
    Point3, Vec3,
    curve::{
        ArcPath, BlendVariant, CircleSpline, CircleSplineOptions, CurveIndex, ParamCurve, SplineEnds, closest_point,
        joints,
    },
    mesh::flatten,
    model::{Exactness, Lower},
};
use proptest::prelude::*;

/// Largest distances of samples: of the curve from the arcs and of the arcs from the curve.
fn two_sided(s: &CircleSpline, arcs: &ArcPath) -> (f64, f64) {
    let samples = |curve: &dyn ParamCurve, n: usize| -> Vec<Point3> {
        let n = n * curve.piece_count();
        (0..=n).map(|i| curve.point(i as f64 / n as f64)).collect()
    };
    let there = samples(s, 24).into_iter().map(|q| arcs.closest_point(q).distance).fold(0.0, f64::max);
    let back = samples(arcs, 6).into_iter().map(|q| closest_point(s, q).distance).fold(0.0, f64::max);
    (there, back)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn arcs_stay_within_the_tolerance_both_ways(points in data::tame_points(), options in data::options(), digits in 1.0_f64..4.0) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        if s.segments().iter().any(|x| infinity_distance_squared(x) < 1e-2) {
            return Ok(()); // curves a hundred times the size of the points
        }
        let tolerance = 10.0_f64.powf(-digits);
        let (arcs, exactness) = s.to_arcs(tolerance).unwrap();
        prop_assert!(exactness.bound() <= tolerance);
        let (there, back) = two_sided(&s, &arcs);
        prop_assert!(there <= tolerance && back <= tolerance, "{there:e} {back:e} of {tolerance:e}");
        let kink = joints(&arcs).iter().map(|j| j.angle).fold(0.0, f64::max);
        // Tangents are shared: rounding over the length of the shortest arc.
        prop_assert!(!s.kinks().is_empty() || kink < 1e-9, "{kink:e}");
        prop_assert_eq!(arcs.point(0.0), s.point(0.0));
        prop_assert_eq!(arcs.point(1.0), s.point(1.0));
        prop_assert_eq!(arcs.is_closed(), s.is_closed());
    }
}

#[test]
fn counts_double_per_decade_and_nodes_are_shared() {
    let at = |i: usize| {
        let a = std::f64::consts::TAU * i as f64 / 200.0;
        let r = 100.0 * (1.0 + 0.3 * (3.0 * a).sin());
        p(r * a.cos(), r * a.sin(), 0.0)
    };
    let points: Vec<Point3> = (0..200).map(at).collect();
    for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
        let options = CircleSplineOptions { closed: true, variant, ..CircleSplineOptions::default() };
        let s = CircleSpline::from_points(&points, &options).unwrap();
        let count = |tolerance: f64| s.to_arcs(tolerance).unwrap().0.arcs().len();
        let (coarse, fine) = (count(0.1), count(0.01));
        // Third order: 10^(1/3) = 2.15 per decade.
        assert!(fine as f64 / (coarse as f64) < 2.6, "{coarse} {fine}");
        assert!(coarse < 60, "biarcs of dense data pass over nodes: {coarse} arcs for 200 points");
    }
}

#[test]
fn exact_arcs_and_straight_runs_stay_as_they_are() {
    // A straight run, a bend, a straight run.
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [4.0, 1.0], [4.0, 2.0], [4.0, 3.0], [4.0, 4.0]]
        .map(|[x, y]| p(x, y, 0.0));
    let s = CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap();
    let (arcs, exactness) = s.to_arcs(1e-3).unwrap();
    assert_eq!(exactness, Exactness::Sampled(1e-3));
    assert_eq!(arcs.arcs().iter().filter(|a| a.is_straight()).count(), 4);
    let corner = CircleSplineOptions { corners: vec![3, 4], ..CircleSplineOptions::default() };
    let s = CircleSpline::from_points(&points, &corner).unwrap();
    let (arcs, exactness) = s.to_arcs(1e-3).unwrap();
    assert_eq!((arcs.arcs().len(), exactness), (7, Exactness::Exact));
    assert!(arcs.arcs().iter().all(cyclide::curve::Arc::is_straight));
}

#[test]
fn a_tolerance_below_rounding_is_refused() {
    let points = [[1e6, 0.0], [1e6 + 1.0, 0.3], [1e6 + 2.0, 0.0], [1e6 + 2.5, 1.0]].map(|[x, y]| p(x, y, 0.0));
    let s = CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap();
    assert_eq!(s.to_arcs(1e-12).unwrap_err().reason(), "too-many-pieces");
}

#[test]
fn a_segment_that_runs_far_out_is_followed() {
    // Tangents that point away from the chord: the curve runs out to hundreds of chords and back, between l = 0.499
    // and 0.501, where samples at even parameters would miss it.
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)];
    for (order, variant) in [(1, BlendVariant::Rational), (2, BlendVariant::Trigonometric), (3, BlendVariant::Rational)]
    {
        let ends =
            SplineEnds::Clamped { start: Some(Vec3::new(-1.0, 2e-3, 0.0)), end: Some(Vec3::new(-1.0, -3e-3, 1e-3)) };
        let s = CircleSpline::from_points(&points, &CircleSplineOptions { order, variant, ends, ..Default::default() });
        let s = s.unwrap();
        let tolerance = 1e-2;
        let (arcs, _) = s.to_arcs(tolerance).unwrap();
        let size = s.piece_bounds(0).diagonal();
        assert!(size > 400.0, "{size}");
        // 1 - 2l = w tan of uniform angles, with w about the angles above: even along the large circles.
        for i in -2000..=2000 {
            let l = 0.5 + 1e-3 * (f64::from(i) / 2000.0 * 1.5688).tan();
            let distance = arcs.closest_point(s.piece_point(0, l.clamp(0.0, 1.0))).distance;
            assert!(distance <= tolerance, "{order} {variant:?} at {l}: {distance:e}");
        }
        assert!(arcs.bounds().diagonal() > 400.0 && arcs.bounds().diagonal() < 4.0 * size);
    }
}

#[test]
fn arcs_follow_the_fast_parts_of_hairpins() {
    // Turns of 179.9 degrees: samples evenly spaced in the parameter would step over the far ends of the loops.
    let points = [(0.0776, 0.0), (1.0323, 4.0326e-4), (0.088, 8.0653e-4), (0.9225, 12.0979e-4), (-0.0121, 16.1306e-4)]
        .map(|(x, y)| p(x, y, 0.0));
    let options =
        CircleSplineOptions { closed: true, order: 3, variant: BlendVariant::Trigonometric, ..Default::default() };
    let s = CircleSpline::from_points(&points, &options).unwrap();
    let tolerance = 0.01;
    let arcs = s.to_arcs(tolerance).unwrap().0;
    // Vertices of fine polylines are dense where the curve is fast too.
    let far = |from: &dyn ParamCurve, to: &dyn ParamCurve| {
        let index = CurveIndex::new(to);
        let vertices = flatten(from, 1e-4).unwrap();
        vertices.into_iter().map(|(_, q)| index.closest_point(q).distance).fold(0.0, f64::max)
    };
    let (there, back) = (far(&s, &arcs), far(&arcs, &s));
    assert!(there <= tolerance && back <= tolerance, "{there:e} {back:e}");
}

/// A number in `[0, 1)` that depends on its index without a pattern.
fn random(index: u64) -> f64 {
    let x = (index + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((x ^ (x >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn arcs_never_go_round_the_long_way() {
    // Chords of 1e-7 to 1 beside each other, and turns back: the ends of a biarc may be next to each other, and it must
    // not go all the way round between two samples.
    for case in 0..150 {
        let number = |k: u64| random(100 * case + k);
        let (mut at, mut direction) = (p(0.0, 0.0, 0.0), 0.0);
        let mut points = vec![at];
        for k in 0..4 {
            let length = [1.0, 1e-3, 1e-5, 1e-7][(4.0 * number(3 * k)) as usize];
            direction += if number(3 * k + 1) < 0.2 { 3.139 } else { 4.0 * (number(3 * k + 2) - 0.5) };
            at += Vec3::new(direction.cos(), direction.sin(), 0.0) * length;
            points.push(at);
        }
        let order = 1 + (4.0 * number(20)) as u32;
        let options = CircleSplineOptions { closed: number(21) < 0.3, order, ..Default::default() };
        let Ok(s) = CircleSpline::from_points(&points, &options) else { continue };
        let tolerance = 10.0_f64.powf(-2.0 - 3.0 * number(22));
        let Ok((arcs, _)) = s.to_arcs(tolerance) else { continue };
        let far = |from: &dyn ParamCurve, to: &dyn ParamCurve| {
            let index = CurveIndex::new(to);
            let vertices = flatten(from, 0.01 * tolerance).unwrap();
            vertices.into_iter().map(|(_, q)| index.closest_point(q).distance).fold(0.0, f64::max)
        };
        let (there, back) = (far(&s, &arcs), far(&arcs, &s));
        assert!(
            there <= tolerance && back <= tolerance,
            "{case} {points:?} {options:?}: {there:e} {back:e} of {tolerance:e}"
        );
        // Nor is a loop added that is not in the curve, where one would be longer than the tolerance.
        let size = cyclide::curve::bounds(&s).diagonal();
        if tolerance < 1e-3 * size {
            let (own, theirs) = (cyclide::curve::length(&s), cyclide::curve::length(&arcs));
            assert!((own / theirs - 1.0).abs() < 0.1, "{case} {points:?} {options:?} {tolerance:e}: {own} {theirs}");
        }
    }
}
