//! One arc: certificate and intervals.

use super::*;

/// A polyline near an arc, or not near anything.
fn span() -> impl Strategy<Value = Vec<Point2>> {
    let near = (3_usize..20, 0.05..5.0_f64, 0.0..0.03_f64, any::<u64>()).prop_map(|(n, sweep, noise, seed)| {
        let mut random = Random(seed);
        let at = |i: usize| {
            let (s, c) = (sweep * i as f64 / (n - 1) as f64).sin_cos();
            Point2::new(c + noise * random.next(), s + noise * random.next())
        };
        (0..n).map(at).collect()
    });
    let wild = prop::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 3..7)
        .prop_map(|v| v.into_iter().map(|(x, y)| Point2::new(x, y)).collect());
    prop_oneof![4 => near, 1 => wild]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bulges_inside_the_interval_certify_and_those_outside_do_not(
        points in span(), tolerance in 0.001..0.3_f64, edges: bool,
    ) {
        let intervals = feasible_bulges(&points, tolerance, edges, MAX_SWEEP).unwrap();
        let limit = (MAX_SWEEP / 4.0).tan();
        for (interval, sign) in [(intervals.ccw, 1.0), (intervals.cw, -1.0)] {
            let within = |b: f64, tolerance: f64| {
                let c = certify_arc(&points, sign * b, None).unwrap();
                let deviation = if edges { c.deviation } else { c.vertex_deviation };
                (c.monotone && deviation <= tolerance, c.extra_turns)
            };
            match interval {
                Some([lo, hi]) => {
                    prop_assert!(lo <= hi);
                    for f in [0.0, 0.01, 0.3, 0.5, 0.8, 0.99, 1.0] {
                        let b = lo + (hi - lo) * f;
                        // A rounding of the interval's ends is worth this much tolerance.
                        let slack = 1e-9;
                        let c = certify_arc(&points, sign * b, None).unwrap();
                        let deviation = if edges { c.deviation } else { c.vertex_deviation };
                        // With extra turns the arc passes V at the wrong place: W is a test of its own.
                        if c.extra_turns == 0 {
                            prop_assert!(deviation <= tolerance + slack, "{} {} {}", b, deviation, tolerance);
                        }
                    }
                    let gap = 1e-6 * (1.0 + hi);
                    if hi + gap < limit {
                        let (ok, turns) = within(hi + gap, tolerance);
                        prop_assert!(!ok || turns != 0, "above {}", hi);
                    }
                    if lo > gap {
                        let (ok, turns) = within(lo - gap, tolerance);
                        prop_assert!(!ok || turns != 0, "below {}", lo);
                    }
                }
                None => {
                    for i in 0..200 {
                        let b = limit * f64::from(i) / 200.0;
                        let (ok, turns) = within(b, tolerance * (1.0 - 1e-9));
                        prop_assert!(!ok || turns != 0, "nothing feasible, but {} is", sign * b);
                    }
                }
            }
        }
    }

    #[test]
    fn reversal_swaps_the_orientations_and_similarities_keep_them(
        points in span(), tolerance in 0.001..0.3_f64, edges: bool, angle in 0.0..TAU, scale in -6.0..6.0_f64,
    ) {
        let close = |a: Option<[f64; 2]>, b: Option<[f64; 2]>| match (a, b) {
            (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-8 * (1.0 + a.abs())),
            (None, None) => true,
            // An interval of rounding width may close up.
            (Some([lo, hi]), None) | (None, Some([lo, hi])) => hi - lo < 1e-8,
        };
        let plain = feasible_bulges(&points, tolerance, edges, MAX_SWEEP).unwrap();
        let mut reversed = points.clone();
        reversed.reverse();
        let back = feasible_bulges(&reversed, tolerance, edges, MAX_SWEEP).unwrap();
        prop_assert!(close(plain.ccw, back.cw) && close(plain.cw, back.ccw), "{:?} {:?}", plain, back);
        let (s, c) = angle.sin_cos();
        let k = 10_f64.powf(scale);
        let moved: Vec<_> =
            points.iter().map(|p| Point2::new(k * (c * p.x - s * p.y + 3.0), k * (s * p.x + c * p.y - 2.0))).collect();
        let similar = feasible_bulges(&moved, k * tolerance, edges, MAX_SWEEP).unwrap();
        prop_assert!(close(plain.ccw, similar.ccw) && close(plain.cw, similar.cw), "{:?} {:?}", plain, similar);
    }

    #[test]
    fn a_larger_tolerance_or_fewer_vertices_never_shrink_an_interval(
        points in span(), tolerance in 0.001..0.3_f64, edges: bool, drop in 1_usize..18,
    ) {
        let plain = feasible_bulges(&points, tolerance, edges, MAX_SWEEP).unwrap();
        let contains = |outer: Option<[f64; 2]>, inner: Option<[f64; 2]>| match (outer, inner) {
            (_, None) => true,
            (None, Some([lo, hi])) => hi - lo < 1e-9,
            (Some(o), Some(i)) => o[0] <= i[0] + 1e-9 && i[1] <= o[1] + 1e-9,
        };
        let wider = feasible_bulges(&points, 1.1 * tolerance, edges, MAX_SWEEP).unwrap();
        prop_assert!(contains(wider.ccw, plain.ccw) && contains(wider.cw, plain.cw));
        if !edges && drop + 1 < points.len() {
            let mut fewer = points.clone();
            fewer.remove(drop);
            let subset = feasible_bulges(&fewer, tolerance, false, MAX_SWEEP).unwrap();
            // Up to half a turn: beyond, two steps may merge into one of more than half a turn, which runs backwards.
            let half = |i: Option<[f64; 2]>| i.filter(|i| i[0] <= 1.0).map(|[lo, hi]| [lo, hi.min(1.0)]);
            prop_assert!(contains(subset.ccw, half(plain.ccw)) && contains(subset.cw, half(plain.cw)));
        }
    }

    #[test]
    fn the_certificate_is_the_two_sided_distance(points in span(), fraction in 0.0..=1.0_f64, left: bool) {
        // Some bulge that runs with the points, near or not.
        let loose = feasible_bulges(&points, 0.5, false, MAX_SWEEP).unwrap();
        let Some([lo, hi]) = (if left { loose.ccw } else { loose.cw }) else { return Ok(()) };
        let bulge = (lo + fraction * (hi - lo)) * if left { 1.0 } else { -1.0 };
        let certificate = certify_arc(&points, bulge, None).unwrap();
        if !certificate.proves() {
            return Ok(()); // an extra turn, or rounding at an end of the interval
        }
        let space = flat(&points);
        let arc = cyclide::curve::Arc::from_bulge(
            space[0], space[space.len() - 1], cyclide::Vec3::Z, bulge).unwrap();
        let mut sampled = 0.0_f64;
        for i in 0..=2000 {
            sampled = sampled.max(to_polyline(arc.point_at_length(f64::from(i) / 2000.0), &space, false));
        }
        let mut longest = 0.0_f64;
        for w in space.windows(2) {
            longest = longest.max(w[0].distance(w[1]));
            for k in 0..=200 {
                sampled = sampled.max(arc.closest_point(w[0].lerp(w[1], f64::from(k) / 200.0)).distance);
            }
        }
        // One-sided distances change by at most the distance between samples.
        let step = longest / 200.0;
        prop_assert!(sampled <= certificate.deviation + 1e-9);
        prop_assert!(sampled >= certificate.deviation - step - 1e-9, "{} {}", sampled, certificate.deviation);
    }

    #[test]
    fn curvature_intervals_are_nested_and_hold_the_true_curvature(
        sweep in 0.1..3.0_f64, n in 3_usize..30, left: bool,
    ) {
        let sign = if left { 1.0 } else { -1.0 };
        let points: Vec<_> = (0..n).map(|i| {
            let (s, c) = (sweep * i as f64 / (n - 1) as f64).sin_cos();
            Point2::new(s, sign * (1.0 - c))
        }).collect();
        let list = curvature_intervals(&points, points[0], 0.0, 0.01).unwrap();
        prop_assert_eq!(list.len(), n - 1);
        for interval in &list {
            prop_assert!(interval[0] <= sign && sign <= interval[1]);
        }
        for pair in list.windows(2) {
            prop_assert!(pair[0][0] <= pair[1][0] && pair[1][1] <= pair[0][1]);
        }
    }
}

