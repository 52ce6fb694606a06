//! Swept surfaces: every point is that of the moved curve; closed ones are watertight.

use crate::data::timed;
use cyclide::{
    Point3, Quat, Vec3, Warning,
    construct::SweptSurface,
    curve::Arc,
    motion::{Pose, RationalMotion, TimedPose},
    surface::ParamSurface,
    topology::EdgeCurve,
    warning::NetWarning,
};
use proptest::prelude::*;

fn arc() -> EdgeCurve {
    let [a, b, c] = [[0.5, 0.0, 0.0], [0.0, 0.15, 0.05], [-0.5, 0.0, 0.0]].map(Point3::from);
    Arc::from_three_points(a, b, c).unwrap().into()
}

fn square() -> Vec<EdgeCurve> {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]].map(Point3::from);
    (0..4).map(|k| Arc::segment(corners[k], corners[(k + 1) % 4]).unwrap().into()).collect()
}

proptest! {
    #[test]
    fn faces_are_the_moved_curve(poses in timed(2..5)) {
        let Ok(motion) = RationalMotion::spline(&poses) else { return Ok(()) };
        let Ok(swept) = SweptSurface::new(&[arc()], false, &motion) else { return Ok(()) };
        let shell = &swept.body().outer;
        // An arc of less than a third of a turn is one piece, so faces are parts of spans in order; the joints are their corners.
        let mut start = motion.times()[0];
        for face in shell.faces() {
            let surface = &face.surface;
            let along = |t: f64| surface.point(0.0, t);
            let end = motion.times().iter().chain(&halvings(&motion)).copied().filter(|u| *u > start)
                .filter(|u| motion.pose(*u).apply(arc().start()).distance(along(1.0)) < 1e-9)
                .fold(f64::INFINITY, f64::min);
            prop_assert!(end.is_finite());
            for (s, t) in [(0.0, 0.3), (0.25, 0.5), (0.7, 0.9), (1.0, 0.1)] {
                let time = start + (end - start) * t;
                let expected = motion.pose(time).apply(arc().point(s));
                let speed = motion.jet(time, arc().point(s)).point.speed();
                // The arc has equal weights at its ends, as the profile of a face.
                prop_assert!(expected.distance(surface.point(s, t)) < 1e-9 * (1.0 + speed), "{s} {t}");
            }
            start = end;
        }
    }
}

/// Times at which spans are cut for positive weights.
fn halvings(motion: &RationalMotion) -> Vec<f64> {
    motion.times().windows(2).flat_map(|w| (1..64).map(move |k| w[0] + (w[1] - w[0]) * f64::from(k) / 64.0)).collect()
}

fn turned(time: f64, degrees: f64, x: [f64; 3]) -> TimedPose {
    TimedPose { time, pose: Pose::new(Quat::from_axis_angle(Vec3::Z, degrees.to_radians()), Vec3::from(x)).unwrap() }
}

#[test]
fn a_segment_that_turns_is_a_disk() {
    let motion =
        RationalMotion::conic(&[turned(0.0, 0.0, [0.0; 3]), turned(0.5, 80.0, [0.0; 3]), turned(1.0, 160.0, [0.0; 3])]);
    let blade = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0)).unwrap();
    let swept = SweptSurface::new(&[blade.into()], false, &motion.unwrap()).unwrap();
    let expected = 0.5 * 9.0 * 160_f64.to_radians();
    assert!((swept.body().outer.area() - expected).abs() < 1e-9, "{}", swept.body().outer.area());
    assert!(swept.warnings().is_empty());
}

#[test]
fn what_comes_back_closes() {
    // A square goes round, and lies as it did in the end.
    let places = [[5.0, 0.0, 0.0], [0.0, 5.0, 1.0], [-5.0, 0.0, 0.0], [0.0, -5.0, 1.0], [5.0, 0.0, 0.0]];
    let poses: Vec<TimedPose> = places
        .iter()
        .enumerate()
        .map(|(k, place)| {
            let upright = Quat::from_axis_angle(Vec3::X, std::f64::consts::FRAC_PI_2);
            let turn = Quat::from_axis_angle(Vec3::Z, k as f64 * std::f64::consts::FRAC_PI_2);
            TimedPose { time: k as f64, pose: Pose::new(turn * upright, Vec3::from(*place)).unwrap() }
        })
        .collect();
    let motion = RationalMotion::spline(&poses).unwrap();
    let swept = SweptSurface::new(&square(), true, &motion).unwrap();
    let shell = &swept.body().outer;
    assert!(shell.is_closed() && shell.faces().len() == 16);
    // A ring with the section 2 and a way of about 2π·5, and more for the waves.
    assert!((60.0..80.0).contains(&shell.volume()), "{}", shell.volume());
}

