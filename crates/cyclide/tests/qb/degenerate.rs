//! Input that is refused, and input far from 1 and from the origin.

use crate::data::PARAMETERS;
use cyclide::{
    Error, Point3, Quat, Vec3,
    conformal::HPoint,
    construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation, QbNode, circle_tangents},
    curve::{ParamCurve, QbCurve, QbSpline},
    error::{InterpolationError, NurbsError},
};

fn five() -> [Point3; 5] {
    [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [5.0, 1.0, 1.0], [6.0, 0.0, 3.0]].map(Point3::from)
}

#[test]
fn pairs_that_make_no_curve_are_refused() {
    let reason = |pairs: &[HPoint]| QbCurve::new(pairs).unwrap_err().reason();
    assert_eq!(reason(&[]), "too-few-points");
    assert_eq!(reason(&[HPoint { n: Quat::ONE, d: Quat::new(f64::NAN, 0.0, 0.0, 0.0) }]), "not-finite");
    assert_eq!(reason(&[HPoint { n: Quat::ONE, d: Quat::ZERO }]), "point-at-infinity");
    assert_eq!(reason(&[HPoint { n: Quat::ONE, d: Quat::ONE }]), "not-in-space");
}

#[test]
fn interpolation_names_what_is_wrong() {
    let points = five();
    let given = |t: [f64; 5]| QbInterpolation::through_points(&points, &NodeParameters::Given(t.to_vec())).unwrap_err();
    assert_eq!(given([0.0, 0.2, 0.2, 0.7, 1.0]).reason(), "repeated-parameter");
    assert_eq!(given([0.0, 0.2, f64::NAN, 0.7, 1.0]).reason(), "not-finite");
    assert_eq!(given([0.0, 0.2, 0.5, 0.7, 1.5]).reason(), "parameter-out-of-range");
    let short = QbInterpolation::through_points(&points, &NodeParameters::Given(vec![0.0, 1.0])).unwrap_err();
    assert_eq!(short.reason(), "count-differs");
    let even = QbInterpolation::through_points(&points[..4], &NodeParameters::Chord).unwrap_err();
    assert_eq!(even.reason(), "even-point-count");
    let mut broken = points;
    broken[3].y = f64::INFINITY;
    let error = QbInterpolation::through_points(&broken, &NodeParameters::Chord).unwrap_err();
    assert_eq!((error.reason(), error.index()), ("not-finite", Some(3)));
    let mut twice = points;
    twice[3] = twice[2];
    let error = QbInterpolation::through_points(&twice, &NodeParameters::Chord).unwrap_err();
    assert_eq!((error.reason(), error.index()), ("coincident-points", Some(3)));
    assert_eq!(QbInterpolation::through_nodes(&[]).unwrap_err().reason(), "even-point-count");
    let node = QbNode { parameter: 0.5, point: points[0], derivatives: vec![Vec3::X, Vec3::new(f64::NAN, 0.0, 0.0)] };
    assert_eq!(QbInterpolation::through_nodes(&[node]).unwrap_err().reason(), "not-finite");
    for t in [0.0, 1.0, f64::NAN] {
        let error = QbInterpolation::three_points_two_tangents([points[0], points[1], points[2]], [Vec3::X; 2], t);
        assert_eq!(error.unwrap_err().reason(), "parameter-out-of-range");
    }
}

/// Points in space that are on no curve of low degree.
fn wild(count: u32) -> Vec<Point3> {
    let noise = |x: f64| (x * 78.233).sin() * 43_758.545;
    let coordinate = |k: u32| noise(f64::from(k) + 0.37).fract();
    (0..count).map(|i| Point3::new(coordinate(3 * i), coordinate(3 * i + 1), coordinate(3 * i + 2))).collect()
}

