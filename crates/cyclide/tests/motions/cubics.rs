//! Motions of degree 3 take all four poses, and are on the quadric.

use crate::data::{apart, pose};
use cyclide::{
    Quat, Vec3,
    motion::{CubicMotions, Pose},
};
use proptest::prelude::*;

proptest! {
    #[test]
    fn they_take_all_four_poses(poses in prop::array::uniform4(pose())) {
        let cubics = CubicMotions::new(&poses).unwrap();
        for x in cubics.admissible() {
            let Ok(motion) = cubics.motion(x, [2.0, 5.0]) else { continue };
            let a = x.sqrt() / (1.0 + x.sqrt());
            for (pose, part) in poses.iter().zip([0.0, a, 1.0 - a, 1.0]) {
                prop_assert!(apart(motion.pose(2.0 + 3.0 * part), *pose) < 1e-8);
            }
            for k in 0..=20 {
                let d = motion.dual_quat(2.0 + 0.15 * f64::from(k));
                // On the quadric itself, not only on its fibers: with no more than the rounding of a double root.
                prop_assert!(d.study_product().abs() < 1e-6 * d.real.norm() * (d.dual.norm() + d.real.norm()));
            }
        }
    }
}

fn poses(rows: [([f64; 4], [f64; 3]); 4]) -> [Pose; 4] {
    rows.map(|(rotation, translation)| Pose::new(Quat::from(rotation), Vec3::from(translation)).unwrap())
}

#[test]
fn a_root_of_rounding_is_none() {
    // The first pose moves to the second without a turn: one product of the equation is zero, and 0 is a root of it.
    let poses = poses([
        ([3.0, 0.0, 3.0, 2.0], [8.0, -4.0, 8.0]),
        ([3.0, 0.0, 3.0, 2.0], [3.0, 7.0, -6.0]),
        ([0.0, -1.0, 3.0, -2.0], [5.0, 8.0, -9.0]),
        ([3.0, -3.0, 1.0, 1.0], [-3.0, 3.0, -7.0]),
    ]);
    let cubics = CubicMotions::new(&poses).unwrap();
    let admissible = cubics.admissible();
    assert_eq!(admissible.len(), 1);
    // 1 − C/B of the products, from a separate calculation.
    assert!((admissible[0] - 0.925_679_012_345_679).abs() < 1e-13, "{admissible:?}");
    let a = admissible[0].sqrt() / (1.0 + admissible[0].sqrt());
    let motion = cubics.motion(admissible[0], [0.0, 1.0]).unwrap();
    for (pose, time) in poses.iter().zip([0.0, a, 1.0 - a, 1.0]) {
        assert!(apart(motion.pose(time), *pose) < 1e-9);
    }
}

#[test]
fn an_equation_that_says_nothing_is_refused() {
    // Three poses turn about one axis, the fourth screws against all of them: every product has a factor that vanishes.
    let poses = poses([
        ([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
        ([1.0, 0.0, 0.0, 0.4], [2.0, 1.0, 0.0]),
        ([1.0, 0.0, 0.0, 1.1], [4.0, -1.0, 0.0]),
        ([1.0, 0.2, 0.5, 0.3], [3.0, 2.0, 5.0]),
    ]);
    assert_eq!(CubicMotions::new(&poses).unwrap_err().reason(), "study-form-vanishes");
}
