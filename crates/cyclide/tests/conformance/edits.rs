//! Laws of reversal, cutting and similarity, for every curve type.

use crate::curves::{circle_spline, point, rational_cubic, stadium};
use cyclide::{
    Frame, Point2, Quat, Vec3,
    conformal::{Conformal, Mobius},
    construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation},
    curve::{Arc, BlendVariant, Circle, CircleSplineOptions, CurveIndex, ParamCurve, QbSpline, length},
    model::{ChainPiece, CurveChain},
    surface::{Torus, TorusSpline},
};

/// A similarity and a reflection after it.
fn maps() -> [Mobius; 2] {
    let similarity = Mobius::similarity(Quat::new(1.0, 0.4, -0.3, 0.8), 2.5, Vec3::new(3.0, -1.0, 0.5)).unwrap();
    let mirror = Mobius::reflection(point(0.2, 0.0, 0.1), Vec3::new(0.3, 1.0, -0.2)).unwrap();
    [similarity, mirror.after(&similarity)]
}

/// Rounding of points whose coordinates stay below 10 (25 after the maps), evaluated twice and mapped.
const ROUNDING: f64 = 64.0 * f64::EPSILON * 10.0;

fn check_reversal(name: &str, curve: &dyn ParamCurve, reversed: &dyn ParamCurve, twice: &dyn ParamCurve) {
    assert_eq!(curve.piece_count(), reversed.piece_count(), "{name}");
    assert_eq!(curve.is_closed(), reversed.is_closed(), "{name}");
    for i in 0..=100 {
        let t = f64::from(i) / 100.0;
        let d = reversed.point(1.0 - t).distance(curve.point(t));
        assert!(d <= ROUNDING, "{name} at {t}: {d:e}");
        let (forth, back) = (curve.jet(t), twice.jet(t));
        assert!(forth.point.distance(back.point) <= ROUNDING, "{name} at {t}");
        assert!((forth.d1 - back.d1).length() <= 16.0 * ROUNDING * (1.0 + forth.d1.length()), "{name} at {t}");
    }
    assert_eq!(reversed.point(0.0), curve.point(1.0), "{name}");
    assert_eq!(reversed.point(1.0), curve.point(0.0), "{name}");
}

fn check_similar(name: &str, curve: &dyn ParamCurve, image: &dyn ParamCurve, map: &Mobius) {
    for i in 0..=100 {
        let t = f64::from(i) / 100.0;
        let want = map.map_point(curve.point(t)).unwrap();
        let d = image.point(t).distance(want);
        assert!(d <= 4.0 * ROUNDING, "{name} at {t}: {d:e}");
    }
}

fn check_split(name: &str, curve: &dyn ParamCurve, t: f64, left: &dyn ParamCurve, right: &dyn ParamCurve) {
    assert_eq!(left.point(1.0), right.point(0.0), "{name} cut at {t}");
    assert!(left.point(1.0).distance(curve.point(t)) <= ROUNDING, "{name} cut at {t}");
    assert!(left.point(0.0).distance(curve.point(0.0)) <= ROUNDING, "{name} cut at {t}");
    assert!(right.point(1.0).distance(curve.point(1.0)) <= ROUNDING, "{name} cut at {t}");
    assert!(!left.is_closed() && !right.is_closed(), "{name}");
    let (sum, whole) = (length(left) + length(right), length(curve));
    // Two quadratures to 1e-12 each.
    assert!((sum - whole).abs() <= 4e-12 * whole, "{name} cut at {t}: {sum} {whole}");
    let index = CurveIndex::new(curve);
    for part in [left, right] {
        for i in 0..=40 {
            let d = index.closest_point(part.point(f64::from(i) / 40.0)).distance;
            assert!(d <= ROUNDING, "{name} cut at {t}: {d:e}");
        }
    }
}

/// Applies every law to a curve with `reversed`, a similarity under the given name, and `split`.
macro_rules! check {
    ($name:expr, $curve:expr, $similar:ident) => {{
        let (name, curve) = ($name, $curve);
        check_reversal(name, &curve, &curve.reversed(), &curve.reversed().reversed());
        for map in maps() {
            check_similar(name, &curve, &curve.$similar(&map).unwrap(), &map);
        }
        let n = curve.piece_count() as f64;
        for t in [0.31, 0.5, 1.0 / n, 1.3 / n, 1.0 - 1e-3] {
            if t < 1.0 {
                let (left, right) = curve.split(t).unwrap();
                check_split(name, &curve, t, &left, &right);
            }
        }
        for t in [0.0, 1.0, -1.0, f64::NAN] {
            assert_eq!(curve.split(t).unwrap_err().reason(), "parameter-out-of-range", "{name}");
        }
    }};
}

