//! Poses that are written with few digits.

use cyclide::{
    Point3, Quat, Vec3,
    motion::{Motion, Pose, RationalMotion, TimedPose},
};
use proptest::prelude::*;

use crate::data::{apart, pose, timed};

/// A pose with so many decimals.
fn rounded(pose: Pose, decimals: i32) -> Pose {
    let unit = 10_f64.powi(decimals);
    let cut = |v: f64| (v * unit).round() / unit;
    Pose::new(Quat::from(pose.rotation().to_array().map(cut)), Vec3::from(pose.translation().to_array().map(cut)))
        .unwrap()
}

/// The largest distance of two motions over their times.
fn between(a: &RationalMotion, b: &RationalMotion) -> f64 {
    let [first, last] = [a.times()[0], a.times()[a.times().len() - 1]];
    (0..=64)
        .map(|k| first + (last - first) * f64::from(k) / 64.0)
        .map(|time| apart(a.pose(time), b.pose(time)))
        .fold(0.0, f64::max)
}

fn reasons(motion: &RationalMotion) -> Vec<&'static str> {
    motion.warnings().iter().map(cyclide::Warning::reason).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: proptest::test_runner::RngSeed::Fixed(1), cases: 64, ..ProptestConfig::default() })]

    /// Poses of one plane somewhere in space, with six or nine decimals: the motion is that of the poses themselves, to what they are off. It was one of
    /// the rounding.
    #[test]
    fn planar_poses_with_few_decimals_stay_planar(
        decimals in prop::sample::select(vec![6, 9]),
        frame in pose(),
        angles in prop::array::uniform5(-1.2..1.2_f64),
        places in prop::array::uniform5(prop::array::uniform2(-2.0..2.0_f64)),
    ) {
        let poses: Vec<TimedPose> = (0..5)
            .map(|i| {
                let turn = Quat::from_axis_angle(Vec3::Z, angles[i]);
                let flat = Pose::new(turn, Vec3::new(places[i][0], places[i][1], 0.0)).unwrap();
                TimedPose { time: i as f64, pose: frame.after(flat) }
            })
            .collect();
        let cut: Vec<TimedPose> = poses.iter().map(|p| TimedPose { pose: rounded(p.pose, decimals), ..*p }).collect();
        for (made, of_cut) in [
            (RationalMotion::conic(&poses[..3]), RationalMotion::conic(&cut[..3])),
            (RationalMotion::quartic(&poses), RationalMotion::quartic(&cut)),
        ] {
            let Ok(made) = made else { continue };
            prop_assert!(reasons(&made).is_empty());
            let of_cut = of_cut.unwrap();
            // Where the real part is short what poses are off grows with its inverse; here it does so a thousandfold at most.
            let least = (0..=64).map(|k| made.dual_quat(made.times()[1] * f64::from(k) / 64.0).real.norm()).fold(1.0, f64::min);
            prop_assert!(between(&made, &of_cut) < 1e3 * 10_f64.powi(-decimals) / (least * least), "{:e} {least}", between(&made, &of_cut));
            prop_assert_eq!(reasons(&of_cut), ["poses-rounded"]);
            for p in &cut[..if of_cut.degree() == 2 { 3 } else { 5 }] {
                prop_assert!(apart(of_cut.pose(p.time), p.pose) < 1e-9);
            }
        }
    }

    /// Five poses of a motion of degree 2 with nine decimals: a motion beside it takes them. Two of three were refused.
    #[test]
    fn poses_of_a_conic_with_nine_decimals_give_it(poses in timed(3)) {
        let Ok(conic) = RationalMotion::conic(&poses) else { return Ok(()) };
        let [first, last] = Motion::from(conic.clone()).domain();
        let reach = (0..=40).map(|k| conic.pose(first + (last - first) * f64::from(k) / 40.0).translation().length()).fold(0.0, f64::max);
        prop_assume!(reach < 10.0);
        let five: Vec<TimedPose> = (0..5)
            .map(|k| first + (last - first) * f64::from(k) / 4.0)
            .map(|time| TimedPose { time, pose: rounded(conic.pose(time), 9) })
            .collect();
        let Ok(quartic) = RationalMotion::quartic(&five) else {
            // Forms that are rounding of each other leave nothing to tell.
            return Err(TestCaseError::fail(format!("{:?}", RationalMotion::quartic(&five).unwrap_err())));
        };
        for p in &five {
            // Poses are met within 1e-9 of the size, which is below 5 here.
            prop_assert!(apart(quartic.pose(p.time), p.pose) < 5e-9);
        }
        prop_assert!(between(&conic, &quartic) < 1e-5, "{:e}", between(&conic, &quartic));
    }
}

/// A path whose end is its start but for rounding is closed, far from the origin, too; one that goes on is not.
#[test]
fn paths_of_motions_that_come_back_to_rounding_are_closed() {
    let at = |time: f64, x: [f64; 3], angle: f64| TimedPose {
        time,
        pose: Pose::new(Quat::from_axis_angle(Vec3::Z, angle), Vec3::from(x)).unwrap(),
    };
    for far in [0.0, 1e3, 1e6] {
        let third = std::f64::consts::TAU / 3.0;
        let spot = |k: f64| [far + 5.0 * (k * third).cos(), 5.0 * (k * third).sin(), 1.0];
        let poses = [0.0, 1.0, 2.0, 3.0].map(|k| at(k, spot(k), 0.4 * (k * third).sin()));
        assert!(poses[0].pose != poses[3].pose);
        let motion = RationalMotion::spline(&poses).unwrap();
        let path = motion.trajectory(Point3::new(0.3, -0.2, 0.5)).unwrap();
        assert_eq!(path.control_points().first(), path.control_points().last(), "{far}");
        assert!(Motion::from(motion).closing_turn().unwrap() < 1e-9);
    }
    // At a million units a way of a ten thousandth of a millionth has no end to tell from its start; a longer one has.
    let on = RationalMotion::spline(&[
        at(0.0, [1e9, 0.0, 0.0], 0.0),
        at(1.0, [1e9 + 2e-3, 0.0, 0.0], 0.1),
        at(2.0, [1e9 + 5e-4, 0.0, 0.0], 0.2),
    ])
    .unwrap();
    let path = on.trajectory(Point3::ORIGIN).unwrap();
    assert_ne!(path.control_points().first(), path.control_points().last());
    assert!(Motion::from(on).closing_turn().is_none());
}
