//! Where circles stop being circles: cusps, opposite circles, the long way, circles through infinity, bad input.

use crate::data::p;
use cyclide::{
    Error, Point3, Quat, Vec3, Warning,
    conformal::Mobius,
    curve::{
        BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, CurveIndex, ParamCurve, SplineEnds, bounds,
    },
    error::{ErrorItem, NumberError, PointError},
    mesh::flatten,
    warning::CurveWarning,
};
use proptest::prelude::*;

fn closed() -> CircleSplineOptions {
    CircleSplineOptions { closed: true, ..CircleSplineOptions::default() }
}

fn reason(points: &[Point3], options: &CircleSplineOptions) -> &'static str {
    CircleSpline::from_points(points, options).unwrap_err().reason()
}

proptest! {
    #[test]
    fn nearly_collinear_triples_never_go_the_long_way(
        exponent in -12.0_f64..-5.0, between in -0.9_f64..1.9, turn in (-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0),
        scale in prop_oneof![Just(1.0), Just(1e-6), Just(1e6)]
    ) {
        let q = Quat::new(turn.0, turn.1, turn.2, turn.3);
        prop_assume!(q.norm() > 1e-3 && between.abs() > 1e-3 && (between - 1.0).abs() > 1e-3);
        let map = Mobius::similarity(q, scale, Vec3::ZERO).unwrap();
        let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(between, 10.0_f64.powf(exponent), 0.0)]
            .map(|x| map.map_point(x).unwrap());
        let s = CircleSpline::from_points(&points, &closed()).unwrap();
        // Where one sharp turn counts as a cusp and the other does not, the tangents are opposite to rounding.
        prop_assume!(s.kinks().is_empty() || s.kinks().len() == 2);
        for segment in s.segments() {
            prop_assert!(!segment.long_way() && !segment.opposite_circles(), "{s:?}");
        }
    }

    #[test]
    fn a_crossed_square_stays_in_its_plane(turn in (-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0), far in 0.0..4.5) {
        // Opposite circles in the first and third segment: the half turn must be taken in the plane, although the
        // tangents are opposite to rounding only (and rounding grows with the distance from the origin).
        let q = Quat::new(turn.0, turn.1, turn.2, turn.3);
        prop_assume!(q.norm() > 1e-3);
        let distance = 10.0_f64.powf(far);
        let map = Mobius::similarity(q, 1.0, Vec3::new(0.6, -0.64, 0.48) * distance).unwrap();
        let points = [p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0)].map(|x| map.map_point(x).unwrap());
        let normal = map.push_forward(p(0.0, 0.0, 0.0), Vec3::Z).unwrap();
        for variant in [BlendVariant::Trigonometric, BlendVariant::Rational] {
            let s = CircleSpline::from_points(&points, &CircleSplineOptions { variant, ..closed() }).unwrap();
            for i in 0..=64 {
                let off = (s.point(f64::from(i) / 64.0) - points[0]).dot(normal).abs();
                // The coordinates are rounded by 1e-16 of the distance; chords are 1 and the circles small.
                prop_assert!(off < 64.0 * f64::EPSILON * (1.0 + distance), "{off:e}");
            }
        }
    }

    #[test]
    fn three_points_closed_are_their_circle(exponent in -6.0..0.0, between in 0.1..0.9) {
        let points = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(between, 10.0_f64.powf(exponent), 0.0)];
        let s = CircleSpline::from_points(&points, &closed()).unwrap();
        let circle = cyclide::curve::Circle::through_points(points).unwrap();
        for i in 0..=48 {
            let off = (s.point(f64::from(i) / 48.0).distance(circle.center()) - circle.radius()).abs();
            // The circle's own rounding grows with its radius, that of its center with the square of it.
            prop_assert!(off < 1e-14 * (1.0 + circle.radius()).powi(2), "{off:e} of {}", circle.radius());
        }
    }
}

#[test]
fn cusps_are_reported_and_keep_one_sided_tangents() {
    let points = [p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0)];
    let s = CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap();
    assert_eq!(s.warnings()[0], Warning::Curve(CurveWarning::Cusp { node: 1 }));
    assert_eq!(s.kinks(), [1]);
    assert!((s.segments()[0].end_tangent() - Vec3::X).length() < 1e-15);
    assert!((s.segments()[1].start_tangent() + Vec3::X).length() < 1e-15);
    // Three collinear points closed turn back twice.
    let s = CircleSpline::from_points(&[p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(3.0, 0.0, 0.0)], &closed()).unwrap();
    assert_eq!(s.kinks(), [0, 2]);
}

