//! The principal patch of a Dupin cyclide: four concircular corners and quaternion weights.
//!
//! ```text
//! f(s,t) = n D^-1,   D = sum w_k B_k,   n = sum a_k w_k B_k,   B = (1-s)(1-t), s(1-t), (1-s)t, st
//! f_s = q1(t) D V1 ~D / |D|^4,   f_t = q2(s) D V2 ~D / |D|^4,   N = D V3 D^-1
//! ```
//! (source: `001`, (10); the moving frame and the real quadratics `q1`, `q2` from
//! `docs/math/patches.md#speeds-and-moving-frame`, not in the paper). All parameter lines are circles and lines of
//! curvature. The corners are in binary order, first parameter fastest: `a0` at (0,0), `a1` at (1,0), `a2` at (0,1),
//! `a3` at (1,1), so round the corner circle they come as a0, a1, a3, a2.

mod circles;
mod construct;
mod corner_circle;
mod curvature;
mod curvature_range;
mod frame_at;
mod implicit;
mod lines;
mod locate;
mod offset;
mod polar;
mod pole;
mod rational;
mod recognize;
mod rows;
mod singular;
mod transform;
mod twist;

pub(crate) use construct::orthonormal;
pub(super) use corner_circle::check_quad;
pub(crate) use corner_circle::{check_following_quad, on_corner_circle};
pub(super) use implicit::sphere_form;
pub(super) use pole::check_no_pole;
pub(super) use rational::{biquadratic_form, real_weights};

use super::param_surface::ParamSurface;
use crate::base::quat::Quat;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use polar::{Polar, runs_backwards};

pub use implicit::ImplicitForm;
pub use locate::PatchLocation;
pub use recognize::PatchKind;
pub use rows::PatchRow;

/// A principal patch of a Dupin cyclide (plane, sphere, cylinder, cone and torus included), over `[0, 1]²`.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch};
/// let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
/// let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0))?;
/// assert!(patch.s_circle(0.5).is_some()); // every parameter line is a circle
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CyclidePatch {
    corners: [Point3; 4],
    weights: [Quat; 4],
    /// Numerators `(a_k - a0)/scale · w_k`.
    n: [Quat; 4],
    /// Largest distance between corners: the unit of the numerators.
    scale: f64,
    /// The constant frame `V1, V2, V3 = V1 × V2`: at a point with denominator `D` the moving frame is `D V D^-1`.
    v: [Vec3; 3],
    polar: Polar,
}

impl CyclidePatch {
    /// The patch of given weights and constant frame, valid by construction.
    pub(crate) fn from_weights_unchecked(corners: [Point3; 4], weights: [Quat; 4], v1: Vec3, v2: Vec3) -> Self {
        let scale = largest_distance(&corners);
        let n = std::array::from_fn(|k| Quat::from((corners[k] - corners[0]) / scale) * weights[k]);
        let v = [v1, v2, v1.cross(v2)];
        Self { corners, weights, n, scale, v, polar: Polar::new(&corners, &weights, v) }
    }

