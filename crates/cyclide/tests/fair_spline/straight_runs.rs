//! Straight runs beside corners, tight corners, and ends.

use crate::data::{closed, p, samples, with_ends};
use cyclide::{
    Point3, Vec3,
    construct::{FairEnd, FairSplineOptions},
    curve::{CircleSpline, ParamCurve, joints},
};

/// Unit steps along two legs at a corner of this turn, `n` on each.
fn legs(turn: f64, n: i32) -> Vec<Point3> {
    let before = (-n..=0).map(|i| p(f64::from(i), 0.0, 0.0));
    let after = (1..=n).map(|i| p(f64::from(i) * turn.cos(), f64::from(i) * turn.sin(), 0.0));
    before.chain(after).collect()
}

/// Largest distance from the first leg over the first `segments`.
fn swing(s: &CircleSpline, segments: usize) -> f64 {
    let on = |i: usize| (0..=32).map(move |k| s.piece_point(i, f64::from(k) / 32.0).y.abs());
    (0..segments).flat_map(on).fold(0.0, f64::max)
}

#[test]
fn legs_beside_a_right_angle_stay_straight() {
    let points = legs(std::f64::consts::FRAC_PI_2, 5);
    let kept = CircleSpline::fair(&points, &Default::default()).unwrap();
    assert_eq!(swing(&kept, 4), 0.0, "to the bit");
    assert!(joints(&kept).iter().all(|j| j.curvature_jump < 1e-14));
    let off = FairSplineOptions { straight_runs: false, ..Default::default() };
    // `docs/math/fair-splines.md#figures`: ripple 2.7e-3, 9.6e-3, 3.6e-2 of a chord on the legs.
    let ripple = swing(&CircleSpline::fair(&points, &off).unwrap(), 4);
    assert!((ripple - 3.6e-2).abs() < 1e-3, "{ripple}");
}

#[test]
fn gentle_bends_are_left_fair() {
    let points = legs(25_f64.to_radians(), 5);
    let off = FairSplineOptions { straight_runs: false, ..Default::default() };
    assert_eq!(CircleSpline::fair(&points, &Default::default()).unwrap(), CircleSpline::fair(&points, &off).unwrap());
}

#[test]
fn the_blend_changes_continuously_with_the_turn() {
    let end = |degrees: f64| CircleSpline::fair(&legs(degrees.to_radians(), 4), &Default::default()).unwrap();
    for degrees in [30.0, 45.0, 60.0] {
        let (a, b) = (end(degrees - 1e-7), end(degrees + 1e-7));
        let largest = samples(&a).iter().zip(samples(&b)).map(|(x, y)| x.distance(y)).fold(0.0, f64::max);
        assert!(largest < 1e-6, "{degrees}: {largest:e}");
    }
}

#[test]
fn tight_corners_round_in_proportion() {
    let points = legs(std::f64::consts::FRAC_PI_2, 5);
    let reach = |tight: Option<f64>| {
        let s = CircleSpline::fair(&points, &FairSplineOptions { tight, ..Default::default() }).unwrap();
        assert!(joints(&s).iter().all(|j| j.curvature_jump < 1e-13));
        assert!(points.iter().all(|q| samples(&s).iter().any(|x| x == q) || *q == points[points.len() - 1]));
        (swing(&s, s.piece_count() / 2), s.piece_count())
    };
    // `docs/math/fair-splines.md#figures`: .143 of a chord, .143 rho of it.
    let (plain, _) = reach(None);
    for rho in [0.05, 0.2, 0.45] {
        let (tight, pieces) = reach(Some(rho));
        assert_eq!(pieces, 12, "two more points");
        assert!((tight - 0.143 * rho).abs() < 2e-3 * rho, "{rho}: {tight}");
        assert!((plain - 0.143).abs() < 1e-3);
    }
}

