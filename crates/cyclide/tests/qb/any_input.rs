//! Constructors on any doubles at all: they refuse by name or give curves whose every number is finite; they never panic.

use crate::data::PARAMETERS;
use cyclide::{
    CurveJet, Point3, Vec3,
    construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation, QbNode},
    curve::{ParamCurve, QbCurve, QbSpline},
};
use cyclide_testkit::generators::{three_points, wild, wild_point, wild_vector};
use proptest::prelude::*;

/// Every number is finite, but for a third derivative that no double is: where a curve of 1e132 has a needle the derivatives grow by 1e133 from one
/// to the next, and the third would be 1e400.
fn finite(jet: &CurveJet) -> bool {
    let beyond = jet.d2.length() / jet.d1.length() * jet.d2.length() > 1e300;
    jet.point.is_finite() && [jet.d1, jet.d2].into_iter().all(Vec3::is_finite) && (jet.d3.is_finite() || beyond)
}

fn is_sound(curve: &dyn ParamCurve) -> Result<(), TestCaseError> {
    for t in PARAMETERS {
        prop_assert!(finite(&curve.jet(t)), "{curve:?} at {t}: {:?}", curve.jet(t));
    }
    let bounds = cyclide::curve::bounds(curve);
    prop_assert!(bounds.min.is_finite() && bounds.max.is_finite(), "{curve:?}: {bounds:?}");
    Ok(())
}

fn parameters() -> impl Strategy<Value = NodeParameters> {
    prop_oneof![
        Just(NodeParameters::Automatic),
        Just(NodeParameters::Centripetal),
        Just(NodeParameters::Uniform),
        prop::collection::vec(wild(), 0..6).prop_map(NodeParameters::Given),
    ]
}

proptest! {
    #[test]
    fn spans(a in wild_point(), b in wild_point(), v in wild_vector(), w in wild_vector()) {
        if let Ok(span) = QbCurve::invariant_span([a, b], [v, w]) {
            is_sound(&span)?;
        }
    }

    #[test]
    fn curves_through_points(points in prop::collection::vec(wild_point(), 0..6), parameters in parameters()) {
        if let Ok(found) = QbInterpolation::through_points(&points, &parameters) {
            is_sound(found.curve())?;
        }
    }

    #[test]
    fn curves_through_points_in_special_position(points in three_points(), t in 0.0..1.0_f64, v in wild_vector(), w in wild_vector()) {
        if let Ok(found) = QbInterpolation::through_points(&points, &NodeParameters::Given(vec![0.0, t, 1.0])) {
            is_sound(found.curve())?;
        }
        if let Ok(found) = QbInterpolation::three_points_two_tangents(points, [v, w], t) {
            is_sound(found.curve())?;
        }
        let size = points[0].distance(points[1]);
        if let Ok(found) = QbInterpolation::three_points_two_tangents(points, [Vec3::X * size, Vec3::Y * size], t) {
            is_sound(found.curve())?;
        }
        if let Ok(spline) = QbSpline::through_points(&points, &MoebiusSplineOptions::default()) {
            is_sound(&spline)?;
        }
    }

    #[test]
    fn curves_through_jets(points in prop::collection::vec((wild_point(), wild_vector()), 1..4), count in 0_usize..3) {
        let n = points.len();
        let node = |(i, (point, v)): (usize, &(Point3, Vec3))| QbNode {
            parameter: i as f64 / n as f64,
            point: *point,
            derivatives: vec![*v; if i == 0 { count } else { 0 }],
        };
        if let Ok(found) = QbInterpolation::through_nodes(&points.iter().enumerate().map(node).collect::<Vec<_>>()) {
            is_sound(found.curve())?;
        }
    }

    #[test]
    fn splines(points in prop::collection::vec(wild_point(), 0..6), knots in parameters(), closed: bool, v in wild_vector()) {
        let mut tangents = vec![None; points.len()];
        if let Some(first) = tangents.first_mut() {
            *first = Some(v);
        }
        for tangents in [Vec::new(), tangents] {
            let options = MoebiusSplineOptions { closed, knots: knots.clone(), tangents, ..Default::default() };
            if let Ok(spline) = QbSpline::through_points(&points, &options) {
                is_sound(&spline)?;
            }
        }
    }
}
