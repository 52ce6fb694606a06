//! The volume of a spherical cube and a frame (`001`, (11); `docs/math/volumes.md#weights`).

use super::super::spherical_cube::SphericalCube;
use super::frame::{VolumeFrame, frame_at, runs_against};
use super::{CyclideVolume, FoldVerdict};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::error::{Result, VolumeError};

impl CyclideVolume {
    /// The volume of a spherical cube and a frame at its first corner. Whether it folds is told by [`folds`](Self::folds). Where the third side at
    /// the first corner runs against the third direction of [`VolumeFrame::First`] this is turned round, unless the volume would be refused then, or
    /// fold: left-handed corners with the directions of two sides are those of a left-handed block.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
    /// let mirrored = SphericalCube::cuboid(Point3::ORIGIN, [-Vec3::X, Vec3::Y, Vec3::Z])?;
    /// let block = CyclideVolume::new(&mirrored, VolumeFrame::First(-Vec3::X, Vec3::Y))?;
    /// assert!(!block.is_right_handed() && (block.measure().volume - 1.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `frame-not-orthonormal`; `ambiguous-frame` if the sides at the first corner give none for [`VolumeFrame::Auto`];
    /// `crossing-face` if a face crosses itself, `volume-through-infinity`.
    pub fn new(cube: &SphericalCube, frame: VolumeFrame) -> Result<Self> {
        let v = frame_at(cube, frame)?;
        let given = Self::of_frame(cube, v).checked();
        if !runs_against(cube, frame, v) {
            return given;
        }
        let is_regular = |volume: &Self| volume.folds() == FoldVerdict::Regular;
        match Self::of_frame(cube, [v[0], v[1], -v[2]]).checked() {
            Ok(turned) if is_regular(&turned) || !given.as_ref().is_ok_and(is_regular) => Ok(turned),
            _ => given,
        }
    }

    /// The volume, unless it is refused.
    pub(super) fn checked(self) -> Result<Self> {
        self.check_sides()?;
        self.check_no_pole()?;
        Ok(self)
    }

    /// As [`new`](Self::new), also if the volume passes through infinity: there it has no points. The third direction of
    /// [`VolumeFrame::First`] is the cross product always.
    ///
    /// # Errors
    /// As [`new`](Self::new), but for `volume-through-infinity`.
    pub fn unbounded(cube: &SphericalCube, frame: VolumeFrame) -> Result<Self> {
        let volume = Self::of_frame(cube, frame_at(cube, frame)?);
        volume.check_sides()?;
        Ok(volume)
    }

    /// The volume of a cube and an orthonormal frame, which may fold, pass through infinity or have sides that run backwards.
    pub(super) fn of_frame(cube: &SphericalCube, v: [Vec3; 3]) -> Self {
        let (b, last) = cube.inverted();
        let q = Quat::from;
        let [v1, v2, v3] = v.map(Quat::from);
        // Of a left-handed frame V1 V2 = -V3: it is the right-handed one of the cube whose first two directions are exchanged.
        let sense = 1.0_f64.copysign(v[0].cross(v[1]).dot(v[2]));
        let [_, b1, b2, b12, b3, b13, b23] = *b;
        let weights = [
            Quat::ONE,
            q(b1) * v1,
            q(b2) * v2,
            q(b12) * q(b1 - b2) * v3 * sense,
            q(b3) * v3,
            q(b13) * q(b3 - b1) * v2 * sense,
            q(b23) * q(b2 - b3) * v1 * sense,
            last[1] * sense,
        ];
        let corners = cube.corners();
        // The norms of the paper: the lengths of the sides at the first corner, in units of the scale.
        let lengths = [1, 2, 4].map(|k| corners[0].distance(corners[k]) / cube.scale());
        let factor = |k: usize| (0..3).filter(|axis| k >> axis & 1 == 1).map(|axis| lengths[axis]).product::<f64>();
        let weights = std::array::from_fn(|k| weights[k] * factor(k));
        Self::from_weights_unchecked(corners, weights, v)
    }

    /// Refuses a volume of which a side runs backwards: the two faces that share it cross themselves.
    pub(in crate::volume) fn check_sides(&self) -> Result<()> {
        for axis in 0..3 {
            let q = &self.speeds[axis];
            for [i, j] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let (speed, limit) = (q[2 * i][2 * j], -self.rounding);
                if speed < limit {
                    return Err(VolumeError::CrossingFace { axis, at: [i as f64, j as f64], speed, limit }.into());
                }
            }
        }
        Ok(())
    }
}
