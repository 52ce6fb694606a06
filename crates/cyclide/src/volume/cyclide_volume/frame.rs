//! The frame of a volume at its first corner (`docs/math/volumes.md#default-frame`).

use super::super::spherical_cube::SphericalCube;
use super::{CyclideVolume, FoldVerdict, corners_at_start, others};
use crate::base::quat::Quat;
use crate::base::svd3;
use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, NumberError, PatchError, Result};
use crate::surface::orthonormal;

/// Sides shorter than this part of the longest weigh no more than one of that: the nearest rotation keeps its digits.
const SHORTEST: f64 = 1e-8;
/// Directions are perpendicular and sides straight up to this angle and rounding.
const EXACT: f64 = 1e-9;
/// Rounding of the ends of a side, relative to the largest coordinate.
const SIDE_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The frame of a volume at its first corner.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let [v1, v2, v3] = CyclideVolume::new(&cube, VolumeFrame::Auto)?.moving_frame([0.0; 3]);
/// assert!((v1 - Vec3::X).length() + (v2 - Vec3::Y).length() + (v3 - Vec3::Z).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum VolumeFrame {
    /// The frame nearest to the three sides there, the more so the shorter they are: the sum of the cosines over the lengths is largest. As right- or
    /// left-handed as the sides. Another one that has a side's own direction is taken where it makes more sides straight, in one or two directions
    /// all four, and the block regular: a bend of straight sides and arcs has a corner at which its arcs do not run along their chords.
    #[default]
    Auto,
    /// The directions of growing s and t, perpendicular to each other and of any length; the third is their cross product, or against it
    /// where the third side is: see [`CyclideVolume::new`].
    First(Vec3, Vec3),
}

/// The frame at the first corner, orthonormal; of [`VolumeFrame::First`] with the cross product.
///
/// # Errors
/// As [`CyclideVolume::new`].
pub(in crate::volume) fn frame_at(cube: &SphericalCube, frame: VolumeFrame) -> Result<[Vec3; 3]> {
    match frame {
        VolumeFrame::First(v1, v2) => {
            for (index, v) in [v1, v2].into_iter().enumerate() {
                if !v.is_finite() {
                    return Err(NumberError::NotFinite { what: ErrorItem::FrameVector, index }.into());
                }
            }
            let (v1, v2) = orthonormal(v1, v2)?;
            Ok([v1, v2, v1.cross(v2)])
        }
        VolumeFrame::Auto => {
            let sides = Sides::new(cube)?;
            let nearest = sides.nearest_frame()?;
            let of_nearest = CyclideVolume::of_frame(cube, nearest).straight_directions();
            if of_nearest[0] == 3 {
                return Ok(nearest);
            }
            // The first of the best; none is better than the nearest one in general.
            let (mut best, mut most) = (nearest, of_nearest);
            for v in sides.exact_frames() {
                let volume = CyclideVolume::of_frame(cube, v);
                let straight = volume.straight_directions();
                if straight > most && volume.folds() == FoldVerdict::Regular && volume.checked().is_ok() {
                    (best, most) = (v, straight);
                }
            }
            Ok(best)
        }
    }
}

/// True if the third side at the first corner is against the third direction of [`VolumeFrame::First`]; a side of half a circle, perpendicular
/// to it, is not.
pub(in crate::volume) fn runs_against(cube: &SphericalCube, frame: VolumeFrame, v: [Vec3; 3]) -> bool {
    let corners = cube.corners();
    let side = corners[4] - corners[0];
    let limit = EXACT * side.length() + rounding(&corners.map(|p| p.to_vec()));
    matches!(frame, VolumeFrame::First(..)) && v[2].dot(side) < -limit
}

/// The three sides at the first corner.
struct Sides {
    /// Unit directions.
    e: [Vec3; 3],
    /// One over the length, in units of the longest.
    weights: [f64; 3],
    /// Up to which angle two of them are known.
    rounding: f64,
    /// -1 if they are left-handed.
    sense: f64,
}

