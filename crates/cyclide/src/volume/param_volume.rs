//! The trait every volume implements.

use crate::base::vector::Point3;
use crate::base::volume_jet::VolumeJet;

/// A smooth parametric volume over `[0, 1]³`. Object-safe; one method is required.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z * 2.0])?;
/// let block = CyclideVolume::new(&cube, VolumeFrame::Auto)?;
/// let volume: &dyn ParamVolume = &block;
/// assert!(volume.point([0.5, 0.5, 0.5]).distance(Point3::new(0.5, 0.5, 1.0)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
pub trait ParamVolume: Send + Sync {
    /// Point and partial derivatives of orders 1 and 2 at `[s, t, u]`.
    fn jet(&self, at: [f64; 3]) -> VolumeJet;

    /// The point at `[s, t, u]`; override where it is cheaper than a jet.
    fn point(&self, at: [f64; 3]) -> Point3 {
        self.jet(at).point
    }

    /// Determinant of the first derivatives at `[s, t, u]`; override where there is a closed form.
    fn jacobian(&self, at: [f64; 3]) -> f64 {
        self.jet(at).jacobian()
    }
}
