//! Paths and surfaces of bodies that come to a stand are measured by their limits there, not by the rounding of a speed that is zero.

use cyclide::{
    Point3, Quat, Vec3,
    construct::SweptSurface,
    curve::{Arc, ParamCurve as _, extreme_curvature, fairness, joints, tight_places},
    model::CurveObject,
    motion::{Pose, RationalMotion, TimedPose},
    topology::surface_joints,
};
use std::f64::consts::PI;

fn pose(time: f64, place: Vec3, turn: Quat) -> TimedPose {
    TimedPose { time, pose: Pose::new(turn, place).unwrap() }
}

/// Poses at one another's end, a second apart.
fn spline(places: &[(Vec3, Quat)]) -> RationalMotion {
    let poses: Vec<TimedPose> = places.iter().zip(0..).map(|((p, q), k)| pose(f64::from(k), *p, *q)).collect();
    RationalMotion::spline(&poses).unwrap()
}

/// A straight path with a rest, of a body whose turn has no short numbers, here and far from the origin.
#[test]
fn a_straight_path_that_rests_is_straight() {
    let turn = Quat::new(0.8, 0.0, 0.0, 0.6);
    for far in [0.0, 1e3, 1e6] {
        let places = [0.0, 5.0, 5.0, 9.0].map(|x| (Vec3::new(far + x, -far, 0.3 * far), turn));
        let path = spline(&places).trajectory(Point3::ORIGIN).unwrap();
        assert_eq!(path.piece_count(), 2);
        let joint = joints(&path)[0];
        // Roundings of the coordinates, over steps a thousand times as short as the path, squared in curvatures.
        let rounding = 1e-13 * (1.0 + far);
        assert!(joint.angle < rounding && joint.curvature_jump < 1e4 * rounding, "{far} {joint:?}");
        assert!(tight_places(&path, 1.0).unwrap().is_empty(), "{far}");
        assert_eq!(cyclide::curve::cusps(&path), []);
        let measured = fairness(&path);
        assert_eq!((measured.corners, measured.cusps, measured.jumps), (0, 0, 0), "{far}");
        if far < 1e5 {
            assert!(extreme_curvature(&path).max < 1e-3, "{far}");
            assert!(measured.variation.is_some_and(|variation| variation < 1e-9), "{far} {measured:?}");
        }
        for side in [path.piece_jet(0, 1.0), path.piece_jet(1, 0.0)] {
            assert!(side.tangent().is_none(), "{far}");
        }
        // Arcs go on through the stand.
        assert!(CurveObject::from(path).spine(Some(0.01)).is_ok());
    }
}

/// About an axis, with a rest: the curvature is that of the circle, also where the point stands.
#[test]
fn a_turn_that_rests_bends_as_its_circle() {
    let turn = |angle: f64| (Vec3::ZERO, Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), angle));
    let path = spline(&[0.0, 0.9, 0.9, 1.6].map(turn)).trajectory(Point3::new(-1.6, 0.0, 1.2)).unwrap();
    let joint = joints(&path)[0];
    assert!(joint.angle < 1e-12 && joint.curvature_jump < 1e-6, "{joint:?}");
    assert!((extreme_curvature(&path).max - 0.5).abs() < 1e-6);
    assert_eq!(tight_places(&path, 1.9).unwrap(), []);
    let measured = fairness(&path);
    assert_eq!((measured.corners, measured.cusps, measured.jumps, measured.extrema), (0, 0, 0, 0), "{measured:?}");
    assert!(measured.variation.is_some_and(|variation| variation < 1e-6), "{measured:?}");
}

/// There and back: the path turns back, and the surface is folded along the line at which the sweep stands.
#[test]
fn a_sweep_there_and_back_is_folded() {
    let tilted = Quat::from_axis_angle(Vec3::new(1.0, 2.0, -1.0), 0.7);
    let segment = || vec![Arc::segment(Point3::ORIGIN, Point3::new(0.0, 0.0, 3.0)).unwrap().into()];
    let circle = || {
        let corner = |k: f64| Point3::new(0.0, (0.5 * PI * k).cos(), (0.5 * PI * k).sin());
        let quarter = |k: f64| Arc::from_three_points(corner(k), corner(k + 0.5), corner(k + 1.0)).unwrap().into();
        vec![quarter(0.0), quarter(1.0), quarter(2.0), quarter(3.0)]
    };
    for turn in [Quat::ONE, tilted] {
        let motion = spline(&[0.0, 10.0, 0.0].map(|x| (turn.rotate(Vec3::X * x), turn)));
        for (profile, closed, folds) in [(segment(), false, 1), (circle(), true, 8)] {
            let count = profile.len();
            let swept = SweptSurface::new(&profile, closed, &motion).unwrap();
            let joints = surface_joints(&swept.body().outer);
            let folded = joints.iter().filter(|joint| (joint.angle - PI).abs() < 1e-6).count();
            let smooth = joints.iter().filter(|joint| joint.angle < 1e-6).count();
            // Each edge at the far end is a fold; those at the near end where both ends of the sweep are one.
            assert_eq!(folded + smooth, joints.len(), "{joints:?}");
            assert!(folded == count || folded == folds, "{folded} of {joints:?}");
        }
    }
}

/// A rest between two ways in one line is no crease.
#[test]
fn a_sweep_that_rests_on_its_way_is_smooth() {
    let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, -1.0), 0.7);
    let motion = spline(&[0.0, 4.0, 4.0, 10.0].map(|x| (turn.rotate(Vec3::X * x), turn)));
    let segment = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 0.0, 3.0)).unwrap();
    let swept = SweptSurface::new(&[segment.into()], false, &motion).unwrap();
    let outer = &swept.body().outer;
    let found = surface_joints(outer);
    assert!(found.len() == 1 && found[0].angle < 1e-9, "{found:?}");
    // It is measured at normals, not at the lack of any.
    for face in outer.faces() {
        for (s, t) in [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (0.0, 0.5), (1.0, 0.5)] {
            assert!(face.outer_normal(s, t).is_some(), "{s} {t}");
        }
    }
}
