//! Blocks whose coordinate surfaces are Dupin cyclides: eight points with quaternion weights.
//!
//! ```text
//! f(s,t,u) = n D^-1,   D = sum w_k B_k,   n = sum a_k w_k B_k,   B = products of (1-s) or s, (1-t) or t, (1-u) or u
//! f_s = q1(t,u) D V1 ~D/|D|^4,   f_t = q2(s,u) D V2 ~D/|D|^4,   f_u = q3(s,t) D V3 ~D/|D|^4
//! ```
//! (source: `001`, (11) to (16); that it stays in three-space, its conjecture, and the speeds: `docs/math/volumes.md`). The three
//! families of coordinate surfaces are principal patches that cross at right angles everywhere, along their lines of curvature.

mod construct;
mod folds;
mod frame;
mod locate;
mod measure;
mod metric;
mod parts;
mod pole;
mod rational;
mod rows;
mod transform;

use super::fold::FoldVerdict;
use super::param_volume::ParamVolume;
use crate::base::multilinear::biquadratic;
use crate::base::quadratic;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::base::volume_jet::VolumeJet;

pub use frame::VolumeFrame;
pub(super) use frame::{frame_at, runs_against};
pub use locate::VolumeLocation;
pub use measure::VolumeMeasure;
pub use metric::VolumeMetric;
pub(super) use pole::check_no_pole;
pub(super) use rational::rational_form;
pub use rows::VolumeRow;

/// A block over `[0, 1]³` whose six faces are cyclide patches and whose parameter lines are circles that cross at right angles.
///
/// ```
/// use cyclide::{Point3, volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
/// let cube = SphericalCube::from_barycentric(corners, [1.0, 1.0, 1.0], 0.5)?;
/// let block = CyclideVolume::new(&cube, VolumeFrame::Auto)?;
/// let jet = block.jet([0.2, 0.5, 0.8]);
/// assert!(jet.orthogonality() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CyclideVolume {
    corners: [Point3; 8],
    weights: [Quat; 8],
    /// Numerators `(a_k - a0)/scale · w_k`.
    n: [Quat; 8],
    /// Largest distance from the first corner: the unit of the numerators.
    scale: f64,
    /// The constant frame: at a point with denominator `D` the moving frame is `D V D^-1`. Right- or left-handed.
    v: [Vec3; 3],
    /// Bernstein coefficients of the speeds, each by the two other parameters in order, the first outside.
    speeds: [[[f64; 3]; 3]; 3],
    /// Rounding of the speeds.
    rounding: f64,
}

impl CyclideVolume {
    /// The volume of given weights and constant frame, valid by construction.
    pub(in crate::volume) fn from_weights_unchecked(corners: [Point3; 8], weights: [Quat; 8], v: [Vec3; 3]) -> Self {
        let scale = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
        let n = std::array::from_fn(|k| Quat::from((corners[k] - corners[0]) / scale) * weights[k]);
        let rounding = folds::speed_rounding(&corners, &weights, scale);
        let speeds = std::array::from_fn(|axis| {
            let q = speed(&corners, &weights, axis, v[axis]);
            folds::still_at_points(q, &corners, axis, rounding)
        });
        Self { corners, weights, n, scale, v, speeds, rounding }
    }

    /// The corners, binary order, first parameter fastest.
    #[must_use]
    pub fn corners(&self) -> [Point3; 8] {
        self.corners
    }

    /// The quaternion weights of the corners. A common right factor and factors `x^i y^j z^k` of corner ijk with positive x, y, z change the
    /// parametrisation only. [`new`](Self::new) gives those of `001`, (11).
    #[must_use]
    pub fn weights(&self) -> [Quat; 8] {
        self.weights
    }

    /// The constant frame `V1, V2, V3`: where the denominator is `D`, the unit tangents are `D V D^-1`. Left-handed after a
    /// [reversal](Self::reversed) or a map that reverses orientation.
    #[must_use]
    pub fn frame(&self) -> [Vec3; 3] {
        self.v
    }

    /// True if the frame is right-handed: the Jacobian of a block without folds is then positive.
    #[must_use]
    pub fn is_right_handed(&self) -> bool {
        self.handedness() > 0.0
    }

    fn handedness(&self) -> f64 {
        1.0_f64.copysign(self.v[0].cross(self.v[1]).dot(self.v[2]))
    }

