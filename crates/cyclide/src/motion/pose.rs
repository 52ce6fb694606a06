//! Poses: where a body is, and how it is turned.

use super::dual_quat::DualQuat;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, PoseError, Result};

/// Entries of a matrix may be off those of a rotation by this much: they are often written with six digits.
const NOT_A_ROTATION: f64 = 1e-5;
/// Steps to the nearest rotation: what is off by 0.1 is by 1e-2 after the first, 1e-4, 1e-8, and then by rounding.
const POLAR_STEPS: usize = 4;

/// A place and an orientation of a body: the displacement `x ↦ q x q⁻¹ + τ` from the body's frame to the world.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, motion::Pose};
/// let pose = Pose::new(Quat::new(1.0, 0.0, 0.0, 1.0), Vec3::new(2.0, 0.0, 0.0))?; // a quarter about z, and moved
/// assert!(pose.apply(Point3::new(1.0, 0.0, 0.0)).distance(Point3::new(2.0, 1.0, 0.0)) < 1e-15);
/// let back = pose.inverse().after(pose);
/// assert!(back.translation().length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Of length 1.
    rotation: Quat,
    translation: Vec3,
}

impl Pose {
    /// The pose of a body that lies as it was drawn.
    pub const IDENTITY: Self = Self { rotation: Quat::ONE, translation: Vec3::ZERO };

    /// From a rotation, of any length but zero, and the place of the body's origin.
    ///
    /// # Errors
    /// `not-finite`, `zero-rotation`.
    pub fn new(rotation: Quat, translation: Vec3) -> Result<Self> {
        if !rotation.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Rotation, index: 0 }.into());
        }
        if !translation.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Translation, index: 0 }.into());
        }
        // By the largest coefficient first: squares and sums of others may under- or overflow.
        let largest = rotation.to_array().into_iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        if largest == 0.0 {
            return Err(PoseError::ZeroRotation { index: 0 }.into());
        }
        let near_one = Quat::from(rotation.to_array().map(|v| v / largest));
        Ok(Self::of_unit(near_one * (1.0 / near_one.norm()), translation))
    }

    /// As [`new`](Self::new) of a rotation of length 1.
    pub(super) const fn of_unit(rotation: Quat, translation: Vec3) -> Self {
        Self { rotation, translation }
    }

    /// From the rows of a matrix `[R τ; 0 0 0 1]` that is multiplied by columns of points.
    ///
    /// ```
    /// use cyclide::{Vec3, motion::Pose};
    /// let pose = Pose::from_matrix([[0.0, -1.0, 0.0, 5.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])?;
    /// assert_eq!(pose.translation(), Vec3::new(5.0, 0.0, 0.0));
    /// assert!((pose.rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`; `not-a-rotation` if the left upper part is not orthonormal and right-handed to 1e-5, or the last row is not
    /// `0 0 0 1`.
    pub fn from_matrix(rows: [[f64; 4]; 4]) -> Result<Self> {
        Self::nearest_to_matrix(rows, NOT_A_ROTATION).map(|(pose, _)| pose)
    }

    /// As [`from_matrix`](Self::from_matrix), to another limit than 1e-5: the pose with the nearest rotation, and by how much the matrix is off one.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, motion::Pose};
    /// // A turn by 30 degrees, with two decimals.
    /// let rows = [[0.87, -0.5, 0.0, 5.0], [0.5, 0.87, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    /// assert_eq!(Pose::from_matrix(rows).unwrap_err().reason(), "not-a-rotation");
    /// let (pose, off) = Pose::nearest_to_matrix(rows, 1e-2)?;
    /// assert!((0.006..0.007).contains(&off)); // of the determinant
    /// let meant = Pose::new(Quat::from_axis_angle(Vec3::Z, 30_f64.to_radians()), Vec3::ZERO)?;
    /// assert!(pose.angle_to(meant) < 2e-3);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `not-a-rotation`.
    pub fn nearest_to_matrix(rows: [[f64; 4]; 4], limit: f64) -> Result<(Self, f64)> {
        if let Some(index) = rows.iter().flatten().position(|v| !v.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::MatrixEntry, index }.into());
        }
        let column = |j: usize| Vec3::new(rows[0][j], rows[1][j], rows[2][j]);
        let axes = [column(0), column(1), column(2)];
        let last: [f64; 4] = std::array::from_fn(|j| rows[3][j] - f64::from(u8::from(j == 3)));
        let off = off_rotation(axes).max(last.into_iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        if off.is_nan() || off > limit {
            return Err(PoseError::NotARotation { off, limit }.into());
        }
        Self::new(rotation_of_axes(nearest_axes(axes)), column(3)).map(|pose| (pose, off))
    }

    /// The rows of the matrix `[R τ; 0 0 0 1]`.
    #[must_use]
    pub fn to_matrix(self) -> [[f64; 4]; 4] {
        let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| self.rotation.rotate(axis).to_array());
        let t = self.translation.to_array();
        let row = |i: usize| [x[i], y[i], z[i], t[i]];
        [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
    }

    /// From a place and the angles of roll, pitch and yaw in radians: turned about the fixed axes x by `roll`, then y by `pitch`,
    /// then z by `yaw` (the same as about the moved axes z, y', x'').
    ///
    /// ```
    /// use cyclide::{Vec3, motion::Pose};
    /// let half_pi = std::f64::consts::FRAC_PI_2;
    /// let pose = Pose::from_roll_pitch_yaw(Vec3::ZERO, [half_pi, 0.0, half_pi])?;
    /// assert!((pose.rotation().rotate(Vec3::Y) - Vec3::Z).length() < 1e-15); // y to z by the roll, where the yaw keeps it
    /// assert!((pose.rotation().rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`.
    pub fn from_roll_pitch_yaw(translation: Vec3, angles: [f64; 3]) -> Result<Self> {
        if let Some(index) = angles.iter().position(|a| !a.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index }.into());
        }
        let [roll, pitch, yaw] = angles;
        let turn = |axis: Vec3, angle: f64| Quat::from_axis_angle(axis, angle);
        Self::new(turn(Vec3::Z, yaw) * turn(Vec3::Y, pitch) * turn(Vec3::X, roll), translation)
    }

    /// The rotation, of length 1. Its negative is the same rotation.
    #[must_use]
    pub fn rotation(self) -> Quat {
        self.rotation
    }

    /// The place of the body's origin.
    #[must_use]
    pub fn translation(self) -> Vec3 {
        self.translation
    }

    /// Where a point of the body is.
    #[must_use]
    pub fn apply(self, point: Point3) -> Point3 {
        Point3::ORIGIN + self.rotation.rotate(point.to_vec()) + self.translation
    }

    /// This displacement after another one.
    #[must_use]
    pub fn after(self, first: Self) -> Self {
        let rotation = self.rotation * first.rotation;
        Self::of_unit(rotation * (1.0 / rotation.norm()), self.rotation.rotate(first.translation) + self.translation)
    }

    /// The displacement back.
    #[must_use]
    pub fn inverse(self) -> Self {
        let back = self.rotation.conj();
        Self::of_unit(back, -back.rotate(self.translation))
    }

    /// The angle of the turn from this pose to another, from 0 to π.
    #[must_use]
    pub fn angle_to(self, other: Self) -> f64 {
        let relative = self.rotation.conj() * other.rotation;
        2.0 * relative.vector().length().atan2(relative.w.abs())
    }

    /// `q + ε ½ τ q`.
    #[must_use]
    pub fn dual_quat(self) -> DualQuat {
        DualQuat::from_rotation_translation(self.rotation, self.translation)
    }
}

