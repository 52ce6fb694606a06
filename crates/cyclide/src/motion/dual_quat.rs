//! Dual quaternions `p + ε r`, `ε² = 0`: displacements are multiplied as they are carried out.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use std::ops::{Add, Mul, Sub};

/// A dual quaternion `real + ε dual` in the usual convention: a displacement with the rotation `p` (unit) and the translation `τ` is
/// `p + ε ½ τ p`, and the product does the right factor first (`docs/math/motions.md#dual-quaternions`).
///
/// ```
/// use cyclide::{Quat, Vec3, motion::DualQuat};
/// let quarter = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
/// let turn = DualQuat::from_rotation_translation(quarter, Vec3::ZERO);
/// let step = DualQuat::from_rotation_translation(Quat::ONE, Vec3::X);
/// let both = turn * step; // the step first, then the turn
/// assert!((both.translation().unwrap() - Vec3::Y).length() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DualQuat {
    /// The part without ε: the rotation.
    pub real: Quat,
    /// The part with ε: half the translation times the rotation.
    pub dual: Quat,
}

impl DualQuat {
    /// The displacement that moves nothing.
    pub const IDENTITY: Self = Self { real: Quat::ONE, dual: Quat::ZERO };

    /// The displacement `x ↦ p x p⁻¹ + τ` of a rotation of any length but zero: `p + ε ½ τ p`.
    #[must_use]
    pub fn from_rotation_translation(rotation: Quat, translation: Vec3) -> Self {
        Self { real: rotation, dual: Quat::from(translation * 0.5) * rotation }
    }

    /// Conjugate of both parts: of a displacement with a rotation of length 1 the inverse.
    #[must_use]
    pub fn conj(self) -> Self {
        Self { real: self.real.conj(), dual: self.dual.conj() }
    }

    /// `p·r`: zero on the Study quadric, where the displacements are.
    #[must_use]
    pub fn study_product(self) -> f64 {
        self.real.dot(self.dual)
    }

    /// `p·r' + r·p'`: the bilinear form of the quadric, zero where the relative displacement is a rotation or a translation.
    #[must_use]
    pub fn study_form(self, other: Self) -> f64 {
        self.real.dot(other.dual) + self.dual.dot(other.real)
    }

    /// The point of the quadric on the same fiber, `r − (p·r)/(p·p) p`: division by a real dual number, so it commutes with products by
    /// displacements. `None` if the real part is zero.
    #[must_use]
    pub fn fibre_projected(self) -> Option<Self> {
        let unit = self.real.norm();
        let p = self.real * (1.0 / unit);
        let dual = self.dual - p * p.dot(self.dual);
        (unit > 0.0 && dual.is_finite()).then_some(Self { real: self.real, dual })
    }

    /// The translation `2 Im(r p⁻¹)` of the fiber; `None` if the real part is zero.
    #[must_use]
    pub fn translation(self) -> Option<Vec3> {
        let inverse = self.real.inverse()?;
        let translation = (self.dual * inverse).vector() * 2.0;
        translation.is_finite().then_some(translation)
    }

    /// Where the displacement of the fiber takes a point; `None` if the real part is zero.
    ///
    /// ```
    /// use cyclide::{Point3, Quat, Vec3, motion::DualQuat};
    /// let step = DualQuat::from_rotation_translation(Quat::ONE, Vec3::new(0.0, 2.0, 0.0));
    /// assert_eq!(step.apply(Point3::new(1.0, 0.0, 0.0)).unwrap().to_array(), [1.0, 2.0, 0.0]);
    /// ```
    #[must_use]
    pub fn apply(self, point: Point3) -> Option<Point3> {
        let translation = self.translation()?;
        let unit = self.real * (1.0 / self.real.norm());
        let image = Point3::ORIGIN + unit.rotate(point.to_vec()) + translation;
        image.is_finite().then_some(image)
    }

    /// True if every coefficient is finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.real.is_finite() && self.dual.is_finite()
    }

    /// The eight coefficients, real part first.
    pub(crate) fn to_array(self) -> [f64; 8] {
        let (p, r) = (self.real.to_array(), self.dual.to_array());
        [p[0], p[1], p[2], p[3], r[0], r[1], r[2], r[3]]
    }

    /// From eight coefficients, real part first.
    pub(crate) fn from_array([a, b, c, d, e, f, g, h]: [f64; 8]) -> Self {
        Self { real: Quat::new(a, b, c, d), dual: Quat::new(e, f, g, h) }
    }
}

impl Mul for DualQuat {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { real: self.real * other.real, dual: self.real * other.dual + self.dual * other.real }
    }
}
impl Mul<f64> for DualQuat {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { real: self.real * factor, dual: self.dual * factor }
    }
}
impl Add for DualQuat {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { real: self.real + other.real, dual: self.dual + other.dual }
    }
}
impl Sub for DualQuat {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { real: self.real - other.real, dual: self.dual - other.dual }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn displacement(k: f64) -> DualQuat {
        DualQuat::from_rotation_translation(Quat::new(1.0, 0.3 * k, -0.7, 0.2 * k), Vec3::new(k, -2.0 * k, 0.5))
    }

    #[test]
    fn products_are_compositions_and_conjugates_inverses() {
        let (a, b, x) = (displacement(1.0), displacement(-0.4), Point3::new(0.3, -1.0, 2.0));
        let twice = a.apply(b.apply(x).unwrap()).unwrap();
        assert!((a * b).apply(x).unwrap().distance(twice) < 1e-14);
        assert!(a.conj().apply(a.apply(x).unwrap()).unwrap().distance(x) < 1e-14);
        assert!((a * b).study_product().abs() < 1e-14);
    }

    #[test]
    fn fibre_projection_commutes_with_displacements() {
        let off = DualQuat { real: Quat::new(0.4, -1.0, 0.2, 0.9), dual: Quat::new(1.0, 2.0, -0.5, 0.3) };
        for (left, right) in [(displacement(2.0), DualQuat::IDENTITY), (DualQuat::IDENTITY, displacement(-1.3))] {
            let after = (left * off * right).fibre_projected().unwrap();
            let before = left * off.fibre_projected().unwrap() * right;
            let (d, size) = (after - before, before.dual.norm());
            assert!(d.real.norm() + d.dual.norm() < 1e-14 * size, "{d:?}");
            assert!(after.study_product().abs() < 1e-14 * size);
        }
        assert!(DualQuat { real: Quat::ZERO, dual: Quat::ONE }.fibre_projected().is_none());
    }
}
