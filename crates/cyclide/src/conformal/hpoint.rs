//! A point as a quaternion pair `n d^-1`.

use crate::base::quat::Quat;
use crate::base::vector::Point3;

/// The homogeneous pair `(n, d)` of the point `n d^-1`; `d = 0` is the point at infinity. Multiplying both on the
/// right by one quaternion changes nothing.
///
/// ```
/// use cyclide::{Point3, Quat, conformal::HPoint};
/// let p = Point3::new(1.0, 2.0, 3.0);
/// let weighted = HPoint::weighted(p, Quat::new(2.0, 0.0, 0.0, 1.0));
/// assert!((weighted.quotient().expect("it is finite").vector() - p.to_vec()).length() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HPoint {
    /// Numerator.
    pub n: Quat,
    /// Denominator, also called the weight.
    pub d: Quat,
}

impl HPoint {
    /// The pair `(a w, w)` of a point with a weight.
    #[must_use]
    pub fn weighted(point: Point3, weight: Quat) -> Self {
        Self { n: Quat::from(point) * weight, d: weight }
    }

    /// The quotient `n d^-1` as a quaternion; `None` at infinity.
    #[must_use]
    pub fn quotient(&self) -> Option<Quat> {
        self.d.inverse().map(|i| self.n * i).filter(|q| q.is_finite())
    }
}
