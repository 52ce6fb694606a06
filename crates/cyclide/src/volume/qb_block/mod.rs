//! The general trilinear block of circles: eight points with quaternion weights, in space.
//!
//! ```text
//! f(s,t,u) = n D^-1,   D = sum w_k B_k,   n = sum a_k w_k B_k,   B = products of (1-s) or s, (1-t) or t, (1-u) or u
//! f_s = D K(t,u) ~D/|D|^4,   f_t = D L(s,u) ~D/|D|^4,   f_u = D M(s,t) ~D/|D|^4
//! ```
//! (source: own, `docs/math/bilinear-patches.md#blocks`; `001`, end of section 4, has the special case of orthogonal coordinate surfaces as a
//! conjecture.) All parameter lines are circles, all coordinate surfaces bilinear patches. Where these are Dupin patches that cross at right
//! angles the block is a [`CyclideVolume`](super::CyclideVolume), which has closed forms that this one lacks.

mod construct;
mod folds;

use super::cyclide_volume::{corners_at_start, derivative, others, rational_form, trilinear};
use super::param_volume::ParamVolume;
use crate::base::multilinear::biquadratic;
use crate::base::quadratic;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::base::volume_jet::VolumeJet;
use crate::rational::RationalBezierVolume;
use crate::surface::QbPatch;

pub use construct::BlockBranch;

/// The Bernstein coefficients of a vector that is quadratic in two parameters, the first of them the outer index.
type Biquadratic = [[[f64; 3]; 3]; 3];

/// A trilinear quotient of quaternions that stays in space, over `[0, 1]³`: every parameter line is a circle or straight.
///
/// ```no_run
/// use cyclide::{Point3, Vec3, surface::CornerTwist, volume::{BlockBranch, ParamVolume, QbBlock}};
/// // Seven corners, the first parameter fastest; the eighth follows.
/// let corners = [
///     [0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.0, 1.0, 0.1], [0.9, 1.1, 0.0],
///     [0.1, 0.0, 1.0], [1.0, 0.0, 1.1], [0.0, 1.0, 1.0],
/// ].map(Point3::from);
/// let directions = [Vec3::new(1.0, 0.1, 0.2), Vec3::new(-0.1, 1.0, 0.1), Vec3::new(0.1, 0.0, 1.0)];
/// let block = QbBlock::new(corners, directions, [CornerTwist::Default; 3], BlockBranch::Miquel)?;
/// assert!(block.point([1.0, 1.0, 0.0]).distance(corners[3]) < 1e-14);
/// assert!(block.real_residual([0.3, 0.6, 0.8]) < 1e-13);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QbBlock {
    corners: [Point3; 8],
    weights: [Quat; 8],
    /// Numerators `(a_k - a0)/scale · w_k`.
    n: [Quat; 8],
    /// Largest distance from the first corner: the unit of the numerators.
    scale: f64,
    /// `K`, `L` and `M`, each by the two other parameters in order, in units of the size.
    along: [Biquadratic; 3],
}

impl QbBlock {
    /// The block of given weights, which is in space and finite by construction.
    pub(super) fn from_weights_unchecked(corners: [Point3; 8], weights: [Quat; 8]) -> Self {
        let scale = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
        let n: [Quat; 8] = std::array::from_fn(|k| Quat::from((corners[k] - corners[0]) / scale) * weights[k]);
        let along = std::array::from_fn(|axis| {
            let start = corners_at_start(axis);
            biquadratic(|k, l| {
                let (i, j) = (start[k], start[l] | (1 << axis));
                (weights[i].conj() * n[j] + n[i].conj() * weights[j]).vector().to_array()
            })
        });
        Self { corners, weights, n, scale, along }
    }

    /// The corners, binary order, first parameter fastest.
    #[must_use]
    pub fn corners(&self) -> [Point3; 8] {
        self.corners
    }

    /// The quaternion weights of the corners. A common right factor and factors `x^i y^j z^k` of corner ijk with positive x, y, z change the
    /// parametrisation only.
    #[must_use]
    pub fn weights(&self) -> [Quat; 8] {
        self.weights
    }