impl Sides {
    fn new(cube: &SphericalCube) -> Result<Self> {
        let corners = cube.corners();
        let ways = [1, 2, 4].map(|k| corners[k] - corners[0]);
        let ambiguous = Error::Patch(PatchError::AmbiguousFrame { measured: 0.0, limit: svd3::UNIQUE });
        let [Some(a), Some(b), Some(c)] = ways.map(Vec3::unit) else { return Err(ambiguous) };
        let lengths = ways.map(Vec3::length);
        let [longest, shortest] =
            [lengths.into_iter().fold(0.0, f64::max), lengths.into_iter().fold(f64::MAX, f64::min)];
        Ok(Self {
            e: [a, b, c],
            weights: lengths.map(|length| longest / length.max(SHORTEST * longest)),
            rounding: rounding(&corners.map(|p| p.to_vec())) / shortest,
            sense: 1.0_f64.copysign(a.cross(b).dot(c)),
        })
    }

    /// A left-handed corner is the mirror image of a right-handed one: its third direction is turned round, and back.
    fn nearest_frame(&self) -> Result<[Vec3; 3]> {
        let Self { e: [a, b, c], weights: [k, l, m], sense, .. } = *self;
        let found = svd3::nearest_rotation([a * k, b * l, c * (m * sense)]);
        let [v1, v2, v3] =
            found.map_err(|measured| Error::Patch(PatchError::AmbiguousFrame { measured, limit: svd3::UNIQUE }))?;
        Ok([v1, v2, v3 * sense])
    }

    /// Frames with the directions of two sides that are perpendicular, then of one side, with the others as near as they can be.
    fn exact_frames(&self) -> Vec<[Vec3; 3]> {
        let pairs = (0..3).map(others).filter(|&[i, j]| self.e[i].dot(self.e[j]).abs() <= EXACT + self.rounding);
        let pairs = pairs.filter_map(|[i, j]| self.frame(i, j, self.e[j]));
        let singles = (0..3).filter_map(|i| {
            let [j, k] = others(i);
            // The third direction, turned about the first one to where the second is.
            let turned = self.e[k].cross(self.e[i]) * (self.sense * sign_of(j, k, i));
            self.frame(i, j, self.e[j] * self.weights[j] + turned * self.weights[k])
        });
        pairs.chain(singles).collect()
    }

    /// The frame with this side's direction, and another one as near to `across` as it can be.
    fn frame(&self, i: usize, j: usize, across: Vec3) -> Option<[Vec3; 3]> {
        let first = self.e[i];
        let second = (across - first * across.dot(first)).unit()?;
        let k = 3 - i - j;
        let mut v = [Vec3::ZERO; 3];
        (v[i], v[j]) = (first, second);
        v[k] = first.cross(second) * (self.sense * sign_of(i, j, k));
        Some(v)
    }
}

/// 1 for the cyclic orders of three directions, -1 for the others.
fn sign_of(i: usize, j: usize, k: usize) -> f64 {
    if (j + 3 - i) % 3 == 1 && (k + 3 - j) % 3 == 1 { 1.0 } else { -1.0 }
}

fn rounding(corners: &[Vec3; 8]) -> f64 {
    SIDE_ROUNDING * corners.iter().map(|p| p.max_abs()).fold(0.0, f64::max)
}

impl CyclideVolume {
    /// In how many of its directions all four sides are straight or points, and how many straight sides these have: a slice of a pie has two more
    /// than the wedge with straight sides over its corners.
    fn straight_directions(&self) -> [usize; 2] {
        let rounding = rounding(&self.corners.map(|p| p.to_vec()));
        let is_point = |axis: usize, start: usize| self.corners[start | 1 << axis] == self.corners[start];
        let is_straight = |axis: usize, start: usize| {
            let chord = self.corners[start | 1 << axis] - self.corners[start];
            let w = self.weights[start];
            // The direction of the side at its start, times |w|².
            let along = (w * Quat::from(self.v[axis]) * w.conj()).vector();
            let limit = EXACT * chord.length() + rounding;
            along.cross(chord).length() <= limit * w.norm_squared() && along.dot(chord) > 0.0
        };
        let straight_of = |axis: usize| {
            let sides = corners_at_start(axis).into_iter().filter(|start| !is_point(axis, *start));
            sides
                .map(|start| is_straight(axis, start).then_some(()))
                .collect::<Option<Vec<()>>>()
                .map(|sides| sides.len())
        };
        let counts: Vec<usize> = (0..3).filter_map(straight_of).collect();
        [counts.len(), counts.iter().sum()]
    }
}
