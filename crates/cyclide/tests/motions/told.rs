//! What is refused or told of motions that would harm a machine: turns on the spot, rests, reversals, half turns.

use cyclide::{
    Error, Point3, Quat, Vec3, Warning,
    error::MotionError,
    motion::{Motion, MovingBody, Pose, RationalMotion, ScrewMotion, SpeedKind, TimeLaw, TimedPose, Timing},
    warning::{MotionWarning, SwingPart},
};

const BY_WAY: [TimeLaw; 2] = [TimeLaw::ConstantSpeed, TimeLaw::Eased];

fn at(time: f64, x: f64, angle: f64) -> TimedPose {
    TimedPose { time, pose: Pose::new(Quat::from_axis_angle(Vec3::Z, angle), Vec3::X * x).unwrap() }
}

fn both(poses: &[TimedPose]) -> [Motion; 2] {
    [RationalMotion::spline(poses).unwrap().into(), ScrewMotion::new(poses).unwrap().into()]
}

fn reasons(body: &MovingBody) -> Vec<&'static str> {
    body.warnings().iter().map(|warning| warning.reason()).collect()
}

/// A turn on the spot takes no time under a law that goes by the way: it is refused, with the span and the turn, unless an arm counts it.
#[test]
fn turns_on_the_spot_are_refused() {
    let poses = [
        at(0.0, 0.0, 0.0),
        at(1.0, 3.0, 0.0),
        at(2.0, 3.0, 0.0),
        at(3.0, 3.0, 1.5),
        at(4.0, 3.0, 1.5),
        at(5.0, 4.0, 1.5),
    ];
    for motion in both(&poses) {
        for law in BY_WAY {
            let error = Timing::new(&motion, law, Point3::ORIGIN, 0.0).unwrap_err();
            assert_eq!((error.reason(), error.index()), ("span-without-way", Some(2)));
            let Error::Motion(MotionError::SpanWithoutWay { turn, length, limit, .. }) = error else {
                panic!("by its reason")
            };
            assert!((turn - 1.5).abs() < 1e-12 && length <= limit && limit < 1e-11, "{turn} {length}");
            assert!(
                error.to_string().contains("rotates by 86 degrees in place") && error.to_string().contains("an `arm`")
            );
            // By the times it is what was asked for, and with an arm the turn takes its part: 0.15 of 4.15.
            let body = MovingBody::new(motion.clone()).with_tool(Point3::ORIGIN, 0.1).unwrap();
            assert!(reasons(&body).is_empty());
            let joints = body.with_law(law, 2.0).unwrap().schedule().unwrap().timing().joints();
            assert!(joints[3] - joints[2] > 0.0);
            if law == TimeLaw::ConstantSpeed {
                assert!((joints[3] - joints[2] - 0.15 / 4.15).abs() < 1e-12, "{joints:?}");
            }
        }
    }
}

/// A rest takes no time under such a law either, and that is told.
#[test]
fn rests_are_told() {
    let poses = [at(0.0, 0.0, 0.0), at(1.0, 3.0, 0.0), at(2.0, 3.0, 0.0), at(3.0, 4.0, 0.0)];
    for motion in both(&poses) {
        let body = MovingBody::new(motion);
        assert!(reasons(&body).is_empty());
        for law in BY_WAY {
            let body = body.clone().with_law(law, 2.0).unwrap();
            assert_eq!(body.warnings(), [Warning::Motion(MotionWarning::RestsPassedOver { span: 1, count: 1 })]);
            let joints = body.schedule().unwrap().timing().joints();
            assert!(joints[1] > 0.5 && joints[1].to_bits() == joints[2].to_bits(), "{joints:?}");
            assert!((body.schedule().unwrap().way() - 4.0).abs() < 1e-13);
        }
    }
}

