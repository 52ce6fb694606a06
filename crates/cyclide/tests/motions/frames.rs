//! Every construction is the same in every frame: displacements on the left move the world, on the right the body's axes.

use crate::data::{apart, kinds, motions, pose, timed};
use cyclide::motion::{Motion, Pose, TimedPose};
use proptest::prelude::*;

fn places(motion: &Motion) -> impl Iterator<Item = f64> {
    let [first, last] = motion.domain();
    (0..=24).map(move |k| first + (last - first) * f64::from(k) / 24.0)
}

fn changed(poses: &[TimedPose], change: impl Fn(Pose) -> Pose) -> Vec<TimedPose> {
    poses.iter().map(|p| TimedPose { time: p.time, pose: change(p.pose) }).collect()
}

proptest! {
    #[test]
    fn poses_are_taken_at_their_times(poses in timed(5)) {
        for motion in motions(&poses) {
            let count = match &motion { Motion::Rational(m) if m.times().len() == 2 => m.degree() + 1, _ => 5 };
            for p in &poses[..count] {
                // 1e-9 is what the constructions prove themselves.
                prop_assert!(apart(motion.pose(p.time), p.pose) < 1e-8);
            }
        }
    }

    #[test]
    fn frames_of_world_and_body_do_not_matter(poses in timed(5), left in pose(), right in pose()) {
        let all = kinds(&poses);
        let moved = [
            (kinds(&changed(&poses, |p| left.after(p))), left, Pose::IDENTITY),
            (kinds(&changed(&poses, |p| p.after(right))), Pose::IDENTITY, right),
        ];
        for (others, left, right) in moved {
            for (motion, other) in all.iter().zip(&others) {
                // Where a motion exists in one frame only, it is at a limit.
                let (Some(motion), Some(other)) = (motion, other) else { continue };
                for time in places(motion) {
                    let expected = left.after(motion.pose(time)).after(right);
                    // Motions of least degree lose what their factors differ by, up to ten digits.
                    prop_assert!(apart(other.pose(time), expected) < 1e-5, "{time}");
                }
            }
        }
    }

    #[test]
    fn splines_and_screws_lose_no_digits_by_frames(poses in timed(2..8), left in pose(), right in pose()) {
        let other = changed(&poses, |p| left.after(p).after(right));
        let pairs = [
            (cyclide::motion::RationalMotion::spline(&poses).map(Motion::from), cyclide::motion::RationalMotion::spline(&other).map(Motion::from)),
            (cyclide::motion::ScrewMotion::new(&poses).map(Motion::from), cyclide::motion::ScrewMotion::new(&other).map(Motion::from)),
        ];
        for (a, b) in pairs {
            let (Ok(a), Ok(b)) = (a, b) else { continue };
            for time in places(&a) {
                let jet = a.jet(time, cyclide::Point3::ORIGIN);
                let expected = left.after(a.pose(time)).after(right);
                // Rounding of the poses, times how much the quaternion is shorter than 1, which shows in the speed.
                let allowed = 1e-12 * (1.0 + jet.angular_velocity.length() + jet.point.speed());
                prop_assert!(apart(b.pose(time), expected) < allowed);
            }
        }
    }

    #[test]
    fn time_runs_backwards(poses in timed(5)) {
        let back: Vec<TimedPose> = poses.iter().rev().map(|p| TimedPose { time: -p.time, pose: p.pose }).collect();
        let pairs = [
            (cyclide::motion::RationalMotion::spline(&poses).map(Motion::from), cyclide::motion::RationalMotion::spline(&back).map(Motion::from)),
            (cyclide::motion::ScrewMotion::new(&poses).map(Motion::from), cyclide::motion::ScrewMotion::new(&back).map(Motion::from)),
        ];
        for (a, b) in pairs {
            let (Ok(a), Ok(b)) = (a, b) else { continue };
            for time in places(&a) {
                let jet = a.jet(time, cyclide::Point3::ORIGIN);
                let allowed = 1e-12 * (1.0 + jet.angular_velocity.length() + jet.point.speed());
                prop_assert!(apart(a.pose(time), b.pose(-time)) < allowed);
            }
        }
    }
}
