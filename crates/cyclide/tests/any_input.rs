//! Constructors on any doubles at all: they refuse by name or give curves whose every number is finite; they never
//! panic.

use cyclide::{
    CurveJet, Point3, Quat, Vec3,
    conformal::Sphere,
    construct::{ArcSplineOptions, Biarc, BiarcRule, estimate_tangents},
    curve::{Arc, Arc4, ArcPath, Circle, ParamCurve},
};
use cyclide_testkit::generators::{three_points, wild, wild_point, wild_vector};
use proptest::prelude::*;

const PARAMETERS: [f64; 7] = [0.0, 1e-12, 0.25, 0.5, 0.75, 1.0 - 1e-12, 1.0];

fn finite(jet: &CurveJet) -> bool {
    jet.point.is_finite() && [jet.d1, jet.d2, jet.d3].into_iter().all(Vec3::is_finite)
}

/// Everything that can be asked of an accepted arc is finite and in its range.
fn is_sound(arc: &Arc) -> Result<(), TestCaseError> {
    for t in PARAMETERS {
        prop_assert!(arc.point(t).is_finite(), "{arc:?} at {t}: {:?}", arc.point(t));
        prop_assert!(finite(&arc.piece_jet(0, t)), "{arc:?} at {t}: {:?}", arc.piece_jet(0, t));
        let at = arc.parameter_at_length(t);
        prop_assert!((0.0..=1.0).contains(&at), "{arc:?}: parameter {at} at length {t}");
        prop_assert!(arc.point_at_length(t).is_finite(), "{arc:?} at length {t}");
    }
    prop_assert!(arc.length().is_finite() && arc.length() >= 0.0, "{arc:?}: length {}", arc.length());
    prop_assert!((0.0..std::f64::consts::TAU + 1e-12).contains(&arc.angle()));
    prop_assert!(arc.curvature().is_finite(), "{arc:?}: curvature {}", arc.curvature());
    prop_assert!(arc.bulge_vector().is_finite(), "{arc:?}: bulge");
    let bounds = arc.bounds();
    prop_assert!(bounds.min.is_finite() && bounds.max.is_finite(), "{arc:?}: {bounds:?}");
    let nearest = arc.closest_point(arc.start().midpoint(arc.end()));
    prop_assert!(nearest.distance.is_finite() && (0.0..=1.0).contains(&nearest.t), "{arc:?}: {nearest:?}");
    let back = arc.reversed();
    prop_assert!(back.point(0.5).is_finite() && finite(&back.piece_jet(0, 0.0)), "{arc:?} reversed");
    if let Ok((left, right)) = arc.split(0.25) {
        prop_assert!(left.point(0.5).is_finite() && right.point(0.5).is_finite(), "{arc:?} split");
    }
    if let Ok(nurbs) = arc.to_nurbs(1.5) {
        prop_assert!(nurbs.control_points().iter().all(|p| p.is_finite()), "{arc:?} as a spline");
    }
    Ok(())
}

fn path_is_sound(path: &ArcPath) -> Result<(), TestCaseError> {
    path.arcs().iter().try_for_each(is_sound)
}

fn quat() -> impl Strategy<Value = Quat> {
    (wild(), wild_vector()).prop_map(|(w, v)| Quat::from_parts(w, v))
}

fn rule() -> impl Strategy<Value = BiarcRule> {
    prop_oneof![Just(BiarcRule::EqualD), Just(BiarcRule::EqualChord), Just(BiarcRule::Auto)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4 * ProptestConfig::default().cases, ..ProptestConfig::default() })]

    #[test]
    fn arcs_from_weights(a in wild_point(), b in wild_point(), w0 in quat(), w1 in quat()) {
        if let Ok(arc) = Arc::from_weights(a, b, w0, w1) {
            is_sound(&arc)?;
        }
        // Wild weights hardly ever stay in three-space: the complex ones do.
        if let Ok(arc) = Arc::from_complex([a.x, a.y], [b.x, b.y], [w0.w, w0.x], [w1.w, w1.x]) {
            is_sound(&arc)?;
        }
        if let Ok(arc) = Arc4::from_weights(a.into(), b.into(), w0, w1) {
            for t in PARAMETERS {
                prop_assert!(arc.point(t).is_finite(), "{arc:?} at {t}");
            }
        }
    }

    #[test]
    fn arcs_from_tangents(a in wild_point(), b in wild_point(), v in wild_vector()) {
        for arc in [Arc::from_start_tangent(a, b, v), Arc::from_end_tangent(a, b, v)].into_iter().flatten() {
            is_sound(&arc)?;
        }
    }

    #[test]
    fn arcs_and_circles_from_points(a in wild_point(), b in wild_point(), c in wild_point()) {
        if let Ok(arc) = Arc::from_three_points(a, b, c) {
            is_sound(&arc)?;
        }
        if let Ok(circle) = Circle::through_points([a, b, c]) {
            prop_assert!(circle.center().is_finite() && circle.radius().is_finite(), "{circle:?}");
        }
        if let Ok(sphere) = Sphere::through_points([a, b, c, Point3::ORIGIN]) {
            prop_assert!(sphere.center().is_finite() && sphere.radius().is_finite(), "{sphere:?}");
        }
    }

    #[test]
    fn arcs_from_bulge_and_centre(a in wild_point(), b in wild_point(), n in wild_vector(), x in wild()) {
        if let Ok(arc) = Arc::from_bulge(a, b, n, x) {
            is_sound(&arc)?;
        }
        if let Ok(arc) = Arc::from_center(a, n, b, x) {
            is_sound(&arc)?;
        }
        for circle in [Circle::from_center(a, n, b), Circle::from_radius(a, n, x)].into_iter().flatten() {
            for t in PARAMETERS {
                prop_assert!(finite(&circle.piece_jet(0, t)), "{circle:?} at {t}");
            }
            for arc in circle.to_arcs() {
                is_sound(&arc)?;
            }
        }
    }

    #[test]
    fn biarcs(a in wild_point(), t0 in wild_vector(), b in wild_point(), t1 in wild_vector(), rule in rule()) {
        if let Ok(biarc) = Biarc::new(a, t0, b, t1, rule) {
            path_is_sound(&biarc.to_path())?;
            prop_assert!(biarc.joint_tangent().is_finite());
        }
    }

    #[test]
    fn arc_splines(points in prop::collection::vec(wild_point(), 0..6), t in wild_vector(), closed: bool, rule in rule()) {
        let options = ArcSplineOptions { closed, rule, tangents: None };
        for path in [ArcPath::spline(&points, &options), ArcPath::chain_from_tangent(&points, closed, t)].into_iter().flatten() {
            path_is_sound(&path)?;
        }
    }

    #[test]
    fn arcs_from_points_in_special_position(points in three_points()) {
        let [a, b, c] = points;
        if let Ok(arc) = Arc::from_three_points(a, b, c) {
            is_sound(&arc)?;
            prop_assert_eq!((arc.start(), arc.end()), (a, c));
        }
        if let Ok(tangents) = estimate_tangents(&points, false) {
            prop_assert!(tangents.iter().all(|t| (t.length() - 1.0).abs() < 1e-15));
        }
        for closed in [false, true] {
            if let Ok(path) = ArcPath::spline(&points, &ArcSplineOptions { closed, ..Default::default() }) {
                path_is_sound(&path)?;
            }
        }
    }
}
