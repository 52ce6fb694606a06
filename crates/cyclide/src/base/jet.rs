//! A point of a curve with its derivatives, and what follows from them alone.

use super::vector::{Point3, Vec3};

/// Speeds up to this part of the largest of their piece are a stand: of the length of the next derivatives, next to an end.
pub(crate) const AT_REST: f64 = 1e-9;
/// Derivatives up to so many roundings of what they are made of may be zero: of products, of sums and of inserted knots.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// Derivatives whose directions differ by a smaller sine are parallel: a curve that starts along them from rest is straight there.
const PARALLEL: f64 = 1e-6;

/// A point of a curve with its first three derivatives.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, ParamCurve}};
/// let jet = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?.jet(0.25);
/// assert!((jet.signed_curvature(Vec3::Z).expect("it moves") - 0.5).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CurveJet {
    /// The point.
    pub point: Point3,
    /// First derivative.
    pub d1: Vec3,
    /// Second derivative.
    pub d2: Vec3,
    /// Third derivative.
    pub d3: Vec3,
}

impl CurveJet {
    /// Unit tangent; `None` where the first derivative vanishes.
    #[must_use]
    #[inline]
    pub fn tangent(&self) -> Option<Vec3> {
        self.d1.unit()
    }

    /// Unit direction of travel from the first derivative that does not vanish, on the side ahead (`side` +1, as at the start
    /// of a piece) or behind (-1, as at its end). `None` if all three vanish.
    pub(crate) fn limit_tangent(&self, side: f64) -> Option<Vec3> {
        // x'(s0 + h) = d1 + h d2 + h²/2 d3 with h of the sign of `side`.
        self.d1.unit().or_else(|| (self.d2 * side).unit()).or_else(|| self.d3.unit())
    }

    /// The jet of an end of a piece without derivatives that are rounding: the first ones vanish that are some roundings of what they are made of,
    /// coordinates of this `size`, and as good as nothing against those that follow. What is left of them has no direction.
    pub(crate) fn without_rounding(self, size: f64) -> Self {
        let rounding = ROUNDINGS * size;
        let stands = |d: Vec3, next: f64| d.max_abs() <= rounding.min(AT_REST * next);
        let mut jet = self;
        if stands(jet.d1, jet.d2.max_abs().max(jet.d3.max_abs())) {
            jet.d1 = Vec3::ZERO;
            if stands(jet.d2, jet.d3.max_abs()) {
                jet.d2 = Vec3::ZERO;
            }
        }
        jet
    }

    /// Of a jet without speed: whether the curvature next to it has no bound, since the next two derivatives point apart.
    pub(crate) fn bends_from_rest(&self) -> bool {
        // A third derivative next to nothing may be rounding: what it bends is next to nothing, too.
        let third = self.d3 / self.d3.max_abs().max(self.d2.max_abs());
        self.d2.unit().is_some_and(|second| second.cross(third).length() > PARALLEL)
    }

    /// Speed, the length of the first derivative.
    #[must_use]
    #[inline]
    pub fn speed(&self) -> f64 {
        self.d1.length()
    }

    /// Curvature vector: second derivative by arc length, pointing to the center of curvature, length `1/R`.
    /// `None` where the first derivative vanishes. Zero on a straight line.
    #[must_use]
    #[inline]
    pub fn curvature_vector(&self) -> Option<Vec3> {
        let t = self.tangent()?;
        let v = self.speed();
        Some((self.d2 - t * self.d2.dot(t)) / v / v)
    }

    /// Curvature `|x' × x''|/|x'|³` (never negative).
    #[must_use]
    #[inline]
    pub fn curvature(&self) -> Option<f64> {
        self.curvature_vector().map(Vec3::length)
    }

    /// Curvature signed by a plane normal: positive where the curve turns left seen against `normal`.
    #[must_use]
    #[inline]
    pub fn signed_curvature(&self, normal: Vec3) -> Option<f64> {
        let (t, k) = (self.tangent()?, self.curvature_vector()?);
        Some(t.cross(k).dot(normal))
    }

    /// Torsion `(x' × x'')·x''' / |x' × x''|²`; `None` where the curvature vanishes.
    #[must_use]
    #[inline]
    pub fn torsion(&self) -> Option<f64> {
        let b = self.d1.cross(self.d2);
        let b2 = b.length_squared();
        let torsion = b.dot(self.d3) / b2;
        (b2 > 0.0 && torsion.is_finite()).then_some(torsion)
    }

    /// The jet with respect to a parameter that runs `factor` times as slowly (derivatives times `factor^k`).
    #[must_use]
    #[inline]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            point: self.point,
            d1: self.d1 * factor,
            d2: self.d2 * (factor * factor),
            d3: self.d3 * (factor * factor * factor),
        }
    }
}
