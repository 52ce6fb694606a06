//! Laws of curves of any kind run backwards and cut, also past the start of closed ones.

use crate::curves::{circle_spline, kinked_spline, point, rational_cubic, stadium};
use cyclide::{
    Frame, Point2, Point3, Vec3,
    construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation, TorusSplineOptions},
    curve::{Arc, BlendVariant, Circle, CircleSplineOptions, CurveIndex, QbSpline, bounds, length},
    model::CurveObject,
    surface::{Torus, TorusSpline},
};

/// Part of the size within which a part lies on its curve: rounding of two evaluations, and of the cut of control points.
const ON_CURVE: f64 = 1e-13;

/// A curve of every kind, open and closed, by name.
fn objects(s: f64) -> Vec<(&'static str, CurveObject)> {
    let p = |x: f64, y: f64, z: f64| point(x * s, y * s, z * s);
    let points = [p(0.0, 0.0, 0.0), p(2.0, -0.5, 0.3), p(4.0, 0.5, 0.0), p(4.5, 2.5, -0.4), p(3.0, 4.0, 0.0)];
    let circle = Circle::from_center(p(1.0, -2.0, 0.5), Vec3::new(0.3, -0.5, 0.8), p(3.0, 0.0, 0.0)).unwrap();
    let torus =
        Torus::new(Frame::from_normal(p(1.0, -0.5, 0.2), Vec3::new(0.2, 0.4, 1.0), Vec3::X).unwrap(), 2.0 * s, 0.7 * s);
    let torus = torus.unwrap();
    let places = [[0.0, 0.1], [0.9, 0.8], [1.6, 0.2], [2.2, -0.9]].map(Point2::from);
    let seam =
        |closed| TorusSpline::through_places(&torus, &places, &TorusSplineOptions { closed, ..Default::default() });
    let moebius = |closed| QbSpline::through_points(&points, &MoebiusSplineOptions { closed, ..Default::default() });
    let blend = |closed, variant| circle_spline(s, &CircleSplineOptions { closed, variant, ..Default::default() });
    let through = QbInterpolation::through_points(&points, &NodeParameters::Chord).unwrap();
    vec![
        ("arc", Arc::from_three_points(points[0], points[1], points[2]).unwrap().into()),
        ("segment", Arc::segment(points[0], points[3]).unwrap().into()),
        ("circle", circle.into()),
        ("stadium", stadium(s).into()),
        ("rational cubic", rational_cubic(s).into()),
        ("circle as spline", circle.to_nurbs().unwrap().into()),
        ("smooth circle as spline", circle.to_nurbs().unwrap().with_c1_knots().unwrap().into()),
        ("open circle spline", blend(false, BlendVariant::Rational).into()),
        ("closed circle spline", blend(true, BlendVariant::Rational).into()),
        ("closed trigonometric circle spline", blend(true, BlendVariant::Trigonometric).into()),
        ("kinked circle spline", kinked_spline(s, true, 2, BlendVariant::Rational).into()),
        ("open Möbius spline", moebius(false).unwrap().into()),
        ("closed Möbius spline", moebius(true).unwrap().into()),
        ("QB curve", QbSpline::from_curve(through.curve().clone()).unwrap().into()),
        ("knot", TorusSpline::knot(&torus, [2, 3], places[0]).unwrap().into()),
        ("open seam", seam(false).unwrap().into()),
        ("closed seam", seam(true).unwrap().into()),
    ]
}

/// Runs a law on all of them, small and large.
fn each(law: impl Fn(&str, &CurveObject, f64)) {
    for scale in [1e-6, 1.0, 1e6] {
        for (name, object) in objects(scale) {
            let size = bounds(object.as_curve()).diagonal();
            law(&format!("{name} at scale {scale:e}"), &object, size);
        }
    }
}

