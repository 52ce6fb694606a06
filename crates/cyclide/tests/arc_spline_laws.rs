//! Laws of arcs through three points, biarcs and arc splines (`docs/math/arc-splines.md`) on random, nearly collinear,
//! nearly coincident and badly scaled points.
#![allow(clippy::unwrap_used, reason = "a helper of tests fails by panicking")]

use cyclide::{
    Error, Point3, Vec3,
    construct::{ArcSplineOptions, Biarc, BiarcRule},
    curve::{Arc, ArcPath, ParamCurve},
    error::{ArcError, NumberError, PointError},
};
use cyclide_testkit::generators::{direction, neighbor, point, scale, three_points};
use proptest::prelude::*;

fn angle(u: Vec3, v: Vec3) -> f64 {
    u.cross(v).length().atan2(u.dot(v))
}

/// Largest absolute coordinate.
fn size(points: &[Point3]) -> f64 {
    points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max)
}

/// The angle that rounding of the ends can turn an arc's tangents by: of the chord against the coordinates.
fn tangent_rounding(arc: &Arc) -> f64 {
    rounding(arc, &[arc.start(), arc.end()])
}

/// The same of an arc with an end that was computed from all of these points: the joint of a biarc may be near an end that
/// is the origin, and is as far off as the other end is away.
fn rounding(arc: &Arc, from: &[Point3]) -> f64 {
    64.0 * f64::EPSILON * (1.0 + size(from) / arc.chord().length())
}

/// What rounding of unit tangents is multiplied by in the joint of a biarc: by the legs of the control triangles over
/// the chord for equal legs, by 1/|K| for equal chords (down to the 1e-8 where the planar limit takes over).
fn joint_condition(biarc: &Biarc) -> f64 {
    let [first, second] = biarc.arcs();
    let w = second.end() - first.start();
    match biarc.rule() {
        BiarcRule::EqualD => {
            // From the longer arc: both legs are equal, and the other arc may be tiny.
            let longer = if first.chord().length() > second.chord().length() { first } else { second };
            1.0 + 0.5 * longer.chord().length() / (0.5 * longer.angle()).cos().abs() / w.length()
        }
        _ => {
            let t1 = second.end_tangent().unwrap();
            let k = first.start_tangent().unwrap() + t1.reflect(w.unit().unwrap());
            1.0 + 1.0 / k.length().max(1e-8)
        }
    }
}

/// Fails unless the path is tangent-continuous at every joint, up to rounding times `condition`.
fn is_g1(path: &ArcPath, condition: f64) -> Result<(), TestCaseError> {
    let n = path.arcs().len();
    for i in 0..if path.is_closed() { n } else { n - 1 } {
        let (a, b) = (path.arcs()[i], path.arcs()[(i + 1) % n]);
        prop_assert_eq!(a.end(), b.start());
        let kink = angle(a.end_tangent().unwrap(), b.start_tangent().unwrap());
        let ends = [a.start(), a.end(), b.end()];
        let allowed = condition * (rounding(&a, &ends) + rounding(&b, &ends));
        prop_assert!(kink <= allowed, "joint {i}: kink {kink:e} > {allowed:e}: {a:?} {b:?}");
    }
    Ok(())
}

fn rule() -> impl Strategy<Value = BiarcRule> {
    prop_oneof![Just(BiarcRule::EqualD), Just(BiarcRule::EqualChord), Just(BiarcRule::Auto)]
}

