//! Derivatives against differences of poses.

use crate::data::{motions, timed};
use cyclide::{Point3, Vec3, motion::Motion};
use proptest::prelude::*;

/// Step of the differences, in spans.
const STEP: f64 = 1e-4;

proptest! {
    #[test]
    fn velocities_are_those_of_the_poses(poses in timed(5), x in prop::array::uniform3(-2.0..2.0_f64), part in 0.05..0.95_f64) {
        let x = Point3::from(x);
        for motion in motions(&poses) {
            let times = motion.times().to_vec();
            for ends in times.windows(2) {
                let (time, h) = (ends[0] + (ends[1] - ends[0]) * part, STEP * (ends[1] - ends[0]));
                let at = |k: f64| motion.jet(time + k * h, x);
                let jet = at(0.0);
                let size = 1.0 + [jet.point.d1, jet.point.d2, jet.point.d3].map(Vec3::length).into_iter().fold(0.0, f64::max);
                prop_assert!(jet.point.point.distance(motion.pose(time).apply(x)) < 1e-11 * size);
                let (before, after) = (at(-1.0), at(1.0));
                let difference = |f: fn(&cyclide::motion::MotionJet) -> Vec3| (f(&after) - f(&before)) / (2.0 * h);
                // Of second order in the step; what a third derivative of a swinging motion adds to that.
                let steep = [&before, &after, &jet].map(|j| j.point.d3.length()).into_iter().fold(size, f64::max);
                let limit = 1e-5 * steep * steep;
                prop_assert!((difference(|j| j.point.point.to_vec()) - jet.point.d1).length() < limit);
                prop_assert!((difference(|j| j.point.d1) - jet.point.d2).length() < limit);
                prop_assert!((difference(|j| j.angular_velocity) - jet.angular_acceleration).length() < limit);
                prop_assert!((difference(|j| j.angular_acceleration) - jet.angular_jerk).length() < 1e2 * limit);
            }
        }
    }

    #[test]
    fn the_body_is_rigid(poses in timed(5), x in prop::array::uniform3(-2.0..2.0_f64), y in prop::array::uniform3(-2.0..2.0_f64), part in 0.0..1.0_f64) {
        let (x, y) = (Point3::from(x), Point3::from(y));
        for motion in motions(&poses) {
            let [first, last] = motion.domain();
            let time = first + (last - first) * part;
            let (a, b) = (motion.jet(time, x), motion.jet(time, y));
            let (arm, turn) = (b.point.point - a.point.point, a.angular_velocity);
            let size = 1.0 + a.point.d2.length() + b.point.d2.length() + turn.length() * turn.length();
            // v_y − v_x = ω × r, and its derivative.
            prop_assert!((b.point.d1 - a.point.d1 - turn.cross(arm)).length() < 1e-10 * size);
            let second = a.angular_acceleration.cross(arm) + turn.cross(turn.cross(arm));
            prop_assert!((b.point.d2 - a.point.d2 - second).length() < 1e-9 * size * size);
        }
    }
}

#[test]
fn a_spline_is_c1_at_its_poses() {
    let pose = |q: [f64; 4], x: [f64; 3]| cyclide::motion::Pose::new(q.into(), x.into()).unwrap();
    let poses = [
        pose([1.0, 0.0, 0.0, 0.0], [0.0; 3]),
        pose([1.0, 0.5, -0.2, 0.1], [1.0, 2.0, 0.0]),
        pose([0.3, 0.5, 0.4, 0.1], [2.0, 2.0, 1.0]),
    ];
    let timed: Vec<_> =
        poses.into_iter().zip([0.0, 1.0, 1.5]).map(|(pose, time)| cyclide::motion::TimedPose { time, pose }).collect();
    let motion = Motion::from(cyclide::motion::RationalMotion::spline(&timed).unwrap());
    let x = Point3::new(0.3, -1.0, 0.7);
    let (before, after) = (motion.jet(1.0 - 1e-12, x), motion.jet(1.0, x));
    // A step of 1e-12 times second derivatives of about 10.
    assert!((before.point.d1 - after.point.d1).length() < 1e-10);
    assert!((before.angular_velocity - after.angular_velocity).length() < 1e-10);
}
