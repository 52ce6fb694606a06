//! Möbius maps of arcs: the homogeneous pairs map linearly, so the image is an arc with the same parameter.

use super::Arc;
use crate::base::quat::Quat;
use crate::conformal::hpoint::HPoint;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, Result};

impl Conformal for Arc {
    /// The image under a Möbius map, with the same parameter (`10`, section 1.6).
    ///
    /// # Errors
    /// `pole-on-segment` if the arc passes through the point that goes to infinity, `point-at-infinity` if an end
    /// does, `not-in-im-h` if rounding destroyed the result.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let start = map.map_pair(HPoint::weighted(self.p0, Quat::ONE));
        let end = map.map_pair(HPoint::weighted(self.p1, self.weight_ratio()));
        let point = |p: HPoint| p.quotient().map(Quat::to_point).ok_or(Error::PointAtInfinity);
        let (a0, a1) = (point(start)?, point(end)?);
        let inverse = start.d.inverse().ok_or(Error::PointAtInfinity)?;
        Self::from_weight_ratio(a0, a1, end.d * inverse)
    }
}
