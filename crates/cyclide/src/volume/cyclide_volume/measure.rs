//! Volume, centroid and surface by quadrature, with error control by halving.

use super::CyclideVolume;
use crate::base::quadrature::{unit_rule4, unit_rule8};
use crate::base::vector::{Point3, Vec3};
use crate::volume::ParamVolume as _;

/// Two rules agree to this part of the largest cell's integral: the better one, exact for twice the degree, is better by orders of magnitude.
const AGREEMENT: f64 = 1e-8;
/// Cells at most: a block that folds has a kink along which halving never ends.
const CELLS: usize = 256;

/// Measures of a volume.
///
/// ```
/// use cyclide::{CyclideVolume, Point3, SphericalCube, Vec3, VolumeFrame};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y * 2.0, Vec3::Z])?;
/// let measure = CyclideVolume::new(&cube, VolumeFrame::Auto)?.measure();
/// assert!((measure.volume - 2.0).abs() < 1e-14 && measure.centroid.distance(Point3::new(0.5, 1.0, 0.5)) < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeMeasure {
    /// The integral of the Jacobian's size: the volume of a block without folds.
    pub volume: f64,
    /// The centroid.
    pub centroid: Point3,
    /// How far the last two rules disagree, a volume: the better one is off by far less.
    pub error: f64,
}

impl CyclideVolume {
    /// Volume and centroid by Gauss rules of 8 x 8 x 8 places, on parts where that of 4 x 4 x 4 does not agree, to about 1e-12 of the
    /// volume. Its [faces](Self::faces) give the area of its surface.
    #[must_use]
    pub fn measure(&self) -> VolumeMeasure {
        let mut open = vec![([0.0; 3], 1.0)];
        let (mut sum, mut error, mut cells) = ([0.0; 4], 0.0, 1);
        let mut whole = 0.0;
        while let Some((from, size)) = open.pop() {
            let fine = self.moments(&unit_rule8(), from, size);
            let off = (fine[0] - self.moments(&unit_rule4(), from, size)[0]).abs();
            whole = fine[0].max(whole);
            if off > AGREEMENT * whole && cells + 8 <= CELLS {
                cells += 8;
                open.extend((0..8).map(|octant| (super::pole::at_octant(from, 0.5 * size, octant), 0.5 * size)));
            } else {
                sum = std::array::from_fn(|k| sum[k] + fine[k]);
                error += off;
            }
        }
        let way = Vec3::new(sum[1], sum[2], sum[3]) / if sum[0] > 0.0 { sum[0] } else { 1.0 };
        VolumeMeasure { volume: sum[0], centroid: self.corners[0] + way, error }
    }

    /// Volume and first moments about the first corner of a cube of parameters.
    fn moments(&self, rule: &[(f64, f64)], from: [f64; 3], size: f64) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for &(x, wx) in rule {
            for &(y, wy) in rule {
                for &(z, wz) in rule {
                    let at = [from[0] + size * x, from[1] + size * y, from[2] + size * z];
                    let element = self.jacobian(at).abs() * wx * wy * wz * size * size * size;
                    let way = self.point(at) - self.corners[0];
                    let terms = [element, element * way.x, element * way.y, element * way.z];
                    sum = std::array::from_fn(|k| sum[k] + terms[k]);
                }
            }
        }
        sum
    }
}
