//! Turns back, corners, cuts, wild figures, and what is refused.

use crate::data::{closed, p, samples};
use cyclide::{
    Point3, Vec3, Warning,
    construct::{FairEnd, FairSplineOptions, blends_by_turn},
    curve::{CircleSpline, ParamCurve},
    warning::CurveWarning,
};

fn has(s: &CircleSpline, reason: &str) -> bool {
    s.warnings().iter().any(|w| w.reason() == reason)
}

#[test]
fn a_turn_back_is_a_cusp() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.2, 0.0), p(2.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, -1.0, 0.0)];
    let s = CircleSpline::fair(&points, &Default::default()).unwrap();
    assert_eq!(s.kinks(), &[] as &[usize]);
    let back = [points[0], points[1], points[2], points[1], points[4]];
    let s = CircleSpline::fair(&back, &Default::default()).unwrap();
    assert_eq!((s.kinks(), has(&s, "cusp")), (&[2][..], true));
    // Closed with one cusp: one open piece from there round to it.
    let drop = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(2.0, 1.0, 0.0), p(2.0, -1.0, 0.0), p(1.0, 0.0, 0.0)];
    let s = CircleSpline::fair(&drop, &closed()).unwrap();
    assert_eq!(s.kinks(), &[0]);
    assert!(samples(&s).iter().all(|q| q.is_finite()));
}

#[test]
fn corners_cut_and_the_pieces_know_nothing_of_each_other() {
    let points = [
        [0.0, 0.0, 0.0],
        [2.0, 0.3, 0.0],
        [4.0, 0.0, 0.0],
        [4.2, 2.0, 0.5],
        [4.0, 4.0, 0.0],
        [2.0, 4.4, 0.0],
        [0.0, 4.0, 0.0],
        [-0.3, 2.0, 0.0],
    ];
    let points = points.map(Point3::from);
    let whole = CircleSpline::fair(&points, &FairSplineOptions { corners: vec![4, 0], ..closed() }).unwrap();
    assert_eq!(whole.kinks(), &[0, 4]);
    let one = CircleSpline::fair(&points[0..=4], &Default::default()).unwrap();
    assert_eq!(&whole.segments()[..4], one.segments());
    // One corner away from the seam.
    let single = CircleSpline::fair(&points, &FairSplineOptions { corners: vec![3], ..closed() }).unwrap();
    let round: Vec<Point3> = (3..=11).map(|i| points[i % 8]).collect();
    let open = CircleSpline::fair(&round, &Default::default()).unwrap();
    for (i, segment) in open.segments().iter().enumerate() {
        assert_eq!(*segment, single.segments()[(i + 3) % 8]);
    }
    // On open curves, with given ends at the ends only.
    let t = Vec3::new(0.0, 1.0, 0.0);
    let ends = [FairEnd::Clamped(t), FairEnd::Free];
    let cut =
        CircleSpline::fair(&points, &FairSplineOptions { ends, corners: vec![0, 2, 7], ..Default::default() }).unwrap();
    assert_eq!(cut.kinks(), &[2]);
    assert!(cut.segments()[0].start_tangent().angle(t) < 1e-15);
    assert!(cut.segments()[6].end_curvatures()[1].length() < 1e-14);
}

#[test]
fn sharp_turns_are_cut_where_the_curve_would_swing_out() {
    // Needles of 178 degrees.
    let points: Vec<Point3> = (0..8).map(|i| p(0.02 * f64::from(i), f64::from(i % 2), 0.0)).collect();
    let arcs = FairSplineOptions { ends: [FairEnd::Arc; 2], ..Default::default() };
    let s = CircleSpline::fair(&points, &arcs).unwrap();
    assert!(has(&s, "sharp-turn-cut") && !has(&s, "sharp-turn"));
    assert_eq!(s.kinks(), &[1, 2, 3, 4, 5, 6]);
    // Straight from point to point then.
    assert!((cyclide::curve::length(&s) - points.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>()).abs() < 1e-12);
    let kept = CircleSpline::fair(&points, &FairSplineOptions { cut_sharp_turns: false, ..arcs }).unwrap();
    assert!(kept.kinks().is_empty() && has(&kept, "relaxed") && has(&kept, "sharp-turn"));
    let Some(Warning::Curve(CurveWarning::Relaxed { segments })) =
        kept.warnings().iter().find(|w| w.reason() == "relaxed")
    else {
        panic!()
    };
    assert!(segments.iter().all(|(_, e)| *e == 0.0));
}

#[test]
fn relaxed_curves_are_short() {
    // Zigzags of many turns and spacings (`docs/math/fair-splines.md#figures`: at most 1.46 times the polygon at 120
    // degrees, 3.9 for clouds).
    for degrees in [90.0, 120.0, 135.0, 150.0, 165.0, 174.0_f64] {
        let half = 0.5 * (180.0 - degrees).to_radians();
        for legs in 0..8_u32 {
            let leg = |i: u32| 0.3 + 0.7 * f64::from((i * 7 + legs * 3) % 10) / 9.0;
            let mut at = Point3::ORIGIN;
            let mut points = vec![at];
            for i in 0..11 {
                let up = if i % 2 == 0 { 1.0 } else { -1.0 };
                at += Vec3::new(half.sin(), up * half.cos(), 0.0) * leg(i);
                points.push(at);
            }
            let s = CircleSpline::fair(&points, &Default::default()).unwrap();
            let polygon: f64 = points.windows(2).map(|w| w[0].distance(w[1])).sum();
            assert!(
                cyclide::curve::length(&s) < 4.0 * polygon,
                "{degrees} {legs}: {}",
                cyclide::curve::length(&s) / polygon
            );
        }
    }
}

