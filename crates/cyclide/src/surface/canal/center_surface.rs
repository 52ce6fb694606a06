//! The surface of the centers of all balls that touch two pipes, as an exact biquadratic patch (`docs/math/canal-blends.md#the-surface-of-centers`;
//! source: `002`, section 4 and Fig. 4).
//!
//! The diamond of places is a square in `u = B - A`, `v = B + A`, both between 0 and pi, and what a ball is made of is linear in cosine and sine of
//! `2A = v - u` and of `2B = v + u`: of degree 1 in those of u, and of v. An angle that runs from `a` to `b`, less than half a turn, has with the weights
//! `1, cos((b-a)/2), 1` cosine and sine of degree 2, with those of the angles `a, (a+b)/2, b` for coefficients; so products have those of sums and differences.

use super::ball_space::BallVector;
use super::{QuadricPair, SkewCylinders};
use crate::base::vector::Vec3;
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::RationalBezierSurface;
use std::f64::consts::PI;

/// A ball in homogeneous coordinates: both parts have this weight for a factor.
pub(super) type WeightedBall = (BallVector, f64);

impl SkewCylinders {
    /// The centers of the balls at the places with `B - A` and `B + A` between these angles: the first runs along s, the second along t. Weights are positive.
    ///
    /// ```
    /// use cyclide::surface::SkewCylinders;
    /// let pair = SkewCylinders::new([1.0, 1.5], 2.0)?;
    /// let centers = pair.center_surface([0.5, 2.5], [0.4, 2.6])?;
    /// let m = centers.point(0.3, 0.8);
    /// // Both balls that reach it have one radius.
    /// let [first, second] = [m.y.hypot(m.z + 2.0) - 1.0, m.x.hypot(m.z - 2.0) - 1.5];
    /// assert!((first - second).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` unless both rise between 0 and pi.
    pub fn center_surface(&self, u: [f64; 2], v: [f64; 2]) -> Result<RationalBezierSurface> {
        rational(self.weighted_balls(u, v)?)
    }

    /// Coefficients of the balls, those along t next to each other.
    pub(super) fn weighted_balls(&self, u: [f64; 2], v: [f64; 2]) -> Result<Vec<WeightedBall>> {
        let [u, v] = [coefficients(u)?, coefficients(v)?];
        let (h, d, root) = (self.half_gap(), self.difference(), self.width());
        let [_, across] = self.second_axis();
        let mut balls = Vec::with_capacity(9);
        for (alpha, first_unit) in u {
            for (beta, second_unit) in v {
                let ((sin_a, cos_a), sin_b) = ((beta - alpha).sin_cos(), (beta + alpha).sin());
                let (unit, weight) = (first_unit * second_unit, 2.0 * alpha.sin() * beta.sin());
                let (first, second) = (root * sin_a, root * sin_b);
                let center =
                    Vec3::new((second - first * across.y) / across.x, first, 2.0 * h * cos_a - d * unit - weight * h);
                let radius = 2.0 * h * unit - d * cos_a - weight * self.radii()[0];
                balls.push((BallVector { center, radius }, weight));
            }
        }
        Ok(balls)
    }
}

impl QuadricPair {
    /// The centers of the balls at the places with `B - A` and `B + A` between these angles, as
    /// [those of two cylinders](SkewCylinders::center_surface).
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::{NaturalQuadric, QuadricPair}};
    /// let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::X, 1.0)?;
    /// let cone = NaturalQuadric::cone(Point3::new(0.0, -4.0, 3.0), Vec3::Y, 0.2)?;
    /// let centers = QuadricPair::new([pipe, cone])?.center_surface([0.8, 2.2], [0.9, 2.4])?;
    /// let m = centers.point(0.3, 0.8);
    /// // From the cone, whose apex is 4 back: its surface leans by 0.2.
    /// let from_cone = m.x.hypot(m.z - 3.0) * 0.2_f64.cos() - (m.y + 4.0) * 0.2_f64.sin();
    /// assert!((m.y.hypot(m.z) - 1.0 - from_cone).abs() < 1e-13);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-timelike-pair`; as [`SkewCylinders::center_surface`].
    pub fn center_surface(&self, u: [f64; 2], v: [f64; 2]) -> Result<RationalBezierSurface> {
        self.moved()?.center_surface(u, v)
    }
}

/// The three angles of the coefficients, with the weights of 1.
fn coefficients([from, to]: [f64; 2]) -> Result<[(f64, f64); 3]> {
    for (index, angle) in [from, to].into_iter().enumerate() {
        if !angle.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index }.into());
        }
    }
    if !(0.0 < from && from < to && to < PI) {
        let (value, min) = if 0.0 < from && from < PI { (to, from) } else { (from, 0.0) };
        return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Angle, value, min, max: PI }.into());
    }
    Ok([(from, 1.0), (0.5 * (from + to), (0.5 * (to - from)).cos()), (to, 1.0)])
}

/// The centers.
pub(super) fn rational(balls: Vec<WeightedBall>) -> Result<RationalBezierSurface> {
    let row = |(BallVector { center, .. }, weight): WeightedBall| [center.x, center.y, center.z, weight];
    RationalBezierSurface::new([2, 2], balls.into_iter().map(row).collect())
}