#[test]
fn what_moves_along_itself_is_refused_or_said() {
    let blade = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0)).unwrap();
    let slide = RationalMotion::spline(&[turned(0.0, 0.0, [0.0; 3]), turned(1.0, 0.0, [2.0, 0.0, 0.0])]).unwrap();
    assert_eq!(SweptSurface::new(&[blade.into()], false, &slide).unwrap_err().reason(), "not-a-shell");
    // A rod that turns to the left and goes to the right runs along itself where both cancel.
    let poses = [turned(0.0, 0.0, [0.0; 3]), turned(1.0, 120.0, [0.0, -6.0, 0.0])];
    let swept = SweptSurface::new(&[blade.into()], false, &RationalMotion::spline(&poses).unwrap()).unwrap();
    assert_eq!(swept.warnings().iter().map(|w| w.reason()).collect::<Vec<_>>(), ["swept-surface-folds"]);
}

/// What turns back exactly at a pose folds at the border of its faces, where none of them has a place that tells.
#[test]
fn what_turns_back_at_a_pose_is_said() {
    let warned = |motion: &[TimedPose], profile: &[EdgeCurve], closed: bool| {
        let swept = SweptSurface::new(profile, closed, &RationalMotion::spline(motion).unwrap()).unwrap();
        swept.warnings().to_vec()
    };
    let up = [turned(0.0, 0.0, [0.0; 3]), turned(1.0, 0.0, [0.0, 0.0, 5.0]), turned(2.0, 0.0, [0.0; 3])];
    // There and back: the tube is closed and has no volume.
    let Some(Warning::Net(NetWarning::SweptSurfaceFolds { count, face, borders })) =
        warned(&up, &square(), true).first().cloned()
    else {
        panic!()
    };
    assert_eq!((count, face, borders), (8, 0, 8));
    // Up, and half of the way back; in uneven times it turns back between them.
    let part = |time: f64| [up[0], up[1], turned(time, 0.0, [0.0, 0.0, 2.0])];
    for time in [1.5, 2.0, 7.0] {
        assert_eq!(warned(&part(time), &[arc()], false).len(), 1, "{time}");
    }
    // On, with a stop and without, and round a corner of the profile: nothing folds.
    let on = [up[0], up[1], turned(2.0, 0.0, [0.0, 0.0, 9.0]), turned(3.0, 40.0, [0.0, 0.0, 20.0])];
    for profile in [&square()[..], &square()[..2]] {
        assert!(warned(&on, profile, profile.len() == 4).is_empty());
    }
    let rest = [up[0], turned(1.0, 0.0, [0.0; 3])];
    let error = SweptSurface::new(&square(), true, &RationalMotion::spline(&rest).unwrap()).unwrap_err();
    assert_eq!(error.reason(), "motion-at-rest");
}

/// Far from the origin faces are those near it, moved: to a few roundings of the coordinates, whatever the weights.
#[test]
fn faces_far_from_the_origin_are_those_near_it() {
    let place = Vec3::new(1.0, -0.75, 0.5) * 2_f64.powi(20);
    let swept = |by: Vec3| {
        let at = |time: f64, degrees: f64, x: [f64; 3]| turned(time, degrees, (Vec3::from(x) + by).to_array());
        // Nothing is rounded when the place is added.
        let poses = [at(0.0, 0.0, [0.5, 0.0, 0.0]), at(1.0, 170.0, [0.0, 1.25, 2.0]), at(1.5, 340.0, [1.0, 0.75, 3.0])];
        SweptSurface::new(&[arc()], false, &RationalMotion::spline(&poses).unwrap()).unwrap()
    };
    let (near, far) = (swept(Vec3::ZERO), swept(place));
    assert_eq!(near.body().outer.faces().len(), far.body().outer.faces().len());
    for (a, b) in near.body().outer.faces().iter().zip(far.body().outer.faces()) {
        for (s, t) in [(0.0, 0.3), (0.25, 0.5), (0.7, 0.9), (1.0, 0.1), (0.4, 1.0)] {
            let gap = (b.surface.point(s, t) - (a.surface.point(s, t) + place)).max_abs();
            assert!(gap <= 4.0 * f64::EPSILON * place.max_abs(), "{gap:e} at {s} {t}");
        }
    }
}

