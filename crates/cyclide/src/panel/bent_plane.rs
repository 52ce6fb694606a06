//! Plane, cylinder, cone, sphere and torus as one surface that is bent from a plane, and its fit to points.
//!
//! In the frame `x, y, z` of a point of the surface, with the normal `z`, heights are "unbent" by circles that touch the plane:
//! of a place at height `z` and distance `r` from the point of contact, the signed distance to the circle or sphere of curvature `c`
//! is
//! ```text
//! d = E/(1 + sqrt(1 - c E)),   E = 2 z - c r²
//! ```
//! without cancellation, also where `c = 0`. A torus is that twice: its parallel circle through the origin lies in the plane of `x` and
//! `w = z cos(tilt) - y sin(tilt)` with the curvature `along`; unbent, the place has the meridian coordinates `(u, h)` along `w` and the
//! axis; in these the meridian circle has the curvature `across` and the normal `z`. A cone has `across = 0`, a cylinder
//! `along = 0`, so all of them are near each other as they should be, and fits do not fail where one becomes another
//! (`docs/math/panels.md#nearest-surfaces`).

use crate::base::quat::Quat;
use crate::base::vector::Vec3;

/// All that may change in a fit: three angles, three ways, curvatures across and along, tilt.
pub(super) const PARAMETERS: usize = 9;

/// The family of a bent plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bend {
    Plane,
    Cylinder,
    Cone,
    Sphere,
    Torus,
}

impl Bend {
    /// The parameters that a fit of this family changes: no more than its surfaces have, or nothing would hold them.
    pub(super) const fn free(self) -> &'static [usize] {
        match self {
            Self::Plane => &[0, 1, 5],
            Self::Sphere => &[0, 1, 5, 6],
            Self::Cylinder => &[0, 1, 2, 5, 6],
            Self::Cone => &[0, 1, 2, 5, 7, 8],
            Self::Torus => &[0, 1, 2, 5, 6, 7, 8],
        }
    }
}

/// The parameters that a fit of a given mould changes: its place.
pub(super) const PLACE: &[usize] = &[0, 1, 2, 3, 4, 5];

/// See the module.
#[derive(Debug, Clone, Copy)]
pub(super) struct BentPlane {
    pub(super) bend: Bend,
    pub(super) origin: Vec3,
    pub(super) axes: [Vec3; 3],
    pub(super) across: f64,
    pub(super) along: f64,
    pub(super) tilt: f64,
}

/// A signed distance with its derivatives by the parameters.
pub(super) struct Residual {
    pub(super) value: f64,
    pub(super) by: [f64; PARAMETERS],
}

/// The signed distance, and the root that its derivatives are divided by.
fn unbent(c: f64, z: f64, r2: f64) -> (f64, f64) {
    let e = 2.0 * z - c * r2;
    let root = (1.0 - c * e).max(0.0).sqrt();
    (e / (1.0 + root), root.max(1e-12))
}

impl BentPlane {
    /// Signed distances of points, positive on the side of the third axis.
    pub(super) fn distances(self) -> impl Fn(Vec3) -> f64 {
        // Once, not for each point.
        let turn = self.tilt.sin_cos();
        move |p| self.distance(p, turn)
    }

    fn distance(&self, p: Vec3, (sin, cos): (f64, f64)) -> f64 {
        let p = p - self.origin;
        let [x, y, z] = self.axes.map(|axis| axis.dot(p));
        match self.bend {
            Bend::Plane => z,
            Bend::Cylinder => unbent(self.across, z, y * y + z * z).0,
            Bend::Sphere => unbent(self.across, z, x * x + y * y + z * z).0,
            Bend::Cone | Bend::Torus => {
                let (w, h) = (cos * z - sin * y, sin * z + cos * y);
                let u = unbent(self.along, w, x * x + w * w).0;
                let (mz, my) = (u * cos + h * sin, h * cos - u * sin);
                unbent(self.across, mz, mz * mz + my * my).0
            }
        }
    }

