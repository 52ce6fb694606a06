//! Quaternions `[w, x, y, z]`, of any length: they are weights here, not only rotations.

use super::euclidean::length;
use super::vector::{Point3, Vec3};
use std::ops::{Add, Mul, Neg, Sub};

/// A quaternion `w + x i + y j + z k`. The product is right-handed (`i j = k`); Im(H) is three-space.
///
/// ```
/// use cyclide::{Quat, Vec3};
/// let quarter = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
/// assert!((quarter.rotate(Vec3::X) - Vec3::Y).length() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Quat {
    /// Real part.
    pub w: f64,
    /// Coefficient of i.
    pub x: f64,
    /// Coefficient of j.
    pub y: f64,
    /// Coefficient of k.
    pub z: f64,
}

impl Quat {
    /// The number 1.
    pub const ONE: Self = Self::new(1.0, 0.0, 0.0, 0.0);
    /// The number 0.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0, 0.0);

    /// Quaternion from its four coefficients, real part first.
    #[must_use]
    #[inline]
    pub const fn new(w: f64, x: f64, y: f64, z: f64) -> Self {
        Self { w, x, y, z }
    }

    /// Quaternion from real and vector part.
    #[must_use]
    #[inline]
    pub const fn from_parts(real: f64, vector: Vec3) -> Self {
        Self::new(real, vector.x, vector.y, vector.z)
    }

    /// The unit quaternion whose conjugation `q v q^-1` turns by `angle` radians, right-handed about `axis` (unit).
    #[must_use]
    #[inline]
    pub fn from_axis_angle(axis: Vec3, angle: f64) -> Self {
        let (s, c) = (0.5 * angle).sin_cos();
        Self::from_parts(c, axis * s)
    }

    /// Vector part.
    #[must_use]
    #[inline]
    pub const fn vector(self) -> Vec3 {
        Vec3::new(self.x, self.y, self.z)
    }

    /// Vector part, read as a point.
    #[must_use]
    #[inline]
    pub const fn to_point(self) -> Point3 {
        Point3::new(self.x, self.y, self.z)
    }

    /// Conjugate.
    #[must_use]
    #[inline]
    pub const fn conj(self) -> Self {
        Self::new(self.w, -self.x, -self.y, -self.z)
    }

    /// Squared length.
    #[must_use]
    #[inline]
    pub fn norm_squared(self) -> f64 {
        self.w * self.w + self.x * self.x + self.y * self.y + self.z * self.z
    }

    /// Length, without overflow of the squares.
    #[must_use]
    #[inline]
    pub fn norm(self) -> f64 {
        length([self.w, self.x, self.y, self.z])
    }

    /// Inverse; `None` for zero.
    #[must_use]
    #[inline]
    pub fn inverse(self) -> Option<Self> {
        let n = self.norm();
        if !(n > 0.0 && n.is_finite()) {
            return None;
        }
        // Divided twice: n² may under- or overflow where n does not.
        let u = self.conj() * (1.0 / n);
        let inverse = u * (1.0 / n);
        inverse.is_finite().then_some(inverse)
    }

    /// Scalar product of two quaternions as vectors of R^4.
    #[must_use]
    #[inline]
    pub fn dot(self, o: Self) -> f64 {
        self.w * o.w + self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// `q v q^-1` for a unit quaternion: rotation of a vector.
    #[must_use]
    #[inline]
    pub fn rotate(self, v: Vec3) -> Vec3 {
        let p = self.vector();
        let t = p.cross(v) * 2.0;
        v + t * self.w + p.cross(t)
    }

    /// True if every coefficient is finite.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.w.is_finite() && self.vector().is_finite()
    }

    /// The coefficients `[w, x, y, z]`.
    #[must_use]
    #[inline]
    pub const fn to_array(self) -> [f64; 4] {
        [self.w, self.x, self.y, self.z]
    }
}

impl From<[f64; 4]> for Quat {
    #[inline]
    fn from(a: [f64; 4]) -> Self {
        Self::new(a[0], a[1], a[2], a[3])
    }
}
impl From<Vec3> for Quat {
    #[inline]
    fn from(v: Vec3) -> Self {
        Self::from_parts(0.0, v)
    }
}
impl From<Point3> for Quat {
    #[inline]
    fn from(p: Point3) -> Self {
        Self::from_parts(0.0, p.to_vec())
    }
}
impl Add for Quat {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.w + o.w, self.x + o.x, self.y + o.y, self.z + o.z)
    }
}
impl Sub for Quat {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.w - o.w, self.x - o.x, self.y - o.y, self.z - o.z)
    }
}
impl Neg for Quat {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.w, -self.x, -self.y, -self.z)
    }
}
impl Mul<f64> for Quat {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.w * s, self.x * s, self.y * s, self.z * s)
    }
}
impl Mul for Quat {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        let (p, q) = (self.vector(), o.vector());
        Self::from_parts(self.w * o.w - p.dot(q), q * self.w + p * o.w + p.cross(q))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_is_right_handed_and_associative() {
        let (i, j, k) = (Quat::new(0.0, 1.0, 0.0, 0.0), Quat::new(0.0, 0.0, 1.0, 0.0), Quat::new(0.0, 0.0, 0.0, 1.0));
        assert_eq!(i * j, k);
        assert_eq!(j * k, i);
        let (a, b, c) =
            (Quat::new(1.0, -2.0, 0.5, 3.0), Quat::new(-0.5, 0.25, 2.0, 1.0), Quat::new(2.0, 1.0, -1.0, 0.5));
        assert_eq!((a * b) * c, a * (b * c)); // dyadic numbers: exact
    }

    #[test]
    fn inverse_works_at_the_ends_of_the_range() {
        for s in [1e-200, 1.0, 1e200] {
            let q = Quat::new(1.0, -2.0, 0.5, 3.0) * s;
            let e = q * q.inverse().unwrap() - Quat::ONE;
            assert!(e.norm() < 1e-15, "{s:e}: {e:?}");
        }
        assert!(Quat::ZERO.inverse().is_none());
    }

    #[test]
    fn rotation_is_conjugation() {
        let q = Quat::from_axis_angle(Vec3::new(1.0, 2.0, -2.0) / 3.0, 2.5);
        let v = Vec3::new(0.3, -1.0, 2.0);
        let by_product = (q * Quat::from(v) * q.conj()).vector();
        assert!((by_product - q.rotate(v)).length() < 1e-15);
    }
}
