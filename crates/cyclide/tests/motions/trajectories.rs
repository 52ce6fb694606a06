//! Paths of points: the exact rational form is the path.

use crate::data::{motions, timed};
use cyclide::{
    Point3, Quat, Vec3,
    curve::ParamCurve,
    motion::{Motion, Pose, RationalMotion, TimedPose},
};
use proptest::prelude::*;

proptest! {
    #[test]
    fn the_rational_form_is_the_path(poses in timed(5), x in prop::array::uniform3(-2.0..2.0_f64)) {
        let x = Point3::from(x);
        for motion in motions(&poses) {
            let Motion::Rational(motion) = motion else { continue };
            let path = motion.trajectory(x).unwrap();
            prop_assert!(path.degree() <= 2 * motion.degree());
            prop_assert!(path.weights().iter().all(|w| *w > 0.0));
            let times = motion.times();
            let (first, duration) = (times[0], times[times.len() - 1] - times[0]);
            for k in 0..=40 {
                let part = f64::from(k) / 40.0;
                let jet = motion.jet(first + duration * part, x);
                // Control points far out cost digits: a ten thousandth of what a step of 1e-8 of the duration would move.
                let allowed = 1e-10 * (1.0 + jet.point.speed());
                prop_assert!(path.point_at_knot(part).distance(jet.point.point) < allowed, "{part}");
            }
        }
    }

    #[test]
    fn smooth_motions_have_smooth_knots(poses in timed(5)) {
        let Ok(motion) = RationalMotion::spline(&poses) else { return Ok(()) };
        let path = motion.trajectory(Point3::new(0.2, 0.1, -0.4)).unwrap();
        let inner = &path.knot_multiplicities()[1..path.span_count()];
        prop_assert!(inner.iter().all(|(_, m)| *m == path.degree() - 1), "{inner:?}");
    }
}

#[test]
fn a_path_through_the_origin_has_joints() {
    // At the joint the body's origin is at the origin of the world, up to rounding.
    let at = |time: f64, x: [f64; 3], w: f64| TimedPose {
        time,
        pose: Pose::new([w, 0.1, 0.7, 0.3].into(), Vec3::from(x)).unwrap(),
    };
    let poses = [at(0.0, [-100.0, 3.0, 7.0], 1.0), at(1.0, [0.0; 3], 0.8), at(2.5, [120.0, -3.0, 1.0], 0.1)];
    let path = RationalMotion::spline(&poses).unwrap().trajectory(Point3::ORIGIN).unwrap();
    assert!(path.point_at_knot(0.4).to_vec().length() < 1e-12);
}

#[test]
fn weights_next_to_zero_are_halved_away() {
    // A whole turn in one span: a coefficient of |p|² vanishes but for rounding, and its control point was 1e17 away.
    let at = |degrees: f64, x: f64, y: f64| TimedPose {
        time: x,
        pose: Pose::new(Quat::from_axis_angle(Vec3::Z, degrees.to_radians()), Vec3::new(x, y, 0.0)).unwrap(),
    };
    let motion = RationalMotion::conic(&[at(-180.0, 0.0, 0.0), at(0.0, 10.0, 2.0), at(180.0, 20.0, 0.0)]).unwrap();
    let point = Point3::new(5.0, 0.0, 0.0);
    let path = motion.trajectory(point).unwrap();
    let far = path.control_points().iter().map(|p| p.to_vec().length()).fold(0.0, f64::max);
    assert!(far < 100.0, "{far:e}");
    for k in 0..=40 {
        let part = f64::from(k) / 40.0;
        assert!(path.point_at_knot(part).distance(motion.pose(20.0 * part).apply(point)) < 1e-13 * 25.0, "{part}");
    }
}