/// A turn with next to no way is warned of with its time, whatever the motion; by the times, or with an arm, there is nothing to tell.
#[test]
fn turns_nearly_in_place_are_told() {
    let places = [[0.0, 0.0], [40.0, 0.0], [40.0, 0.0], [40.01, 1.5], [40.01, 1.5], [80.0, 1.5]];
    let poses: Vec<TimedPose> = (0..6).zip(places).map(|(k, [x, angle])| at(f64::from(k), x, angle)).collect();
    for motion in both(&poses) {
        for law in BY_WAY {
            let body = MovingBody::new(motion.clone()).with_law(law, 3.0).unwrap();
            let warnings = body.warnings();
            let of_turn = warnings.iter().find_map(|warning| match *warning {
                Warning::Motion(MotionWarning::TurnsNearlyInPlace { span, turn, seconds, ratio, .. }) => {
                    Some((span, turn, seconds, ratio))
                }
                _ => None,
            });
            let (span, turn, seconds, ratio) = of_turn.unwrap_or_else(|| panic!("{warnings:?}"));
            let joints = body.schedule().unwrap().timing().joints();
            assert!(span == 2 && (seconds - 3.0 * (joints[3] - joints[2])).abs() < 1e-12 && seconds < 0.1);
            // All of the turn of the motion.
            assert!((turn - 1.5).abs() < 1e-9 && (ratio - 3.0 / seconds).abs() < 1e-6 * ratio, "{turn} {ratio}");
            let steady = body.with_tool(Point3::ORIGIN, 30.0).unwrap();
            assert_eq!(reasons(&steady), ["rests-passed-over"]);
        }
        assert_eq!(reasons(&MovingBody::new(motion)), [""; 0]);
    }
}

/// At constant speed over x = 0, 1, 10, 11 a spline runs beyond the poses and back: where it turns, the velocity turns over in no time.
#[test]
fn reversals_within_a_span_are_told() {
    let poses = [at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(2.0, 10.0, 0.0), at(3.0, 11.0, 0.0)];
    let motion = Motion::from(RationalMotion::spline(&poses).unwrap());
    let body = MovingBody::new(motion.clone());
    assert!(body.schedule().unwrap().reversals().is_empty(), "by its times it comes to a stand");
    for law in BY_WAY {
        let body = body.clone().with_law(law, 3.0).unwrap();
        let schedule = body.schedule().unwrap();
        let found = schedule.reversals();
        assert_eq!(
            found.iter().map(|reversal| (reversal.span, reversal.inside)).collect::<Vec<_>>(),
            [(0, true), (2, true)]
        );
        for reversal in &found {
            // The velocities by differences of poses on both sides, some of the time away from the place.
            let part = reversal.time / 3.0;
            let x = |step: f64| schedule.pose(part + step).translation().x;
            let h = 1e-5;
            let [before, after] = [(x(-h) - x(-3.0 * h)) / (6.0 * h), (x(3.0 * h) - x(h)) / (6.0 * h)];
            assert!(before * after < 0.0, "{before} {after}");
            // The eased speed changes by 1e-4 of itself within these steps.
            assert!((reversal.velocity_jump / (after - before).abs() - 1.0).abs() < 1e-3, "{reversal:?}");
        }
        let extremes = schedule.extremes();
        assert!(extremes.acceleration.is_infinite() && extremes.jerk.is_infinite());
        assert!((extremes.acceleration_at.time - found[0].time).abs() < 1e-12);
        let told = body.warnings().into_iter().find(|warning| warning.reason() == "motion-reverses").unwrap();
        assert!(matches!(told, Warning::Motion(MotionWarning::Reverses { span: 0, count: 2, .. })), "{told:?}");
    }
    // One way on, with a stand of higher order in between, is none; nor is a turn that is only tight.
    let cube = |t: f64| at(t, (t - 2.0).powi(3), 0.0);
    let on = RationalMotion::quartic(&[0.0, 1.0, 2.0, 3.0, 4.0].map(cube)).unwrap();
    let on = MovingBody::new(on.into()).with_law(TimeLaw::ConstantSpeed, 4.0).unwrap();
    assert!(on.schedule().unwrap().reversals().is_empty());
    let beside = |t: f64, y: f64| TimedPose {
        time: t,
        pose: Pose::new(Quat::ONE, Vec3::new((t - 1.0).powi(2), y, 0.0)).unwrap(),
    };
    let tight = RationalMotion::conic(&[beside(0.0, 0.0), beside(1.0, 0.1), beside(2.0, 0.2)]).unwrap();
    let tight = MovingBody::new(tight.into()).with_law(TimeLaw::ConstantSpeed, 4.0).unwrap();
    assert!(
        tight.schedule().unwrap().reversals().is_empty()
            && tight.schedule().unwrap().extremes().acceleration.is_finite()
    );
}

