//! Extremes of the principal curvatures over a patch, in closed form.

use super::CyclidePatch;
use super::singular::roots;
use crate::base::vector::Vec3;

impl CyclidePatch {
    /// Smallest and largest principal curvature along the s-lines, [`k1`](Self::k1), over the patch; infinite where an
    /// s-line shrinks to a point with a curvature that does not vanish.
    #[must_use]
    pub fn k1_range(&self) -> [f64; 2] {
        self.range(self.polar.m, self.v[1], -2.0, self.polar.q1, |t| self.k1(t))
    }

    /// Smallest and largest principal curvature along the t-lines, [`k2`](Self::k2), over the patch.
    #[must_use]
    pub fn k2_range(&self) -> [f64; 2] {
        self.range(self.polar.m_star, self.v[0], 2.0, self.polar.q2, |s| self.k2(s))
    }

    /// Extremes over [0, 1] of `factor m·v/q`, a quotient of quadratics: at the ends, and where the Wronskian of the two
    /// quadratics is zero, which is a quadratic again.
    fn range(&self, m: [Vec3; 3], v: Vec3, factor: f64, q: [f64; 3], at: impl Fn(f64) -> f64) -> [f64; 2] {
        let p = m.map(|m| factor * m.dot(v));
        if !roots(q).is_empty() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let minor = |i: usize, j: usize| p[j] * q[i] - p[i] * q[j];
        let inside = roots([minor(0, 1), 0.5 * minor(0, 2), minor(1, 2)]);
        // The curvature at a side of one point is the limit, which rounding may make 0/0.
        let values = [0.0, 1.0].into_iter().chain(inside).map(at).filter(|k| !k.is_nan());
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], k| [lo.min(k), hi.max(k)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::Point3;

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