#[test]
fn high_degrees_are_refused() {
    for count in [27, 41, 101, 401, 2001] {
        for parameters in [NodeParameters::Uniform, NodeParameters::Chord] {
            let error = QbInterpolation::through_points(&wild(count), &parameters).unwrap_err();
            assert_eq!(error, Error::Nurbs(NurbsError::DegreeTooHigh { degree: count as usize / 2, limit: 12 }));
        }
    }
    let node = |(k, point): (usize, &Point3)| QbNode {
        parameter: k as f64 / 40.0,
        point: *point,
        derivatives: vec![Vec3::X; usize::from(k % 2 == 0) * 2],
    };
    let nodes: Vec<QbNode> = wild(41).iter().enumerate().map(node).collect();
    let error = QbInterpolation::through_nodes(&nodes).unwrap_err();
    assert_eq!(error, Error::Nurbs(NurbsError::DegreeTooHigh { degree: (41 + 42) / 2, limit: 12 }));
}

/// A curve that is not plane, of degree 2, and its parameters.
fn quadratic(count: usize) -> (QbCurve, Vec<f64>) {
    let found = QbInterpolation::through_points(&five(), &NodeParameters::Chord).unwrap();
    (found.curve().clone(), (0..count).map(|k| k as f64 / (count - 1) as f64).collect())
}

#[test]
fn many_points_on_a_curve_of_low_degree_give_it() {
    let (curve, t) = quadratic(401);
    let points: Vec<Point3> = t.iter().map(|t| curve.point(*t)).collect();
    let found = QbInterpolation::through_points(&points, &NodeParameters::Given(t.clone())).unwrap();
    assert_eq!((found.curve().degree(), found.attainability().len()), (2, 401));
    assert!(found.warnings().is_empty());
    let nodes: Vec<QbNode> = t
        .iter()
        .map(|t| QbNode { parameter: *t, point: curve.point(*t), derivatives: curve.derivatives(*t, 2) })
        .collect();
    let jets = QbInterpolation::through_nodes(&nodes).unwrap();
    assert_eq!(jets.curve().degree(), 2);
    // Five points among 25 of a curve of size 6: a few roundings, as of five points alone.
    for t in PARAMETERS {
        assert!(found.curve().point(t).distance(curve.point(t)) < 1e-11);
        assert!(jets.curve().point(t).distance(curve.point(t)) < 1e-11);
    }
}

#[test]
fn a_few_points_off_a_curve_of_low_degree_are_named() {
    let (curve, t) = quadratic(401);
    let mut points: Vec<Point3> = t.iter().map(|t| curve.point(*t)).collect();
    // One of those that make the curve, and one that does not.
    for off in [0, 123] {
        points[off] += Vec3::new(0.0, 0.1, 0.2);
    }
    let error = QbInterpolation::through_points(&points, &NodeParameters::Given(t)).unwrap_err();
    let Error::Interpolation(InterpolationError::UnattainablePoint { points, .. }) = error else { panic!("{error}") };
    assert_eq!(points, [0, 123]);
}

#[test]
fn one_point_is_a_curve_but_no_object() {
    let p = Point3::new(1.0, 2.0, 3.0);
    let found = QbInterpolation::through_points(&[p; 3], &NodeParameters::Uniform).unwrap();
    assert_eq!((found.curve().degree(), found.curve().point(0.3)), (0, p));
    assert_eq!(QbSpline::from_curve(found.curve().clone()).unwrap_err().reason(), "coincident-points");
}