    /// Largest distance of a corner from the first one.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.scale
    }

    /// Denominator `D(s, t, u)`.
    #[must_use]
    pub fn denominator(&self, at: [f64; 3]) -> Quat {
        trilinear(&self.weights, at)
    }

    /// How far the quotient `n D^-1` is from three-space, a length: an estimate of the rounding error of the block.
    #[must_use]
    pub fn real_residual(&self, at: [f64; 3]) -> f64 {
        let d = self.denominator(at);
        (trilinear(&self.n, at) * d.conj()).w.abs() * (self.scale / d.norm_squared())
    }

    /// The six faces: s = 0, s = 1, t = 0, t = 1, u = 0, u = 1, each by the two other parameters in order.
    #[must_use]
    pub fn faces(&self) -> [QbPatch; 6] {
        std::array::from_fn(|k| {
            let (axis, end) = (k / 2, (k % 2) << (k / 2));
            let at = corners_at_start(axis).map(|corner| corner | end);
            QbPatch::from_weights_unchecked(at.map(|c| self.corners[c]), at.map(|c| self.weights[c]))
        })
    }

    /// The rational triquadratic with the same parameters, homogeneous rows `[wx, wy, wz, w]`. Weights may be zero or negative beside long arcs.
    #[must_use]
    pub fn to_rational(&self) -> RationalBezierVolume {
        rational_form(self.corners[0], self.scale, &self.n, &self.weights)
    }

    /// The direction of the lines in direction `axis` at a place, in the frame that the denominator carries, in units of the size.
    fn along(&self, axis: usize, at: [f64; 3]) -> Vec3 {
        let [x, y] = others(axis).map(|k| at[k]);
        value(&self.along[axis], x, y)
    }

    fn quotient(&self, at: [f64; 3], d: Quat) -> Point3 {
        self.corners[0] + (trilinear(&self.n, at) * d.conj()).vector() * (self.scale / d.norm_squared())
    }
}

impl ParamVolume for QbBlock {
    fn jet(&self, at: [f64; 3]) -> VolumeJet {
        let d = self.denominator(at);
        let squared = d.norm_squared();
        let turn = |v: Vec3| (d * Quat::from(v) * d.conj()).vector() * (self.scale / (squared * squared));
        let first: [Vec3; 3] = std::array::from_fn(|axis| turn(self.along(axis, at)));
        // x -> -2 Im(x D' D^-1)
        let derivatives: [Quat; 3] = std::array::from_fn(|axis| derivative(&self.weights, axis, at));
        let bend = |x: Vec3, axis: usize| (Quat::from(x) * derivatives[axis] * d.conj()).vector() * (-2.0 / squared);
        let mixed = |axis: usize, by: usize| {
            let [x, y] = others(axis).map(|k| at[k]);
            let growth = slope(&self.along[axis], x, y, others(axis)[0] == by);
            turn(growth) + bend(first[axis], by)
        };
        let second = [bend(first[0], 0), mixed(0, 1), mixed(0, 2), bend(first[1], 1), mixed(1, 2), bend(first[2], 2)];
        VolumeJet { point: self.quotient(at, d), first, second }
    }

    fn point(&self, at: [f64; 3]) -> Point3 {
        self.quotient(at, self.denominator(at))
    }
}

/// The value of a biquadratic vector.
fn value(c: &Biquadratic, x: f64, y: f64) -> Vec3 {
    let part = |k: usize| quadratic::value(&c.map(|row| quadratic::value(&row.map(|v| v[k]), y)), x);
    Vec3::new(part(0), part(1), part(2))
}

/// Its derivative by the outer parameter, or by the inner one.
fn slope(c: &Biquadratic, x: f64, y: f64, outer: bool) -> Vec3 {
    let part = |k: usize| {
        if outer {
            quadratic::derivative(&c.map(|row| quadratic::value(&row.map(|v| v[k]), y)), x)
        } else {
            quadratic::value(&c.map(|row| quadratic::derivative(&row.map(|v| v[k]), y)), x)
        }
    };
    Vec3::new(part(0), part(1), part(2))
}