    /// Signed distances with their derivatives.
    pub(super) fn residuals(self) -> impl Fn(Vec3) -> Residual {
        let turn = self.tilt.sin_cos();
        move |p| self.residual(p, turn)
    }

    fn residual(&self, p: Vec3, turn: (f64, f64)) -> Residual {
        let p = p - self.origin;
        let [x, y, z] = self.axes.map(|axis| axis.dot(p));
        let (value, gradient, shape) = match self.bend {
            Bend::Plane => (z, Vec3::Z, [0.0; 3]),
            Bend::Cylinder => {
                let r2 = y * y + z * z;
                let (d, root) = unbent(self.across, z, r2);
                let gradient = Vec3::new(0.0, -self.across * y, 1.0 - self.across * z) / root;
                (d, gradient, [0.5 * (d * d - r2) / root, 0.0, 0.0])
            }
            Bend::Sphere => {
                let r2 = x * x + y * y + z * z;
                let (d, root) = unbent(self.across, z, r2);
                let gradient = (Vec3::Z - Vec3::new(x, y, z) * self.across) / root;
                (d, gradient, [0.5 * (d * d - r2) / root, 0.0, 0.0])
            }
            Bend::Cone | Bend::Torus => self.twice_unbent([x, y, z], turn),
        };
        let turn = Vec3::new(x, y, z).cross(gradient);
        let by = [-turn.x, -turn.y, -turn.z, -gradient.x, -gradient.y, -gradient.z, shape[0], shape[1], shape[2]];
        Residual { value, by }
    }

    /// Distance, gradient, and derivatives by `across`, `along` and `tilt` of a torus.
    fn twice_unbent(&self, [x, y, z]: [f64; 3], (sin, cos): (f64, f64)) -> (f64, Vec3, [f64; 3]) {
        let (w, h) = (cos * z - sin * y, sin * z + cos * y);
        let c = self.along;
        let (u, root) = unbent(c, w, x * x + w * w);
        let (u_x, u_w, u_c) = (-c * x / root, (1.0 - c * w) / root, 0.5 * (u * u - x * x - w * w) / root);
        let (mz, my) = (u * cos + h * sin, h * cos - u * sin);
        let k = self.across;
        let r2 = mz * mz + my * my;
        let (d, root) = unbent(k, mz, r2);
        let (d_z, d_y) = ((1.0 - k * mz) / root, -k * my / root);
        // By u and h, and by the turn of both about the origin.
        let (d_u, d_h) = (d_z * cos - d_y * sin, d_z * sin + d_y * cos);
        let (d_w, d_tilt) = (d_u * u_w, d_h * w - d_u * u_w * h + d_z * my - d_y * mz);
        let gradient = Vec3::new(d_u * u_x, d_h * cos - d_w * sin, d_w * cos + d_h * sin);
        (d, gradient, [0.5 * (d * d - r2) / root, d_u * u_c, d_tilt])
    }

    /// The surface after a step of its parameters.
    pub(super) fn moved(&self, step: &[f64; PARAMETERS]) -> Self {
        let [x, y, z] = self.axes;
        let turn = x * step[0] + y * step[1] + z * step[2];
        let origin = self.origin + x * step[3] + y * step[4] + z * step[5];
        let turned = match turn.unit() {
            Some(axis) => {
                let q = Quat::from_axis_angle(axis, turn.length());
                // Made orthonormal again: thousands of steps may follow.
                let z = q.rotate(z).unit().unwrap_or(z);
                let x = q.rotate(x);
                let x = (x - z * z.dot(x)).unit().unwrap_or(x);
                [x, z.cross(x), z]
            }
            None => self.axes,
        };
        Self {
            origin,
            axes: turned,
            across: self.across + step[6],
            along: self.along + step[7],
            tilt: self.tilt + step[8],
            ..*self
        }
    }
}