/// A motion of a body of size 1 a million units from the origin: what its paths lose is the rounding of their control points.
#[test]
fn paths_far_from_the_origin_are_those_near_it() {
    let at = |time: f64, place: Vec3, q: [f64; 4], x: [f64; 3]| TimedPose {
        time,
        pose: Pose::new(q.into(), place + Vec3::from(x)).unwrap(),
    };
    // Nothing is rounded when the places are added.
    let poses = |place: Vec3| {
        [
            at(0.0, place, [1.0, 0.0, 0.1, -0.9], [0.0, 0.5, 0.25]),
            at(1.0, place, [0.1, 0.9, 0.4, 0.5], [1.0, 0.75, -0.5]),
            at(1.5, place, [-0.3, 0.2, 0.9, -0.6], [0.5, -1.0, 0.25]),
            at(3.0, place, [0.8, -0.7, 0.1, 0.4], [-0.5, 0.75, 1.0]),
        ]
    };
    let point = Point3::new(0.25, -0.5, 0.75);
    for far in [1e3_f64, 1e6, 1e9] {
        let place = Vec3::new(1.0, -0.75, 0.5) * 2_f64.powi(far.log2().round() as i32);
        let path = |poses: &[TimedPose]| RationalMotion::spline(poses).unwrap().trajectory(point).unwrap();
        let (near, far) = (path(&poses(Vec3::ZERO)), path(&poses(place)));
        assert_eq!(near.knots(), far.knots());
        // One rounding of a sum of the size of the place.
        let limit = 0.75 * f64::EPSILON * place.max_abs();
        for (a, b) in near.control_points().iter().zip(far.control_points()) {
            let gap = (*b - (*a + place)).max_abs();
            assert!(gap <= limit, "{gap:e} {limit:e}");
        }
    }
}

/// The path of a motion that rests is that of its ways: spans in which the point stands still have no part in it, also those in which the body turns
/// about it.
#[test]
fn paths_have_no_rests() {
    let at = |time: f64, x: f64, y: f64, degrees: f64| TimedPose {
        time,
        pose: Pose::new(Quat::from_axis_angle(Vec3::Z, degrees.to_radians()), Vec3::new(x, y, 0.0)).unwrap(),
    };
    let straight = [at(0.0, 0.0, 0.0, 0.0), at(1.0, 10.0, 0.0, 0.0), at(2.0, 10.0, 0.0, 0.0), at(4.0, 20.0, 0.0, 0.0)];
    let tip = Point3::new(0.0, 0.0, 1.0);
    let path = RationalMotion::spline(&straight).unwrap().trajectory(tip).unwrap();
    assert_eq!(path.span_count(), 2);
    // A second there and two on: the knot is at a third.
    assert!((path.knot_multiplicities()[1].0 - 1.0 / 3.0).abs() < 1e-15);
    for k in 0..=60 {
        let s = f64::from(k) / 60.0;
        let curvature = path.jet(s).curvature();
        assert!(curvature.is_none_or(|curvature| curvature < 1e-9), "{s}: {curvature:?}");
        assert!((path.point(s) - tip).cross(Vec3::X).length() < 1e-12);
    }
    // In front, in the end, and a turn about the point.
    let all = [
        at(-3.0, 0.0, 0.0, 0.0),
        straight[0],
        straight[1],
        straight[2],
        at(3.0, 10.0, 0.0, 60.0),
        at(3.5, 10.0, 0.0, 60.0),
        at(4.5, 10.0, 8.0, 60.0),
        at(5.0, 10.0, 8.0, 60.0),
    ];
    let motion = RationalMotion::spline(&all).unwrap();
    assert_eq!(motion.trajectory(Point3::ORIGIN).unwrap().span_count(), 2);
    assert_eq!(motion.trajectory(Point3::new(1.0, 0.0, 0.0)).unwrap().span_count(), 3);
    // One that rests all along is a point, as before.
    let rest = RationalMotion::spline(&[straight[1], straight[2]]).unwrap().trajectory(Point3::ORIGIN).unwrap();
    assert!(rest.control_points().iter().all(|p| p.distance(Point3::new(10.0, 0.0, 0.0)) < 1e-12));
}
