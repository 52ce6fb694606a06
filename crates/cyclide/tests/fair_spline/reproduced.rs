//! The shapes that a fair spline gives back: circles, lines, planes, spheres.

use crate::data::{closed, p, reach, samples, with_ends};
use cyclide::{
    Frame, Point2, Point3, Vec3,
    construct::{FairEnd, FairSplineOptions},
    curve::{CircleSpline, joints},
};
use proptest::prelude::*;

/// A plane at any tilt with its origin this far out.
fn frame(normal: Vec3, distance: f64) -> Frame {
    Frame::from_normal(Point3::ORIGIN + Vec3::new(0.6, -0.5, 0.62) * distance, normal, Vec3::X).unwrap()
}

/// Angles that rise from 0 to less than a full turn.
fn angles() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.05..1.0_f64, 3..24).prop_map(|steps| {
        let total: f64 = steps.iter().sum();
        let mut at = 0.0;
        let next = |step: &f64| {
            let now = at;
            at += step / total * std::f64::consts::TAU;
            now
        };
        steps.iter().map(next).collect()
    })
}

proptest! {
    #[test]
    fn points_on_a_circle_give_the_circle(
        angles in angles(), open in any::<bool>(), arc in any::<bool>(),
        normal in (-1.0..1.0, -1.0..1.0, 0.1..1.0), distance in prop_oneof![Just(0.0), Just(1.0), Just(1e5), Just(1e7)]
    ) {
        let frame = frame(Vec3::new(normal.0, normal.1, normal.2), distance);
        // An end along the circle of three points never points away from its chord: half a turn at most.
        let n = angles.len();
        let ends = (angles[1] - angles[0]).max(angles[n - 1] - angles[n - 2]);
        if open && !arc && ends > std::f64::consts::PI {
            return Ok(());
        }
        let points: Vec<Point3> = angles.iter().map(|a| frame.to_world(Point2::new(a.cos(), a.sin()))).collect();
        let end = if arc { FairEnd::Arc } else { FairEnd::Circle };
        let options = FairSplineOptions { closed: !open, ..with_ends([end; 2]) };
        let s = CircleSpline::fair(&points, &options).unwrap();
        let shortest = s.segments().iter().map(|s| s.chord_length()).fold(2.0, f64::min);
        for q in samples(&s) {
            let off = (q.distance(frame.origin()) - 1.0).abs().max((q - frame.origin()).dot(frame.z()).abs());
            // Coordinates are known to eps times their size, tangents to that over the chord.
            let limit = (2e-13 + 16.0 * f64::EPSILON * distance) / shortest.min(1.0);
            prop_assert!(off <= limit, "{off:e} {limit:e}");
        }
    }

    #[test]
    fn points_on_a_sphere_give_a_curve_on_it(
        steps in prop::collection::vec((-0.6..0.6, 0.2..0.8), 4..16), arc in any::<bool>(), is_closed in any::<bool>()
    ) {
        let (mut heading, mut up, mut east) = (0.4_f64, 0.0_f64, 0.0_f64);
        let place = |(turn, step): &(f64, f64)| {
            heading += turn;
            up += step * heading.sin();
            east += step * heading.cos();
            p(up.cos() * east.cos(), up.cos() * east.sin(), up.sin())
        };
        let points: Vec<Point3> = steps.iter().map(place).collect();
        let end = if arc { FairEnd::Arc } else { FairEnd::Circle };
        let options = FairSplineOptions { closed: is_closed, ..with_ends([end; 2]) };
        let Ok(s) = CircleSpline::fair(&points, &options) else { return Ok(()) };
        // Tangents are known to rounding over the sum of the two of a segment; opposite circles turn through the chord.
        let apart = s.segments().iter().map(|s| (0.5 * s.theta()).cos().abs()).fold(1.0, f64::min);
        // A piece of two points between cuts is straight.
        if apart < 1e-3 || !s.kinks().is_empty() {
            return Ok(());
        }
        for q in samples(&s) {
            let off = (q.to_vec().length() - 1.0).abs();
            // Wild walks: the equations are solved to 1e-11 at least.
            prop_assert!(off < 1e-11 / apart, "{off:e} {apart:e}");
        }
    }

    #[test]
    fn points_in_a_plane_give_a_curve_in_it(
        points in prop::collection::vec((-1.0..1.0, -1.0..1.0), 4..12), is_closed in any::<bool>(),
        normal in (-1.0..1.0, -1.0..1.0, 0.1..1.0), distance in prop_oneof![Just(0.0), Just(1.0), Just(1e5)]
    ) {
        let frame = frame(Vec3::new(normal.0, normal.1, normal.2), distance);
        let points: Vec<Point3> = points.iter().map(|(x, y)| frame.to_world(Point2::new(*x, *y))).collect();
        let options = FairSplineOptions { closed: is_closed, ..Default::default() };
        let Ok(s) = CircleSpline::fair(&points, &options) else { return Ok(()) };
        let shortest = s.segments().iter().map(|s| s.chord_length()).fold(1.0, f64::min);
        let apart = s.segments().iter().map(|s| (0.5 * s.theta()).cos().abs()).fold(1.0, f64::min);
        for q in samples(&s) {
            let off = (q - frame.origin()).dot(frame.z()).abs();
            let far = q.distance(frame.origin());
            // The plane of the points is known to their rounding, chords lean by that over their length, and where the
            // curve runs far out a lean grows with the square of the way; opposite circles turn through the chord, about the
            // sum of the two tangents, whose lean grows as that gets short.
            let limit = (512.0 + 1.0 / apart) * f64::EPSILON * (1.0 + distance) * (1.0 + far * far) / shortest;
            prop_assert!(off <= limit, "{off:e} {limit:e}");
        }
    }

    #[test]
    fn points_on_a_line_in_order_give_the_line(steps in prop::collection::vec(0.001..1.0_f64, 2..12), free in any::<bool>()) {
        let mut at = -3.0;
        let points: Vec<Point3> = steps.iter().map(|s| { at += s; p(at, 0.0, 0.0) }).collect();
        let end = if free { FairEnd::Free } else { FairEnd::Circle };
        let s = CircleSpline::fair(&points, &with_ends([end; 2])).unwrap();
        prop_assert!(samples(&s).iter().all(|q| q.y == 0.0 && q.z == 0.0));
        prop_assert!(s.segments().iter().all(|s| s.to_arc().is_some_and(|arc| arc.is_straight())));
    }
}

