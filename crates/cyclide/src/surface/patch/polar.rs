//! The polar forms of a patch: speeds `q1, q2` and bending vectors `m, m*` of the parameter circles.
//!
//! ```text
//! K_s(t) = ~D0 n1 + ~n0 D1 = q1(t) V1,   K_t(s) = q2(s) V2,   m(t) = Im(~D(0,t) D(1,t)),   m*(s) = Im(~D(s,0) D(s,1))
//! ```
//! Bernstein coefficients from `K_ij = ~w_i (a_j - a_i) w_j` (`docs/math/patches.md#speeds-and-moving-frame`).
//! They are multiples of `V1` and `V2` all together: the proof is at [`PatchRow`](super::PatchRow).

use crate::base::quadratic;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};

/// Quadratics in Bernstein form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Polar {
    /// `q1(t)`, a length.
    pub(super) q1: [f64; 3],
    /// `q2(s)`, a length.
    pub(super) q2: [f64; 3],
    /// `m(t)`, perpendicular to `V1`.
    pub(super) m: [Vec3; 3],
    /// `m*(s)`, perpendicular to `V2`.
    pub(super) m_star: [Vec3; 3],
}

impl Polar {
    pub(super) fn new(a: &[Point3; 4], w: &[Quat; 4], v: [Vec3; 3]) -> Self {
        // An edge that is one point has speed zero exactly: a difference of equal doubles.
        let k = |i: usize, j: usize, v: Vec3| v.dot((w[i].conj() * Quat::from(a[j] - a[i]) * w[j]).vector());
        let im = |i: usize, j: usize| (w[i].conj() * w[j]).vector();
        Self {
            q1: [k(0, 1, v[0]), 0.5 * (k(0, 3, v[0]) + k(2, 1, v[0])), k(2, 3, v[0])],
            q2: [k(0, 2, v[1]), 0.5 * (k(0, 3, v[1]) + k(1, 2, v[1])), k(1, 3, v[1])],
            m: [im(0, 1), (im(0, 3) + im(2, 1)) * 0.5, im(2, 3)],
            m_star: [im(0, 2), (im(0, 3) + im(1, 2)) * 0.5, im(1, 3)],
        }
    }

    pub(super) fn q1_at(&self, t: f64) -> f64 {
        quadratic::value(&self.q1, t)
    }

    pub(super) fn q2_at(&self, s: f64) -> f64 {
        quadratic::value(&self.q2, s)
    }

    /// `m·V2` for the given `V2`: `q1 + 2h m·V2` is the speed of the offset, `-2 m·V2/q1` the curvature of the s-lines.
    pub(super) fn bend1(&self, v2: Vec3) -> [f64; 3] {
        self.m.map(|m| m.dot(v2))
    }

    /// `-m*·V1` for the given `V1`, the same for the t-lines.
    pub(super) fn bend2(&self, v1: Vec3) -> [f64; 3] {
        self.m_star.map(|m| -m.dot(v1))
    }

    pub(super) fn q1_derivative(&self, t: f64) -> f64 {
        quadratic::derivative(&self.q1, t)
    }

    pub(super) fn m_at(&self, t: f64) -> Vec3 {
        quadratic_vector(&self.m, t)
    }

    pub(super) fn m_star_at(&self, s: f64) -> Vec3 {
        quadratic_vector(&self.m_star, s)
    }
}

/// The value at 1/2.
pub(super) fn at_half(c: &[f64; 3]) -> f64 {
    0.25 * (c[0] + 2.0 * c[1] + c[2])
}

/// Speeds below this part of the largest one have no sign.
const VANISHING: f64 = 1e-13;

/// True where a speed with these Bernstein coefficients is negative. At a double zero rounding has any sign, and the speeds on
/// both sides that of the middle.
pub(super) fn runs_backwards(c: &[f64; 3], at: f64) -> bool {
    let (q, largest) = (quadratic::value(c, at), c.iter().fold(0.0, |m: f64, c| m.max(c.abs())));
    if q.abs() <= VANISHING * largest { at_half(c) < 0.0 } else { q < 0.0 }
}

/// The number `k` with `a = k b` by least squares, and the largest `|a - k b|` over the largest `|b|`. NaN for `b = 0`.
pub(super) fn proportion(a: [f64; 3], b: [f64; 3]) -> (f64, f64) {
    let largest = b.iter().fold(0.0, |m: f64, b| m.max(b.abs()));
    let b = b.map(|b| b / largest);
    let dot = |a: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let k = dot(a) / dot(b);
    let rest = a.iter().zip(b).map(|(a, b)| (a - k * b).abs()).fold(0.0, f64::max);
    (k / largest, rest / largest)
}

fn quadratic_vector(c: &[Vec3; 3], t: f64) -> Vec3 {
    let u = 1.0 - t;
    (c[0] * u + c[1] * (2.0 * t)) * u + c[2] * (t * t)
}