#[test]
fn unusual_data_are_named() {
    let has = |points: &[Point3], wanted: &str, index: usize| {
        let s = CircleSpline::from_points(points, &CircleSplineOptions::default()).unwrap();
        let found = s.warnings().iter().any(|w| w.reason() == wanted && w.index() == Some(index));
        assert!(found, "{wanted} {index}: {:?}", s.warnings());
    };
    has(&[p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0), p(1.0, 0.05, 0.0)], "sharp-turn", 1);
    has(&[p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(5.0, 1.0, 0.0)], "uneven-spacing", 1);
    has(&[p(0.0, 1.0, 0.0), p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(1.0, 0.0, 0.0)], "opposite-circles", 1);
    // Circles that leave the chord backwards on both sides of it: the blend takes the long way round.
    let p3 = |x: f64, y: f64| p(x, y, 0.0);
    has(&[p3(0.2, -0.3), p3(0.0, 0.0), p3(1.0, 0.0), p3(0.8, 0.3)], "long-way", 1);
    let calm = [p(0.0, 0.0, 0.0), p(1.0, 0.2, 0.0), p(2.0, 0.0, 0.5), p(3.0, 0.3, 0.0)];
    assert!(CircleSpline::from_points(&calm, &CircleSplineOptions::default()).unwrap().warnings().is_empty());
}

#[test]
fn bad_input_is_refused_by_name() {
    let good = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(0.0, 1.0, 1.0)];
    let open = CircleSplineOptions::default();
    assert_eq!(reason(&good[..1], &open), "too-few-points");
    assert_eq!(reason(&good[..2], &closed()), "too-few-points");
    assert_eq!(reason(&[], &closed()), "too-few-points");
    for order in [0, 5, u32::MAX] {
        assert_eq!(reason(&good, &CircleSplineOptions { order, ..open.clone() }), "order-out-of-range");
    }
    let mut bad = good;
    bad[2].y = f64::NAN;
    assert_eq!(
        CircleSpline::from_points(&bad, &open).unwrap_err(),
        Error::Number(NumberError::NotFinite { what: ErrorItem::Point, index: 2 })
    );
    let huge = [p(-1e308, 0.0, 0.0), p(1e308, 0.0, 0.0), p(0.0, 1.0, 0.0)];
    assert_eq!(reason(&huge, &open), "parameter-out-of-range");
    // A repeated first point closes nothing, and a billionth of the size is not nothing.
    let repeated = [good[0], good[1], good[2], good[0]];
    let error = CircleSpline::from_points(&repeated, &closed()).unwrap_err();
    assert!(matches!(error, Error::Point(PointError::CoincidentPoints { first: 3, second: 0, .. })));
    let near = |h: f64| [good[0], good[1], p(1.0, h, 0.0), good[3]];
    assert_eq!(reason(&near(1e-12), &open), "coincident-points");
    assert!(CircleSpline::from_points(&near(1e-9), &open).is_ok());
    assert_eq!(reason(&good, &CircleSplineOptions { corners: vec![4], ..open }), "parameter-out-of-range");
}

#[test]
fn clamped_ends_are_kept_and_checked() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 0.5, 0.0), p(2.0, 0.0, 0.5)];
    let clamped = |start: Option<Vec3>, end: Option<Vec3>| {
        let options = CircleSplineOptions { ends: SplineEnds::Clamped { start, end }, ..Default::default() };
        CircleSpline::from_points(&points, &options)
    };
    let (start, end) = (Vec3::new(0.0, 3.0, 4.0), Vec3::new(1.0, -1.0, 0.0));
    let s = clamped(Some(start), Some(end)).unwrap();
    assert!((s.segments()[0].start_tangent() - start / 5.0).length() < 1e-15);
    assert!(s.segments()[1].end_tangent().angle(end) < 1e-15);
    let natural = clamped(None, None).unwrap();
    assert!(natural.segments().iter().all(BlendSegment::is_arc));
    assert_eq!(clamped(Some(Vec3::ZERO), None).unwrap_err().reason(), "zero-tangent");
    assert_eq!(clamped(None, Some(Vec3::new(f64::INFINITY, 0.0, 0.0))).unwrap_err().reason(), "not-finite");
    assert_eq!(clamped(Some(p(-1.0, -0.5, 0.0).to_vec()), None).unwrap_err().reason(), "arc-through-infinity");
}

