//! The patch from four concircular corners and a frame (`docs/math/patches.md#weights`).

use super::corner_circle::{CornerCircle, corner_circle, distinct};
use super::pole::check_no_pole;
use super::{CyclidePatch, largest_distance};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ArcError, Error, ErrorItem, NumberError, PatchError, PointError, Result};

/// Largest distance from three-space that counts as rounding of weights, relative to the size.
const SPACE_LIMIT: f64 = 1e-9;
/// Rounding of a corner by itself and by the map it comes from, relative to its coordinates.
const CORNER_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Largest cosine between the directions of a frame.
const FRAME_LIMIT: f64 = 1e-9;

impl CyclidePatch {
    /// The patch with the given corners and the directions `v1` (of growing s) and `v2` (of growing t) at the first
    /// corner, perpendicular to each other and of any length. Corners in binary order `a0` (0,0), `a1` (1,0), `a2` (0,1), `a3` (1,1); they must be concircular (or
    /// collinear) in the cyclic order a0, a1, a3, a2, both to 1e-9 of the largest distance and the rounding of their
    /// coordinates; a3 is moved onto the circle of the others, and to a1 or a2 if it is beyond that by no more.
    /// `a3 = a1` or `a3 = a2` is legal (a triangular patch with a pole). Weights are those of `001`, (9), by form C
    /// (`docs/math/patches.md#weights`), which has the right sign in every order. Every frame direction is admissible;
    /// whether a parameter line shrinks to a point inside is told by [`singular_s`](Self::singular_s) and
    /// [`singular_t`](Self::singular_t).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place` (the corners' box is below 1.5e-11 of their
    /// coordinates), `coincident-points`, `frame-not-orthonormal`, `not-concircular`, `crossing-quad` (corners not in cyclic order), `patch-through-infinity`; checked in this order.
    pub fn from_corners_and_frame(corners: [Point3; 4], v1: Vec3, v2: Vec3) -> Result<Self> {
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, v) in [v1, v2].into_iter().enumerate() {
            if !v.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::FrameVector, index }.into());
            }
        }
        range::check_place(ErrorItem::Surface, &corners)?;
        let scale = distinct(&corners)?;
        let (v1, v2) = orthonormal(v1, v2)?;
        let CornerCircle { inverses, corner, .. } = corner_circle(&corners, scale)?;
        let [b1, b2, b3] = inverses.map(Quat::from);
        let (d1, d2) = (corners[0].distance(corners[1]) / scale, corners[0].distance(corners[2]) / scale);
        let weights = [
            Quat::ONE,
            b1 * Quat::from(v1) * d1,
            b2 * Quat::from(v2) * d2,
            b3 * (b1 - b2) * Quat::from(v1.cross(v2)) * (d1 * d2),
        ];
        let corners = [corners[0], corners[1], corners[2], corner];
        let patch = Self::from_weights_unchecked(corners, weights, v1, v2);
        check_no_pole(&patch.weights)?;
        Ok(patch)
    }

    /// The patch of corners with quaternion weights and the constant frame `V1, V2` of the frame equation
    /// `D V D^-1`: how nets and whole cyclides make their patches. The weights must put the surface into three-space.
    ///
    /// # Errors
    /// `not-finite`, `coincident-points`, `zero-weight`, `frame-not-orthonormal`, `not-in-space` (the quotient leaves
    /// three-space by more than 1e-9 of the size and 1e-14 of the coordinates), `patch-through-infinity`,
    /// `below-rounding-of-place`.
    pub fn from_weights(corners: [Point3; 4], weights: [Quat; 4], v1: Vec3, v2: Vec3) -> Result<Self> {
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        range::check_place(ErrorItem::Surface, &corners)?;
        Self::from_rounded_weights(corners, weights, v1, v2, 0.0)
    }

    /// Refuses a patch that is a point at its place.
    ///
    /// # Errors
    /// `below-rounding-of-place`.
    pub(super) fn check_place(&self) -> Result<()> {
        range::check_place(ErrorItem::Surface, &self.corners)
    }

    /// As [`from_weights`](Self::from_weights), with weights that are wrong by a part `rounding`.
    ///
    /// # Errors
    /// As [`from_weights`](Self::from_weights).
    pub(crate) fn from_rounded_weights(
        corners: [Point3; 4],
        weights: [Quat; 4],
        v1: Vec3,
        v2: Vec3,
        rounding: f64,
    ) -> Result<Self> {
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, w) in weights.into_iter().enumerate() {
            if !w.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Weight, index }.into());
            }
            if w.norm() == 0.0 {
                return Err(ArcError::ZeroWeight { index }.into());
            }
        }
        let scale = largest_distance(&corners);
        range::check_distance(scale)?;
        if scale == 0.0 {
            return Err(PointError::CoincidentPoints { first: 0, second: 3, distance: 0.0, limit: 0.0 }.into());
        }
        let (v1, v2) = orthonormal(v1, v2)?;
        let patch = Self::from_weights_unchecked(corners, weights, v1, v2);
        check_no_pole(&patch.weights)?;
        patch.check_in_space(patch.corner_rounding() + rounding)?;
        Ok(patch)
    }

    /// How far the rounding of the corners may put the quotient out of three-space, relative to the size.
    pub(super) fn corner_rounding(&self) -> f64 {
        CORNER_ROUNDING * self.corners.iter().map(|a| a.to_vec().max_abs()).fold(0.0, f64::max) / self.scale
    }

    /// Refuses weights that put the quotient out of three-space by more than 1e-9 of the size and what is known of
    /// their rounding and that of the corners.
    ///
    /// # Errors
    /// `not-in-space`.
    pub(super) fn check_in_space(&self, rounding: f64) -> Result<()> {
        let limit = SPACE_LIMIT + rounding;
        // Re(~D n) is biquadratic: zero at five places of each parameter is zero.
        let places = [0.0, 0.25, 0.5, 0.75, 1.0];
        let residuals = places.iter().flat_map(|&s| places.iter().map(move |&t| (s, t)));
        let defect = residuals.map(|(s, t)| self.real_residual(s, t)).fold(0.0, f64::max) / self.scale;
        if defect <= limit { Ok(()) } else { Err(PatchError::NotInSpace { defect, limit }.into()) }
    }
}

/// The frame of two directions of any length made orthonormal to rounding, if they are perpendicular to the limit.
pub(crate) fn orthonormal(v1: Vec3, v2: Vec3) -> Result<(Vec3, Vec3)> {
    let refused =
        |cosine: f64| Error::Patch(PatchError::FrameNotOrthonormal { measured: cosine.abs(), limit: FRAME_LIMIT });
    // A direction without a length is perpendicular to nothing.
    let (u1, along) = v1.unit().zip(v2.unit()).ok_or_else(|| refused(1.0))?;
    let cosine = u1.dot(along);
    if !(cosine.abs() <= FRAME_LIMIT) {
        return Err(refused(cosine));
    }
    let u2 = (v2 - u1 * v2.dot(u1)).unit().ok_or_else(|| refused(cosine))?;
    Ok((u1, u2))
}
