//! The patch of four points, two directions and a twist (`docs/math/bilinear-patches.md#four-points-two-directions-one-twist`).

use super::QbPatch;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ArcError, ErrorItem, NumberError, PatchError, PointError, Result};
use crate::surface::patch::{check_no_pole, largest_distance};

/// Points nearer than this part of the largest distance are one; what vanishes up to this part is zero.
const LIMIT: f64 = 1e-12;
/// Largest distance from three-space that counts as rounding of weights, relative to the size.
const SPACE_LIMIT: f64 = 1e-9;
/// Rounding of a corner by itself and by the map it comes from, relative to its coordinates.
const CORNER_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What a bilinear patch leaves free beside its corners and directions: how its last corner is turned.
///
/// ```no_run
/// use cyclide::{Point3, Vec3, surface::{CornerTwist, ParamSurface, QbPatch}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.1, 1.0, 0.2], [1.1, 1.0, 0.5]].map(Point3::from);
/// let directions = [Vec3::new(1.0, 0.0, 0.3), Vec3::new(0.3, 1.0, 0.0)];
/// let middle = |twist| QbPatch::from_directions(corners, directions, twist).map(|patch| patch.point(0.5, 0.5));
/// assert!(middle(CornerTwist::Twist(0.5))?.distance(middle(CornerTwist::Twist(-0.5))?) > 0.01);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum CornerTwist {
    /// The twist of the principal Dupin patch wherever there is one, and its projection elsewhere.
    #[default]
    Default,
    /// Any number, independent of the unit of length: the patch stays in space for each.
    Twist(f64),
    /// A vector of which the part that is free is taken, in units in which a twist of 1 has length 1: for corners and directions on one
    /// sphere or plane, or with a side that is one point, where one number does not say the patch.
    Corner(Vec3),
}

impl QbPatch {
    /// The patch with the given corners, in binary order `a0` (0,0), `a1` (1,0), `a2` (0,1), `a3` (1,1), and the directions of growing s and
    /// t at the first corner: of any length, at any angle. With a twist these are all bilinear patches of circles there are, up to their
    /// parametrisation (`docs/math/bilinear-patches.md#four-points-two-directions-one-twist`). Points anywhere but for the conditions below;
    /// `a3 = a1` or `a3 = a2` is legal, with [`CornerTwist::Corner`]. The speeds at the first corner are the lengths of the sides there.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points` (`a0` with another corner, to 1e-12 of the
    /// largest distance), `zero-tangent`, `edge-circle-through-corner` (the circle of a side at `a0` runs through `a3`), `twist-not-unique`
    /// (corners and directions on one sphere or plane, or a collapsed side: use [`CornerTwist::Corner`]), `zero-weight`,
    /// `patch-through-infinity`.
    pub fn from_directions(corners: [Point3; 4], directions: [Vec3; 2], twist: CornerTwist) -> Result<Self> {
        Self::finite(corners, Self::weights_of(&corners, directions, twist)?)
    }

    /// The weights of the patch, whether it passes through infinity or not.
    ///
    /// # Errors
    /// As [`from_directions`](Self::from_directions), but for `patch-through-infinity`.
    pub(crate) fn weights_of(corners: &[Point3; 4], directions: [Vec3; 2], twist: CornerTwist) -> Result<[Quat; 4]> {
        let scale = check_corners(corners)?;
        let directions = unit_directions(directions)?;
        check_twist(twist)?;
        Equations::new(corners, scale, directions)?.weights(twist)
    }

    /// The patch of corners with quaternion weights, which must put it into three-space.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points`, `zero-weight`, `patch-through-infinity`,
    /// `not-in-space` (the quotient leaves three-space by more than 1e-9 of the size and the rounding of the coordinates).
    pub fn from_weights(corners: [Point3; 4], weights: [Quat; 4]) -> Result<Self> {
        check_corners(&corners)?;
        for (index, w) in weights.into_iter().enumerate() {
            if !w.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Weight, index }.into());
            }
            if w.norm() == 0.0 {
                return Err(ArcError::ZeroWeight { index }.into());
            }
        }
        let patch = Self::finite(corners, weights)?;
        patch.check_in_space(patch.corner_rounding())?;
        Ok(patch)
    }

    /// The patch of weights that are in space, if it has no pole.
    ///
    /// # Errors
    /// `patch-through-infinity`.
    pub(super) fn finite(corners: [Point3; 4], weights: [Quat; 4]) -> Result<Self> {
        check_no_pole(&weights)?;
        Ok(Self::from_weights_unchecked(corners, weights))
    }

    /// How far the rounding of the corners may put the quotient out of three-space, relative to the size.
    pub(super) fn corner_rounding(&self) -> f64 {
        CORNER_ROUNDING * self.corners.iter().map(|a| a.to_vec().max_abs()).fold(0.0, f64::max) / self.scale
    }

    /// Refuses weights that put the quotient out of three-space by more than 1e-9 of the size and what is known of their rounding.
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

/// The largest distance between corners that are in range, if none of them is the first.
///
/// # Errors
/// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points`.
pub(super) fn check_corners(corners: &[Point3; 4]) -> Result<f64> {
    for (index, p) in corners.iter().enumerate() {
        range::check_point(index, p.to_vec())?;
    }
    let scale = largest_distance(corners);
    range::check_distance(scale)?;
    check_distinct(corners, scale, &[[0, 1], [0, 2], [0, 3]])?;
    range::check_place(ErrorItem::Surface, corners)?;
    Ok(scale)
}

