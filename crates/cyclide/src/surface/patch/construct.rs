//! The patch from four concircular corners and a frame (`20`, section 2, formula (C)).

use super::{CyclidePatch, largest_distance};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, Result};

/// Corners closer than this part of the largest distance coincide.
const COINCIDENT_LIMIT: f64 = 1e-12;
/// Largest distance of the fourth corner from the circle of the others, and of its place from their arc, relative.
pub(super) const CONCIRCULAR_LIMIT: f64 = 1e-9;
/// Largest deviation of the frame from unit length and right angle.
const FRAME_LIMIT: f64 = 1e-9;

impl CyclidePatch {
    /// The patch with the given corners and unit directions `v1` (of growing s) and `v2` (of growing t) at the first
    /// corner. Corners in binary order `a0` (0,0), `a1` (1,0), `a2` (0,1), `a3` (1,1); they must be concircular (or
    /// collinear) in the cyclic order a0, a1, a3, a2, and a3 is moved onto the circle of the others by rounding.
    /// `a3 = a1` or `a3 = a2` is legal (a triangular patch with a pole). Weights are those of `001`, (9), by the form
    /// (C) of `20`, which has the right sign in every order. Every frame direction is admissible; whether a parameter
    /// line shrinks to a point inside is told by [`singular_s`](Self::singular_s) and
    /// [`singular_t`](Self::singular_t).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `coincident-points`, `frame-not-orthonormal`, `not-concircular`,
    /// `crossing-quad` (corners not in cyclic order), `patch-through-infinity`; checked in this order.
    pub fn from_corners_and_frame(corners: [Point3; 4], v1: Vec3, v2: Vec3) -> Result<Self> {
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, v) in [v1, v2].into_iter().enumerate() {
            if !v.is_finite() {
                return Err(Error::NotFinite { what: "frame vector", index });
            }
        }
        let scale = largest_distance(&corners);
        range::check_distance(scale)?;
        let distance = |i: usize, j: usize| corners[i].distance(corners[j]);
        for (first, second) in [(0, 1), (0, 2), (0, 3), (1, 2)] {
            let (distance, limit) = (distance(first, second), COINCIDENT_LIMIT * scale);
            if distance <= limit {
                return Err(Error::CoincidentPoints { first, second, distance, limit });
            }
        }
        let (v1, v2) = orthonormal(v1, v2)?;
        let x = |k: usize| (corners[k] - corners[0]) / scale;
        // b_k = (a_k - a0)^-1 = -x/|x|², imaginary.
        let inverse = |x: Vec3| x / -x.length_squared();
        let (b1, b2) = (inverse(x(1)), inverse(x(2)));
        let (b3, corner) = if distance(1, 3) <= COINCIDENT_LIMIT * scale {
            (b1, corners[1])
        } else if distance(2, 3) <= COINCIDENT_LIMIT * scale {
            (b2, corners[2])
        } else {
            on_circle(b1, b2, inverse(x(3)), corners[0], corners[3], scale)?
        };
        let (b1, b2, b3) = (Quat::from(b1), Quat::from(b2), Quat::from(b3));
        let (d1, d2) = (x(1).length(), x(2).length());
        let weights = [
            Quat::ONE,
            b1 * Quat::from(v1) * d1,
            b2 * Quat::from(v2) * d2,
            b3 * (b1 - b2) * Quat::from(v1.cross(v2)) * (d1 * d2),
        ];
        let corners = [corners[0], corners[1], corners[2], corner];
        let patch = Self::from_weights_unchecked(corners, weights, v1, v2);
        patch.check_no_pole()?;
        Ok(patch)
    }

    /// The patch of corners with quaternion weights and the constant frame `V1, V2` of the frame equation
    /// `D V D^-1`: how nets and whole cyclides make their patches. The weights must put the surface into three-space.
    ///
    /// # Errors
    /// `not-finite`, `coincident-points`, `zero-weight`, `frame-not-orthonormal`, `not-in-space` (the quotient leaves
    /// three-space by more than 1e-9 of the size), `patch-through-infinity`.
    pub fn from_weights(corners: [Point3; 4], weights: [Quat; 4], v1: Vec3, v2: Vec3) -> Result<Self> {
        for (index, p) in corners.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, w) in weights.into_iter().enumerate() {
            if !w.is_finite() {
                return Err(Error::NotFinite { what: "weight", index });
            }
            if w.norm() == 0.0 {
                return Err(Error::ZeroWeight { index });
            }
        }
        let scale = largest_distance(&corners);
        range::check_distance(scale)?;
        if scale == 0.0 {
            return Err(Error::CoincidentPoints { first: 0, second: 3, distance: 0.0, limit: 0.0 });
        }
        let (v1, v2) = orthonormal(v1, v2)?;
        let patch = Self::from_weights_unchecked(corners, weights, v1, v2);
        patch.check_no_pole()?;
        patch.check_in_space(CONCIRCULAR_LIMIT)?;
        Ok(patch)
    }

    /// Refuses weights that put the quotient out of three-space by more than `limit` of the size.
    ///
    /// # Errors
    /// `not-in-space`.
    pub(super) fn check_in_space(&self, limit: f64) -> Result<()> {
        // Re(~D n) is biquadratic: zero at five places of each parameter is zero.
        let places = [0.0, 0.25, 0.5, 0.75, 1.0];
        let residuals = places.iter().flat_map(|&s| places.iter().map(move |&t| (s, t)));
        let defect = residuals.map(|(s, t)| self.real_residual(s, t)).fold(0.0, f64::max) / self.scale;
        if defect <= limit { Ok(()) } else { Err(Error::NotInSpace { defect, limit }) }
    }
}

/// `b3` moved onto the segment `b1 b2` (the inverted arc opposite to a0), and the corner it stands for.
fn on_circle(b1: Vec3, b2: Vec3, b3: Vec3, a0: Point3, a3: Point3, scale: f64) -> Result<(Vec3, Point3)> {
    let side = b2 - b1;
    let x = (b3 - b1).dot(side) / side.length_squared();
    let foot = b1 + side * x;
    let corner = a0 + foot * (-scale / foot.length_squared());
    let (moved, limit) = (corner.distance(a3) / scale, CONCIRCULAR_LIMIT);
    if !(moved <= limit) {
        return Err(Error::NotConcircular { quad: 0, measured: moved, limit });
    }
    if !(-limit..=1.0 + limit).contains(&x) {
        return Err(Error::CrossingQuad { quad: 0, position: x });
    }
    Ok((foot, corner))
}

/// The frame made orthonormal to rounding, if it is orthonormal to the limit.
pub(crate) fn orthonormal(v1: Vec3, v2: Vec3) -> Result<(Vec3, Vec3)> {
    let (l1, l2, cosine) = (v1.length(), v2.length(), v1.dot(v2));
    let measured = (l1 - 1.0).abs().max((l2 - 1.0).abs()).max(cosine.abs());
    let refused = Error::FrameNotOrthonormal { measured, limit: FRAME_LIMIT };
    if !(measured <= FRAME_LIMIT) {
        return Err(refused);
    }
    let u1 = v1.unit().ok_or(refused.clone())?;
    let u2 = (v2 - u1 * v2.dot(u1)).unit().ok_or(refused)?;
    Ok((u1, u2))
}
