//! The circles of the parameter lines and of the principal curvatures, in closed form.

use super::CyclidePatch;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Circle;
use crate::surface::ParamSurface as _;

/// A line whose bending vector is this part of its weights is straight.
const STRAIGHT: f64 = 1e-14;

/// Center, unit normal (the line runs right-handed about it) and radius of a parameter line.
pub(super) struct LineCircle {
    pub(super) center: Point3,
    pub(super) normal: Vec3,
    pub(super) radius: f64,
}

impl CyclidePatch {
    /// The full circle that carries the s-line at `t`, starting at `(0, t)` in the direction of growing s: radius
    /// `|q1|/(2|m|)`, center `f + k/|k|²` with the curvature vector `k = (2/q1) D (m × V1) D^-1`
    /// (`docs/math/patches.md#curvatures`). `None` where the line is straight or one point.
    #[must_use]
    pub fn s_circle(&self, t: f64) -> Option<Circle> {
        let circle = self.s_line_circle(t)?;
        Circle::from_center(circle.center, circle.normal, self.point(0.0, t)).ok()
    }

    /// The full circle that carries the t-line at `s`, starting at `(s, 0)`; as [`s_circle`](Self::s_circle).
    #[must_use]
    pub fn t_circle(&self, s: f64) -> Option<Circle> {
        let circle = self.t_line_circle(s)?;
        Circle::from_center(circle.center, circle.normal, self.point(s, 0.0)).ok()
    }

    /// The circles of curvature of the two principal normal sections at `(s, t)`: center `f + N/k`, in the plane of
    /// `N` and the principal direction, starting at the point. `None` where the curvature is zero (radius above 1e14 of
    /// the patch's size) or infinite.
    #[must_use]
    pub fn curvature_circles(&self, s: f64, t: f64) -> [Option<Circle>; 2] {
        let (point, [e1, e2, n]) = (self.point(s, t), self.moving_frame(s, t));
        [(e1, self.k1(t)), (e2, self.k2(s))].map(|(direction, k)| {
            let toward = n * (1.0 / k);
            let flat = !(toward.length() * STRAIGHT <= self.scale);
            if flat { None } else { Circle::from_center(point + toward, direction.cross(toward), point).ok() }
        })
    }

    pub(super) fn s_line_circle(&self, t: f64) -> Option<LineCircle> {
        self.line_circle([(0.0, t), (1.0, t)], self.polar.q1_at(t), self.polar.m_at(t), self.v[0])
    }

    pub(super) fn t_line_circle(&self, s: f64) -> Option<LineCircle> {
        self.line_circle([(s, 0.0), (s, 1.0)], self.polar.q2_at(s), self.polar.m_star_at(s), self.v[1])
    }

    /// The line from the first place to the second, with speed `q`, bending vector `m` and constant direction `v`.
    fn line_circle(&self, [from, to]: [(f64, f64); 2], q: f64, m: Vec3, v: Vec3) -> Option<LineCircle> {
        let (d0, d1) = (self.denominator(from.0, from.1), self.denominator(to.0, to.1));
        let bend = m.length();
        if q == 0.0 || bend <= STRAIGHT * d0.norm() * d1.norm() {
            return None;
        }
        let unit = d0 * (1.0 / d0.norm());
        let m = m / bend;
        let radius = q.abs() / (2.0 * bend);
        let center = self.point(from.0, from.1) + unit.rotate(m.cross(v)) * (0.5 * q / bend);
        Some(LineCircle { center, normal: unit.rotate(m), radius })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_of_a_torus() {
        // R = 3, r = 1: s along the tube from the outer equator, t about the z axis.
        let at = |u: f64, v: f64| {
            let rho = 3.0 + v.cos();
            Point3::new(rho * u.cos(), rho * u.sin(), v.sin())
        };
        let corners = [at(0.0, 0.0), at(0.0, 1.0), at(2.0, 0.0), at(2.0, 1.0)];
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Z, Vec3::Y).unwrap();
        for t in [0.0, 0.3, 1.0] {
            let tube = patch.s_circle(t).unwrap();
            let centre = tube.center().to_vec();
            assert!((tube.radius() - 1.0).abs() < 1e-14 && (centre.length() - 3.0).abs() < 1e-14);
            assert!(centre.z.abs() < 1e-14 && (tube.closest_point(patch.point(0.7, t)).distance) < 1e-14);
            let jet = patch.jet(0.0, t);
            assert!((tube.tangent_at(jet.point).unwrap() - jet.ds.unit().unwrap()).length() < 1e-14);
        }
        let parallel = patch.t_circle(1.0).unwrap();
        assert!(parallel.center().distance(Point3::new(0.0, 0.0, 1.0f64.sin())) < 1e-14);
        assert!((parallel.normal() - Vec3::Z).length() < 1e-14, "t grows with the angle");
        // The center of the second curvature is on the axis, where the normal meets it.
        let [first, second] = patch.curvature_circles(0.4, 0.6).map(Option::unwrap);
        assert!((first.radius() - 1.0).abs() < 1e-14);
        assert!(second.center().x.hypot(second.center().y) < 1e-13);
    }

    #[test]
    fn a_plane_has_no_circles_of_curvature() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (2.0, 1.0)].map(|(x, y)| Point3::new(x, y, 0.0));
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap();
        assert!(patch.s_circle(0.5).is_none() && patch.t_circle(0.5).is_none());
        assert_eq!(patch.curvature_circles(0.5, 0.5), [None, None]);
    }
}
