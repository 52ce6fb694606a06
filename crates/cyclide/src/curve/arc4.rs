//! The circular arc in four-space: end points and weights are any quaternions.
//!
//! ```text
//! xi(t) = (a0 w0 (1-t) + a1 w1 t) (w0 (1-t) + w1 t)^-1 = a0 + c (t w x^-1)
//! ```
//! (source: `000`, equations (4), (11), Proposition 3). The formulas of [`Arc`](crate::curve::Arc) hold with the quaternion
//! product `c p` in place of `c × p`; the condition that keeps an arc in three-space (Proposition 4) is not needed.

use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::Vec3;
use crate::error::{ArcError, ErrorItem, NumberError, Result};

/// A circular arc or straight segment in four-space, parametrised by a linear fraction over `t` in `[0, 1]`.
///
/// ```
/// use cyclide::{Quat, curve::Arc4};
/// let arc = Arc4::from_weights(Quat::new(0.0, 1.0, 0.0, 0.0), Quat::new(1.0, 0.0, 0.0, 0.0), Quat::ONE, Quat::new(1.0, 0.5, 0.0, 0.0))?;
/// assert_eq!(arc.point(0.0), arc.start());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc4 {
    a0: Quat,
    a1: Quat,
    /// Real part of the weight ratio `w1 w0^-1`.
    r: f64,
    /// Chord `a1 - a0`.
    c: Quat,
    /// Quaternion product of the chord and the vector part of the weight ratio.
    cp: Quat,
    /// Length of that vector part.
    pn: f64,
    /// Length of the weight ratio.
    n: f64,
}

impl Arc4 {
    /// The arc with end points and weights. Multiplying both weights on the right by a common quaternion changes
    /// nothing. Equal ends give a constant arc.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (size of the data), `zero-weight`, `pole-on-segment`.
    pub fn from_weights(start: Quat, end: Quat, start_weight: Quat, end_weight: Quat) -> Result<Self> {
        for (index, q) in [start, end].into_iter().enumerate() {
            range::check_point(index, q.vector())?;
            range::check_point(index, Vec3::new(q.w, 0.0, 0.0))?;
        }
        for (index, w) in [start_weight, end_weight].into_iter().enumerate() {
            if !w.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Weight, index }.into());
            }
            if w.norm() == 0.0 {
                return Err(ArcError::ZeroWeight { index }.into());
            }
        }
        let w = end_weight * start_weight.inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
        let (c, p) = (end - start, w.vector());
        range::check_distance(c.norm())?;
        range::check_weight_ratio(w.norm())?;
        let pn = p.length();
        let limit = 8.0 * f64::EPSILON * -w.w;
        if w.w < 0.0 && pn <= limit {
            return Err(ArcError::PoleOnSegment { real: w.w, vector: pn, limit }.into());
        }
        Ok(Self { a0: start, a1: end, r: w.w, c, cp: c * Quat::from(p), pn, n: w.norm() })
    }

    /// Start point.
    #[must_use]
    pub fn start(&self) -> Quat {
        self.a0
    }

    /// End point.
    #[must_use]
    pub fn end(&self) -> Quat {
        self.a1
    }

    /// The point at `t`, exact at both ends, without cancellation for lines.
    #[must_use]
    pub fn point(&self, t: f64) -> Quat {
        let (s, x, y) = (1.0 - t, 1.0 - t + t * self.r, t * self.pn);
        let d = 1.0 / (x * x + y * y);
        if t <= 0.5 {
            self.a0 + (self.c * (t * (t * self.n * self.n + s * self.r)) + self.cp * (t * s)) * d
        } else {
            self.a1 - (self.c * (s * x) - self.cp * (t * s)) * d
        }
    }

    /// Swept angle in `[0, 2 pi)`, radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        2.0 * self.pn.atan2(self.r)
    }

    /// Radius; `None` for a straight segment or one point.
    #[must_use]
    pub fn radius(&self) -> Option<f64> {
        let radius = 0.5 * self.c.norm() * (self.n / self.pn);
        (radius > 0.0 && radius.is_finite()).then_some(radius)
    }

    /// Center; `None` for a straight segment or one point.
    #[must_use]
    pub fn center(&self) -> Option<Quat> {
        self.radius()?;
        // -(c u) r/(2|p|) with u = p/|p|, about the middle of the chord
        let center = (self.a0 + self.a1) * 0.5 - self.cp * (0.5 * self.r / self.pn / self.pn);
        center.is_finite().then_some(center)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::Point3;
    use crate::curve::Arc;

    #[test]
    fn in_three_space_it_is_the_arc() {
        let (a, b) = (Point3::new(1.0, 2.0, -1.0), Point3::new(3.0, 1.0, 0.5));
        // A vector part across the chord (2, -1, 1.5).
        let (w0, w1) =
            (Quat::new(0.5, 1.0, -1.0, 2.0), Quat::new(-0.4, 0.5, 2.5, 1.0) * Quat::new(0.5, 1.0, -1.0, 2.0));
        let arc = Arc::from_weights(a, b, w0, w1).unwrap();
        let arc4 = Arc4::from_weights(a.into(), b.into(), w0, w1).unwrap();
        for i in 0..=8 {
            let t = f64::from(i) / 8.0;
            assert!((arc4.point(t) - Quat::from(arc.point(t))).norm() < 1e-14, "{t}");
        }
        assert!((arc4.angle() - arc.angle()).abs() < 1e-15);
        assert!((arc4.radius().unwrap() - arc.radius().unwrap()).abs() < 1e-14);
        assert!((arc4.center().unwrap() - arc.center().unwrap().into()).norm() < 1e-14);
    }

    #[test]
    fn every_point_is_at_the_radius_from_the_centre_in_four_space() {
        let (a, b) = (Quat::new(1.0, 0.5, -2.0, 0.0), Quat::new(-1.0, 2.0, 0.3, 1.0));
        let arc = Arc4::from_weights(a, b, Quat::ONE, Quat::new(-0.7, 1.0, -0.2, 0.4)).unwrap();
        let (center, radius) = (arc.center().unwrap(), arc.radius().unwrap());
        for i in 0..=16 {
            let p = arc.point(f64::from(i) / 16.0);
            assert!(((p - center).norm() - radius).abs() < 1e-14);
        }
        assert_eq!((arc.point(0.0), arc.point(1.0)), (a, b));
    }

    #[test]
    fn refuses_by_name() {
        let reason = |w0, w1| Arc4::from_weights(Quat::ZERO, Quat::ONE, w0, w1).unwrap_err().reason();
        assert_eq!(reason(Quat::ONE, Quat::ZERO), "zero-weight");
        assert_eq!(reason(Quat::ONE, -Quat::ONE), "pole-on-segment");
        assert_eq!(reason(Quat::ONE, Quat::ONE * f64::NAN), "not-finite");
        let segment = Arc4::from_weights(Quat::ZERO, Quat::ONE, Quat::ONE, Quat::ONE).unwrap();
        assert_eq!((segment.radius(), segment.center()), (None, None));
    }
}