#[test]
fn a_gap_in_an_exact_circle_is_no_reason_to_relax() {
    let at = |i: i32| p((0.2 * f64::from(i)).cos(), (0.2 * f64::from(i)).sin(), 0.0);
    let points: Vec<Point3> = (0..5).map(at).collect();
    let s = CircleSpline::fair(&points, &closed()).unwrap();
    assert!(!has(&s, "relaxed"));
    assert!(samples(&s).iter().all(|q| (q.to_vec().length() - 1.0).abs() < 1e-13));
}

#[test]
fn tiny_huge_and_uneven_data() {
    for scale in [1e-140, 1e-6, 1.0, 1e6, 1e140] {
        let rows = [[0.0, 0.0], [2.0, 0.3], [2.001, 0.31], [4.2, 2.0], [1.0, 4.0]];
        let points: Vec<Point3> = rows.iter().map(|[x, y]| p(x * scale, y * scale, 0.1 * x * scale)).collect();
        let s = CircleSpline::fair(&points, &closed()).unwrap();
        let unit = CircleSpline::fair(&rows.map(|[x, y]| p(x, y, 0.1 * x)), &closed()).unwrap();
        for (a, b) in samples(&s).iter().zip(samples(&unit)) {
            assert!((a.to_vec() / scale - b.to_vec()).length() < 1e-11, "{scale:e}");
        }
    }
}

#[test]
fn any_doubles_give_a_curve_or_an_error() {
    let wild = [0.0, 1.0, -1.0, 1e-300, 1e300, f64::NAN, f64::INFINITY, 1e-13, 1.0 + f64::EPSILON];
    for k in 0..2000_usize {
        let pick = |i: usize| wild[(k * 31 + i * 17 + (k / 7) * i) % wild.len()];
        let points: Vec<Point3> = (0..4 + k % 3).map(|i| p(pick(3 * i), pick(3 * i + 1), pick(3 * i + 2))).collect();
        let ends = [FairEnd::Clamped(Vec3::new(pick(1), pick(2), pick(3))), FairEnd::Circle];
        let options = FairSplineOptions { closed: k % 2 == 0, ends, tight: Some(0.3), ..Default::default() };
        if let Ok(s) = CircleSpline::fair(&points, &options) {
            assert!(samples(&s).iter().all(|q| q.is_finite()));
        }
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0)];
    let refused =
        |points: &[Point3], options: &FairSplineOptions| CircleSpline::fair(points, options).unwrap_err().reason();
    let plain = FairSplineOptions::default();
    assert_eq!(refused(&points[..1], &plain), "too-few-points");
    assert_eq!(refused(&points[..2], &closed()), "too-few-points");
    assert_eq!(refused(&[points[0], points[0], points[1]], &plain), "coincident-points");
    assert_eq!(refused(&[points[0], p(f64::NAN, 0.0, 0.0), points[1]], &plain), "not-finite");
    for tension in [-0.1, 1.1, f64::NAN] {
        assert_eq!(refused(&points, &FairSplineOptions { tension, ..plain.clone() }), "parameter-out-of-range");
        assert_eq!(blends_by_turn(&points, true, tension).unwrap_err().reason(), "parameter-out-of-range");
    }
    for tight in [0.0, 0.5, -1.0, f64::NAN] {
        assert_eq!(
            refused(&points, &FairSplineOptions { tight: Some(tight), ..plain.clone() }),
            "parameter-out-of-range"
        );
    }
    assert_eq!(refused(&points, &FairSplineOptions { corners: vec![3], ..plain.clone() }), "parameter-out-of-range");
    let clamped = |t: Vec3| FairSplineOptions { ends: [FairEnd::Clamped(t), FairEnd::Circle], ..plain.clone() };
    assert_eq!(refused(&points, &clamped(Vec3::ZERO)), "zero-tangent");
    assert_eq!(refused(&points, &clamped(Vec3::new(-1.0, 0.0, 0.0))), "arc-through-infinity");
    assert_eq!(refused(&points, &clamped(Vec3::new(f64::INFINITY, 0.0, 0.0))), "not-finite");
}

#[test]
fn dense_data_take_linear_time() {
    let at = |i: u32| {
        let a = f64::from(i) * 1e-3;
        p(a, (0.7 * a).sin() * 5.0, 0.0)
    };
    let points: Vec<Point3> = (0..200_000).map(at).collect();
    let s = CircleSpline::fair(&points, &Default::default()).unwrap();
    assert_eq!(s.piece_count(), 199_999);
    assert!(s.warnings().is_empty());
}
