//! Volume and centroid by quadrature, the worst part halved first.

use super::{CyclideVolume, corners_at_start};
use crate::base::quadrature::{unit_rule4, unit_rule8};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Two rules agree to this part of the volume: the better one, exact for twice the degree, is better by orders of magnitude.
const AGREEMENT: f64 = 1e-8;
/// Parts at most: a corner near infinity takes some fifty for each power of two of its distance.
const PARTS: usize = 4096;
/// What the rules still disagree by, as part of the volume, beyond which it is not known: reports show five digits.
const UNKNOWN: f64 = 1e-6;
/// Least product of two corners' denominators, relative to the largest, in a part that rules of eight places do not miss a peak of.
const WILD: f64 = 0.0625;

/// Measures of a volume.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y * 2.0, Vec3::Z])?;
/// let measure = CyclideVolume::new(&cube, VolumeFrame::Auto)?.measure();
/// assert!((measure.volume - 2.0).abs() < 1e-14 && measure.centroid.distance(Point3::new(0.5, 1.0, 0.5)) < 1e-14);
/// assert!(measure.known().is_ok());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeMeasure {
    /// The integral of the Jacobian, positive whatever the handedness: of a block that folds, what its parts that run backwards cover is
    /// subtracted, as in the [solid](CyclideVolume::to_body) of its faces.
    pub volume: f64,
    /// The centroid.
    pub centroid: Point3,
    /// How far the last two rules disagree, a volume: the better one is off by far less. Infinite if parts that come near infinity are left.
    pub error: f64,
}

impl VolumeMeasure {
    /// The measures, if they are known to a millionth of the volume at least.
    ///
    /// # Errors
    /// `too-many-pieces`; `parameter-out-of-range` beyond 1.8e308.
    pub fn known(self) -> Result<Self> {
        // Not `>`: what is no number is not known, nor is infinity.
        if self.volume.is_finite() && self.error <= UNKNOWN * self.volume.abs() {
            return Ok(self);
        }
        // The cube of a large size, which no quadrature makes smaller.
        if !self.volume.is_finite() && self.error.is_nan() {
            let (min, max) = (0.0, 1e308);
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Volume, value: self.volume, min, max }.into()
            );
        }
        let (what, remedy) =
            ("a volume by quadrature", "the block comes near infinity, or what its folds cover cancels itself");
        Err(NumberError::TooManyPieces { what, segment: None, needed: f64::INFINITY, cap: PARTS, remedy }.into())
    }
}

impl CyclideVolume {
    /// Volume and centroid by Gauss rules of 8 x 8 x 8 places on the whole or, where rules of 4 do not agree, on halves of the worst part, to about
    /// 1e-12 of the volume. Parts that come near infinity are halved whatever the rules say: a peak may be between their places. Work is
    /// bounded: what it leaves unknown is [told](VolumeMeasure::known). Its [faces](Self::faces) give the area of its surface.
    #[must_use]
    pub fn measure(&self) -> VolumeMeasure {
        let mut parts = BinaryHeap::from([Part::new(self, [0.0; 3], [1.0; 3])]);
        let [mut volume, mut error] = sums(&parts);
        loop {
            let is_good = |volume: f64, error: f64| {
                error <= AGREEMENT * volume.abs() && parts.peek().is_some_and(|part| !part.is_wild)
            };
            let is_last = parts.len() >= PARTS;
            if is_last || is_good(volume, error) {
                // Running sums keep the rounding of peaks that came and went.
                [volume, error] = sums(&parts);
                if is_last || is_good(volume, error) {
                    break;
                }
            }
            let Some(worst) = parts.pop() else { break };
            (volume, error) = (volume - worst.moments[0], error - worst.error);
            for half in worst.halves(self) {
                (volume, error) = (volume + half.moments[0], error + half.error);
                parts.push(half);
            }
        }
        if parts.peek().is_some_and(|part| part.is_wild) {
            error = f64::INFINITY;
        }
        let sum = parts.iter().fold([0.0; 4], |sum, part| std::array::from_fn(|k| sum[k] + part.moments[k]));
        let way = Vec3::new(sum[1], sum[2], sum[3]) / if volume == 0.0 { 1.0 } else { volume };
        VolumeMeasure { volume, centroid: self.corners[0] + way, error }
    }

    /// Volume and first moments about the first corner of a box of parameters.
    fn moments(&self, rule: &[(f64, f64)], from: [f64; 3], size: [f64; 3]) -> [f64; 4] {
        let mut sum = [0.0; 4];
        let whole = size.into_iter().product::<f64>() * self.handedness();
        for &(x, wx) in rule {
            for &(y, wy) in rule {
                for &(z, wz) in rule {
                    let at = [from[0] + size[0] * x, from[1] + size[1] * y, from[2] + size[2] * z];
                    let d = self.denominator(at);
                    let element = self.jacobian_of(self.speeds_at(at), d.norm_squared()) * wx * wy * wz * whole;
                    let way = self.quotient(at, d) - self.corners[0];
                    let terms = [element, element * way.x, element * way.y, element * way.z];
                    sum = std::array::from_fn(|k| sum[k] + terms[k]);
                }
            }
        }
        sum
    }
}

/// Of all parts, added one by one: the volume and the error.
fn sums(parts: &BinaryHeap<Part>) -> [f64; 2] {
    parts.iter().fold([0.0; 2], |[volume, error], part| [volume + part.moments[0], error + part.error])
}

/// A box of parameters.
struct Part {
    from: [f64; 3],
    size: [f64; 3],
    moments: [f64; 4],
    error: f64,
    is_wild: bool,
    /// The direction in which the denominator varies most: what is integrated are polynomials over powers of it.
    axis: usize,
}

impl Part {
    fn new(volume: &CyclideVolume, from: [f64; 3], size: [f64; 3]) -> Self {
        let corner = |k: usize| std::array::from_fn(|axis| from[axis] + size[axis] * (k >> axis & 1) as f64);
        let d: [Quat; 8] = std::array::from_fn(|k| volume.denominator(corner(k)));
        let largest = d.iter().map(|d| d.norm_squared()).fold(0.0, f64::max);
        let is_wild = (0..8).any(|i| (0..i).any(|j| d[i].dot(d[j]) < WILD * largest));
        let change = |axis: usize| -> f64 {
            corners_at_start(axis).into_iter().map(|k| (d[k | 1 << axis] - d[k]).norm_squared()).fold(0.0, f64::max)
        };
        let axis = (0..3).max_by(|&x, &y| change(x).total_cmp(&change(y))).unwrap_or(0);
        let moments = volume.moments(&unit_rule8(), from, size);
        let error = (moments[0] - volume.moments(&unit_rule4(), from, size)[0]).abs();
        Self { from, size, moments, error, is_wild, axis }
    }

    fn halves(&self, volume: &CyclideVolume) -> [Self; 2] {
        let mut size = self.size;
        size[self.axis] *= 0.5;
        let mut middle = self.from;
        middle[self.axis] += size[self.axis];
        [self.from, middle].map(|from| Self::new(volume, from, size))
    }
}

/// The wild ones first, then by error.
impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.is_wild.cmp(&other.is_wild).then(self.error.total_cmp(&other.error))
    }
}
impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Part {}
