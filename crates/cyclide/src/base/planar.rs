//! Points and vectors of the plane, used by the planar arc fit inside a frame of its own.

use super::euclidean::length;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector of the plane.
///
/// ```
/// use cyclide::Vec2;
/// assert_eq!(Vec2::new(3.0, 4.0).left().dot(Vec2::new(3.0, 4.0)), 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vec2 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
}

/// A point of the plane.
///
/// ```
/// use cyclide::Point2;
/// assert_eq!(Point2::new(0.0, 0.0).distance(Point2::new(3.0, 4.0)), 5.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point2 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

impl Vec2 {
    /// Vector from its components.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Dot product.
    #[must_use]
    #[inline]
    pub fn dot(self, o: Self) -> f64 {
        self.x * o.x + self.y * o.y
    }

    /// Third component of the cross product: positive if `o` is to the left.
    #[must_use]
    #[inline]
    pub fn cross(self, o: Self) -> f64 {
        self.x * o.y - self.y * o.x
    }

    /// Length, without overflow of the squares.
    #[must_use]
    #[inline]
    pub fn length(self) -> f64 {
        length([self.x, self.y])
    }

    /// The vector turned by a quarter to the left.
    #[must_use]
    #[inline]
    pub fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// The unit vector in the same direction; `None` for zero or non-finite input.
    #[must_use]
    #[inline]
    pub fn unit(self) -> Option<Self> {
        let l = self.length();
        (l > 0.0 && l.is_finite()).then(|| Self::new(self.x / l, self.y / l))
    }
}

impl Point2 {
    /// Point from its coordinates.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Distance to another point.
    #[must_use]
    #[inline]
    pub fn distance(self, o: Self) -> f64 {
        (self - o).length()
    }

    /// True if both coordinates are finite.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl From<[f64; 2]> for Point2 {
    #[inline]
    fn from(a: [f64; 2]) -> Self {
        Self::new(a[0], a[1])
    }
}
impl Sub for Point2 {
    type Output = Vec2;
    #[inline]
    fn sub(self, o: Self) -> Vec2 {
        Vec2::new(self.x - o.x, self.y - o.y)
    }
}
impl Add<Vec2> for Point2 {
    type Output = Self;
    #[inline]
    fn add(self, v: Vec2) -> Self {
        Self::new(self.x + v.x, self.y + v.y)
    }
}
impl Add for Vec2 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y)
    }
}
impl Sub for Vec2 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y)
    }
}
impl Mul<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s)
    }
}
impl Neg for Vec2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}