/// A way that comes back at a pose turns over there.
#[test]
fn reversals_at_poses_are_told() {
    let poses = [at(0.0, 0.0, 0.0), at(1.0, 30.0, 0.0), at(2.0, 30.0, 0.0), at(3.0, 0.0, 0.0)];
    let motion = Motion::from(RationalMotion::spline(&poses).unwrap());
    let body = MovingBody::new(motion).with_law(TimeLaw::ConstantSpeed, 2.0).unwrap();
    let found = body.schedule().unwrap().reversals();
    assert!(found.len() == 1 && !found[0].inside && found[0].span == 2, "{found:?}");
    assert!((found[0].time - 1.0).abs() < 1e-9 && (found[0].velocity_jump - 60.0).abs() < 1e-6, "{found:?}");
}

/// Half a turn to the next pose is told where the sign of a rotation decides which way the body goes.
#[test]
fn half_turns_are_told() {
    let half = std::f64::consts::PI;
    let first = |motion: &Motion| {
        motion.warnings().into_iter().find_map(|warning| match warning {
            Warning::Motion(MotionWarning::HalfTurn { pose, count, off, .. }) => Some((pose, count, off)),
            // A spline runs on a half circle then.
            Warning::Motion(MotionWarning::LeavesChords { .. }) => None,
            other => panic!("{other:?}"),
        })
    };
    // The same poses go round both ways, by the sign alone.
    let other = TimedPose {
        pose: Pose::new(-at(1.0, 4.0, half).pose.rotation(), Vec3::X * 4.0).unwrap(),
        ..at(1.0, 4.0, half)
    };
    let [one, two] = [at(1.0, 4.0, half), other].map(|pose| both(&[at(0.0, 0.0, 0.0), pose]));
    for (one, two) in one.iter().zip(&two) {
        let y = |motion: &Motion| motion.pose(0.5).rotation().rotate(Vec3::X).y;
        assert!(y(one) > 0.9 && y(two) < -0.9);
        assert!(first(one).is_some_and(|(pose, count, off)| pose == 1 && count == 1 && off < 1e-15));
    }
    for (missing, told) in [(1e-6, true), (1e-5, false)] {
        let poses = [at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.3), at(2.0, 2.0, 0.3 + half - missing), at(3.0, 3.0, 0.3)];
        for motion in both(&poses) {
            let found = first(&motion);
            assert_eq!(found.map(|(pose, count, _)| (pose, count)), told.then_some((2, 2)));
            assert!(found.is_none_or(|(_, _, off)| (off - missing).abs() < 1e-12));
        }
    }
    // Planar poses of a conic; in space the sign does not matter.
    let conic = RationalMotion::conic(&[at(0.0, 0.0, 0.0), at(1.0, 1.0, half), at(2.0, 4.0, 0.2)]).unwrap();
    assert!(first(&conic.into()).is_some());
    let up = |pose: TimedPose, z: f64| TimedPose {
        pose: Pose::new(pose.pose.rotation(), Vec3::new(1.0, z, z)).unwrap(),
        ..pose
    };
    let poses = [up(at(0.0, 0.0, 0.0), 0.0), up(at(1.0, 1.0, half), 1.0), up(at(2.0, 4.0, 0.2), 3.0)];
    assert!(first(&RationalMotion::conic(&poses).unwrap().into()).is_none());
}

