//! Points and vectors of three-space, and their planar counterparts.
//!
//! Points and vectors differ: under an inversion a point maps, a tangent vector is pushed forward.

use super::euclidean::length;
use std::ops::{Add, Div, Index, Mul, Neg, Sub};

/// A vector (displacement, tangent, normal) of three-space.
///
/// ```
/// use cyclide::Vec3;
/// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
/// assert_eq!(Vec3::new(0.0, 0.0, 7.0).unit(), Some(Vec3::Z));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vec3 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
    /// Third component.
    pub z: f64,
}

/// A point of three-space.
///
/// ```
/// use cyclide::{Point3, Vec3};
/// let p = Point3::new(1.0, 2.0, 3.0);
/// assert_eq!((p + Vec3::X) - p, Vec3::X);
/// assert_eq!(p.midpoint(Point3::ORIGIN), Point3::new(0.5, 1.0, 1.5));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point3 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// Third coordinate.
    pub z: f64,
}

impl Vec3 {
    /// The zero vector.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    /// Unit vector along the first axis.
    pub const X: Self = Self::new(1.0, 0.0, 0.0);
    /// Unit vector along the second axis.
    pub const Y: Self = Self::new(0.0, 1.0, 0.0);
    /// Unit vector along the third axis.
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);

    /// Vector from its components.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// Dot product.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Cross product, right-handed.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Squared length.
    #[must_use]
    #[inline]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// Length, without overflow or underflow of the squares.
    #[must_use]
    #[inline]
    pub fn length(self) -> f64 {
        length([self.x, self.y, self.z])
    }

    /// Largest absolute component.
    #[must_use]
    #[inline]
    pub fn max_abs(self) -> f64 {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// The vector of length 1 in the same direction; `None` for the zero vector and for non-finite input.
    #[must_use]
    #[inline]
    pub fn unit(self) -> Option<Self> {
        let m = self.max_abs();
        if !(m > 0.0 && self.is_finite()) {
            return None;
        }
        // Scaled first: the squares of tiny or huge components would under- or overflow.
        let v = self / m;
        Some(v / v.dot(v).sqrt())
    }

    /// Some unit vector perpendicular to this one (which must not be zero).
    #[must_use]
    #[inline]
    pub fn any_perpendicular(self) -> Self {
        let a = if self.x.abs() <= self.y.abs() && self.x.abs() <= self.z.abs() {
            Self::X
        } else if self.y.abs() <= self.z.abs() {
            Self::Y
        } else {
            Self::Z
        };
        self.cross(a).unit().unwrap_or(Self::X)
    }

    /// The mirror image of this vector in the direction `axis` (unit): `2<v,axis>axis - v`.
    ///
    /// This is the end tangent of a circular arc from its start tangent and the unit chord
    /// (`000`, consequence of (22), (23)).
    #[must_use]
    #[inline]
    pub fn reflect(self, axis: Self) -> Self {
        axis * (2.0 * self.dot(axis)) - self
    }

    /// Angle to another vector in `[0, pi]`, radians; accurate for all angles.
    #[must_use]
    #[inline]
    pub fn angle(self, other: Self) -> f64 {
        self.cross(other).length().atan2(self.dot(other))
    }

    /// True if every component is finite.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// The components as an array.
    #[must_use]
    #[inline]
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

impl Point3 {
    /// The origin.
    pub const ORIGIN: Self = Self::new(0.0, 0.0, 0.0);

    /// Point from its coordinates.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The vector from the origin to this point.
    #[must_use]
    #[inline]
    pub const fn to_vec(self) -> Vec3 {
        Vec3::new(self.x, self.y, self.z)
    }

    /// Distance to another point.
    #[must_use]
    #[inline]
    pub fn distance(self, other: Self) -> f64 {
        (self - other).length()
    }

    /// The point halfway to another one.
    #[must_use]
    #[inline]
    pub fn midpoint(self, other: Self) -> Self {
        Self::new(0.5 * self.x + 0.5 * other.x, 0.5 * self.y + 0.5 * other.y, 0.5 * self.z + 0.5 * other.z)
    }

    /// The point `(1-t) self + t other`, exact at `t = 0` and `t = 1`.
    #[must_use]
    #[inline]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        let s = 1.0 - t;
        Self::new(s * self.x + t * other.x, s * self.y + t * other.y, s * self.z + t * other.z)
    }

    /// Distance from the segment between two points, which may be one.
    pub(crate) fn distance_to_segment(self, [from, to]: [Self; 2]) -> f64 {
        let way = to - from;
        let part = ((self - from).dot(way) / way.dot(way).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        self.distance(from + way * part)
    }

    /// True if every coordinate is finite.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.to_vec().is_finite()
    }

    /// The coordinates as an array.
    #[must_use]
    #[inline]
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

macro_rules! from_array {
    ($($t:ident),*) => {$(
        impl From<[f64; 3]> for $t {
            #[inline]
            fn from(a: [f64; 3]) -> Self {
                Self::new(a[0], a[1], a[2])
            }
        }
        impl Index<usize> for $t {
            type Output = f64;
            /// # Panics
            /// If `i > 2`.
            #[inline]
            fn index(&self, i: usize) -> &f64 {
                [&self.x, &self.y, &self.z][i]
            }
        }
    )*};
}
from_array!(Vec3, Point3);

impl Add for Vec3 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}
impl Sub for Vec3 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}
impl Neg for Vec3 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
impl Mul<f64> for Vec3 {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}
impl Mul<Vec3> for f64 {
    type Output = Vec3;
    #[inline]
    fn mul(self, v: Vec3) -> Vec3 {
        v * self
    }
}
impl Div<f64> for Vec3 {
    type Output = Self;
    #[inline]
    fn div(self, s: f64) -> Self {
        Self::new(self.x / s, self.y / s, self.z / s)
    }
}
impl Sub for Point3 {
    type Output = Vec3;
    #[inline]
    fn sub(self, o: Self) -> Vec3 {
        Vec3::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}
impl Add<Vec3> for Point3 {
    type Output = Self;
    #[inline]
    fn add(self, v: Vec3) -> Self {
        Self::new(self.x + v.x, self.y + v.y, self.z + v.z)
    }
}
impl Sub<Vec3> for Point3 {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vec3) -> Self {
        Self::new(self.x - v.x, self.y - v.y, self.z - v.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_survives_extreme_scales() {
        for s in [1e-300, 1e-150, 1.0, 1e150, 1e300] {
            let u = Vec3::new(3.0 * s, 0.0, 4.0 * s).unit().unwrap();
            assert!((u - Vec3::new(0.6, 0.0, 0.8)).length() < 1e-15);
        }
        assert!(Vec3::ZERO.unit().is_none());
        assert!(Vec3::new(f64::NAN, 1.0, 0.0).unit().is_none());
        assert!(Vec3::new(f64::INFINITY, 1.0, 0.0).unit().is_none());
    }

    #[test]
    fn reflection_is_an_involution_that_keeps_the_axis() {
        let axis = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        let v = Vec3::new(0.3, -1.0, 2.0);
        assert!((v.reflect(axis).reflect(axis) - v).length() < 1e-15);
        assert!((axis.reflect(axis) - axis).length() < 1e-15);
    }
}
