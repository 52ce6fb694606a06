//! Extremes of the principal curvatures over a patch, in closed form.

use super::CyclidePatch;
use super::singular::roots;

impl CyclidePatch {
    /// Smallest and largest of the finite values that the principal curvature along the s-lines, [`k1`](Self::k1), takes
    /// at the ends of [0, 1] and where it is stationary. These are its extremes over the patch, but where an s-line
    /// is a node or a singular line inside: towards those named by [`node_t`](Self::node_t) and
    /// [`singular_t`](Self::singular_t) the curvature grows beyond all bounds. `[INFINITY, -INFINITY]` if there is no
    /// such value.
    #[must_use]
    pub fn k1_range(&self) -> [f64; 2] {
        range(self.polar.m.map(|m| -2.0 * m.dot(self.v[1])), self.polar.q1, self.speed_rounding(0.0)[0], &self.node_t())
    }

    /// The same of the principal curvature along the t-lines, [`k2`](Self::k2), with [`node_s`](Self::node_s) and
    /// [`singular_s`](Self::singular_s).
    #[must_use]
    pub fn k2_range(&self) -> [f64; 2] {
        range(
            self.polar.m_star.map(|m| 2.0 * m.dot(self.v[0])),
            self.polar.q2,
            self.speed_rounding(0.0)[1],
            &self.node_s(),
        )
    }
}

/// Finite extremes over [0, 1] of a quotient of quadratics `p/q` in Bernstein form: at the ends, and where the Wronskian
/// of the two quadratics is zero, which is a quadratic again.
fn range(p: [f64; 3], q: [f64; 3], rounding: [f64; 3], nodes: &[f64]) -> [f64; 2] {
    let (mut p, mut q) = (p, q);
    for (end, at) in [(0, 0.0), (2, 1.0)] {
        if q[end] == 0.0 {
            // A zero of the speed that is double but for rounding is double.
            if q[1].abs() <= rounding[1] {
                q[1] = 0.0;
            }
            // At a pole both quadratics vanish, the first but for rounding.
            if !nodes.contains(&at) {
                p[end] = 0.0;
            }
        }
    }
    // The value at an end, at a pole the limit: its factor is cancelled.
    let limit = |end: usize| {
        if q[end] != 0.0 {
            Some(p[end] / q[end])
        } else if nodes.contains(&(0.5 * end as f64)) {
            None
        } else {
            Some(if q[1] != 0.0 { p[1] / q[1] } else { p[2 - end] / q[2 - end] })
        }
    };
    let minor = |i: usize, j: usize| p[j] * q[i] - p[i] * q[j];
    let inside = roots([minor(0, 1), 0.5 * minor(0, 2), minor(1, 2)], [0.0; 3]);
    let at = |t: f64| {
        let value = |c: [f64; 3]| (1.0 - t) * ((1.0 - t) * c[0] + 2.0 * t * c[1]) + t * t * c[2];
        value(p) / value(q)
    };
    let values = [limit(0), limit(2)].into_iter().flatten().chain(inside.into_iter().map(at));
    values.filter(|k| k.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], k| [lo.min(k), hi.max(k)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};

    #[test]
    fn a_pole_has_the_limit_and_a_node_no_bound() {
        let octant = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v);
        let octant = CyclidePatch::from_corners_and_frame(octant, Vec3::Y, Vec3::Z).unwrap();
        assert!(octant.node_t().is_empty() && octant.node_s().is_empty());
        // A cone of slope 1 with its tip at a2 = a3, normal outward: k1 = -1/(r sqrt 2).
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
        let up = Vec3::new(-1.0, 0.0, 1.0).unit().unwrap();
        let cone = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, up).unwrap();
        assert_eq!((cone.node_t(), cone.node_s()), (vec![1.0], vec![]));
        for (range, k) in [(octant.k1_range(), -1.0), (octant.k2_range(), -1.0), (cone.k1_range(), -(0.5_f64.sqrt()))] {
            assert!((range[0] - k).abs() < 1e-13 && (range[1] - k).abs() < 1e-13, "{range:?} {k}");
        }
    }

    #[test]
    fn the_range_holds_every_sample_and_is_reached() {
        let point = |a: f64| Point3::new(2.0 * a.cos(), 2.0 * a.sin(), 0.5);
        let [p0, p1, p3, p2] = [0.1, 1.4, 2.9, 5.0].map(point);
        let v1 = Vec3::new(0.9, -0.3, 0.4).unit().unwrap();
        let v2 = v1.cross(Vec3::new(0.1, 0.4, 0.7)).unit().unwrap();
        let patch = CyclidePatch::from_corners_and_frame([p0, p1, p2, p3], v1, v2).unwrap();
        assert!(patch.is_regular());
        for (range, at) in
            [(patch.k1_range(), &(|t| patch.k1(t)) as &dyn Fn(f64) -> f64), (patch.k2_range(), &|s| patch.k2(s))]
        {
            let sampled: Vec<f64> = (0..=10_000).map(|i| at(f64::from(i) / 10_000.0)).collect();
            let low = sampled.iter().fold(f64::INFINITY, |a, b| a.min(*b));
            let high = sampled.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
            let size = high - low;
            assert!(range[0] <= low && range[1] >= high);
            // Samples miss a smooth extreme by the square of their distance, 1e-8.
            assert!(low - range[0] < 1e-6 * size && range[1] - high < 1e-6 * size, "{range:?} {low} {high}");
        }
    }
}
