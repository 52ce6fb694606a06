//! The numbers a linear system may be made of: real, and complex for the damped steps.

use std::ops::{Add, Mul, Sub};

/// A real or complex number.
pub(super) trait Scalar: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A real number.
    fn real(value: f64) -> Self;
    /// Its real part.
    fn real_part(self) -> f64;
    /// The reciprocal; not finite for zero.
    fn reciprocal(self) -> Self;
}

impl Scalar for f64 {
    fn real(value: f64) -> Self {
        value
    }
    fn real_part(self) -> f64 {
        self
    }
    fn reciprocal(self) -> Self {
        1.0 / self
    }
}

/// A complex number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Complex {
    pub(super) re: f64,
    pub(super) im: f64,
}

impl Scalar for Complex {
    fn real(value: f64) -> Self {
        Self { re: value, im: 0.0 }
    }
    fn real_part(self) -> f64 {
        self.re
    }
    fn reciprocal(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        Self { re: self.re / square, im: -self.im / square }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { re: self.re + o.re, im: self.im + o.im }
    }
}
impl Sub for Complex {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { re: self.re - o.re, im: self.im - o.im }
    }
}
impl Mul for Complex {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
}
