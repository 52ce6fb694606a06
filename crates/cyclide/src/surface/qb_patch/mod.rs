//! The general bilinear patch of circles: four points with quaternion weights, in space.
//!
//! ```text
//! f(s,t) = n D^-1,   D = sum w_k B_k,   n = sum a_k w_k B_k,   B = (1-s)(1-t), s(1-t), (1-s)t, st
//! f_s = D K(t) ~D / |D|^4,   f_t = D L(s) ~D / |D|^4,   N = unit(D (K × L) ~D)
//! ```
//! (source: `001`, introduction, where such a surface is called a cyclide; which one it is, how many there are, and the vectors `K` and `L`:
//! `docs/math/bilinear-patches.md`, not in the paper.) All parameter lines are circles. Where `K` and `L` each have one direction they are
//! lines of curvature: that patch is a [`CyclidePatch`](super::CyclidePatch), which has offsets and closed forms that this one lacks. The
//! corners are in binary order, first parameter fastest: `a0` at (0,0), `a1` at (1,0), `a2` at (0,1), `a3` at (1,1).

mod arcs;
mod construct;
mod implicit;
mod locate;
mod rational;
mod recognize;
mod transform;

use super::param_surface::ParamSurface;
use super::patch::{bilinear, largest_distance, line};
use crate::base::quat::Quat;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};

pub use construct::CornerTwist;
pub use recognize::QbPatchKind;

/// A bilinear quotient of quaternions that stays in space, over `[0, 1]²`: every parameter line is a circle or straight.
///
/// ```no_run
/// use cyclide::{Point3, Vec3, surface::{CornerTwist, ParamSurface, QbPatch}};
/// // No circle runs through these corners, and the directions are not perpendicular.
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.1, 1.0, 0.2], [1.1, 1.0, 0.5]].map(Point3::from);
/// let directions = [Vec3::new(1.0, 0.0, 0.3), Vec3::new(0.3, 1.0, 0.0)];
/// let patch = QbPatch::from_directions(corners, directions, CornerTwist::Default)?;
/// assert!(patch.point(1.0, 1.0).distance(corners[3]) < 1e-15);
/// assert!(patch.jet(0.0, 0.0).ds.cross(directions[0]).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QbPatch {
    corners: [Point3; 4],
    weights: [Quat; 4],
    /// Numerators `(a_k - a0)/scale · w_k`.
    n: [Quat; 4],
    /// Largest distance between corners: the unit of the numerators.
    scale: f64,
    /// Bernstein coefficients of `K(t) = ~D(0,t) n(1,t) + ~n(0,t) D(1,t)`, in units of the size.
    k: [Vec3; 3],
    /// Those of `L(s) = ~D(s,0) n(s,1) + ~n(s,0) D(s,1)`.
    l: [Vec3; 3],
}

impl QbPatch {
    /// The patch of given weights, which is in space and finite by construction.
    pub(crate) fn from_weights_unchecked(corners: [Point3; 4], weights: [Quat; 4]) -> Self {
        let scale = largest_distance(&corners);
        let n: [Quat; 4] = std::array::from_fn(|k| Quat::from((corners[k] - corners[0]) / scale) * weights[k]);
        let along = |i: usize, j: usize| (weights[i].conj() * n[j] + n[i].conj() * weights[j]).vector();
        let middle = |[a, b]: [(usize, usize); 2]| (along(a.0, a.1) + along(b.0, b.1)) * 0.5;
        Self {
            corners,
            weights,
            n,
            scale,
            k: [along(0, 1), middle([(0, 3), (2, 1)]), along(2, 3)],
            l: [along(0, 2), middle([(0, 3), (1, 2)]), along(1, 3)],
        }
    }

    /// The corners `a0, a1, a2, a3` at (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self) -> [Point3; 4] {
        self.corners
    }

    /// The quaternion weights of the corners. A common right factor and factors `1, lam, mu, lam mu > 0` change the parametrisation only.
    #[must_use]
    pub fn weights(&self) -> [Quat; 4] {
        self.weights
    }

    /// Largest distance between two corners.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.scale
    }

    /// Denominator `D(s, t)`.
    #[must_use]
    pub fn denominator(&self, s: f64, t: f64) -> Quat {
        bilinear(&self.weights, s, t)
    }

    /// The direction `K(t)` of the s-lines, one for each of them in the frame that `D` carries: `f_s = D K ~D/|D|⁴`. Length times the size.
    #[must_use]
    pub fn s_direction(&self, t: f64) -> Vec3 {
        quadratic(&self.k, t) * self.scale
    }

    /// The direction `L(s)` of the t-lines: `f_t = D L ~D/|D|⁴`.
    #[must_use]
    pub fn t_direction(&self, s: f64) -> Vec3 {
        quadratic(&self.l, s) * self.scale
    }

    /// The angle between the parameter lines, from 0 to π: it is that of `K(t)` and `L(s)`. `None` where one of the lines is a point.
    #[must_use]
    pub fn line_angle(&self, s: f64, t: f64) -> Option<f64> {
        let (k, l) = (self.s_direction(t).unit()?, self.t_direction(s).unit()?);
        Some(k.cross(l).length().atan2(k.dot(l)))
    }

    /// How far the quotient `n D^-1` is from three-space, a length: an estimate of the rounding error of the patch.
    #[must_use]
    pub fn real_residual(&self, s: f64, t: f64) -> f64 {
        let d = self.denominator(s, t);
        (bilinear(&self.n, s, t) * d.conj()).w.abs() * (self.scale / d.norm_squared())
    }

    /// Point from numerator and denominator.
    fn quotient(&self, s: f64, t: f64, d: Quat) -> Point3 {
        self.corners[0] + (bilinear(&self.n, s, t) * d.conj()).vector() * (self.scale / d.norm_squared())
    }
}

impl ParamSurface for QbPatch {
    fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        let d = self.denominator(s, t);
        let squared = d.norm_squared();
        let d_s = line(&[self.weights[1] - self.weights[0], self.weights[3] - self.weights[2]], t);
        let d_t = line(&[self.weights[2] - self.weights[0], self.weights[3] - self.weights[1]], s);
        let turn = |v: Vec3| (d * Quat::from(v) * d.conj()).vector() * (self.scale / (squared * squared));
        let (ds, dt) = (turn(quadratic(&self.k, t)), turn(quadratic(&self.l, s)));
        // x -> -2 Im(x D' D^-1)
        let bend = |x: Vec3, derivative: Quat| (Quat::from(x) * derivative * d.conj()).vector() * (-2.0 / squared);
        SurfaceJet {
            point: self.quotient(s, t, d),
            ds,
            dt,
            dss: bend(ds, d_s),
            dst: turn(slope(&self.k, t)) + bend(ds, d_t),
            dtt: bend(dt, d_t),
        }
    }

    fn point(&self, s: f64, t: f64) -> Point3 {
        self.quotient(s, t, self.denominator(s, t))
    }

    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        let d = self.denominator(s, t);
        let (k, l) = (quadratic(&self.k, t).unit()?, quadratic(&self.l, s).unit()?);
        Some((d * (1.0 / d.norm())).rotate(k.cross(l).unit()?))
    }
}

/// A quadratic by its Bernstein coefficients.
fn quadratic(c: &[Vec3; 3], t: f64) -> Vec3 {
    let u = 1.0 - t;
    c[0] * (u * u) + c[1] * (2.0 * u * t) + c[2] * (t * t)
}

/// Its derivative.
fn slope(c: &[Vec3; 3], t: f64) -> Vec3 {
    ((c[1] - c[0]) * (1.0 - t) + (c[2] - c[1]) * t) * 2.0
}