/// The spans of a spline that swing are told by what of them does: a turn behind a slide, a place behind a turn.
#[test]
fn turns_and_places_that_swing_are_told_apart() {
    let told = |poses: &[TimedPose]| match RationalMotion::spline(poses).unwrap().warnings()[..] {
        [] => None,
        [Warning::Motion(MotionWarning::Swings { span, count, ratio, part, limit, .. })] => {
            assert!(ratio > limit);
            Some((span, count, ratio, part))
        }
        _ => panic!("more than one"),
    };
    let degrees = |time: f64, x: f64, angle: f64| at(time, x, f64::to_radians(angle));
    // Turned by 60 degrees at both ends of a slide, it goes to 43.6 and 76.4 in between.
    let turns = [degrees(0.0, 0.0, 0.0), degrees(1.0, 1.0, 60.0), degrees(5.0, 5.0, 60.0), degrees(6.0, 6.0, 120.0)];
    assert_eq!(told(&turns), Some((1, 1, f64::INFINITY, SwingPart::Turn)));
    let message = RationalMotion::spline(&turns).unwrap().warnings()[0].to_string();
    assert!(message.contains("where its orientation is the same at both poses"), "{message}");
    // At one place at both ends of a turn, it leaves that by a tenth of the way before; and on the slides beside, where it should not turn, it rocks.
    let places = [degrees(0.0, 0.0, 0.0), degrees(1.0, 10.0, 0.0), degrees(3.0, 10.0, 90.0), degrees(4.0, 20.0, 90.0)];
    assert_eq!(told(&places), Some((0, 3, f64::INFINITY, SwingPart::Turn)));
    let out = |k: u32| {
        let motion = RationalMotion::spline(&places).unwrap();
        (motion.pose(1.0 + 2.0 * f64::from(k) / 40.0).translation() - Vec3::X * 10.0).length()
    };
    assert!((0..=40).map(out).fold(0.0, f64::max) > 1.0);
    // What is nearly so has a ratio, and a pose more, or a rest, helps.
    let turning = |time: f64, x: f64, angle: f64| degrees(time, x, angle - 10.0 * (2.0 - time).abs());
    let nearly = [turning(0.0, 0.0, 0.0), turning(1.0, 10.0, 0.0), turning(3.0, 10.5, 90.0), turning(4.0, 20.0, 110.0)];
    assert!(told(&nearly).is_some_and(|(span, _, ratio, part)| span == 1 && ratio < 100.0 && part == SwingPart::Place));
    let rests = [places[0], places[1], degrees(1.5, 10.0, 0.0), places[2], degrees(3.5, 10.0, 90.0), places[3]];
    assert_eq!(told(&rests), None);
}

/// Motions that do what their poses say are told of nothing: waves that are sampled at their crests, turns on the spot and about a point, noise.
#[test]
fn plain_motions_do_not_swing() {
    let spline = |poses: Vec<TimedPose>| RationalMotion::spline(&poses).unwrap().warnings();
    let pose = |time: f64, turn: Quat, place: Vec3| TimedPose { time, pose: Pose::new(turn, place).unwrap() };
    let about = |axis: Vec3, angle: f64| Quat::from_axis_angle(axis, angle);
    // 12 samples of a wave of the yaw, two of them beside each crest, while the body goes on; and of its place while it turns.
    let phase = |k: usize| (k as f64 + 0.5) * std::f64::consts::PI / 6.0;
    let yaws = (0..25).map(|k| pose(k as f64, about(Vec3::Z, 0.8 * phase(k).sin()), Vec3::X * (5.0 * k as f64)));
    assert_eq!(spline(yaws.collect()), []);
    let sways = (0..25).map(|k| pose(k as f64, about(Vec3::Z, 0.3 * k as f64), Vec3::X * (5.0 * phase(k).sin())));
    assert_eq!(spline(sways.collect()), []);
    // Unevenly round a point far away, and on the spot.
    let angles = [0.0, 0.4, 1.0, 1.2, 2.0, 2.3, 3.1];
    for arm in [0.0, 50.0] {
        let round = angles.iter().zip([0.0, 1.0, 2.0, 2.5, 4.0, 5.0, 6.0]).map(|(angle, time)| {
            let turn = about(Vec3::Z, *angle);
            pose(time, turn, Vec3::new(7.0, 3.0, 0.0) + turn.rotate(Vec3::X * arm))
        });
        assert_eq!(spline(round.collect()), [], "{arm}");
    }
    // A slide that comes to a stand and turns there, measured to a hundredth of a millimeter, and a slide measured to a thousandth of a radian.
    let noise = |k: usize, i: usize| (((k * 7919 + i * 104_729) % 997) as f64 / 498.0) - 1.0;
    let measured = (0..30).map(|k| {
        let place = Vec3::new(500.0 - 200.0 * (-0.5 * k as f64).exp(), 300.0, 0.0)
            + Vec3::new(noise(k, 1), noise(k, 2), noise(k, 3)) * 0.01;
        pose(k as f64, about(Vec3::Z, 0.2 * k as f64), place)
    });
    assert_eq!(spline(measured.collect()), []);
    let slides = (0..30).map(|k| {
        let turn = about(Vec3::new(noise(k, 4), noise(k, 5), 1.0), 5e-4 * noise(k, 6));
        pose(k as f64, turn, Vec3::X * (4.0 * k as f64))
    });
    assert_eq!(spline(slides.collect()), []);
    // Pick and place, with the turn on the way.
    let stations = [[0.0, 0.0, 50.0], [0.0, 0.0, 0.0], [0.0, 0.0, 50.0], [200.0, 0.0, 50.0], [200.0, 0.0, 0.0]];
    let picks = stations.iter().zip([0.0, 0.0, 0.0, 1.5, 1.5]).zip([0.0, 0.4, 0.8, 2.4, 2.8]);
    let picks = picks.map(|((place, angle), time)| pose(time, about(Vec3::Z, angle), Vec3::from(*place)));
    assert_eq!(spline(picks.collect()), []);
}

