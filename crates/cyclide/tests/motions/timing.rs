//! Time laws: constant speed is constant, eased motions begin and end at rest.

use crate::data::{motions, timed};
use cyclide::{
    Point3, Quat, Vec3,
    motion::{Motion, MotionJet, MovingBody, Pose, RationalMotion, ScrewMotion, TimeLaw, TimedPose, Timing},
};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn constant_speed_is_constant(poses in timed(5), x in prop::array::uniform3(-2.0..2.0_f64), arm in 0.1..2.0_f64) {
        let x = Point3::from(x);
        for motion in motions(&poses) {
            let timing = Timing::new(&motion, TimeLaw::ConstantSpeed, x, arm).unwrap();
            let times: Vec<f64> = (0..=16).map(|k| timing.time_at(f64::from(k) / 16.0)).collect();
            prop_assert!(times.windows(2).all(|w| w[0] < w[1]));
            let bits = |ends: [f64; 2]| ends.map(f64::to_bits);
            prop_assert_eq!(bits([times[0], times[16]]), bits(motion.domain()));
            for pair in times.windows(2) {
                // By the midpoint rule, an independent one, span by span of the motion.
                let way: f64 = way(&motion, x, arm, [pair[0], pair[1]]);
                prop_assert!((way * 16.0 - timing.way()).abs() < 1e-4 * timing.way(), "{way} {}", timing.way());
            }
        }
    }

    #[test]
    fn eased_motions_go_from_rest_to_rest(poses in timed(5)) {
        let x = Point3::new(0.3, 0.2, 0.1);
        for motion in motions(&poses) {
            let eased = Timing::new(&motion, TimeLaw::Eased, x, 0.5).unwrap();
            let steady = Timing::new(&motion, TimeLaw::ConstantSpeed, x, 0.5).unwrap();
            for k in 0..=8 {
                let f = f64::from(k) / 8.0;
                let done = f * f * f * (10.0 - 15.0 * f + 6.0 * f * f);
                let size = motion.domain().iter().fold(1.0_f64, |m, t| m.max(t.abs()));
                prop_assert!((eased.time_at(f) - steady.time_at(done)).abs() < 1e-9 * size);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    #[test]
    fn jets_of_laws_are_derivatives(poses in timed(5), part in 0.1..0.9_f64) {
        for motion in motions(&poses) {
            for law in [TimeLaw::AsGiven, TimeLaw::ConstantSpeed, TimeLaw::Eased] {
                let body = MovingBody::new(motion.clone()).with_tool(Point3::new(0.3, 0.2, 0.1), 0.5).unwrap();
                let body = body.with_law(law, 3.0).unwrap();
                let schedule = body.schedule().unwrap();
                let h = 1e-4;
                let [before, jet, after] = [part - h, part, part + h].map(|x| schedule.jet(x));
                // At a joint derivatives jump.
                let times = [part - 2.0 * h, part + 2.0 * h].map(|x| schedule.timing().time_at(x));
                if motion.times().iter().any(|t| *t >= times[0] && *t <= times[1]) {
                    continue;
                }
                let steep = [&before, &jet, &after].map(|j| j.point.d3.length()).into_iter().fold(1.0, f64::max);
                let difference = |f: fn(&MotionJet) -> Vec3| (f(&after) - f(&before)) / (2.0 * h * 3.0);
                let limit = 1e-5 * steep * steep;
                prop_assert!((difference(|j| j.point.point.to_vec()) - jet.point.d1).length() < limit);
                prop_assert!((difference(|j| j.point.d1) - jet.point.d2).length() < limit);
                prop_assert!((difference(|j| j.point.d2) - jet.point.d3).length() < 1e2 * limit);
                prop_assert!((difference(|j| j.angular_velocity) - jet.angular_acceleration).length() < limit);
                prop_assert!((difference(|j| j.angular_acceleration) - jet.angular_jerk).length() < 1e2 * limit);
            }
        }
    }
}

fn way(motion: &Motion, x: Point3, arm: f64, [from, to]: [f64; 2]) -> f64 {
    let mut ends = vec![from];
    ends.extend(motion.times().iter().copied().filter(|t| *t > from && *t < to));
    ends.push(to);
    ends.windows(2)
        .map(|part| {
            let h = (part[1] - part[0]) / 2000.0;
            let speed = |k: u32| {
                let jet = motion.jet(part[0] + h * (f64::from(k) + 0.5), x);
                jet.point.speed().hypot(arm * jet.angular_velocity.length())
            };
            (0..2000).map(speed).sum::<f64>() * h
        })
        .sum()
}

#[test]
fn arms_that_are_none_are_refused() {
    let poses = [0.0, 1.0].map(|time| TimedPose { time, pose: Pose::IDENTITY });
    let motion = ScrewMotion::new(&poses).unwrap().into();
    for arm in [-1.0, f64::NAN, f64::INFINITY] {
        let error = Timing::new(&motion, TimeLaw::AsGiven, Point3::ORIGIN, arm).unwrap_err();
        assert_eq!(error.reason(), "parameter-out-of-range");
    }
    assert_eq!(Timing::new(&motion, TimeLaw::Eased, Point3::ORIGIN, 1.0).unwrap_err().reason(), "motion-at-rest");
}

fn slide(time: f64, x: f64, angle: f64) -> TimedPose {
    TimedPose { time, pose: Pose::new(Quat::from_axis_angle(Vec3::Z, angle), Vec3::X * x).unwrap() }
}

/// Derivatives next to a joint are those of the span, not differences across it: on a straight way at constant speed there is no jerk at all.
#[test]
fn nothing_is_differenced_across_a_joint() {
    let poses = [slide(0.0, 0.0, 0.0), slide(1.0, 2.0, 0.0), slide(1.5, 3.2, 0.0), slide(3.0, 6.0, 0.0)];
    for motion in [Motion::from(RationalMotion::spline(&poses).unwrap()), ScrewMotion::new(&poses).unwrap().into()] {
        let body = MovingBody::new(motion).with_law(TimeLaw::ConstantSpeed, 3.0).unwrap();
        let schedule = body.schedule().unwrap();
        // The way is x where it is monotone, as here.
        assert!((schedule.way() - 6.0).abs() < 1e-12);
        let joints = schedule.timing().joints();
        for (joint, x) in joints.iter().zip([0.0, 2.0, 3.2, 6.0]) {
            assert!((joint * 6.0 - x).abs() < 1e-12, "{joint}");
        }
        for (span, ends) in joints.windows(2).enumerate() {
            for k in 0..=50 {
                let jet = schedule.jet_in_span(span, ends[0] + (ends[1] - ends[0]) * 0.02 * f64::from(k));
                assert!((jet.point.d1 - Vec3::X * 2.0).length() < 1e-12, "{:?}", jet.point.d1);
                // Differences of numbers of about 10, of which the law makes 0.
                assert!(jet.point.d2.length() < 1e-12 && jet.point.d3.length() < 1e-11, "{:?}", jet.point);
            }
        }
    }
}

/// A body that is held between two poses stays there, also with neighbors at other speeds; what swings is told of.
#[test]
fn held_poses_are_held() {
    let at = |time: f64, x: f64| TimedPose {
        time,
        pose: Pose::new(Quat::new(1.0, 0.2, 0.0, 0.1), Vec3::new(x, 7.0, -3.0)).unwrap(),
    };
    let reasons = |motion: &RationalMotion| motion.warnings().iter().map(|w| w.reason()).collect::<Vec<_>>();
    let held = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 100.0), at(10.0, 100.0), at(11.0, 200.0)]).unwrap();
    for k in 0..=90 {
        let pose = held.pose(1.0 + 0.1 * f64::from(k));
        // Rounding of a translation of 100.
        assert!((pose.translation() - Vec3::new(100.0, 7.0, -3.0)).length() < 1e-13);
    }
    // It comes to the pose and leaves it without running beyond it.
    let x = |t: f64| held.pose(t).translation().x;
    assert!((0..100).all(|k| x(f64::from(k) * 0.01) < x(f64::from(k + 1) * 0.01)), "it comes forward");
    assert!((0..100).all(|k| x(10.0 + f64::from(k) * 0.01) < x(10.0 + f64::from(k + 1) * 0.01)), "it leaves forward");
    assert_eq!(reasons(&held), [""; 0]);
    // The same at both ends, and with two poses alone.
    let ends = RationalMotion::spline(&[at(0.0, 5.0), at(4.0, 5.0), at(5.0, 9.0), at(7.0, 9.0)]).unwrap();
    assert!(
        (ends.pose(2.0).translation().x - 5.0).abs() < 1e-14 && (ends.pose(6.0).translation().x - 9.0).abs() < 1e-14
    );
    // Nearly held: it swings.
    let swings = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 100.0), at(10.0, 101.0), at(11.0, 201.0)]).unwrap();
    let most = (0..=90).map(|k| swings.pose(1.0 + 0.1 * f64::from(k)).translation().x).fold(0.0, f64::max);
    assert!(most > 150.0 && reasons(&swings) == ["motion-swings"]);
    let even = RationalMotion::spline(&[at(0.0, 0.0), at(1.0, 100.0), at(2.0, 150.0), at(3.0, 260.0)]).unwrap();
    assert_eq!(reasons(&even), [""; 0]);
}

