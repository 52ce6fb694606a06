//! What the curve is: it passes through its points, touches the node circles, stays on circles, spheres and planes.

use crate::data::{self, infinity_distance_squared, p, reach, rounding_of, sharpest_turn, spline};
use cyclide::{
    Point3, Vec3,
    curve::{BlendSegment, BlendVariant, Circle, CircleSpline, CircleSplineOptions, ParamCurve, corners_by_angle},
};
use proptest::prelude::*;

proptest! {
    #[test]
    fn passes_through_its_points_to_the_bit(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let n = points.len();
        for piece in 0..s.piece_count() {
            prop_assert_eq!(s.piece_point(piece, 0.0), points[piece]);
            prop_assert_eq!(s.piece_point(piece, 1.0), points[(piece + 1) % n]);
            prop_assert_eq!(s.piece_jet(piece, 1.0).point, points[(piece + 1) % n]);
            prop_assert!(s.piece_point(piece, 0.5).is_finite());
        }
    }

    #[test]
    fn runs_at_chord_speed_at_its_nodes(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for segment in s.segments() {
            // |x'| = |d| at both ends ("free C1"): a few roundings of unit vectors, at the end of N = u + ... too.
            let d = segment.chord_length();
            prop_assert!((segment.jet(0.0).speed() - d).abs() <= 1e-14 * d);
            prop_assert!((segment.jet(1.0).speed() - d).abs() <= 1e-14 * d);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_points(points in data::tame_points(), options in data::options(), l in 0.1..0.9) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for segment in s.segments() {
            // Central differences converge with the square of the step where it resolves the curve.
            if infinity_distance_squared(segment) < 0.05 || segment.theta() > 3.0 {
                continue;
            }
            let error = |h: f64| {
                let (a, b, at) = (segment.jet(l - h), segment.jet(l + h), segment.jet(l));
                [
                    ((b.point - a.point) / (2.0 * h) - at.d1).length(),
                    ((b.d1 - a.d1) / (2.0 * h) - at.d2).length(),
                    ((b.d2 - a.d2) / (2.0 * h) - at.d3).length(),
                ]
            };
            let (coarse, fine, at) = (error(2e-3), error(1e-3), segment.jet(l));
            // Rounding of a difference: eps/h of the values, which for d2 include cancelled terms of 100 chords.
            let noise = 1e-13 * (reach(&points) + at.d1.length() + at.d2.length() + 100.0 * segment.chord_length()) / 1e-3;
            for (c, f) in coarse.into_iter().zip(fine) {
                prop_assert!(f <= 0.3 * c + noise, "{c:e} {f:e} {noise:e}");
            }
        }
    }

    #[test]
    fn touches_the_node_circle_to_its_order(points in data::tame_points(), order in 1_u32..=4, variant in data::variant()) {
        let options = CircleSplineOptions { closed: true, order, variant, ..CircleSplineOptions::default() };
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        let n = points.len();
        for (i, segment) in s.segments().iter().enumerate() {
            let before = points[(i + n - 1) % n];
            let Ok(circle) = Circle::through_points([before, segment.start(), segment.end()]) else { continue };
            if infinity_distance_squared(segment) < 0.2 || circle.radius() > 20.0 * segment.chord_length() {
                continue;
            }
            let off = |l: f64| {
                let v = segment.point(l) - circle.center();
                let height = v.dot(circle.normal());
                height.hypot((v - circle.normal() * height).length() - circle.radius())
            };
            // The distance falls like l^(k+1), by 2^(k+1) when l is halved; a quarter of the order is left to the
            // next term, which is l times a few smaller.
            let (coarse, fine) = (off(0.01), off(0.005));
            let noise = 1e-13 * (circle.radius() + reach(&points));
            prop_assert!(fine <= coarse / 2.0_f64.powf(f64::from(order) + 0.75) + noise, "{order} {coarse:e} {fine:e}");
        }
    }

    #[test]
    fn angle_is_that_between_the_two_circles(points in data::tame_points()) {
        for w in points.windows(4) {
            let Ok(s) = BlendSegment::from_points([w[0], w[1], w[2], w[3]], 2, BlendVariant::Rational) else { continue };
            let tangent = |a, b, c, at| Circle::through_points([a, b, c]).ok().and_then(|circle| circle.tangent_at(at));
            let (Some(t1), Some(t2)) = (tangent(w[0], w[1], w[2], w[1]), tangent(w[1], w[2], w[3], w[1])) else { continue };
            let angle = t1.angle(t2);
            let want = if s.long_way() { std::f64::consts::TAU - angle } else { angle };
            // Tangents from centers: rounding times radius over chord, here below 1e4.
            prop_assert!((s.theta() - want).abs() < 1e-11, "{} {want}", s.theta());
        }
    }

    #[test]
    fn planar_blends_turn_over_the_chord_side(a in -3.1_f64..3.1, b in -3.1_f64..3.1) {
        // For signed angles of the start tangents from the chord the way is long exactly if they differ by more than
        // half a turn: the blend then sweeps through the chord direction, never through infinity.
        let at = |angle: f64| Vec3::new(angle.cos(), angle.sin(), 0.0);
        // The end tangent is the mirror image of the second start tangent.
        let s = BlendSegment::hermite(p(0.0, 0.0, 0.0), at(a), p(1.0, 0.0, 0.0), at(-b), 2, BlendVariant::Rational).unwrap();
        prop_assume!(((a - b).abs() - std::f64::consts::PI).abs() > 1e-9);
        prop_assert_eq!(s.long_way(), (a - b).abs() > std::f64::consts::PI);
        prop_assert!((s.theta() - (a - b).abs()).abs() < 1e-14);
    }

    #[test]
    fn stays_on_a_sphere(angles in prop::collection::vec((-1.0..1.0, -3.1..3.1), 4..9), options in data::options()) {
        let on_sphere = |(z, phi): &(f64, f64)| {
            let r: f64 = ((1.0 - z) * (1.0 + z)).sqrt();
            p(r * phi.cos(), r * phi.sin(), *z)
        };
        let points: Vec<Point3> = angles.iter().map(on_sphere).collect();
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for (segment, rounding) in s.segments().iter().zip(rounding_of(&points, &s)) {
            if segment.opposite_circles() {
                continue;
            }
            for i in 0..=16 {
                let off = (segment.point(f64::from(i) / 16.0).to_vec().length() - 1.0).abs();
                prop_assert!(off <= 64.0 * rounding, "{off:e} {rounding:e}");
            }
        }
    }

    #[test]
    fn points_of_a_circle_give_the_circle(
        start in -3.0_f64..3.0, steps in prop::collection::vec(0.05..1.0, 3..12), shift in -10.0..10.0, options in data::options()
    ) {
        // Angles in cyclic order, once round.
        let total: f64 = steps.iter().sum();
        let mut angle = start;
        let points: Vec<Point3> = steps.iter().map(|step| {
            angle += step * std::f64::consts::TAU / total;
            p(shift + 2.0 * angle.cos(), 2.0 * angle.sin(), shift)
        }).collect();
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for (segment, rounding) in s.segments().iter().zip(rounding_of(&points, &s)) {
            for i in 0..=16 {
                let q = segment.point(f64::from(i) / 16.0);
                let off = ((q.x - shift).hypot(q.y) - 2.0).abs().max((q.z - shift).abs());
                prop_assert!(off <= 64.0 * rounding, "{off:e} {rounding:e}");
            }
        }
    }

    #[test]
    fn lies_in_its_box_and_near_infinity_too(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        for piece in 0..s.piece_count() {
            let b = s.piece_bounds(piece);
            for i in 0..=32 {
                let q = s.piece_point(piece, f64::from(i) / 32.0);
                let slack = 1e-14 * (b.max_abs() + q.to_vec().max_abs());
                for axis in 0..3 {
                    prop_assert!(q[axis] >= b.min[axis] - slack && q[axis] <= b.max[axis] + slack);
                }
            }
        }
    }

    #[test]
    fn turns_that_are_no_cusps_join_with_a_tangent(points in data::points(), options in data::options()) {
        let Some(s) = spline(&points, &options) else { return Ok(()) };
        prop_assume!(sharpest_turn(&points, options.closed) > 1e-6);
        prop_assert!(s.kinks().is_empty());
        let n = s.piece_count();
        for i in usize::from(!options.closed)..n {
            let (before, after) = (&s.segments()[(i + n - 1) % n], &s.segments()[i]);
            let kink = before.end_tangent().angle(after.start_tangent());
            // Reflection and back, and a cancelled sum of chords: a few roundings over their sum. Opposite circles
            // are replaced by exactly opposite ones, 16 eps times size over chord away.
            let shortest = before.chord_length().min(after.chord_length());
            let opposite = if before.opposite_circles() || after.opposite_circles() {
                1e-12_f64.max(32.0 * f64::EPSILON * reach(&points) / shortest)
            } else {
                0.0
            };
            prop_assert!(kink <= 1e-14 / sharpest_turn(&points, options.closed) + opposite, "{kink:e}");
        }
    }
}

#[test]
fn a_straight_run_is_straight_and_uniform() {
    let points: Vec<Point3> = [0.0, 1.0, 5.0, 6.0].map(|x| p(x, 2.0 * x, -x)).to_vec();
    for variant in [BlendVariant::Trigonometric, BlendVariant::Rational] {
        let options = CircleSplineOptions { variant, ..CircleSplineOptions::default() };
        let s = CircleSpline::from_points(&points, &options).unwrap();
        for (i, segment) in s.segments().iter().enumerate() {
            for l in [0.1, 0.5, 0.8] {
                assert!(segment.point(l).distance(points[i].lerp(points[i + 1], l)) < 1e-15 * 16.0);
            }
            assert!(segment.is_arc() && segment.to_arc().unwrap().is_straight());
        }
    }
}

#[test]
fn curvature_is_continuous_from_order_two_on() {
    let points =
        [[0.0, 0.0, 0.0], [2.0, 0.5, 0.3], [3.0, 2.5, 1.0], [1.0, 3.0, -0.5], [-1.0, 1.5, 0.5]].map(Point3::from);
    for variant in [BlendVariant::Trigonometric, BlendVariant::Rational] {
        for order in 1..=4 {
            let options = CircleSplineOptions { closed: true, order, variant, ..CircleSplineOptions::default() };
            let s = CircleSpline::from_points(&points, &options).unwrap();
            let jump = cyclide::curve::joints(&s).iter().map(|j| j.curvature_jump).fold(0.0, f64::max);
            // Curvatures are near 1; with order 1 they differ.
            assert!(if order == 1 { jump > 1e-3 } else { jump < 1e-13 }, "{variant:?} {order}: {jump:e}");
        }
    }
}

#[test]
fn corners_cut_the_curve_into_runs() {
    let square = [[0.0, 0.0], [1.0, -0.2], [2.0, 0.0], [2.2, 1.0], [2.0, 2.0], [1.0, 2.2], [0.0, 2.0], [-0.2, 1.0]];
    let points = square.map(|[x, y]| p(x, y, 0.0));
    let corners = corners_by_angle(&points, true, 45.0_f64.to_radians());
    assert_eq!(corners, [0, 2, 4, 6]);
    let closed = CircleSplineOptions { closed: true, corners: vec![6, 2, 4, 2], ..CircleSplineOptions::default() };
    let s = CircleSpline::from_points(&points, &closed).unwrap();
    // The seam is an ordinary node: the last run passes it.
    assert_eq!(s.kinks(), [2, 4, 6]);
    assert_eq!(s.smooth_runs(), [2..4, 4..6, 6..10]);
    // A run of two segments between corners is the circle through its three points.
    assert!(s.segments()[2].is_arc() && s.segments()[3].is_arc());
    let one = CircleSplineOptions { closed: true, corners: vec![3], ..CircleSplineOptions::default() };
    assert_eq!(CircleSpline::from_points(&points, &one).unwrap().smooth_runs(), vec![3..11]);
    let open = CircleSplineOptions { corners: vec![0, 4, 7], ..CircleSplineOptions::default() };
    let s = CircleSpline::from_points(&points, &open).unwrap();
    assert_eq!((s.kinks(), s.smooth_runs()), ([4].as_slice(), vec![0..4, 4..7]));
    assert!(corners_by_angle(&points[..1], false, 0.1).is_empty() && corners_by_angle(&[], true, 0.1).is_empty());
}

#[test]
fn a_segment_that_runs_far_out_is_measured_in_full() {
    // Circles that pass near infinity: out and back between l = 1/2 - w and 1/2 + w.
    for w in [1e-2, 1e-3, 1e-5] {
        for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
            let (start, end) = (Vec3::new(-1.0, 2.0 * w, 0.0), Vec3::new(-1.0, -3.0 * w, w));
            let s = BlendSegment::hermite(p(0.0, 0.0, 0.0), start, p(1.0, 0.0, 0.0), end, 2, variant).unwrap();
            let n = 100_000;
            let even = (1.0_f64 / w).atan();
            let at = |i: i32| s.point((0.5 + 0.5 * w * (f64::from(i) / f64::from(n) * even).tan()).clamp(0.0, 1.0));
            let chords: f64 = (-n..n).map(|i| at(i).distance(at(i + 1))).sum();
            // Chords are short by (turn)²/24, with a turn of at most 4 pi over all of them; rounding near the far end
            // is eps/w of the size.
            assert!((cyclide::curve::length(&s) / chords - 1.0).abs() < 1e-9 + 1e-14 / w, "{w} {variant:?}");
            let table = cyclide::curve::ArcLength::new(&s);
            assert!((table.total() / chords - 1.0).abs() < 1e-9 + 1e-14 / w);
            let sampled = cyclide::Aabb::of_points((-n..=n).map(at)).unwrap();
            assert!((cyclide::curve::bounds(&s).diagonal() / sampled.diagonal() - 1.0).abs() < 1e-8);
        }
    }
}