#[test]
fn a_tame_curve_on_a_sphere_is_on_it_to_rounding() {
    let at = |i: u32| {
        let a = f64::from(i) / 24.0 * std::f64::consts::TAU;
        let (up, east) = (0.5 * (3.0 * a).sin(), a);
        p(up.cos() * east.cos(), up.cos() * east.sin(), up.sin())
    };
    let points: Vec<Point3> = (0..24).map(at).collect();
    for options in [closed(), with_ends([FairEnd::Circle; 2]), with_ends([FairEnd::Arc; 2])] {
        let s = CircleSpline::fair(&points, &options).unwrap();
        assert!(samples(&s).iter().all(|q| (q.to_vec().length() - 1.0).abs() < 1e-14));
    }
}

#[test]
fn three_points_give_their_circle() {
    let points = [p(0.0, 0.0, 0.0), p(3.0, 1.0, 0.5), p(2.0, 4.0, -1.0)];
    let circle = cyclide::curve::Circle::through_points(points).unwrap();
    for options in [closed(), with_ends([FairEnd::Arc; 2]), with_ends([FairEnd::Circle; 2])] {
        let s = CircleSpline::fair(&points, &options).unwrap();
        assert!(samples(&s).iter().all(|q| (q.distance(circle.center()) - circle.radius()).abs() < 1e-14 * 4.0));
        assert!(joints(&s).iter().all(|j| j.curvature_jump < 1e-14));
    }
}

#[test]
fn a_helix_is_met_closely_in_space() {
    let points: Vec<Point3> =
        (0..13).map(|i| 1.047 * f64::from(i)).map(|a: f64| p(a.cos(), a.sin(), 0.2 * a)).collect();
    let s = CircleSpline::fair(&points, &Default::default()).unwrap();
    let want = 1.0 / (1.0 + 0.04);
    let inner = &s.segments()[3..9];
    let worst =
        inner.iter().flat_map(|s| [0.0, 0.3, 0.5, 0.9].map(|l| (s.jet(l).curvature().unwrap() / want - 1.0).abs()));
    // `docs/math/fair-splines.md#figures`: 7.5e-3 for 13 points on two turns.
    assert!(worst.fold(0.0, f64::max) < 1e-2);
}

#[test]
fn rings_far_from_the_origin_are_solved_in_their_plane() {
    for distance in [1e5, 1e7] {
        for k in 0..40 {
            let normal = Vec3::new(f64::from(k).sin(), f64::from(3 * k).cos(), 0.7);
            let frame = frame(normal, distance);
            let at = |i: i32| {
                let a = std::f64::consts::TAU * f64::from(i) / 11.0;
                let r = 1.0 + 0.3 * (2.0 * a).cos();
                frame.to_world(Point2::new(r * a.cos(), r * a.sin()))
            };
            let points: Vec<Point3> = (0..11).map(at).collect();
            let s = CircleSpline::fair(&points, &closed()).unwrap();
            let flat: Vec<Point3> = points
                .iter()
                .map(|q| {
                    let (w, _) = frame.to_local(*q);
                    p(w.x, w.y, 0.0)
                })
                .collect();
            let near = CircleSpline::fair(&flat, &closed()).unwrap();
            for (a, b) in samples(&s).iter().zip(samples(&near)) {
                let (w, _) = frame.to_local(*a);
                // The rounding of the coordinates, amplified by the curve at most tenfold.
                assert!(p(w.x, w.y, 0.0).distance(b) < 100.0 * f64::EPSILON * reach(&points), "{distance:e} {k}");
            }
        }
    }
}