#[test]
fn cells_are_those_of_the_law_and_the_tool() {
    let at = |time: f64, x: f64, angle: f64| TimedPose {
        time,
        pose: Pose::new(Quat::from_axis_angle(Vec3::Z, angle), Vec3::X * x).unwrap(),
    };
    let poses = [at(0.0, 0.0, 0.0), at(1.0, 8.0, 0.5), at(1.2, 9.0, 2.5), at(4.0, 9.5, 2.6), at(9.0, -3.0, 0.1)];
    let motion = Motion::from(RationalMotion::spline(&poses).unwrap());
    let breaks = |body: &MovingBody| body.schedule().unwrap().breaks();
    let body = MovingBody::new(motion.clone());
    let own = breaks(&body);
    // They are found once, and again for another law or tool: of a body that knows them as of one that was never asked.
    let tool = Point3::new(5.0, 0.0, 0.0);
    for law in [TimeLaw::AsGiven, TimeLaw::ConstantSpeed, TimeLaw::Eased] {
        let lawful = body.clone().with_law(law, 3.0).unwrap();
        assert_eq!(breaks(&lawful), breaks(&MovingBody::new(motion.clone()).with_law(law, 3.0).unwrap()));
        let with_tool = body.clone().with_tool(tool, 1.0).unwrap();
        assert_eq!(breaks(&with_tool), breaks(&MovingBody::new(motion.clone()).with_tool(tool, 1.0).unwrap()));
    }
    assert_ne!(own, breaks(&body.clone().with_law(TimeLaw::ConstantSpeed, 3.0).unwrap()));
    assert_eq!(body, MovingBody::new(motion));
    assert_eq!(breaks(&body), own);
}

