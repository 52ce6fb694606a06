//! Curvatures of a grid at a vertex, by least squares over it and the eight vertices around it, at any stride.

use super::neighbors::around;
use cyclide::surface::QuadGrid;
use cyclide::{Point3, Vec3};

/// Curvatures that differ by less than this part of their sizes have no clear directions.
const UMBILIC: f64 = 0.1;
/// Curvatures that bend the stencil by less than this angle (radians) are those of a plane.
const FLAT: f64 = 1e-6;

/// The second fundamental form at a vertex, in the frame of two directions of the tangent plane.
pub(super) struct Curvature {
    u: Vec3,
    v: Vec3,
    /// Coefficients of `(a x² + 2 b x y + c y²)/2`.
    form: [f64; 3],
    /// Length of the stencil.
    reach: f64,
}

impl Curvature {
    /// Least squares of `z = f + d x + e y + (a x² + 2 b x y + c y²)/2` over the vertex `centre` and the eight around it at
    /// a stride, in the frame of the normal there; the four at the corners count `corners` times. All nine alike smooth noise
    /// best, but are blind to egg crates of three strides, which cancel along each side. `None` beside an open border, where a side has no length, and where
    /// the vertices lie on a conic. Exact in the limit of small strides.
    pub(super) fn at(
        points: &[Point3],
        grid: &QuadGrid,
        centre: [usize; 2],
        stride: [usize; 2],
        corners: f64,
    ) -> Option<Self> {
        let [columns, rows] = [0, 1].map(|d| around(grid, centre, d, stride[d]));
        let ([w, e], [s, n]) = (columns?, rows?);
        let [i, j] = centre;
        // The corners of the stencil, over which a border in steps may run.
        for line in [s, n] {
            around(grid, [i, line], 0, stride[0])?;
        }
        let at = |i: usize, j: usize| points[grid.index(i, j)];
        let along = [at(e, j) - at(w, j), at(i, n) - at(i, s)];
        let normal = along[0].unit()?.cross(along[1].unit()?).unit()?;
        // Along the longer cells, so that slim ones are spread along one axis.
        let longer = if along[0].length() >= along[1].length() { along[0] } else { along[1] };
        let u = (longer - normal * longer.dot(normal)).unit()?;
        let v = normal.cross(u);
        let nine = [(i, j), (w, j), (e, j), (i, s), (i, n), (w, s), (w, n), (e, s), (e, n)];
        let local = nine.map(|(k, l)| {
            let d = at(k, l) - at(i, j);
            [d.dot(u), d.dot(v), d.dot(normal)]
        });
        let [a, b, c] = quadric(&local, corners)?;
        let reach = local.iter().map(|d| d[0].hypot(d[1])).fold(0.0, f64::max);
        Some(Self { u, v, form: [a, b, c], reach })
    }

    pub(super) fn mean(&self) -> f64 {
        0.5 * (self.form[0] + self.form[2])
    }

    /// Half the difference of the principal curvatures.
    pub(super) fn half_difference(&self) -> f64 {
        (0.5 * (self.form[0] - self.form[2])).hypot(self.form[1])
    }

    /// Unit directions of the curvature lines; `None` where the surface is nearly flat or spherical.
    pub(super) fn directions(&self) -> Option<[Vec3; 2]> {
        let (mean, half) = (self.mean(), self.half_difference());
        if !(half > UMBILIC * (mean.abs() + half) && half * self.reach > FLAT) {
            return None;
        }
        let [a, b, c] = self.form;
        let angle = 0.5 * b.atan2(0.5 * (a - c));
        let first = self.u * angle.cos() + self.v * angle.sin();
        Some([first, self.u.cross(self.v).cross(first)])
    }
}

/// Angle (in `[0, pi/4]`, radians) between a direction and the nearer of two perpendicular ones.
pub(super) fn angle_to(along: Vec3, [first, second]: [Vec3; 2]) -> f64 {
    let (x, y) = (along.dot(first).abs(), along.dot(second).abs());
    x.min(y).atan2(x.max(y))
}

/// Coefficients `a, b, c` of the least squares of [`Curvature::at`], by the normal equations in the scale that
/// the points have along each axis; `None` where they lie on a conic.
fn quadric(local: &[[f64; 3]; 9], corners: f64) -> Option<[f64; 3]> {
    let [reach_u, reach_v] = [0, 1].map(|axis| local.iter().map(|d| d[axis].abs()).fold(0.0, f64::max));
    let mut rows = [[0.0; 7]; 6];
    for (place, [u, v, z]) in local.iter().map(|[u, v, z]| [u / reach_u, v / reach_v, *z]).enumerate() {
        let weight = if place < 5 { 1.0 } else { corners };
        let terms = [1.0, u, v, 0.5 * u * u, u * v, 0.5 * v * v, z];
        for i in 0..6 {
            for j in 0..7 {
                rows[i][j] += weight * terms[i] * terms[j];
            }
        }
    }
    for k in 0..6 {
        // Positive definite unless the vertices lie on a conic: the diagonal serves as pivot. Its values are near 1.
        if !(rows[k][k] > 1e-9) {
            return None;
        }
        let pivot = rows[k];
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(pivot).skip(k).for_each(|(x, p)| *x -= factor * p);
        }
    }
    let solution = |k: usize| rows[k][6] / rows[k][k];
    let [uu, uv, vv] = [reach_u * reach_u, reach_u * reach_v, reach_v * reach_v];
    Some([solution(3) / uu, solution(4) / uv, solution(5) / vv])
}
