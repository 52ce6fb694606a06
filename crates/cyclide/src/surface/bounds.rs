//! Boxes around patches in closed form.
//!
//! A coordinate `x = e·f` (`e` a unit vector of an axis) is extreme on a patch at a corner, inside a side, or inside:
//!
//! - Inside a side `t = 0`, where `f_s = q1 D V1 ~D/|D|⁴`: where the quadratic `e·(D V1 ~D)` vanishes.
//! - Inside, where the normal `N = D V3 D^-1` is `±e` (elsewhere `x` grows along the surface), or where a parameter
//!   line has shrunk to a point, which is then a point of two opposite sides. `D V3 = ±e D` is *linear* in `D`: with
//!   `p_k = w_k ∓ e w_k V3`, which lie in one plane of R⁴ because `q -> e q V3` is an involution, it reads
//!   `X(s)(1-t) + Y(s) t = 0`, `X = p0 (1-s) + p1 s`, `Y = p2 (1-s) + p3 s`. Left multiplication by `e` turns that
//!   plane by a right angle, so `s` is a root of the quadratic `(e X)·Y`.
//!
//! Every candidate is a point of the surface, so the box is never too large; the surface is stationary at each, so a
//! rounded root costs the box its square only. Where a quadratic vanishes identically (the coordinate is constant
//! along a line) the line ends at corners or sides, which have been looked at.

use super::{CyclidePatch, ParamSurface as _};
use crate::base::bounds::Aabb;
use crate::base::quat::Quat;
use crate::base::roots::projective_quadratic;
use crate::base::vector::Vec3;

impl CyclidePatch {
    /// The smallest box around the patch, to rounding (some 1e-15 of the size and of the distance from the origin).
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let [a0, a1, a2, a3] = self.corners();
        let mut bounds = Aabb::of_point(a0).including(a1).including(a2).including(a3);
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            for (s, t) in self.side_extremes(axis) {
                bounds = bounds.including(self.point(s, t));
            }
            for (s, t) in self.places_of_normal(axis).into_iter().chain(self.places_of_normal(-axis)).flatten() {
                bounds = bounds.including(self.point(s, t));
            }
        }
        bounds
    }

    /// Where the coordinate along `axis` is stationary on the four sides.
    fn side_extremes(&self, axis: Vec3) -> impl Iterator<Item = (f64, f64)> {
        let (w, [v1, v2, _]) = (self.weights(), self.frame());
        // The vector parts of w_i V ~w_j and w_j V ~w_i are equal.
        let product = |i: usize, j: usize, v: Vec3| axis.dot((w[i] * Quat::from(v) * w[j].conj()).vector());
        let roots = |i: usize, j: usize, v: Vec3| quadratic(product(i, i, v), product(i, j, v), product(j, j, v));
        let [along_s, along_t] = [[roots(0, 1, v1), roots(2, 3, v1)], [roots(0, 2, v2), roots(1, 3, v2)]];
        let s_lines =
            along_s.into_iter().zip([0.0, 1.0]).flat_map(|(r, t)| r.into_iter().flatten().map(move |s| (s, t)));
        let t_lines =
            along_t.into_iter().zip([0.0, 1.0]).flat_map(|(r, s)| r.into_iter().flatten().map(move |t| (s, t)));
        s_lines.chain(t_lines)
    }

    /// The places where the unit normal `D V3 D^-1` is the given unit vector: two at most, where it is not a whole line.
    fn places_of_normal(&self, normal: Vec3) -> [Option<(f64, f64)>; 2] {
        let (e, v3) = (Quat::from(normal), Quat::from(self.frame()[2]));
        // e q V3 = -q exactly where q V3 = e q.
        let p = self.weights().map(|w| w + e * w * v3);
        let area = |i: usize, j: usize| (e * p[i]).dot(p[j]);
        let roots = quadratic(area(0, 2), 0.5 * (area(0, 3) + area(1, 2)), area(1, 3));
        roots.map(|root| {
            let s = root?;
            let (x, y) = (p[0] * (1.0 - s) + p[1] * s, p[2] * (1.0 - s) + p[3] * s);
            // X and Y are parallel: t = |X|²/(|X|² - X·Y) of the point between them that vanishes.
            let (xx, yy, xy) = (x.norm_squared(), y.norm_squared(), x.dot(y));
            let t = if xx >= yy { xx / (xx - xy) } else { -xy / (yy - xy) };
            (0.0..=1.0).contains(&t).then_some((s, t))
        })
    }
}

/// Roots in `[0, 1]` of the quadratic with the Bernstein coefficients `a, b, c`; a double root spread by rounding over
/// the complex numbers is taken at its real part.
fn quadratic(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    projective_quadratic(a, b, c, (b * b - a * c).max(0.0).sqrt())
}