#[test]
fn spans_are_found_whether_poses_are_evenly_apart_or_not() {
    let even: Vec<f64> = (0..50).map(|i| 0.1 * f64::from(i)).collect();
    let uneven: Vec<f64> = (0..50).map(|i| f64::from(i * i * i)).collect();
    for times in [even, uneven] {
        let at = |(i, time): (usize, &f64)| TimedPose {
            time: *time,
            pose: Pose::new(Quat::ONE, Vec3::X * i as f64).unwrap(),
        };
        let poses: Vec<TimedPose> = times.iter().enumerate().map(at).collect();
        let motion = Motion::from(ScrewMotion::new(&poses).unwrap());
        for (i, pair) in times.windows(2).enumerate() {
            let duration = pair[1] - pair[0];
            // The body is as many units away as spans are behind it; places are rounded by 1e-16 of 50, parameters as times are.
            for s in [0.0, 0.3, 0.9] {
                let found = motion.pose(pair[0] + duration * s).translation().x;
                assert!((found - (i as f64 + s)).abs() < 1e-12, "{i} {s}: {found}");
            }
            // A joint is of the span that starts there.
            let speed = motion.jet(pair[0], Point3::ORIGIN).point.d1.x;
            assert!((speed * duration - 1.0).abs() < 1e-12, "{i}: {speed}");
        }
        let [_, last] = motion.domain();
        assert!((motion.pose(last).translation().x - 49.0).abs() < 1e-13);
    }
}