#[test]
fn backwards_twice_is_forwards() {
    each(|name, object, size| {
        let (back, twice) = (object.reversed(), object.reversed().reversed());
        assert_eq!(back.as_curve().is_closed(), object.as_curve().is_closed(), "{name}");
        for k in 0..=100 {
            let t = f64::from(k) / 100.0;
            let p = object.as_curve().point(t);
            assert!(back.as_curve().point(1.0 - t).distance(p) <= ON_CURVE * size, "{name} at {t}");
            assert!(twice.as_curve().point(t).distance(p) <= ON_CURVE * size, "{name} at {t}");
        }
    });
}

/// That the part runs from one place to the other on the curve.
fn check_part(name: &str, object: &CurveObject, part: &CurveObject, [from, to]: [Point3; 2], size: f64) {
    let (curve, part) = (object.as_curve(), part.as_curve());
    assert!(!part.is_closed(), "{name}");
    assert!(part.point(0.0).distance(from) <= ON_CURVE * size, "{name}: {:e}", part.point(0.0).distance(from) / size);
    assert!(part.point(1.0).distance(to) <= ON_CURVE * size, "{name}: {:e}", part.point(1.0).distance(to) / size);
    let index = CurveIndex::new(curve);
    for k in 0..=60 {
        let p = part.point(f64::from(k) / 60.0);
        let distance = index.closest_point(p).distance;
        assert!(distance <= ON_CURVE * size, "{name} at {k}/60: {:e}", distance / size);
    }
}

#[test]
fn a_part_lies_on_its_curve_and_lengths_add() {
    each(|name, object, size| {
        let curve = object.as_curve();
        let joint = 1.0 / curve.piece_count() as f64;
        for [t0, t1] in [[0.1, 0.7], [0.31, 0.33], [0.0, 0.6], [0.4, 1.0], [0.0, joint], [0.5 * joint, 0.75]] {
            if t0 == 0.0 && t1 == 1.0 {
                continue;
            }
            let part = object.restricted(t0, t1).unwrap();
            check_part(&format!("{name}, {t0} to {t1}"), object, &part, [t0, t1].map(|t| curve.point(t)), size);
            // Two quadratures or three, to 1e-12 each.
            let whole = length(curve);
            let outside = match (t0 > 0.0, t1 < 1.0) {
                _ if curve.is_closed() => vec![object.restricted(t1, t0).unwrap()],
                (true, true) => vec![object.restricted(0.0, t0).unwrap(), object.restricted(t1, 1.0).unwrap()],
                (true, false) => vec![object.restricted(0.0, t0).unwrap()],
                (false, true) => vec![object.restricted(t1, 1.0).unwrap()],
                (false, false) => vec![],
            };
            let parts = outside.iter().chain([&part]).map(|part| length(part.as_curve())).sum::<f64>();
            assert!((parts - whole).abs() <= 4e-12 * whole, "{name}, {t0} to {t1}: {parts} of {whole}");
        }
    });
}

#[test]
fn closed_curves_are_cut_past_their_start() {
    each(|name, object, size| {
        let curve = object.as_curve();
        let joint = 1.0 / curve.piece_count() as f64;
        for [t0, t1] in [[0.7, 0.2], [0.95, 0.9], [1.0 - joint, 0.5 * joint], [0.5, 0.0], [1.0, 0.3]] {
            if t0 <= t1 {
                continue;
            }
            if !curve.is_closed() {
                assert_eq!(object.restricted(t0, t1).unwrap_err().reason(), "parameter-out-of-range", "{name}");
                continue;
            }
            let part = object.restricted(t0, t1).unwrap();
            check_part(&format!("{name}, {t0} to {t1}"), object, &part, [t0, t1].map(|t| curve.point(t)), size);
            // Backwards it is the part between the same places of the curve backwards.
            let back = object.reversed().restricted(1.0 - t1, 1.0 - t0).unwrap();
            let (part, back) = (length(part.as_curve()), length(back.as_curve()));
            assert!((part - back).abs() <= 4e-12 * length(curve), "{name}, {t0} to {t1}: {part} {back}");
        }
    });
}

