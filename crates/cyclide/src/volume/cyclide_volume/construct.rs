//! The volume of a spherical cube and a frame (`001`, (11); `docs/math/volumes.md#weights`).

use super::super::spherical_cube::SphericalCube;
use super::CyclideVolume;
use crate::base::quat::Quat;
use crate::base::svd3;
use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, Result};
use crate::surface::orthonormal;

/// The frame of a volume at its first corner.
///
/// ```
/// use cyclide::{CyclideVolume, Point3, SphericalCube, Vec3, VolumeFrame};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let [v1, v2, v3] = CyclideVolume::new(&cube, VolumeFrame::Auto)?.moving_frame([0.0; 3]);
/// assert!((v1 - Vec3::X).length() + (v2 - Vec3::Y).length() + (v3 - Vec3::Z).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum VolumeFrame {
    /// The frame nearest to the directions of the three sides there (least squares of the angles' sines and cosines), as right- or
    /// left-handed as they are.
    #[default]
    Auto,
    /// The directions of growing s and t, perpendicular to each other and of any length; the third is their cross product.
    First(Vec3, Vec3),
}

impl CyclideVolume {
    /// The volume of a spherical cube and a frame at its first corner. Whether it folds is told by [`folds`](Self::folds).
    ///
    /// # Errors
    /// `not-finite`, `frame-not-orthonormal`; `ambiguous-frame` if the sides at the first corner give none for [`VolumeFrame::Auto`];
    /// `crossing-face` if a face crosses itself, `volume-through-infinity`.
    pub fn new(cube: &SphericalCube, frame: VolumeFrame) -> Result<Self> {
        let volume = Self::unbounded(cube, frame)?;
        volume.check_no_pole()?;
        Ok(volume)
    }

    /// As [`new`](Self::new), also if the volume passes through infinity: there it has no points.
    ///
    /// # Errors
    /// As [`new`](Self::new), but for `volume-through-infinity`.
    pub fn unbounded(cube: &SphericalCube, frame: VolumeFrame) -> Result<Self> {
        let volume = Self::of_frame(cube, frame)?;
        volume.check_sides()?;
        Ok(volume)
    }

    fn of_frame(cube: &SphericalCube, frame: VolumeFrame) -> Result<Self> {
        let v = frame_at(cube, frame)?;
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
        Ok(Self::from_weights_unchecked(corners, weights, v))
    }

    /// Refuses a volume of which a side runs backwards: the two faces that share it cross themselves.
    pub(in crate::volume) fn check_sides(&self) -> Result<()> {
        for axis in 0..3 {
            let q = &self.speeds[axis];
            for [i, j] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let (speed, limit) = (q[2 * i][2 * j], -self.speed_rounding());
                if speed < limit {
                    return Err(Error::CrossingFace { axis, at: [i as f64, j as f64], speed, limit });
                }
            }
        }
        Ok(())
    }
}

/// The frame at the first corner, orthonormal.
///
/// # Errors
/// As [`CyclideVolume::new`].
pub(in crate::volume) fn frame_at(cube: &SphericalCube, frame: VolumeFrame) -> Result<[Vec3; 3]> {
    match frame {
        VolumeFrame::First(v1, v2) => {
            for (index, v) in [v1, v2].into_iter().enumerate() {
                if !v.is_finite() {
                    return Err(Error::NotFinite { what: ErrorItem::FrameVector, index });
                }
            }
            let (v1, v2) = orthonormal(v1, v2)?;
            Ok([v1, v2, v1.cross(v2)])
        }
        VolumeFrame::Auto => nearest_frame(cube),
    }
}

/// The orthonormal frame nearest to the directions of the sides at the first corner.
fn nearest_frame(cube: &SphericalCube) -> Result<[Vec3; 3]> {
    let corners = cube.corners();
    let ambiguous = |measured| Error::AmbiguousFrame { measured, limit: svd3::UNIQUE };
    let side = |k: usize| (corners[k] - corners[0]).unit().ok_or_else(|| ambiguous(0.0));
    let [a, b, c] = [side(1)?, side(2)?, side(4)?];
    // A left-handed corner is the mirror image of a right-handed one: its third direction is turned round, and back.
    let sense = 1.0_f64.copysign(a.cross(b).dot(c));
    let [v1, v2, v3] = svd3::nearest_rotation([a, b, c * sense]).map_err(ambiguous)?;
    Ok([v1, v2, v3 * sense])
}