#[test]
fn hermite_segments_are_checked() {
    let (a, b) = (p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0));
    let hermite = |t1: Vec3, t2: Vec3| BlendSegment::hermite(a, t1, b, t2, 2, BlendVariant::Rational);
    let s = hermite(Vec3::new(0.0, 7.0, 0.0), Vec3::new(0.0, 0.0, 0.1)).unwrap();
    assert!((s.start_tangent() - Vec3::Y).length() < 1e-15 && (s.end_tangent() - Vec3::Z).length() < 1e-15);
    assert_eq!(hermite(Vec3::ZERO, Vec3::X).unwrap_err(), Error::Point(PointError::ZeroTangent { index: 0 }));
    assert_eq!(hermite(Vec3::X, Vec3::ZERO).unwrap_err(), Error::Point(PointError::ZeroTangent { index: 1 }));
    // Backwards along the chord at either end: the circle is the outer part of its line.
    assert_eq!(hermite(-Vec3::X, Vec3::X).unwrap_err().reason(), "arc-through-infinity");
    assert_eq!(hermite(Vec3::X, -Vec3::X).unwrap_err().reason(), "arc-through-infinity");
    assert_eq!(hermite(-Vec3::X, -Vec3::X).unwrap_err().reason(), "arc-through-infinity");
    // Opposite circles: t2 = -t1 at the first point, te = -t1 mirrored.
    let s = hermite(Vec3::Y, Vec3::Y).unwrap();
    assert!(s.opposite_circles() && s.point(0.5).distance(p(1.0, 0.0, 0.0)) < 1e-15, "through the chord");
    let same = BlendSegment::hermite(a, Vec3::X, a, Vec3::X, 2, BlendVariant::Rational);
    assert_eq!(same.unwrap_err().reason(), "coincident-points");
}

#[test]
fn numbers_beyond_the_range_of_the_kernel_are_refused() {
    // Their arcs could not be made: the conversion to arcs would have nothing to put there.
    for (scale, expected) in [(1e151, "parameter-out-of-range"), (1e-151, "coincident-points")] {
        let points = [p(0.0, 0.0, 0.0), p(scale, 0.2 * scale, 0.0), p(2.0 * scale, scale, 0.0)];
        assert_eq!(reason(&points, &CircleSplineOptions::default()), expected, "{scale:e}");
    }
}

#[test]
fn an_interval_that_falls_on_one_joint_is_refused() {
    let points = [p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 0.0, 0.0), p(3.0, 1.0, 0.0)];
    let s = CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap();
    let t: f64 = 1.0 / 3.0;
    // Three times either number is 1.
    for (t0, t1) in [(t, t.next_up()), (t, t)] {
        assert_eq!(s.restricted(t0, t1).unwrap_err().reason(), "parameter-out-of-range");
    }
}

/// Out and back with turns of 179.9 degrees, closed: loops a hundred times as large as the points, run through in a
/// small part of the parameter.
fn hairpins() -> [Point3; 4] {
    [p(-0.0633, 0.0, 0.0), p(0.9774, 0.0007, 0.0), p(0.019, 0.0014, 0.0), p(1.0743, 0.0021, 0.0)]
}

#[test]
fn every_point_of_a_loop_is_found_on_it() {
    // The loop from the last point to the first has no curvature at its ends and its middle.
    for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
        for order in 1..=4 {
            let options = CircleSplineOptions { order, variant, ..closed() };
            let s = CircleSpline::from_points(&hairpins(), &options).unwrap();
            let index = CurveIndex::new(&s);
            let points = flatten(&s, 1e-3).unwrap();
            let size = bounds(&s).diagonal();
            for (t, point) in points {
                let d = index.closest_point(point).distance;
                assert!(d < 1e-12 * size, "{variant:?} {order} at {t}: {d:e} of {size}");
            }
        }
    }
}

#[test]
fn points_far_out_do_not_oppose_each_other_by_chance() {
    use cyclide::{Warning, construct::FairSplineOptions};
    // A gentle wave in steps of some thousands of roundings down to ten of them, at 1e6 to 1e9.
    for (place, step) in [(1e6, 1e-6), (1e9, 1e-3), (1e9, 1e-5), (1e9, 3e-6)] {
        let wave = |i: i32| p(place + step * f64::from(i), step * 3.0 * (0.3 * f64::from(i)).sin() - place, 0.0);
        let points: Vec<Point3> = (0..30).map(wave).collect();
        let fair = CircleSpline::fair(&points, &FairSplineOptions::default()).unwrap();
        let mut made = vec![fair];
        made.extend((1..=4).map(|order| {
            CircleSpline::from_points(&points, &CircleSplineOptions { order, ..Default::default() }).unwrap()
        }));
        for s in made {
            let opposed =
                s.warnings().iter().any(|w| matches!(w, Warning::Curve(CurveWarning::OppositeCircles { .. })));
            assert!(!opposed, "{place:e} {step:e}: {:?}", s.warnings());
            // A rounding of 2.3e-10 and 2.4e-7 over the step.
            let rounded = s.warnings().iter().any(|w| w.reason() == "rounded-directions");
            assert_eq!(rounded, f64::EPSILON * place / step > 1e-3, "{place:e} {step:e}: {:?}", s.warnings());
        }
    }
    // Circles that do oppose each other are still told, far out too.
    let zigzag: Vec<Point3> =
        [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]].map(|[x, y]| p(x + 1e5, y, 0.0)).to_vec();
    assert!(CircleSpline::from_points(&zigzag, &CircleSplineOptions::default()).is_ok());
}