    /// The corners `a0, a1, a2, a3` at (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self) -> [Point3; 4] {
        self.corners
    }

    /// The quaternion weights of the corners. A common right factor and factors `1, lam, mu, lam mu > 0` change the
    /// parametrisation only. [`from_corners_and_frame`](Self::from_corners_and_frame) gives those of `001`, (9).
    #[must_use]
    pub fn weights(&self) -> [Quat; 4] {
        self.weights
    }

    /// The constant frame `V1, V2, V3`: where the denominator is `D`, the unit tangents and normal are `D V D^-1`.
    #[must_use]
    pub fn frame(&self) -> [Vec3; 3] {
        self.v
    }

    /// Largest distance between two corners.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.scale
    }

    /// Bernstein coefficients of the real quadratic `q1(t)`, a length: `|f_s| = |q1|/|D|²`.
    #[must_use]
    pub fn q1(&self) -> [f64; 3] {
        self.polar.q1
    }

    /// Bernstein coefficients of the real quadratic `q2(s)`, a length: `|f_t| = |q2|/|D|²`.
    #[must_use]
    pub fn q2(&self) -> [f64; 3] {
        self.polar.q2
    }

    /// Bernstein coefficients of the bending vectors `m(t) = Im(~D(0,t) D(1,t))` and `m*(s) = Im(~D(s,0) D(s,1))`, in the
    /// constant frame (`m·V1 = 0`, `m*·V2 = 0`): the parameter circles have the curvatures `2|m|/|q1|`, `2|m*|/|q2|`.
    #[must_use]
    pub(crate) fn bending(&self) -> [[Vec3; 3]; 2] {
        [self.polar.m, self.polar.m_star]
    }

    /// Denominator `D(s, t)`.
    #[must_use]
    pub fn denominator(&self, s: f64, t: f64) -> Quat {
        bilinear(&self.weights, s, t)
    }

    /// Element of area `q1(t) q2(s)/|D|⁴`, with the sign of `f_s × f_t` along the unit normal.
    pub(crate) fn element(&self, s: f64, t: f64) -> f64 {
        let squared = self.denominator(s, t).norm_squared();
        self.polar.q1_at(t) / squared * (self.polar.q2_at(s) / squared)
    }

    /// The way from the first corner to a point.
    pub(crate) fn way_from_first_corner(&self, s: f64, t: f64) -> Vec3 {
        self.numerator_over(s, t, self.denominator(s, t))
    }

    /// Point from numerator and denominator.
    fn quotient(&self, s: f64, t: f64, d: Quat) -> Point3 {
        self.corners[0] + self.numerator_over(s, t, d)
    }

    /// Numerator over denominator, from the first corner.
    fn numerator_over(&self, s: f64, t: f64, d: Quat) -> Vec3 {
        (bilinear(&self.n, s, t) * d.conj()).vector() * (self.scale / d.norm_squared())
    }

    /// The moving frame at `(s, t)`: unit directions of growing s and t where `q1, q2 > 0`, and the unit normal
    /// `N = D V3 D^-1`.
    #[must_use]
    pub fn moving_frame(&self, s: f64, t: f64) -> [Vec3; 3] {
        let d = self.denominator(s, t);
        let unit = d * (1.0 / d.norm());
        self.v.map(|v| unit.rotate(v))
    }

    /// Unit normal `D V3 D^-1`, continuous over the patch also where a parameter line shrinks to a point. It is
    /// `f_s × f_t` where `q1 q2 > 0` and its opposite where `q1 q2 < 0`.
    #[must_use]
    pub fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        let d = self.denominator(s, t);
        (d * (1.0 / d.norm())).rotate(self.v[2])
    }

    /// How far the quotient `n D^-1` is from three-space, a length: an estimate of the rounding error of the patch.
    #[must_use]
    pub fn real_residual(&self, s: f64, t: f64) -> f64 {
        let d = self.denominator(s, t);
        (bilinear(&self.n, s, t) * d.conj()).w.abs() * (self.scale / d.norm_squared())
    }
}

impl ParamSurface for CyclidePatch {
    fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        let d = self.denominator(s, t);
        let squared = d.norm_squared();
        let d_s = line(&[self.weights[1] - self.weights[0], self.weights[3] - self.weights[2]], t);
        let d_t = line(&[self.weights[2] - self.weights[0], self.weights[3] - self.weights[1]], s);
        let turn = |v: Vec3| (d * Quat::from(v) * d.conj()).vector() / (squared * squared);
        let (along_s, along_t) = (turn(self.v[0]), turn(self.v[1]));
        let (ds, dt) = (along_s * self.polar.q1_at(t), along_t * self.polar.q2_at(s));
        // x -> -2 Im(x D' D^-1)
        let bend = |x: Vec3, derivative: Quat| (Quat::from(x) * derivative * d.conj()).vector() * (-2.0 / squared);
        SurfaceJet {
            point: self.quotient(s, t, d),
            ds,
            dt,
            dss: bend(ds, d_s),
            dst: along_s * self.polar.q1_derivative(t) + bend(ds, d_t),
            dtt: bend(dt, d_t),
        }
    }

    fn point(&self, s: f64, t: f64) -> Point3 {
        self.quotient(s, t, self.denominator(s, t))
    }

    /// [`unit_normal`](CyclidePatch::unit_normal) with the sign of `f_s × f_t`, which is the limit where a parameter
    /// line shrinks to a point.
    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        let n = self.unit_normal(s, t);
        let turned = runs_backwards(&self.polar.q1, t) != runs_backwards(&self.polar.q2, s);
        Some(if turned { -n } else { n })
    }
}

pub(super) fn line(ends: &[Quat; 2], t: f64) -> Quat {
    ends[0] * (1.0 - t) + ends[1] * t
}

pub(super) fn bilinear(w: &[Quat; 4], s: f64, t: f64) -> Quat {
    line(&[line(&[w[0], w[1]], s), line(&[w[2], w[3]], s)], t)
}

pub(super) fn largest_distance(points: &[Point3; 4]) -> f64 {
    let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
    pairs.iter().map(|&(i, j)| points[i].distance(points[j])).fold(0.0, f64::max)
}