/// A tangent near another one, near its opposite, or anywhere: equal and mirrored tangents are where biarcs fail.
fn tangents() -> impl Strategy<Value = (Vec3, Vec3)> {
    let near =
        (direction(), direction(), -16.0..-1.0, any::<bool>()).prop_map(|(t, d, e, opposite): (_, Vec3, f64, _)| {
            let other = t + d * 10.0_f64.powf(e);
            (t, if opposite { -other } else { other })
        });
    prop_oneof![3 => (direction(), direction()), 2 => near]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4 * ProptestConfig::default().cases, ..ProptestConfig::default() })]

    #[test]
    fn the_third_point_is_reached_at_one_half(points in three_points()) {
        let [a, b, c] = points;
        match Arc::from_three_points(a, b, c) {
            Ok(arc) => {
                prop_assert_eq!((arc.point(0.0), arc.point(1.0)), (a, c));
                // Beyond a half turn the chord may be short against the circle: rounding of the chord is turned and
                // stretched by the arc.
                let reach = (a.distance(b) + b.distance(c)) / a.distance(c);
                let allowed = 32.0 * f64::EPSILON * size(&points) * reach;
                let error = arc.point(0.5).distance(b);
                prop_assert!(error <= allowed, "missed by {error:e} > {allowed:e}");
            }
            Err(error) => {
                let named = match error {
                    Error::Point(PointError::CoincidentPoints { .. }) => a == b || b == c || a == c,
                    // On the line of the ends up to rounding of the points, and outside.
                    Error::Point(PointError::AtInfinity { .. }) => (b - a).dot(c - b) < 0.0,
                    // Next to it.
                    Error::Arc(ArcError::NearlyFullCircle { rest, limit }) => rest < limit && (b - a).dot(c - b) < 0.0,
                    // Chords a long way apart in length put nearly all the speed at one end.
                    Error::Number(NumberError::ParameterOutOfRange { .. }) => true,
                    _ => false,
                };
                prop_assert!(named, "{error}");
            }
        }
    }

    #[test]
    fn biarcs_are_g1_and_keep_their_data(
        a in point(),
        c in direction(),
        (t0, t1) in tangents(),
        mirrored: bool,
        s in scale(),
        rule in rule(),
    ) {
        // The mirror image across the chord is where K vanishes.
        let t1 = if mirrored { -t1.reflect(c) } else { t1 };
        let (p0, p1) = (Point3::ORIGIN + a.to_vec() * s, Point3::ORIGIN + (a.to_vec() + c) * s);
        match Biarc::new(p0, t0 * 3.0, p1, t1 * 0.25, rule) {
            Ok(biarc) => {
                let condition = joint_condition(&biarc);
                is_g1(&biarc.to_path(), condition)?;
                let [first, second] = biarc.arcs();
                prop_assert_eq!((first.start(), second.end()), (p0, p1));
                // Exact up to the straightening of arcs whose sagitta is rounding.
                prop_assert!(angle(first.start_tangent().unwrap(), t0) <= tangent_rounding(first));
                prop_assert!(angle(second.end_tangent().unwrap(), t1) <= tangent_rounding(second));
                prop_assert!(angle(first.end_tangent().unwrap(), biarc.joint_tangent()) <= condition * rounding(first, &[p0, p1]));
                let chord = p0.distance(p1);
                match biarc.rule() {
                    // Half a turn at most, up to rounding.
                    BiarcRule::EqualD => prop_assert!(
                        biarc.arcs().iter().all(|a| a.weight_ratio().w > -1e-7 - condition * rounding(a, &[p0, p1]))
                    ),
                    BiarcRule::EqualChord => {
                        let [l0, l1] = biarc.arcs().map(|a| a.chord().length());
                        prop_assert!((l0 - l1).abs() <= 64.0 * f64::EPSILON * (l0 + chord + s), "{l0:e} {l1:e}");
                    }
                    BiarcRule::Auto => prop_assert!(false, "auto must have decided"),
                }
            }
            Err(error) => prop_assert_eq!(error.reason(), "no-finite-biarc"),
        }
    }

    #[test]
    fn auto_fails_only_where_both_rules_fail(a in point(), c in direction(), (t0, t1) in tangents()) {
        let p1 = a + c;
        let made = [BiarcRule::EqualD, BiarcRule::EqualChord, BiarcRule::Auto].map(|rule| Biarc::new(a, t0, p1, t1, rule));
        prop_assert_eq!(made[2].is_ok(), made[0].is_ok() || made[1].is_ok());
        if let [Ok(legs), Ok(chords), Ok(auto)] = &made {
            prop_assert!(auto.length() <= (2.0 * chords.length()).max(legs.length().min(chords.length())) * (1.0 + 1e-12));
        }
    }

    #[test]
    fn data_of_one_circle_give_that_circle(center in point(), n in direction(), sweep in 0.01..3.1_f64, s in scale()) {
        let place = |p: Point3| Point3::ORIGIN + p.to_vec() * s;
        let arc = Arc::from_center(place(center), n, place(center + n.any_perpendicular()), sweep).unwrap();
        let (t0, t1) = (arc.start_tangent().unwrap(), arc.end_tangent().unwrap());
        for rule in [BiarcRule::EqualD, BiarcRule::EqualChord] {
            let biarc = Biarc::new(arc.start(), t0, arc.end(), t1, rule).unwrap();
            for part in biarc.arcs() {
                for t in [0.0, 0.3, 0.5, 0.8, 1.0] {
                    let off = arc.closest_point(part.point(t)).distance;
                    // The tangents carry the rounding of the chord they come from.
                    let allowed = 64.0 * f64::EPSILON * (2.0 * s + arc.radius().unwrap()) / sweep;
                    prop_assert!(off <= allowed, "{rule:?}: off by {off:e} > {allowed:e}");
                }
            }
        }
    }

    #[test]
    fn splines_pass_the_points_and_are_g1(
        points in prop::collection::vec(point(), 3..8),
        close in point().prop_flat_map(|p| (Just(p), neighbor(p))),
        s in scale(),
        closed: bool,
        rule in rule(),
    ) {
        let mut points = points;
        points.extend([close.0, close.1]);
        let points: Vec<Point3> = points.into_iter().map(|p| Point3::ORIGIN + p.to_vec() * s).collect();
        match ArcPath::spline(&points, &ArcSplineOptions { closed, rule, tangents: None }) {
            Ok(path) => {
                // Inside a span the joint's condition counts; between spans the tangents are the same numbers.
                for span in path.arcs().chunks(2) {
                    let (a, b) = (span[0], span[1]);
                    let (t0, t1) = (a.start_tangent().unwrap(), b.end_tangent().unwrap());
                    let biarc = Biarc::new(a.start(), t0, b.end(), t1, rule).unwrap();
                    is_g1(&ArcPath::new(span.to_vec(), false).unwrap(), 2.0 * joint_condition(&biarc))?;
                }
                let between: Vec<Arc> = path.arcs()[1..path.arcs().len() - 1].to_vec();
                for pair in between.chunks(2).filter(|pair| pair.len() == 2) {
                    is_g1(&ArcPath::new(pair.to_vec(), false).unwrap(), 1.0)?;
                }
                let spans = if closed { points.len() } else { points.len() - 1 };
                prop_assert_eq!(path.arcs().len(), 2 * spans);
                for k in 0..spans {
                    prop_assert_eq!(path.arcs()[2 * k].start(), points[k]);
                    prop_assert_eq!(path.arcs()[2 * k + 1].end(), points[(k + 1) % points.len()]);
                }
            }
            Err(error) => {
                let named = ["no-finite-biarc", "coincident-points", "tangent-undefined", "parameter-out-of-range"];
                prop_assert!(named.contains(&error.reason()), "{error}");
                prop_assert!(error.index().is_some() || error.reason() == "parameter-out-of-range", "{error}");
            }
        }
    }

    #[test]
    fn chains_are_g1_and_their_reflections_are_tangents(points in prop::collection::vec(point(), 2..8), t in direction(), s in scale()) {
        let points: Vec<Point3> = points.into_iter().map(|p| Point3::ORIGIN + p.to_vec() * s).collect();
        match ArcPath::chain_from_tangent(&points, false, t) {
            Ok(path) => {
                is_g1(&path, 1.0)?;
                prop_assert_eq!(path.arcs().len(), points.len() - 1);
                prop_assert!(angle(path.arcs()[0].start_tangent().unwrap(), t) <= tangent_rounding(&path.arcs()[0]));
            }
            Err(error) => prop_assert_eq!(error.reason(), "tangent-opposes-chord"),
        }
    }
}

#[test]
fn a_joint_beside_the_origin_is_rounded_as_the_far_end_is() {
    // Nearly mirrored tangents: the joint is 1.4e-8 from the start, the difference of two points at a half.
    let c = Vec3::new(-0.016482843767568003, 0.7358335748563813, -0.6769617906317994);
    let t0 = Vec3::new(-0.9635866549663425, -0.1948548996884704, -0.18311833998311255);
    let t1 = Vec3::new(-0.963586654225668, -0.1948548996884704, -0.18311833998311255);
    let t1 = -t1.reflect(c);
    let biarc = Biarc::new(Point3::ORIGIN, t0, Point3::ORIGIN + c, t1, BiarcRule::EqualD).unwrap();
    assert!(biarc.arcs()[0].chord().length() < 2e-8);
    is_g1(&biarc.to_path(), joint_condition(&biarc)).unwrap();
}