/// A body at constant speed is nowhere faster than at that speed, and everywhere faster than at a little less.
#[test]
fn a_limit_that_is_kept_is_kept_in_spite_of_rounding() {
    let places = [[0.0, 0.0, 0.0], [13.0, 4.0, 1.0], [20.0, -7.0, 5.0], [31.0, 2.0, 2.0], [37.0, 9.0, -4.0]];
    let poses: Vec<TimedPose> = (0..5)
        .zip(places)
        .map(|(k, place)| {
            let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, f64::from(k)), 0.3 * f64::from(k));
            TimedPose { time: f64::from(k), pose: Pose::new(turn, Vec3::from(place)).unwrap() }
        })
        .collect();
    for motion in both(&poses) {
        let way = motion.way(Point3::ORIGIN);
        for speed in [10.0, 7.3, 1e-3] {
            let body = MovingBody::new(motion.clone()).with_law(TimeLaw::ConstantSpeed, way / speed).unwrap();
            let schedule = body.schedule().unwrap();
            assert_eq!(schedule.faster_than(SpeedKind::Tool, speed), [], "{speed}");
            let [all] = schedule.faster_than(SpeedKind::Tool, speed * (1.0 - 1e-9))[..] else { panic!("{speed}") };
            assert!(all.from <= 0.0 && (all.to - body.duration()).abs() <= 1e-12 * all.to, "{all:?}");
        }
    }
}

/// What runs beyond its poses is told wherever it is: by the extent of the poses, not by the way to the origin.
#[test]
fn swings_are_told_wherever_the_origin_is() {
    for step in [1e-3, 0.1, 1.0] {
        let told = |far: Vec3| {
            let places = [0.0, 100.0, 100.0 + step, 200.0].into_iter().zip(0..);
            let poses = places.map(|(x, time)| TimedPose {
                time: f64::from(time),
                pose: Pose::new(Quat::ONE, far + Vec3::X * x).unwrap(),
            });
            RationalMotion::spline(&poses.collect::<Vec<_>>()).unwrap().warnings()
        };
        for far in [Vec3::ZERO, Vec3::new(1e3, 0.0, 0.0), Vec3::new(0.0, 1e5, 1e5), Vec3::new(5e6, 4e5, 0.0)] {
            let [Warning::Motion(MotionWarning::Swings { span: 1, count: 1, .. })] = told(far)[..] else {
                panic!("{step} {far:?}")
            };
        }
    }
}