#[test]
fn errors_of_the_one_arc_functions_have_their_reasons() {
    let p = |x: f64, y: f64| Point2::new(x, y);
    let points = [p(0.0, 0.0), p(1.0, 0.2), p(2.0, 0.0)];
    let reason = |r: Result<cyclide::construct::BulgeIntervals, Error>| r.unwrap_err().reason();
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert_eq!(reason(feasible_bulges(&points, tolerance, true, 6.0)), "tolerance-not-positive");
    }
    for sweep in [0.0, TAU, f64::NAN] {
        assert_eq!(reason(feasible_bulges(&points, 0.1, true, sweep)), "sweep-out-of-range");
    }
    assert_eq!(reason(feasible_bulges(&points[..1], 0.1, true, 6.0)), "too-few-points");
    assert_eq!(reason(feasible_bulges(&[points[0], points[1], points[0]], 0.1, true, 6.0)), "coincident-points");
    let bad = feasible_bulges(&[points[0], p(f64::NAN, 0.0)], 0.1, true, 6.0).unwrap_err();
    assert_eq!((bad.reason(), bad.index()), ("not-finite", Some(1)));
    assert_eq!(certify_arc(&points, f64::INFINITY, None).unwrap_err().reason(), "not-finite");
    assert_eq!(certify_arc(&points, 0.5, Some(&[0.0])).unwrap_err().reason(), "too-few-points");
    assert_eq!(curvature_intervals(&points, points[0], f64::NAN, 0.1).unwrap_err().reason(), "not-finite");
}
