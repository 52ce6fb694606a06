//! Curvature and its variation at both ends of a blend, in closed form
//! (`docs/math/fair-splines.md#law-and-end-curvature`).
//!
//! With the angle `p l + q l² + ...` near the start, `b` the unit vector across `t1` and `b'` the direction at the end
//! back to the first arc:
//!
//! ```text
//! K0 = (2/d) (u - c1 t1 + p b),    K1 = (2/d) (-u + c2 te - p b')
//! V0 = (6/d²) (q - p) b,           V1 = (6/d²) (q - p) b'
//! ```

use super::angle_law::BlendLaw;
use super::segment::BlendSegment;
use crate::base::vector::Vec3;

impl BlendSegment {
    /// The curvature vectors at both ends of the whole segment: toward the center of curvature, as long as the curvature.
    #[must_use]
    pub fn end_curvatures(&self) -> [Vec3; 2] {
        let ([te, back], [p, _]) = (self.end_directions(), self.law.end_rates());
        let (u, t1, w) = (self.u, self.t1, 2.0 / self.length);
        [(u - t1 * u.dot(t1) + self.b * p) * w, (te * u.dot(te) - u - back * p) * w]
    }

    /// The normal parts of the derivatives of the curvature vector by arc length at both ends of the whole segment.
    /// They are of one length, which is why fair segments are nearly Euler spirals.
    #[must_use]
    pub fn end_variations(&self) -> [Vec3; 2] {
        let ([_, back], [p, q]) = (self.end_directions(), self.law.end_rates());
        let size = 6.0 * (q - p) / self.length / self.length;
        [self.b * size, back * size]
    }

    /// The segment's term of the energy whose critical points are the fair splines
    /// (`docs/math/fair-splines.md#energy`): half the bending energy for small angles.
    #[must_use]
    pub fn fair_energy(&self) -> f64 {
        let blend = match self.law.law {
            BlendLaw::Fair { blend } => blend,
            BlendLaw::Rational { order: 1 } => 1.0,
            _ => 0.0,
        };
        let [te, _] = self.end_directions();
        let arcs = 2.0 - self.u.dot(self.t1) - self.u.dot(te);
        2.0 / self.length * (arcs + 4.0 * blend * (1.0 - self.law.half[0]))
    }

    /// End tangent of the whole segment, and the direction there back to the first arc.
    fn end_directions(&self) -> [Vec3; 2] {
        let [c, s] = self.law.full();
        [(self.t1 * c + self.b * s).reflect(self.u), (self.t1 * s - self.b * c).reflect(self.u)]
    }
}