#[test]
fn splines_name_what_is_wrong() {
    let points = five();
    let reason = |points: &[Point3], options: &MoebiusSplineOptions| {
        QbSpline::through_points(points, options).unwrap_err().reason()
    };
    let closed = MoebiusSplineOptions { closed: true, ..Default::default() };
    assert_eq!(reason(&points[..2], &closed), "too-few-points");
    assert_eq!(reason(&[], &MoebiusSplineOptions::default()), "too-few-points");
    let knots = |knots: Vec<f64>| MoebiusSplineOptions { knots: NodeParameters::Given(knots), ..Default::default() };
    assert_eq!(reason(&points, &knots(vec![0.0, 1.0])), "count-differs");
    assert_eq!(reason(&points, &knots(vec![0.0, 1.0, 1.0, 2.0, 3.0])), "parameters-not-increasing");
    assert_eq!(reason(&points, &knots(vec![0.0, 1.0, f64::NAN, 2.0, 3.0])), "not-finite");
    let tangents = |tangents: Vec<Option<Vec3>>| MoebiusSplineOptions { tangents, ..Default::default() };
    assert_eq!(reason(&points, &tangents(vec![None])), "count-differs");
    assert_eq!(reason(&points, &tangents(vec![None, None, Some(Vec3::ZERO), None, None])), "zero-tangent");
    let mut broken = points;
    broken[2].x = f64::NAN;
    assert_eq!(reason(&broken, &MoebiusSplineOptions::default()), "not-finite");
    let mut twice = points;
    twice[1] = twice[0];
    assert_eq!(reason(&twice, &MoebiusSplineOptions::default()), "coincident-points");
    assert_eq!(circle_tangents(&points[..2], &[0.0, 1.0, 2.0], true).unwrap_err().reason(), "too-few-points");
}

#[test]
fn scale_changes_no_digit_of_the_shape() {
    let (points, spline) = (five(), QbSpline::through_points(&five(), &MoebiusSplineOptions::default()).unwrap());
    let found = QbInterpolation::through_points(&points, &NodeParameters::Chord).unwrap();
    for e in [-400, -100, 100, 400] {
        // A power of two: nothing is rounded.
        let s = 2.0_f64.powi(e);
        let scaled = points.map(|p| Point3::ORIGIN + p.to_vec() * s);
        let other = QbInterpolation::through_points(&scaled, &NodeParameters::Chord).unwrap();
        let long = QbSpline::through_points(&scaled, &MoebiusSplineOptions::default()).unwrap();
        for t in PARAMETERS {
            assert!(
                other.curve().point(t).distance(Point3::ORIGIN + found.curve().point(t).to_vec() * s) <= 1e-12 * s,
                "{e}"
            );
            assert!(long.point(t).distance(Point3::ORIGIN + spline.point(t).to_vec() * s) <= 1e-12 * s, "{e}");
        }
    }
}

#[test]
fn far_from_the_origin_curves_keep_the_digits_of_their_coordinates() {
    let offset = Vec3::new(1e6, -2e6, 5e5);
    let points = five();
    // The moved points are doubles again; the others are these moved back.
    let moved = points.map(|p| p + offset);
    let near = moved.map(|p| p - offset);
    let (a, b) = [near, moved].map(|p| QbInterpolation::through_points(&p, &NodeParameters::Uniform).unwrap()).into();
    let (c, d): (QbSpline, QbSpline) =
        [near, moved].map(|p| QbSpline::through_points(&p, &MoebiusSplineOptions::default()).unwrap()).into();
    // A few roundings of 2e6.
    for t in PARAMETERS {
        assert!((a.curve().point(t) + offset).distance(b.curve().point(t)) < 4e-9);
        assert!((c.point(t) + offset).distance(d.point(t)) < 4e-9);
        assert!((c.jet(t).d1 - d.jet(t).d1).length() < 1e-8);
    }
}

#[test]
fn knots_that_rounding_makes_equal_are_parted_in_reverse() {
    let points = &five()[..4];
    for knots in [[0.0, 1e-18, 0.5, 1.0], [0.0, 1e-18, 2e-18, 1.0], [-1e-18, 0.0, 1e-18, 1.0]] {
        let options = MoebiusSplineOptions { knots: NodeParameters::Given(knots.to_vec()), ..Default::default() };
        let back = QbSpline::through_points(points, &options).unwrap().reversed();
        assert!(back.knots().windows(2).all(|w| w[0] < w[1]), "{:?}", back.knots());
        assert_eq!([back.knots()[0], back.knots()[3]], [knots[0], knots[3]]);
        for (i, point) in points.iter().rev().enumerate() {
            assert!(back.jet_at_knot(back.knots()[i]).point.distance(*point) < 1e-12);
        }
    }
}
