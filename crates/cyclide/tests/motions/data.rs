//! Random poses and motions.

use cyclide::{
    Quat, Vec3,
    motion::{Motion, Pose, RationalMotion, ScrewMotion, TimedPose},
};
use proptest::prelude::*;

/// Any pose of a size of about 1.
pub fn pose() -> impl Strategy<Value = Pose> {
    let unit = -1.0..1.0_f64;
    (prop::array::uniform4(unit.clone()), prop::array::uniform3(-2.0..2.0_f64))
        .prop_filter("a rotation", |(q, _)| Quat::from(*q).norm() > 0.1)
        .prop_map(|(q, x)| Pose::new(Quat::from(q), Vec3::from(x)).unwrap())
}

/// Poses at times 0, 1, 2, ..., each moved by up to a third.
pub fn timed(count: impl Into<prop::collection::SizeRange>) -> impl Strategy<Value = Vec<TimedPose>> {
    prop::collection::vec((pose(), -0.33..0.33_f64), count).prop_map(|poses| {
        poses.into_iter().enumerate().map(|(i, (pose, off))| TimedPose { time: i as f64 + off, pose }).collect()
    })
}

/// The motions of every kind through the first of five poses, but for those that do not exist or swing far out: conic, quartic, spline, screws.
pub fn kinds(poses: &[TimedPose]) -> [Option<Motion>; 4] {
    let rational = [
        RationalMotion::conic(&poses[..3]).ok(),
        RationalMotion::quartic(&poses[..5]).ok(),
        RationalMotion::spline(poses).ok(),
    ];
    let [conic, quartic, spline] = rational.map(|motion| motion.map(Motion::from));
    let all = [conic, quartic, spline, ScrewMotion::new(poses).ok().map(Motion::from)];
    all.map(|motion| motion.filter(|motion| reach(motion) < 1e2))
}

/// Those of them that there are.
pub fn motions(poses: &[TimedPose]) -> Vec<Motion> {
    kinds(poses).into_iter().flatten().collect()
}

/// How far the origin of the body gets, and how fast the body moves or turns.
pub fn reach(motion: &Motion) -> f64 {
    let [first, last] = motion.domain();
    (0..=400)
        .map(|k| {
            let jet = motion.jet(first + (last - first) * f64::from(k) / 400.0, cyclide::Point3::ORIGIN);
            let derivatives = [jet.point.d1, jet.point.d2, jet.angular_velocity, jet.angular_acceleration];
            derivatives.iter().map(|d| d.length()).fold(jet.point.point.to_vec().length(), f64::max)
        })
        .fold(0.0, f64::max)
}

/// The distance of two poses: of their translations, and twice that of their rotations.
pub fn apart(a: Pose, b: Pose) -> f64 {
    (a.translation() - b.translation()).length().max(a.angle_to(b))
}
