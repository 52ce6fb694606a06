//! Poses that are degenerate, or badly scaled.

use crate::data::{apart, timed};
use cyclide::{
    Quat, Vec3,
    motion::{DualQuat, Pose, RationalMotion, ScrewMotion, StudyPoint, TimedPose},
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

proptest! {
    #[test]
    fn size_and_place_do_not_matter(poses in timed(5), exponent in -100..100_i32) {
        // A power of two: nothing is rounded.
        let scale = 2_f64.powi(exponent);
        let scaled: Vec<TimedPose> = poses
            .iter()
            .map(|p| {
                let pose = Pose::new(p.pose.rotation(), p.pose.translation() * scale).unwrap();
                TimedPose { time: p.time, pose }
            })
            .collect();
        for make in [RationalMotion::spline, RationalMotion::quartic] {
            match (make(&poses), make(&scaled)) {
                (Ok(a), Ok(b)) => {
                    for k in 0..=10 {
                        let time = a.times()[0] + (a.times()[a.times().len() - 1] - a.times()[0]) * 0.1 * f64::from(k);
                        let back = Pose::new(b.pose(time).rotation(), b.pose(time).translation() * (1.0 / scale)).unwrap();
                        let jet = a.jet(time, cyclide::Point3::ORIGIN);
                        prop_assert!(apart(back, a.pose(time)) < 1e-7 * (1.0 + jet.point.speed()));
                    }
                }
                (Err(a), Err(b)) => prop_assert_eq!(a.reason(), b.reason()),
                (a, b) => prop_assert!(false, "{a:?} {b:?}"),
            }
        }
    }

    #[test]
    fn five_poses_of_a_conic_give_the_conic(poses in timed(3), parts in prop::array::uniform2(0.1..0.9_f64)) {
        let Ok(conic) = RationalMotion::conic(&poses) else { return Ok(()) };
        let far = crate::data::reach(&conic.clone().into());
        prop_assume!(far < 1e2 && (parts[0] - parts[1]).abs() > 0.05);
        let times = [poses[0].time, poses[1].time, poses[2].time];
        let more = [times[0] + (times[1] - times[0]) * parts[0], times[1] + (times[2] - times[1]) * parts[1]];
        let five: Vec<TimedPose> = [times[0], more[0], times[1], more[1], times[2]]
            .into_iter()
            .map(|time| TimedPose { time, pose: conic.pose(time) })
            .collect();
        let again = RationalMotion::quartic(&five);
        prop_assume!(again.is_ok());
        let again = again.unwrap();
        for k in 0..=20 {
            let time = times[0] + (times[2] - times[0]) * 0.05 * f64::from(k);
            prop_assert!(apart(again.pose(time), conic.pose(time)) < 1e-4);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]
    /// Five poses of a motion of degree 2 give that one, also where their coordinates have lost digits.
    #[test]
    fn far_poses_of_a_conic_give_the_conic(poses in timed(3), parts in prop::array::uniform2(0.2..0.8_f64), far in 0.0..7.0_f64) {
        let Ok(conic) = RationalMotion::conic(&poses) else { return Ok(()) };
        if crate::data::reach(&conic.clone().into()) > 100.0 {
            return Ok(());
        }
        let times = [poses[0].time, poses[1].time, poses[2].time];
        let more = [times[0] + (times[1] - times[0]) * parts[0], times[1] + (times[2] - times[1]) * parts[1]];
        let place = Vec3::new(0.6, -0.8, 0.5) * 10_f64.powf(far);
        let five: Vec<TimedPose> = [times[0], more[0], times[1], more[1], times[2]]
            .into_iter()
            .map(|time| {
                let pose = conic.pose(time);
                TimedPose { time, pose: Pose::new(pose.rotation(), pose.translation() + place).unwrap() }
            })
            .collect();
        let again = RationalMotion::quartic(&five);
        prop_assert!(again.is_ok(), "{again:?}");
        let again = again.unwrap();
        prop_assert_eq!(again.degree(), 2);
        for k in 0..=20 {
            let time = times[0] + (times[2] - times[0]) * 0.05 * f64::from(k);
            let back = Pose::new(again.pose(time).rotation(), again.pose(time).translation() - place).unwrap();
            let by = apart(back, conic.pose(time));
            prop_assert!(by < 1e-8 + 1e4 * f64::EPSILON * place.max_abs(), "{by:e} at {:e}", place.max_abs());
        }
    }
}

fn at(time: f64, rotation: [f64; 4], translation: [f64; 3]) -> TimedPose {
    TimedPose { time, pose: Pose::new(Quat::from(rotation), Vec3::from(translation)).unwrap() }
}

#[test]
fn displacements_that_are_none() {
    let reason = |real: [f64; 4], dual: [f64; 4]| {
        StudyPoint::new(DualQuat { real: real.into(), dual: dual.into() }).unwrap_err().reason()
    };
    assert_eq!(reason([0.0; 4], [0.0, 1.0, 0.0, 0.0]), "point-at-infinity");
    assert_eq!(reason([1.0, 0.0, 0.0, 0.0], [1e-8, 1.0, 0.0, 0.0]), "not-on-study-quadric");
    assert_eq!(reason([f64::NAN, 0.0, 0.0, 0.0], [0.0; 4]), "not-finite");
    // Rounding is projected away.
    let near = DualQuat { real: Quat::ONE, dual: Quat::new(1e-10, 1.0, 0.0, 0.0) };
    assert!(StudyPoint::new(near).unwrap().dual_quat().study_product().abs() < 1e-25);
}

#[test]
fn times_of_any_size_are_taken_or_refused() {
    let q = [1.0, 0.2, 0.0, 0.1];
    let poses = |times: [f64; 3]| {
        times.map(|time| at(time, [1.0, 0.1 * (time / times[2]), 0.3, 0.0], [time / times[2], 0.0, 1.0]))
    };
    for scale in [1e-300, 1.0, 1e300] {
        assert!(RationalMotion::spline(&poses([0.0, scale, 2.0 * scale])).is_ok(), "{scale:e}");
    }
    let all = |times: [f64; 2]| times.map(|time| at(time, q, [1.0, 0.0, 0.0]));
    assert_eq!(ScrewMotion::new(&all([-1.7e308, 1.7e308])).unwrap_err().reason(), "not-finite");
    assert_eq!(ScrewMotion::new(&all([0.0, f64::NAN])).unwrap_err().reason(), "not-finite");
    let tiny = [at(-1.0, q, [0.0; 3]), at(1e-320, q, [1.0; 3]), at(2e-320, q, [2.0; 3])];
    assert_eq!(RationalMotion::conic(&tiny).unwrap_err().reason(), "repeated-parameter");
    assert_eq!(RationalMotion::spline(&tiny).unwrap_err().reason(), "parameters-not-increasing");
}

#[test]
fn places_at_the_end_of_the_range_are_refused_or_taken() {
    let poses = [1.7e308_f64, -1.7e308].map(|x| at(x.signum(), [1.0, 0.0, 0.0, 0.3], [x, 0.0, 0.0]));
    let poses = [poses[1], poses[0]];
    if let Ok(motion) = RationalMotion::spline(&poses) {
        assert!(motion.pose(0.0).translation().is_finite());
    }
    let same = [0.0, 1.0, 2.0].map(|time| at(time, [1.0, 0.0, 0.0, 0.0], [5.0, 5.0, 5.0]));
    for motion in [RationalMotion::conic(&same).unwrap(), RationalMotion::spline(&same).unwrap()] {
        assert!((motion.pose(0.7).translation() - Vec3::new(5.0, 5.0, 5.0)).length() < 1e-14);
    }
}
