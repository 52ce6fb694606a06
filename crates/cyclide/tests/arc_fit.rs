//! Laws of arc fitting (`60`, section 8): certificates against sampling, intervals from inside and outside, symmetry,
//! counts on true arcs, and the data that tempt a fit into rogue arcs.

use cyclide::{
    ArcFit, ArcFitOptions, Effort, Error, FitTarget, ParamCurve, Point2, Point3, Warning, certify_arc,
    curvature_intervals, feasible_bulges,
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
    if options.closed {
        assert_eq!(path.eval(0.0), path.eval(1.0));
    } else {
        assert_eq!(path.eval(0.0), points[0]);
        assert_eq!(path.eval(1.0), points[n - 1]);
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

// ---- one arc: certificate and intervals --------------------------------------------------------------------------

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

/// Uniform in [-1/2, 1/2); the point is a fixed sequence, not its quality.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    }
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
        let arc = cyclide::Arc::from_bulge(
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
    let reason = |r: Result<cyclide::BulgeIntervals, Error>| r.unwrap_err().reason();
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

// ---- the fit --------------------------------------------------------------------------------------------------------

#[test]
fn samples_of_true_arcs_give_exactly_that_many() {
    // Curvatures that differ clearly at every joint, 24 samples an arc as in the reference data.
    let cases: [&[(f64, f64)]; 5] = [
        &[(3.0, 0.5), (2.0, -0.4), (4.0, 0.2)],
        &[(2.0, 1.0), (3.0, -0.3), (1.5, 1.2), (4.0, 0.1)],
        &[(5.0, 0.1), (2.0, -1.0), (3.0, 0.6), (2.0, -0.5), (3.0, 0.3), (1.5, -1.5)],
        &[(3.0, 0.0), (2.0, 0.7), (3.0, 0.0)],
        &[(2.0, -0.6), (2.0, 0.9), (2.0, -0.9), (2.0, 0.6), (3.0, -0.2), (2.0, 0.8), (2.0, -0.7)],
    ];
    for arcs in cases {
        let points = chain(arcs, 24);
        for effort in [Effort::Fast, Effort::Default, Effort::Best] {
            let fit = fitted(&points, &ArcFitOptions { effort, ..ArcFitOptions::new(0.002) });
            assert_eq!(pieces(&fit), arcs.len(), "{effort:?}");
            assert!(fit.certificate().max_kink < 1e-13);
        }
    }
}

#[test]
fn a_closed_curve_is_tangent_continuous_at_its_seam() {
    let at = |i: usize| {
        let a = TAU * i as f64 / 150.0;
        let r = 3.0 + 0.4 * (3.0 * a).cos();
        Point3::new(r * a.cos(), 0.7 * r * a.sin(), 0.0)
    };
    let points: Vec<_> = (0..150).map(at).collect();
    let mut counts = Vec::new();
    for start in [0, 37, 90] {
        let mut moved = points.clone();
        moved.rotate_left(start);
        for reverse in [false, true] {
            if reverse {
                moved.reverse();
            }
            for options in [closed(0.01), ArcFitOptions { target: FitTarget::Polyline, ..closed(0.01) }] {
                let fit = fitted(&moved, &options);
                assert!(fit.path().is_closed());
                // Coordinates of size 3 on arcs of length 1: a few ulp.
                assert!(fit.certificate().max_kink < 1e-13, "{:e}", fit.certificate().max_kink);
                counts.push(pieces(&fit));
            }
        }
    }
    // Near the minimum wherever it starts; the start moves the count by one or two.
    let (least, most) = (counts.iter().min().unwrap(), counts.iter().max().unwrap());
    assert!(*most <= least + 2 && *most <= 16, "{counts:?}");
}

#[test]
fn one_circle_and_one_arc_are_found_whole() {
    let fit = fitted(&circle(50, TAU, 2.0, Point3::new(1e6, -1e6, 3.0)), &closed(1e-3));
    assert_eq!(pieces(&fit), 2);
    for arc in fit.path().arcs() {
        // Coordinates of 1e6 are rounded to 1e-10.
        assert!((arc.radius().unwrap() - 2.0).abs() < 1e-9);
    }
    let fit = fitted(&circle(50, 300_f64.to_radians(), 1.0, Point3::ORIGIN), &ArcFitOptions::new(1e-3));
    assert_eq!(pieces(&fit), 1);
    let line: Vec<_> = (0..20).map(|i| Point3::new(f64::from(i), 2.0 * f64::from(i), -f64::from(i))).collect();
    let fit = fitted(&line, &ArcFitOptions::new(1e-3));
    assert_eq!((pieces(&fit), fit.certificate().lines), (1, 1));
}

#[test]
fn two_turns_of_a_circle_are_not_one() {
    let two = circle(100, 2.0 * TAU, 1.0, Point3::ORIGIN);
    for options in [ArcFitOptions::new(1e-3), closed(1e-3)] {
        let fit = fitted(&two, &options);
        // The points run round twice, and so does the path.
        let length = 4.0 * PI * if options.closed { 1.0 } else { 99.0 / 100.0 };
        assert!((fit.path().length() - length).abs() < 0.01 * length, "{}", fit.path().length());
    }
}

#[test]
fn out_and_back_turns_round_at_the_far_end() {
    let out = (0..20).map(|i| Point3::new(f64::from(i), 0.0, 0.0));
    let exact: Vec<_> = out.clone().chain((0..19).rev().map(|i| Point3::new(f64::from(i), 0.0, 0.0))).collect();
    let fit = fitted(&exact, &ArcFitOptions::new(0.1));
    assert_eq!(fit.certificate().lines, 2);
    assert!(matches!(fit.warnings(), [Warning::CornerKept { vertex: 19, .. }]));
    let beside: Vec<_> = out.chain((0..20).rev().map(|i| Point3::new(f64::from(i), 0.5, 0.0))).collect();
    let fit = fitted(&beside, &ArcFitOptions::new(0.1));
    assert!(fit.path().length() > 38.0);
}

#[test]
fn a_zigzag_at_the_tolerance_gives_no_rogue_arc() {
    for tolerance in [1.0 - 1e-9, 1.0 + 1e-9] {
        let zigzag: Vec<_> =
            (0..40).map(|i| Point3::new(f64::from(i), if i % 2 == 0 { 1.0 } else { -1.0 }, 0.0)).collect();
        for base in [ArcFitOptions::new(tolerance), polyline(tolerance)] {
            let options = ArcFitOptions { corner_angle: PI, ..base };
            match ArcFit::new(&zigzag, &options) {
                Ok(fit) => check(&zigzag, &options, &fit),
                Err(error) => assert_eq!(error.reason(), "no-g1-spline-in-tube"),
            }
        }
    }
}

/// An L of two legs with a rounded and a sharp corner, dense points.
fn bracket() -> Vec<Point3> {
    let mut points: Vec<_> = (0..30).map(|i| Point3::new(0.1 * f64::from(i), 0.0, 0.0)).collect();
    points.extend((0..30).map(|i| {
        let (s, c) = (-FRAC_PI_2 + FRAC_PI_2 * f64::from(i) / 30.0).sin_cos();
        Point3::new(3.0 + c, 1.0 + s, 0.0)
    }));
    points.extend((0..30).map(|i| Point3::new(4.0, 1.0 + 0.1 * f64::from(i), 0.0)));
    points.extend((0..=30).map(|i| Point3::new(4.0 - 0.1 * f64::from(i), 4.0, 0.0)));
    points
}

#[test]
fn corners_are_kept_by_angle_and_by_index() {
    let points = bracket();
    for base in [ArcFitOptions::new(1e-3), polyline(1e-3)] {
        let fit = fitted(&points, &base);
        assert!(fit.path().closest_point(Point3::new(4.0, 4.0, 0.0)).distance == 0.0);
        assert!(
            matches!(fit.warnings(), [Warning::CornerKept { vertex: 90, angle }] if (angle - FRAC_PI_2).abs() < 1e-9)
        );
        assert!(fit.certificate().max_kink < 1e-13);
        let fit = fitted(&points, &ArcFitOptions { corners: vec![15], ..base });
        let indices: Vec<_> = fit.warnings().iter().filter_map(Warning::index).collect();
        assert_eq!(indices, [15, 90]);
        assert!(fit.path().arcs().iter().any(|a| a.end() == points[15]));
    }
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|p| Point3::new(p[0], p[1], 0.0));
    let fit = fitted(&square, &ArcFitOptions { closed: true, ..polyline(1e-3) });
    assert_eq!((fit.certificate().lines, fit.certificate().arcs), (4, 0));
    // Without corners the polyline can still be followed, rounding by the tolerance.
    let fit = fitted(&square, &ArcFitOptions { closed: true, corner_angle: PI, ..polyline(1e-3) });
    assert!(fit.certificate().max_kink < 1e-12);
}

#[test]
fn a_tolerance_as_wide_as_the_figure_still_has_a_fit() {
    // Points without order: the search in the whole tube dies at the ninth.
    let points = [
        [0.1595712467096746, 0.8527005277574062],
        [0.8138867621310055, 0.7936311149969697],
        [0.8960940479300916, 0.4813811220228672],
        [0.8068309016525745, 0.6460279668681324],
        [0.9237998379394412, 0.6526364600285888],
        [0.05000823736190796, 0.23717439221218228],
        [0.05431232042610645, 0.4463132433593273],
        [0.3676684186793864, 0.4578312742523849],
        [0.8364745290018618, 0.9953548470512033],
        [0.6382710933685303, 0.08920634491369128],
        [0.3306893026456237, 0.08871648786589503],
    ]
    .map(|[x, y]| Point3::new(x, y, 0.0));
    for closed in [false, true] {
        let options = ArcFitOptions { closed, ..ArcFitOptions::new(1.0) };
        check(&points, &options, &fitted(&points, &options));
    }
}

#[test]
fn straight_data_give_true_lines() {
    // A slot of two half circles and two straight sides, closed: no end to hide a nearly straight arc in.
    let side = |from: f64, step: f64, y: f64| (0..40).map(move |i| Point3::new(from + step * f64::from(i), y, 0.0));
    let bend = |x: f64, start: f64| {
        (0..40).map(move |i| {
            let (s, c) = (start + PI * f64::from(i) / 40.0).sin_cos();
            Point3::new(x + c, s, 0.0)
        })
    };
    let slot: Vec<_> = side(-2.0, 0.1, -1.0)
        .chain(bend(2.0, -FRAC_PI_2))
        .chain(side(2.0, -0.1, 1.0))
        .chain(bend(-2.0, FRAC_PI_2))
        .collect();
    for base in [closed(1e-3), ArcFitOptions { target: FitTarget::Polyline, ..closed(1e-3) }] {
        for start in [0, 20, 55] {
            let mut points = slot.clone();
            points.rotate_left(start);
            let certificate = *fitted(&points, &base).certificate();
            assert_eq!(certificate.lines, 2, "{certificate:?}");
            assert!(certificate.arcs <= 4 && certificate.max_kink < 1e-13);
        }
    }
    // Open: line, fillet, line between two fixed ends.
    let points = &bracket()[..91];
    let certificate = *fitted(points, &ArcFitOptions::new(1e-3)).certificate();
    assert_eq!((certificate.arcs, certificate.lines), (1, 2));
}

#[test]
fn scale_and_offset_do_not_matter() {
    let points = bracket();
    let count = pieces(&fitted(&points, &ArcFitOptions::new(1e-3)));
    for scale in [1e-6, 1e6] {
        let scaled: Vec<_> = points.iter().map(|p| Point3::new(p.x * scale, p.y * scale, 0.0)).collect();
        assert_eq!(pieces(&fitted(&scaled, &ArcFitOptions::new(1e-3 * scale))), count);
    }
    let moved: Vec<_> = points.iter().map(|p| Point3::new(p.x + 1e6, p.y - 1e6, 1e6)).collect();
    let fit = fitted(&moved, &ArcFitOptions::new(1e-3));
    assert_eq!(pieces(&fit), count);
    // 1e6 is rounded to 1e-10, on arcs of length 1.
    assert!(fit.certificate().max_kink < 1e-9);
    // Any plane.
    let tilted: Vec<_> = points.iter().map(|p| Point3::new(0.6 * p.x, p.y, 0.8 * p.x + 2.0)).collect();
    assert_eq!(pieces(&fitted(&tilted, &ArcFitOptions::new(1e-3))), count);
}

#[test]
fn noise_is_smoothed_within_the_tolerance_and_reported_below_it() {
    let mut random = Random(11);
    let noisy: Vec<_> = (0..300)
        .map(|i| {
            let (s, c) = (0.01 * f64::from(i)).sin_cos();
            Point3::new(10.0 * c + 0.02 * random.next(), 10.0 * s + 0.02 * random.next(), 0.0)
        })
        .collect();
    let fit = fitted(&noisy, &ArcFitOptions::new(0.03));
    assert!(pieces(&fit) <= 3 && fit.warnings().is_empty());
    let fit = fitted(&noisy, &ArcFitOptions { corner_angle: PI, ..ArcFitOptions::new(0.002) });
    assert!(fit.warnings().iter().any(|w| w.reason() == "tolerance-below-noise"));
}

#[test]
fn coarse_samples_are_reported_where_the_edges_are_meant() {
    let coarse = circle(24, TAU, 1.0, Point3::ORIGIN);
    let fit = fitted(&coarse, &ArcFitOptions { closed: true, ..polyline(1e-3) });
    assert!(fit.warnings().iter().any(|w| w.reason() == "samples-too-coarse"));
    assert!(fitted(&coarse, &closed(1e-3)).warnings().is_empty());
}

#[test]
fn equal_neighbours_are_merged_and_indices_stay_the_users() {
    let mut points = bracket();
    points.insert(10, points[10]);
    points.insert(0, points[0]);
    let fit = fitted(&points, &ArcFitOptions::new(1e-3));
    assert!(matches!(
        fit.warnings(),
        [Warning::PointsMerged { first: 1, count: 2, .. }, Warning::CornerKept { vertex: 92, .. }]
    ));
    let mut ring = circle(40, TAU, 1.0, Point3::ORIGIN);
    ring.push(ring[0]);
    let fit = ArcFit::new(&ring, &closed(1e-3)).unwrap();
    assert!(matches!(fit.warnings(), [Warning::PointsMerged { first: 40, count: 1, .. }]));
}

#[test]
fn points_in_space_are_fitted_by_biarcs() {
    let helix: Vec<_> = (0..200)
        .map(|i| {
            let a = 0.06 * f64::from(i);
            Point3::new(a.cos(), a.sin(), 0.2 * a)
        })
        .collect();
    for options in [ArcFitOptions::new(1e-3), polyline(1e-3)] {
        let fit = fitted(&helix, &options);
        assert!(fit.certificate().max_kink < 1e-12);
        assert!(pieces(&fit) <= 40, "{}", pieces(&fit));
    }
    let knot: Vec<_> = (0..300)
        .map(|i| {
            let a = TAU * f64::from(i) / 300.0;
            let r = 2.0 + (3.0 * a).cos();
            Point3::new(r * (2.0 * a).cos(), r * (2.0 * a).sin(), (3.0 * a).sin())
        })
        .collect();
    let fit = fitted(&knot, &closed(5e-3));
    assert!(fit.path().is_closed() && fit.certificate().max_kink < 1e-12);
}

#[test]
fn bad_input_has_named_errors() {
    let p = |x: f64| Point3::new(x, 0.0, 0.0);
    let reason = |points: &[Point3], options: &ArcFitOptions| ArcFit::new(points, options).unwrap_err().reason();
    let open = ArcFitOptions::new(0.1);
    assert_eq!(reason(&[p(0.0)], &open), "too-few-points");
    assert_eq!(reason(&[], &open), "too-few-points");
    assert_eq!(reason(&[p(0.0), p(1.0)], &closed(0.1)), "too-few-points");
    assert_eq!(reason(&[p(1.0), p(1.0), p(1.0)], &open), "coincident-points");
    assert_eq!(reason(&[p(0.0), p(f64::NAN)], &open), "not-finite");
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions::new(0.0)), "tolerance-not-positive");
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions::new(f64::NAN)), "tolerance-not-positive");
    assert_eq!(
        reason(&[p(0.0), p(1.0)], &ArcFitOptions { corners: vec![2], ..open.clone() }),
        "parameter-out-of-range"
    );
    assert_eq!(reason(&[p(0.0), p(1.0)], &ArcFitOptions { corner_angle: 4.0, ..open }), "parameter-out-of-range");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(48) })]

    #[test]
    fn whatever_is_fitted_keeps_its_promises(
        arcs in prop::collection::vec((0.5..4.0_f64, -1.2..1.2_f64), 1..6),
        per_arc in 4_usize..20, noise in 0.0..0.01_f64, tolerance in 0.003..0.05_f64,
        edges: bool, is_closed: bool, seed: u64,
    ) {
        let mut random = Random(seed);
        let points: Vec<_> = chain(&arcs, per_arc)
            .into_iter()
            .map(|p| Point3::new(p.x + noise * random.next(), p.y + noise * random.next(), 0.0))
            .collect();
        let target = if edges { FitTarget::Polyline } else { FitTarget::Points };
        let options = ArcFitOptions { closed: is_closed, target, ..ArcFitOptions::new(tolerance) };
        match ArcFit::new(&points, &options) {
            Ok(fit) => {
                check(&points, &options, &fit);
                prop_assert!(fit.certificate().max_kink < 1e-9);
            }
            Err(error) => prop_assert!(edges && error.reason() == "no-g1-spline-in-tube", "{}", error),
        }
    }

    #[test]
    fn no_input_makes_it_panic(
        raw in prop::collection::vec(prop::array::uniform3(prop_oneof![
            Just(0.0), Just(1.0), Just(1e-300), Just(1e300), Just(f64::MAX), -2.0..2.0_f64,
        ]), 0..12),
        tolerance in prop_oneof![Just(1e-300), Just(1e300), 1e-6..1.0_f64],
        edges: bool, is_closed: bool,
    ) {
        let points: Vec<_> = raw.into_iter().map(Point3::from).collect();
        let target = if edges { FitTarget::Polyline } else { FitTarget::Points };
        let options = ArcFitOptions { closed: is_closed, target, ..ArcFitOptions::new(tolerance) };
        if let Ok(fit) = ArcFit::new(&points, &options) {
            prop_assert!(fit.certificate().deviation <= tolerance);
        }
    }
}