#[test]
fn arcs() {
    check!(
        "arc",
        Arc::from_three_points(point(0.0, 0.0, 0.0), point(1.0, 1.0, 0.5), point(2.5, 0.0, 1.0)).unwrap(),
        transformed
    );
    check!("segment", Arc::segment(point(1.0, 2.0, 3.0), point(-2.0, 1.0, 0.0)).unwrap(), transformed);
    check!("stadium", stadium(1.0), transformed);
}

#[test]
fn circles() {
    check!(
        "circle",
        Circle::from_center(point(1.0, -2.0, 0.5), Vec3::new(0.3, -0.5, 0.8), point(3.0, 0.0, 0.0)).unwrap(),
        similar
    );
    let circle = Circle::from_radius(point(1.0, 0.0, 0.0), Vec3::Z, 2.0).unwrap();
    assert_eq!(circle.restricted(0.0, 1.0).unwrap_err().reason(), "sweep-out-of-range");
}

#[test]
fn rational_splines() {
    check!("rational cubic", rational_cubic(1.0), similar);
    let circle = Circle::from_radius(point(1.0, 0.0, 0.0), Vec3::Z, 2.0).unwrap();
    check!("circle as spline", circle.to_nurbs().unwrap(), similar);
}

#[test]
fn chains() {
    let arc = Arc::from_bulge(point(-2.0, 1.0, 0.0), point(0.0, 0.0, 0.0), Vec3::Z, 0.7).unwrap();
    let line = Arc::segment(point(5.0, 3.0, 0.0), point(5.0, 7.0, 2.0)).unwrap();
    let pieces = vec![ChainPiece::Arc(arc), ChainPiece::Spline(rational_cubic(1.0)), ChainPiece::Arc(line)];
    check!("chain", CurveChain::new(pieces, false, 0.0).unwrap(), similar);
}

#[test]
fn circle_splines() {
    for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
        for closed in [false, true] {
            let options = CircleSplineOptions { variant, closed, order: 3, ..Default::default() };
            check!("circle spline", circle_spline(1.0, &options), similar);
        }
    }
}

#[test]
fn qb_splines() {
    let points = [[0.0, 0.0, 0.0], [2.0, -0.5, 0.3], [4.0, 0.5, 0.0], [4.5, 2.5, -0.4], [3.0, 4.0, 0.0]];
    let points = points.map(|[x, y, z]| point(x, y, z));
    for closed in [false, true] {
        let options = MoebiusSplineOptions { closed, ..Default::default() };
        check!("Möbius spline", QbSpline::through_points(&points, &options).unwrap(), transformed);
    }
    let through = QbInterpolation::through_points(&points, &NodeParameters::Chord).unwrap();
    check!("QB curve", through.curve().clone(), transformed);
}

#[test]
fn torus_splines() {
    let torus = Torus::new(Frame::WORLD, 2.0, 0.7).unwrap();
    check!("knot", TorusSpline::knot(&torus, [2, 3], Point2::new(0.1, 0.2)).unwrap(), similar);
    let places = [[0.0, 0.1], [0.9, 0.8], [1.6, 0.2], [2.2, -0.9]].map(Point2::from);
    check!("seam", TorusSpline::through_places(&torus, &places, &Default::default()).unwrap(), similar);
}

#[test]
fn a_part_of_a_part_is_a_part() {
    let path = stadium(1.0);
    for (t0, t1) in [(0.1, 0.9), (0.26, 0.3), (0.25, 0.75), (0.0, 0.6), (0.3, 1.0), (0.2, 0.25)] {
        let part = path.restricted(t0, t1).unwrap();
        assert!(part.point(0.0).distance(path.point(t0)) <= ROUNDING, "{t0} {t1}");
        assert!(part.point(1.0).distance(path.point(t1)) <= ROUNDING, "{t0} {t1}");
        let spline = rational_cubic(1.0);
        let part = spline.restricted(t0, t1).unwrap();
        assert!(part.point(0.0).distance(spline.point(t0)) <= ROUNDING, "{t0} {t1}");
        assert!(part.point(1.0).distance(spline.point(t1)) <= ROUNDING, "{t0} {t1}");
    }
    assert_eq!(path.restricted(0.5, 0.5).unwrap_err().reason(), "parameter-out-of-range");
    assert_eq!(path.restricted(0.5, f64::NAN).unwrap_err().reason(), "parameter-out-of-range");
}

#[test]
fn a_cut_at_a_joint_makes_no_sliver() {
    let (left, right) = stadium(1.0).split(0.5).unwrap();
    assert_eq!((left.arcs().len(), right.arcs().len()), (2, 2));
    let spline = rational_cubic(1.0);
    let (left, right) = spline.split(1.0 / 3.0).unwrap();
    assert_eq!((left.span_count(), right.span_count()), (1, 2));
    // Where the knot was smooth, the parts are the old spans to the bit of the joint.
    assert_eq!(left.point(1.0), spline.span_point(0, 1.0));
}