    /// Largest distance of a corner from the first one.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.scale
    }

    /// Bernstein coefficients of the three speeds, lengths: `|f_s| = |q1(t,u)|/|D|²`, and so on; each by the two other parameters in
    /// order, the first of them the outer index.
    #[must_use]
    pub fn speeds(&self) -> [[[f64; 3]; 3]; 3] {
        self.speeds
    }

    /// Denominator `D(s, t, u)`.
    #[must_use]
    pub fn denominator(&self, at: [f64; 3]) -> Quat {
        trilinear(&self.weights, at)
    }

    /// The moving frame at a place: unit directions of growing s, t, u where the speeds are positive.
    #[must_use]
    pub fn moving_frame(&self, at: [f64; 3]) -> [Vec3; 3] {
        let d = self.denominator(at);
        let unit = d * (1.0 / d.norm());
        self.v.map(|v| unit.rotate(v))
    }

    /// How far the quotient `n D^-1` is from three-space, a length: an estimate of the rounding error of the volume.
    #[must_use]
    pub fn real_residual(&self, at: [f64; 3]) -> f64 {
        let d = self.denominator(at);
        (trilinear(&self.n, at) * d.conj()).w.abs() * (self.scale / d.norm_squared())
    }

    /// Point from numerator and denominator.
    fn quotient(&self, at: [f64; 3], d: Quat) -> Point3 {
        self.corners[0] + (trilinear(&self.n, at) * d.conj()).vector() * (self.scale / d.norm_squared())
    }

    /// The speeds at a place.
    fn speeds_at(&self, at: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| {
            let [x, y] = others(axis).map(|k| at[k]);
            biquadratic_at(&self.speeds[axis], x, y)
        })
    }
}

impl ParamVolume for CyclideVolume {
    fn jet(&self, at: [f64; 3]) -> VolumeJet {
        let d = self.denominator(at);
        let squared = d.norm_squared();
        let along: [Vec3; 3] = std::array::from_fn(|k| self.turned(k, d, squared));
        let speeds = self.speeds_at(at);
        let first: [Vec3; 3] = std::array::from_fn(|k| along[k] * speeds[k]);
        // x -> -2 Im(x D' D^-1)
        let derivatives: [Quat; 3] = std::array::from_fn(|axis| derivative(&self.weights, axis, at));
        let bend = |x: Vec3, axis: usize| (Quat::from(x) * derivatives[axis] * d.conj()).vector() * (-2.0 / squared);
        let mixed = |axis: usize, by: usize| {
            let [x, y] = others(axis).map(|k| at[k]);
            let q = &self.speeds[axis];
            let growth = if others(axis)[0] == by { outer_derivative(q, x, y) } else { inner_derivative(q, x, y) };
            along[axis] * growth + bend(first[axis], by)
        };
        let second = [bend(first[0], 0), mixed(0, 1), mixed(0, 2), bend(first[1], 1), mixed(1, 2), bend(first[2], 2)];
        VolumeJet { point: self.quotient(at, d), first, second }
    }

    fn point(&self, at: [f64; 3]) -> Point3 {
        self.quotient(at, self.denominator(at))
    }

    /// `q1 q2 q3/|D|⁶`, with the handedness of the frame.
    fn jacobian(&self, at: [f64; 3]) -> f64 {
        self.jacobian_of(self.speeds_at(at), self.denominator(at).norm_squared())
    }
}

/// The other two directions, in order.
pub(super) const fn others(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

/// The four corners at 0 in this direction, by the other two directions in binary order.
pub(super) fn corners_at_start(axis: usize) -> [usize; 4] {
    let [x, y] = others(axis);
    std::array::from_fn(|k| ((k & 1) << x) | ((k >> 1) << y))
}

/// `q` with `~D0 n1 + ~n0 D1 = q V`, D0, n0 at 0 and D1, n1 at 1 in this direction: products `~w_i (a_j - a_i) w_j`.
fn speed(a: &[Point3; 8], w: &[Quat; 8], axis: usize, v: Vec3) -> [[f64; 3]; 3] {
    let start = corners_at_start(axis);
    let product = |k: usize, l: usize| {
        let (i, j) = (start[k], start[l] | (1 << axis));
        [v.dot((w[i].conj() * Quat::from(a[j] - a[i]) * w[j]).vector())]
    };
    biquadratic(product).map(|row| row.map(|[c]| c))
}

fn line(a: Quat, b: Quat, t: f64) -> Quat {
    a * (1.0 - t) + b * t
}

pub(super) fn trilinear(w: &[Quat; 8], [s, t, u]: [f64; 3]) -> Quat {
    let row = |k: usize| line(w[k], w[k + 1], s);
    line(line(row(0), row(2), t), line(row(4), row(6), t), u)
}

/// Derivative of the trilinear form by one parameter.
pub(super) fn derivative(w: &[Quat; 8], axis: usize, at: [f64; 3]) -> Quat {
    let start = corners_at_start(axis);
    let [x, y] = others(axis).map(|k| at[k]);
    let across = |k: usize| w[start[k] | (1 << axis)] - w[start[k]];
    line(line(across(0), across(1), x), line(across(2), across(3), x), y)
}

fn biquadratic_at(q: &[[f64; 3]; 3], x: f64, y: f64) -> f64 {
    quadratic::value(&q.map(|row| quadratic::value(&row, y)), x)
}

fn outer_derivative(q: &[[f64; 3]; 3], x: f64, y: f64) -> f64 {
    quadratic::derivative(&q.map(|row| quadratic::value(&row, y)), x)
}

fn inner_derivative(q: &[[f64; 3]; 3], x: f64, y: f64) -> f64 {
    quadratic::value(&q.map(|row| quadratic::derivative(&row, y)), x)
}
