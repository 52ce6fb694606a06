//! Motions of degree 3 take all four poses, and are on the quadric.

use crate::data::{apart, pose};
use cyclide::CubicMotions;
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
                // On the quadric itself, not only on its fibres: with no more than the rounding of a double root.
                prop_assert!(d.study_product().abs() < 1e-6 * d.real.norm() * (d.dual.norm() + d.real.norm()));
            }
        }
    }
}
