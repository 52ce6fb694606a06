//! Principal curvatures in closed form.

use super::CyclidePatch;

impl CyclidePatch {
    /// Principal curvature along the s-lines, against [`unit_normal`](Self::unit_normal) (`N_s = -k1 f_s`):
    /// `k1 = -2 m·V2/q1`, constant along each s-line (`docs/math/patches.md#curvatures`). Infinite or NaN where the
    /// line is one point.
    #[must_use]
    pub fn k1(&self, t: f64) -> f64 {
        -2.0 * self.polar.m_at(t).dot(self.v[1]) / self.polar.q1_at(t)
    }

    /// Principal curvature along the t-lines, `k2 = 2 m*·V1/q2`, constant along each t-line.
    #[must_use]
    pub fn k2(&self, s: f64) -> f64 {
        2.0 * self.polar.m_star_at(s).dot(self.v[0]) / self.polar.q2_at(s)
    }
}