/// End circles that are many chords large and some roundings of their tangents apart: what lies between them reaches no farther than they do.
#[test]
fn a_segment_between_circles_some_roundings_apart_reaches_as_far_as_they_do() {
    for off in [1e-1_f64, 1e-2, 1e-3] {
        // Above a chord that it leaves at this angle less than half a turn.
        let height = 0.5 / (0.5 * off).tan();
        for k in 10..60 {
            for apart in [1e-15, -1e-15].map(|rounding| f64::from(k) * rounding) {
                let start = Vec3::new(-off.cos(), off.sin(), 0.0);
                let end = Vec3::new(-off.cos(), -(off.sin() + apart), 0.0);
                let (a, b) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
                let s = BlendSegment::hermite(a, start, b, end, 2, BlendVariant::Rational).unwrap();
                let bounds = s.bounds();
                assert!((0..=200).all(|k| bounds.contains(cyclide::Aabb::of_point(s.point(f64::from(k) / 200.0)))));
                // About the middle of the chord, a half from the origin.
                assert!(bounds.max_abs() <= height * 1.001 + 0.5, "{off} {apart:e}: {bounds:?}");
            }
        }
    }
}

/// In a plane the tangent turns evenly, also between circles that all but oppose each other: halfway it is the bisector, known as well as both.
#[test]
fn circles_that_all_but_oppose_each_other_are_met_halfway() {
    for short_of_half in [1e-1, 1e-4, 1e-6, 1e-8] {
        let (from, turn) = (-1.0, std::f64::consts::PI - short_of_half);
        let at = |angle: f64| Vec3::new(angle.cos(), angle.sin(), 0.0);
        // At the end the arc of a start tangent runs in the mirror image.
        let (start, end) = (at(from), at(-from - turn));
        let s =
            BlendSegment::hermite(p(0.0, 0.0, 0.0), start, p(1.0, 0.0, 0.0), end, 2, BlendVariant::Rational).unwrap();
        let way = Vec3::X + at(from + 0.5 * turn);
        let middle = Point3::ORIGIN + way / way.length_squared();
        assert!(!s.long_way() && s.point(0.5).distance(middle) < 8.0 * f64::EPSILON, "{short_of_half:e}");
    }
}