#[test]
fn a_part_between_stations_is_as_long_as_they_are_apart() {
    each(|name, object, size| {
        let curve = object.as_curve();
        let whole = length(curve);
        for [from, to] in [[0.1, 0.7], [0.0, 0.25], [0.25, 1.0], [0.8, 0.15]] {
            let part = object.restricted_to_stations(from * whole, to * whole);
            if from > to && !curve.is_closed() {
                assert_eq!(part.unwrap_err().reason(), "parameter-out-of-range", "{name}");
                continue;
            }
            let part = part.unwrap();
            let (want, got) = ((to - from).rem_euclid(1.0) * whole, length(part.as_curve()));
            assert!((want - got).abs() <= 4e-12 * whole, "{name}, {from} to {to}: {want} {got}");
            let ends = [part.as_curve().point(0.0), part.as_curve().point(1.0)];
            check_part(&format!("{name}, {from} to {to} of its length"), object, &part, ends, size);
        }
    });
}

#[test]
fn stations_of_joints_cut_there() {
    let square = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.3], [0.0, 0.3]].map(|[x, y]| point(x, y, 0.0));
    let path = CurveObject::from(cyclide::curve::ArcPath::rounded_polyline(&square, true, &[0.0; 4]).unwrap());
    // 0.1 + 0.3 is not 0.4 in doubles.
    let part = path.restricted_to_stations(0.4, 0.1).unwrap();
    assert_eq!(part.as_curve().piece_count(), 3);
    let middle = path.restricted_to_stations(0.1, 0.4).unwrap();
    assert_eq!((middle.as_curve().piece_count(), middle.as_curve().point(1.0)), (1, square[2]));
}

#[test]
fn kinks_and_turns_are_counted_on_past_the_start() {
    let CurveObject::CircleSpline(part) =
        CurveObject::from(kinked_spline(1.0, true, 2, BlendVariant::Rational)).restricted(0.6, 0.4).unwrap()
    else {
        panic!("of the same kind")
    };
    // Six segments, corners at 4 and nowhere else: of the part, which starts in the fourth, at its second joint or none.
    assert_eq!(part.kinks(), [1]);
    let torus = Torus::new(Frame::WORLD, 2.0, 0.7).unwrap();
    let knot = TorusSpline::knot(&torus, [2, 3], Point2::new(0.3, 0.2)).unwrap();
    let part = knot.restricted_past_start(0.75, 0.5).unwrap();
    let (start, end) = (part.unrolled_place(0, 0.0), part.unrolled_place(part.pieces().len() - 1, 1.0));
    let turned = (end - start) * (1.0 / std::f64::consts::TAU);
    // Three quarters of two turns round the axis and three round the tube, even in both angles by half of the curve.
    let half = knot.restricted(0.0, 0.5).unwrap();
    let (half_start, half_end) = (half.unrolled_place(0, 0.0), half.unrolled_place(half.pieces().len() - 1, 1.0));
    let quarter = knot.restricted(0.75, 1.0).unwrap();
    let (q0, q1) = (quarter.unrolled_place(0, 0.0), quarter.unrolled_place(quarter.pieces().len() - 1, 1.0));
    let want = ((half_end - half_start) + (q1 - q0)) * (1.0 / std::f64::consts::TAU);
    assert!((turned - want).length() < 1e-14);
    let knots = part.knots();
    assert!(knots.windows(2).all(|w| w[0] < w[1]));
}

#[test]
fn what_is_no_part_is_refused() {
    each(|name, object, _| {
        let whole = length(object.as_curve());
        for [t0, t1] in [[0.5, 0.5], [-0.1, 0.5], [0.5, 1.1], [1.1, 0.2], [0.3, f64::NAN], [f64::NAN, 0.3], [0.3, -0.2]]
        {
            assert_eq!(object.restricted(t0, t1).unwrap_err().reason(), "parameter-out-of-range", "{name}: {t0} {t1}");
            let error = object.restricted_to_stations(t0 * whole, t1 * whole).unwrap_err();
            assert_eq!(error.reason(), "parameter-out-of-range", "{name}: {t0} {t1}");
        }
    });
}
