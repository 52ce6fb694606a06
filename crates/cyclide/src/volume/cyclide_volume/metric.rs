//! What is measured of a volume at many places: first derivatives and what follows from them, at a third of the cost of a jet.

use super::{CyclideVolume, trilinear};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::base::volume_jet::VolumeJet;

/// A place of a volume without its point and second derivatives.
///
/// ```
/// use cyclide::{Point3, volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
/// let block = CyclideVolume::new(&SphericalCube::from_barycentric(corners, [1.0; 3], 0.5)?, VolumeFrame::Auto)?;
/// let (metric, jet) = (block.metric([0.2, 0.5, 0.8]), block.jet([0.2, 0.5, 0.8]));
/// assert!(metric.first == jet.first && metric.orthogonality() == jet.orthogonality());
/// assert_eq!(metric.jacobian, block.jacobian([0.2, 0.5, 0.8]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeMetric {
    /// Derivatives by s, t and u, as of the [jet](crate::volume::ParamVolume::jet).
    pub first: [Vec3; 3],
    /// As [`ParamVolume::jacobian`](crate::volume::ParamVolume::jacobian).
    pub jacobian: f64,
    /// As [`CyclideVolume::real_residual`].
    pub residual: f64,
    /// As [`CyclideVolume::standing_lines`].
    pub standing: [bool; 3],
}

impl VolumeMetric {
    /// As [`VolumeJet::orthogonality`].
    #[must_use]
    pub fn orthogonality(&self) -> f64 {
        self.jet().orthogonality()
    }

    /// The determinant of the first derivatives, as [`VolumeJet::jacobian`]: that of the volume up to rounding.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        self.jet().jacobian()
    }

    fn jet(&self) -> VolumeJet {
        VolumeJet { first: self.first, ..VolumeJet::default() }
    }
}

impl CyclideVolume {
    /// First derivatives at a place and what follows from them, the same numbers as those of the functions for each alone.
    #[must_use]
    pub fn metric(&self, at: [f64; 3]) -> VolumeMetric {
        let d = self.denominator(at);
        let squared = d.norm_squared();
        let speeds = self.speeds_at(at);
        VolumeMetric {
            first: std::array::from_fn(|k| self.turned(k, d, squared) * speeds[k]),
            jacobian: self.jacobian_of(speeds, squared),
            residual: (trilinear(&self.n, at) * d.conj()).w.abs() * (self.scale / squared),
            standing: speeds.map(|speed| speed.abs() <= self.rounding),
        }
    }

    /// `D V ~D/|D|⁴` of a direction.
    pub(super) fn turned(&self, axis: usize, d: Quat, squared: f64) -> Vec3 {
        (d * Quat::from(self.v[axis]) * d.conj()).vector() / (squared * squared)
    }

    /// `q1 q2 q3/|D|⁶`, with the handedness of the frame.
    pub(super) fn jacobian_of(&self, speeds: [f64; 3], squared: f64) -> f64 {
        speeds.into_iter().map(|q| q / squared).product::<f64>() * self.handedness()
    }
}