/// Refuses corners of which two are one point, to 1e-12 of the size.
///
/// # Errors
/// `coincident-points`.
pub(super) fn check_distinct(corners: &[Point3; 4], scale: f64, pairs: &[[usize; 2]]) -> Result<()> {
    for &[first, second] in pairs {
        let (distance, limit) = (corners[first].distance(corners[second]), LIMIT * scale);
        if distance <= limit {
            return Err(PointError::CoincidentPoints { first, second, distance, limit }.into());
        }
    }
    Ok(())
}

/// Directions of length 1.
///
/// # Errors
/// `not-finite`, `zero-tangent`.
pub(super) fn unit_directions<const N: usize>(directions: [Vec3; N]) -> Result<[Vec3; N]> {
    let mut units = directions;
    for (index, v) in units.iter_mut().enumerate() {
        if !v.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
        }
        *v = v.unit().ok_or(PointError::ZeroTangent { index })?;
    }
    Ok(units)
}

fn check_twist(twist: CornerTwist) -> Result<()> {
    let is_finite = match twist {
        CornerTwist::Default => true,
        CornerTwist::Twist(value) => value.is_finite(),
        CornerTwist::Corner(vector) => vector.is_finite(),
    };
    if is_finite { Ok(()) } else { Err(NumberError::NotFinite { what: ErrorItem::Twist, index: 0 }.into()) }
}

/// The two real equations of the last numerator `Q = S + q`: `g1·q = S (u·P1)`, `g2·q = S (v·P2)`, in units of the size.
struct Equations {
    /// `(a_k - a0)^-1`.
    inverses: [Vec3; 3],
    /// The directions, as long as the sides.
    p: [Vec3; 2],
    /// `b1 - b3` and `b2 - b3`; 0 where a side is one point.
    u: [Vec3; 2],
    /// The normals `u × P1`, `v × P2`; 0 where their length is rounding.
    g: [Vec3; 2],
    /// The real part `S = -(b1 - b2)·(P1 × P2)`.
    s: f64,
    /// `|u| + |v|`.
    beta: f64,
}

impl Equations {
    /// # Errors
    /// `edge-circle-through-corner`.
    fn new(corners: &[Point3; 4], scale: f64, directions: [Vec3; 2]) -> Result<Self> {
        let x = [1, 2, 3].map(|k| (corners[k] - corners[0]) / scale);
        let inverses = x.map(|x| x / -x.length_squared());
        let p = [directions[0] * x[0].length(), directions[1] * x[1].length()];
        // The distance of neighbors decides, not of their inverses, whether a side is one point.
        let u = [0, 1].map(|k| if (x[k] - x[2]).length() <= LIMIT { Vec3::ZERO } else { inverses[k] - inverses[2] });
        let beta = u[0].length() + u[1].length();
        let s = -(inverses[0] - inverses[1]).dot(p[0].cross(p[1]));
        let real = s.abs() / (x[0].length() * x[1].length());
        let mut g = [Vec3::ZERO; 2];
        for side in 0..2 {
            let normal = u[side].cross(p[side]);
            let (measured, size) = (normal.length(), u[side].length() * p[side].length());
            if measured > LIMIT * size {
                g[side] = normal;
            } else if size > 0.0 && real > LIMIT * beta {
                let (measured, limit) = (measured / size, LIMIT);
                return Err(PatchError::EdgeCircleThroughCorner { side, measured, limit }.into());
            }
        }
        Ok(Self { inverses, p, u, g, s, beta })
    }

    /// The weights `1, b1 P1, b2 P2, b3 (S + q)`.
    ///
    /// # Errors
    /// `twist-not-unique`, `zero-weight`.
    fn weights(&self, twist: CornerTwist) -> Result<[Quat; 4]> {
        let q = self.free_part(twist)?;
        let sizes = self.p[0].length() * self.p[1].length();
        let last = Quat::from_parts(self.s, q);
        if !(last.norm() > LIMIT * self.beta * sizes) {
            return Err(ArcError::ZeroWeight { index: 3 }.into());
        }
        let [b1, b2, b3] = self.inverses.map(Quat::from);
        Ok([Quat::ONE, b1 * Quat::from(self.p[0]), b2 * Quat::from(self.p[1]), b3 * last])
    }

    /// The vector `q`.
    ///
    /// # Errors
    /// `twist-not-unique`.
    fn free_part(&self, twist: CornerTwist) -> Result<Vec3> {
        let Self { inverses, p, u, g, s, beta } = *self;
        let sizes = p[0].length() * p[1].length();
        let sides = [s * u[0].dot(p[0]), s * u[1].dot(p[1])];
        let e = g[0].cross(g[1]);
        let line = e.unit().filter(|_| e.length() > LIMIT * g[0].length() * g[1].length());
        let Some(line) = line else {
            let CornerTwist::Corner(corner) = twist else {
                return Err(PatchError::TwistNotUnique.into());
            };
            // One equation at most is left: of two that are one, the longer normal.
            let wanted = corner * (beta * sizes);
            let side = usize::from(g[1].length() > g[0].length());
            let (normal, value) = (g[side], sides[side]);
            let squared = normal.length_squared();
            return Ok(if squared > 0.0 { wanted - normal * ((wanted.dot(normal) - value) / squared) } else { wanted });
        };
        let shortest = (g[1].cross(e) * sides[0] + e.cross(g[0]) * sides[1]) / e.length_squared();
        let free = match twist {
            CornerTwist::Twist(value) => value * beta * sizes,
            CornerTwist::Corner(corner) => corner.dot(line) * beta * sizes,
            // That of the Dupin patch, d P1 P2, whose projection this is.
            CornerTwist::Default => {
                let d = Quat::from(inverses[0] - inverses[1]);
                line.dot((d * Quat::from(p[0]) * Quat::from(p[1])).vector())
            }
        };
        Ok(shortest + line * free)
    }
}
