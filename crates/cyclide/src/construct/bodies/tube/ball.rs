//! Balls as points of the space of center and radius, whose square of a way `(v, r)` is `v·v - r²` (`docs/math/tubes.md#balls`).

use crate::base::vector::{Point3, Vec3};
use std::ops::{Add, Mul, Sub};

/// A ball: a cross-section of a [`Tube`](crate::construct::Tube) touches it.
///
/// ```
/// use cyclide::{Point3, construct::{Ball, Tube}};
/// let balls = [Ball::new(Point3::ORIGIN, 2.0), Ball::new(Point3::new(10.0, 0.0, 0.0), 2.0)];
/// let rod = Tube::through(&balls, false)?.body()?;
/// assert!((rod.outer.volume() - 40.0 * std::f64::consts::PI).abs() < 1e-10);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Center.
    pub center: Point3,
    /// Radius.
    pub radius: f64,
}

impl Ball {
    /// The ball of a center and a radius; tubes check both.
    #[must_use]
    pub const fn new(center: Point3, radius: f64) -> Self {
        Self { center, radius }
    }

    pub(super) fn to(self, other: Self) -> Way {
        Way { v: other.center - self.center, r: other.radius - self.radius }
    }

    pub(super) fn moved(self, way: Way) -> Self {
        Self { center: self.center + way.v, radius: self.radius + way.r }
    }

    /// The sum of the distance of the centers and the difference of the radii: no point of one ball is farther than this from the other.
    pub(super) fn distance(self, other: Self) -> f64 {
        self.center.distance(other.center) + (self.radius - other.radius).abs()
    }
}

/// A way from ball to ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Way {
    pub(super) v: Vec3,
    pub(super) r: f64,
}

impl Way {
    pub(super) fn dot(self, other: Self) -> f64 {
        self.v.dot(other.v) - self.r * other.r
    }

    /// The square; the product of sums keeps the digits of balls that touch each other from inside.
    pub(super) fn square(self) -> f64 {
        let length = self.v.length();
        (length - self.r.abs()) * (length + self.r.abs())
    }

    /// The way of square 1; none where the square is not positive: one ball holds the other.
    pub(super) fn unit(self) -> Option<Self> {
        let square = self.square();
        (square > 0.0 && square.is_finite()).then(|| self * (1.0 / square.sqrt()))
    }

    /// Carried in parallel along an arc with these unit tangents at its ends, for a way across the first of them.
    pub(super) fn carried(self, [from, to]: [Self; 2]) -> Self {
        self - (from + to) * (self.dot(to) / (1.0 + from.dot(to)))
    }
}

impl Add for Way {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { v: self.v + other.v, r: self.r + other.r }
    }
}

impl Sub for Way {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { v: self.v - other.v, r: self.r - other.r }
    }
}

impl Mul<f64> for Way {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { v: self.v * factor, r: self.r * factor }
    }
}