#[test]
fn tight_figures_are_cut_at_the_corner_asked_for_where_they_pass_twice() {
    // Through (3, 0) on a straight leg, round a tight corner at (6, 0) and over a bow back to (3, 0), where a corner is asked for.
    let xy = [
        (0., 0.),
        (1.5, 0.),
        (3., 0.),
        (4.5, 0.),
        (6., 0.),
        (6., 2.),
        (6., 4.),
        (4., 5.),
        (3., 3.),
        (3., 0.),
        (0., -4.),
    ];
    let points: Vec<Point3> = xy.map(|(x, y)| p(x, y, 0.0)).to_vec();
    let options = FairSplineOptions { tight: Some(0.25), corners: vec![9], ..Default::default() };
    let s = CircleSpline::fair(&points, &options).unwrap();
    let kinks: Vec<usize> = joints(&s).iter().enumerate().filter(|(_, j)| j.angle > 0.1).map(|(i, _)| i).collect();
    let before = (0..s.segments().len()).filter(|i| s.segments()[*i].end() == points[9]).max().unwrap();
    assert_eq!(kinks, [before], "the joint behind the last segment that ends there");
    assert_eq!(s.kinks(), [before + 1]);
}

#[test]
fn tight_closed_figures_keep_their_seam() {
    // A square with points on its sides, starting at a corner: the point before the first one is the last of all.
    let side = |from: Point3, to: Vec3| (0..4).map(move |i| from + to * f64::from(i)).collect::<Vec<_>>();
    let points = [
        side(p(0.0, 0.0, 0.0), Vec3::X),
        side(p(4.0, 0.0, 0.0), Vec3::Y),
        side(p(4.0, 4.0, 0.0), -Vec3::X),
        side(p(0.0, 4.0, 0.0), -Vec3::Y),
    ]
    .concat();
    let s = CircleSpline::fair(&points, &FairSplineOptions { tight: Some(0.25), ..closed() }).unwrap();
    assert_eq!(s.piece_count(), 16 + 8);
    assert_eq!(s.point(0.0), points[0]);
    assert!(joints(&s).iter().all(|j| j.gap == 0.0 && j.curvature_jump < 1e-13));
}

#[test]
fn ends_are_what_they_say() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.8, 0.2), p(2.5, 0.5, 0.0), p(3.0, 2.0, -0.5), p(4.5, 2.2, 0.0)];
    let made = |end: FairEnd| CircleSpline::fair(&points, &with_ends([end; 2])).unwrap();
    let arc = made(FairEnd::Arc);
    for s in [&arc.segments()[0], &arc.segments()[3]] {
        assert!(s.theta() < 1e-15);
    }
    let free = made(FairEnd::Free);
    assert!(free.segments()[0].end_curvatures()[0].length() < 1e-14);
    assert!(free.segments()[3].end_curvatures()[1].length() < 1e-14);
    let t = Vec3::new(0.0, 3.0, 1.0);
    let clamped = made(FairEnd::Clamped(t));
    assert!(
        clamped.segments()[0].start_tangent().angle(t) < 1e-15 && clamped.segments()[3].end_tangent().angle(t) < 1e-15
    );
    let circle = made(FairEnd::Circle);
    let of_three = cyclide::curve::Arc::from_three_points(points[0], points[1], points[2]).unwrap();
    assert!(circle.segments()[0].start_tangent().angle(of_three.start_tangent().unwrap()) < 1e-14);
    // One end only.
    let one = CircleSpline::fair(&points, &with_ends([FairEnd::Clamped(t), FairEnd::Free])).unwrap();
    assert!(one.segments()[0].start_tangent().angle(t) < 1e-15);
    assert!(one.segments()[3].end_curvatures()[1].length() < 1e-14);
}

#[test]
fn two_points_are_a_segment_an_arc_or_one_blend() {
    let points = [p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0)];
    let t = FairEnd::Clamped(Vec3::new(1.0, 1.0, 0.0));
    for end in [FairEnd::Circle, FairEnd::Arc, FairEnd::Free] {
        let s = CircleSpline::fair(&points, &with_ends([end; 2])).unwrap();
        assert!(s.segments()[0].to_arc().unwrap().is_straight());
    }
    for end in [FairEnd::Circle, FairEnd::Arc] {
        for ends in [[t, end], [end, FairEnd::Clamped(Vec3::new(1.0, -1.0, 0.0))]] {
            // A quarter of a circle.
            let s = CircleSpline::fair(&points, &with_ends(ends)).unwrap();
            let arc = s.segments()[0].to_arc().unwrap();
            assert!((arc.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        }
    }
    let both = CircleSpline::fair(&points, &with_ends([t, t])).unwrap();
    assert!(both.segments()[0].end_tangent().angle(Vec3::new(1.0, 1.0, 0.0)) < 1e-15);
    let free = CircleSpline::fair(&points, &with_ends([t, FairEnd::Free])).unwrap();
    assert!(free.segments()[0].end_curvatures()[1].length() < 1e-14);
}
