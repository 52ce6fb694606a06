//! Complex numbers, as far as curves on a torus need them.

use super::euclidean::length;
use std::ops::{Add, Mul};

/// A complex number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Complex {
    pub(crate) re: f64,
    pub(crate) im: f64,
}

impl Complex {
    pub(crate) const ONE: Self = Self::new(1.0, 0.0);

    #[inline]
    pub(crate) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The number of length 1 at this angle, radians.
    #[inline]
    pub(crate) fn at_angle(angle: f64) -> Self {
        let (im, re) = angle.sin_cos();
        Self { re, im }
    }

    #[inline]
    pub(crate) const fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// Square of the length.
    #[inline]
    pub(crate) fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// Length, without overflow of the squares.
    #[inline]
    pub(crate) fn norm(self) -> f64 {
        length([self.re, self.im])
    }

    /// Angle in `(-pi, pi]`, radians.
    #[inline]
    pub(crate) fn arg(self) -> f64 {
        self.im.atan2(self.re)
    }

    /// The number of length 1 at the same angle; `None` for zero and numbers that are not finite.
    #[inline]
    pub(crate) fn unit(self) -> Option<Self> {
        let n = self.norm();
        (n > 0.0 && n.is_finite()).then(|| Self::new(self.re / n, self.im / n))
    }

    /// The square root with a real part that is not negative, of a number of length 1.
    #[inline]
    pub(crate) fn unit_sqrt(self) -> Self {
        // The half of the larger of the two sums: nothing cancels.
        let root = if self.re >= 0.0 {
            Self::new(1.0 + self.re, self.im)
        } else {
            Self::new(self.im.abs(), (1.0 - self.re).copysign(self.im))
        };
        root.unit().unwrap_or(Self::ONE)
    }
}

impl Mul for Complex {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}

impl Mul<f64> for Complex {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.re * s, self.im * s)
    }
}

impl Add for Complex {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.re + o.re, self.im + o.im)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_every_direction() {
        for k in -100..=100 {
            let angle = f64::from(k) * 0.0314;
            let (z, root) = (Complex::at_angle(angle), Complex::at_angle(angle).unit_sqrt());
            let square = root * root;
            assert!((square.re - z.re).abs() + (square.im - z.im).abs() < 1e-15 && root.re >= 0.0, "{angle}");
        }
        assert_eq!(Complex::new(-1.0, 0.0).unit_sqrt(), Complex::new(0.0, 1.0));
    }
}