/// How far three columns are from those of a rotation.
fn off_rotation([x, y, z]: [Vec3; 3]) -> f64 {
    let lengths = [x, y, z].map(|v| (v.length() - 1.0).abs());
    let angles = [x.dot(y).abs(), y.dot(z).abs(), z.dot(x).abs(), (x.cross(y).dot(z) - 1.0).abs()];
    lengths.into_iter().chain(angles).fold(0.0, f64::max)
}

/// The columns of the rotation that is nearest to that of these columns: the orthogonal factor `U` of `A = U H`, by Newton's steps `(A + A⁻ᵀ)/2`, which
/// square what is off (N. J. Higham, SIAM J. Sci. Stat. Comput. 7 (1986), 1160-1174).
fn nearest_axes(mut axes: [Vec3; 3]) -> [Vec3; 3] {
    for _ in 0..POLAR_STEPS {
        let [x, y, z] = axes;
        let determinant = x.cross(y).dot(z);
        // The columns of the inverse transposed.
        let dual = [y.cross(z), z.cross(x), x.cross(y)].map(|v| v / determinant);
        axes = std::array::from_fn(|k| (axes[k] + dual[k]) * 0.5);
    }
    axes
}

/// The rotation whose columns these are, nearly: the row of `q qᵀ` with the largest entry on its diagonal.
fn rotation_of_axes([x, y, z]: [Vec3; 3]) -> Quat {
    let [a, b, c] = [x.x, y.y, z.z];
    let rows = [
        Quat::new(1.0 + a + b + c, y.z - z.y, z.x - x.z, x.y - y.x),
        Quat::new(y.z - z.y, 1.0 + a - b - c, x.y + y.x, z.x + x.z),
        Quat::new(z.x - x.z, x.y + y.x, 1.0 - a + b - c, y.z + z.y),
        Quat::new(x.y - y.x, z.x + x.z, y.z + z.y, 1.0 - a - b + c),
    ];
    rows.into_iter().max_by(|p, q| p.norm_squared().total_cmp(&q.norm_squared())).unwrap_or(Quat::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_go_there_and_back() {
        for q in [
            [1.0, 2.0, -0.5, 0.3],
            [0.0, 0.0, 0.0, 1.0],
            [0.0, 1.0, 0.0, 0.0],
            [1e-9, 0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0, 0.0],
        ] {
            let pose = Pose::new(Quat::from(q), Vec3::new(1.0, -2.0, 3.0)).unwrap();
            let back = Pose::from_matrix(pose.to_matrix()).unwrap();
            assert!(pose.angle_to(back) < 4e-16, "{q:?}");
            assert_eq!(back.translation(), pose.translation());
        }
        let mirror = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        assert_eq!(Pose::from_matrix(mirror).unwrap_err().reason(), "not-a-rotation");
    }

    #[test]
    fn rotations_of_any_length_are_taken() {
        for s in [1e-310, 1e-200, 1.0, 1e200, 1e308] {
            let pose = Pose::new(Quat::new(s, 0.0, 0.0, s), Vec3::ZERO).unwrap();
            assert!((pose.rotation().norm() - 1.0).abs() < 1e-15, "{s:e}");
        }
        assert_eq!(Pose::new(Quat::ZERO, Vec3::ZERO).unwrap_err().reason(), "zero-rotation");
    }
}
