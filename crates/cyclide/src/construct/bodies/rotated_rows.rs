//! Rotations of points in homogeneous rows.

use crate::base::quat::Quat;
use crate::base::vector::Vec3;

/// What a rotation by a rotor of length 1 makes of a vector along the way, in homogeneous rows of weights `1, w, 1`.
pub(super) fn rotated_rows(rotor: Quat, y: Vec3) -> [Vec3; 3] {
    let p = rotor.vector();
    let half = y * rotor.w + p.cross(y);
    [y, half, y + p.cross(half) * 2.0]
}