/// What goes out and back the same way encloses nothing: it is open, also where its curve is closed, and its ends are apart.
#[test]
fn what_goes_back_the_way_it_came_stays_open() {
    let out = [turned(0.0, 0.0, [0.0; 3]), turned(1.0, 0.0, [0.0, 0.0, 5.0]), turned(2.0, 0.0, [0.0; 3])];
    let bent = [out[0], turned(1.0, 10.0, [1.0, 0.0, 5.0]), out[2]];
    // From the middle of the way, so that only inner poses turn back.
    let both =
        [out[0], turned(1.0, 0.0, [0.0, 0.0, 5.0]), turned(2.0, 0.0, [0.0, 0.0, -5.0]), turned(3.0, 0.0, [0.0; 3])];
    for (poses, closed) in [(&out[..], true), (&out, false), (&bent, true), (&bent, false), (&both, true)] {
        let profile = if closed { square() } else { vec![arc()] };
        let motion = RationalMotion::spline(poses).unwrap();
        let swept = SweptSurface::new(&profile, closed, &motion).unwrap();
        let shell = &swept.body().outer;
        assert!(!shell.is_closed() && swept.warnings()[0].reason() == "swept-surface-folds");
        // Faces lie on each other in pairs, so the area is that of the way out twice.
        let half = SweptSurface::new(&profile, closed, &RationalMotion::spline(&poses[..2]).unwrap());
        if poses.len() == 3 {
            let single = half.unwrap().body().outer.area();
            // The way out of the three poses starts twice as fast and ends at rest: the same surface for straight ways.
            let off = (shell.area() / (2.0 * single) - 1.0).abs();
            assert!(off < if poses == out { 1e-9 } else { 0.02 }, "{off}");
        }
    }
}

/// Rests are no part of the surface: it is that of the ways before and after, of as many faces, to the bit but for where they meet.
#[test]
fn rests_have_no_faces() {
    let ways = [turned(0.0, 0.0, [0.0; 3]), turned(1.0, 30.0, [10.0, 0.0, 2.0]), turned(2.0, 70.0, [18.0, 8.0, 4.0])];
    let upright = |pose: TimedPose| TimedPose {
        pose: Pose::new(
            pose.pose.rotation() * Quat::from_axis_angle(Vec3::Y, std::f64::consts::FRAC_PI_2),
            pose.pose.translation(),
        )
        .unwrap(),
        ..pose
    };
    let [a, b, c] = ways.map(upright);
    let later = |pose: TimedPose, by: f64| TimedPose { time: pose.time + by, ..pose };
    let faces =
        |poses: &[TimedPose]| SweptSurface::new(&square(), true, &RationalMotion::spline(poses).unwrap()).unwrap();
    let rests = faces(&[a, b, later(b, 0.5), later(c, 0.5)]);
    let shell = &rests.body().outer;
    assert!(rests.warnings().is_empty(), "{:?}", rests.warnings());
    assert_eq!(shell.faces().len(), 8);
    assert!(shell.edges().iter().all(|edge| edge.curve.point(0.5).distance(edge.curve.start()) > 0.1));
    // At both ends, and twice: the same faces.
    let everywhere = faces(&[later(a, -1.0), a, b, later(b, 0.25), later(b, 0.5), later(c, 0.5), later(c, 9.0)]);
    assert_eq!(everywhere.body().outer.faces().len(), 8);
    let straight = |x: f64, time: f64| turned(time, 0.0, [0.0, 0.0, x]);
    let tube = faces(&[straight(0.0, 0.0), straight(10.0, 1.0), straight(10.0, 2.0), straight(20.0, 3.0)]);
    assert!(tube.warnings().is_empty() && (tube.body().outer.area() - 4.0 * 2_f64.sqrt() * 20.0).abs() < 1e-9);
}
