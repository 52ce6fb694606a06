//! A point of a volume with its derivatives, and what follows from them alone.

use super::vector::{Point3, Vec3};

/// A point of a volume with its first and second partial derivatives by the parameters s, t, u.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z])?;
/// let block = CyclideVolume::new(&cube, VolumeFrame::First(Vec3::new(1.0, 0.2, 0.0), Vec3::new(-0.2, 1.0, 0.0)))?;
/// let jet = block.jet([0.3, 0.6, 0.9]);
/// assert!(jet.orthogonality() < 1e-14 && jet.jacobian() > 0.0); // the parameter lines cross at right angles
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct VolumeJet {
    /// The point.
    pub point: Point3,
    /// Derivatives by s, t and u.
    pub first: [Vec3; 3],
    /// Second derivatives by ss, st, su, tt, tu, uu.
    pub second: [Vec3; 6],
}

impl VolumeJet {
    /// Determinant of the first derivatives, a volume: negative where the block is left-handed or folded.
    #[must_use]
    pub fn jacobian(&self) -> f64 {
        let [a, b, c] = self.first;
        a.cross(b).dot(c)
    }

    /// The Jacobian over the product of the lengths of the derivatives: 1 for a right-handed rectangular cell, 0 where one of them vanishes.
    #[must_use]
    pub fn scaled_jacobian(&self) -> f64 {
        let Some([a, b, c]) = self.directions() else { return 0.0 };
        a.cross(b).dot(c)
    }

    /// Largest cosine between two parameter lines: 0 for orthogonal coordinates. 0 also where a derivative vanishes.
    #[must_use]
    pub fn orthogonality(&self) -> f64 {
        let Some([a, b, c]) = self.directions() else { return 0.0 };
        a.dot(b).abs().max(a.dot(c).abs()).max(b.dot(c).abs())
    }

    fn directions(&self) -> Option<[Vec3; 3]> {
        let [a, b, c] = self.first;
        Some([a.unit()?, b.unit()?, c.unit()?])
    }
}
