//! Quadratics in Bernstein form, without allocation.

/// The value at `t`.
#[must_use]
#[inline]
pub(crate) fn value(c: &[f64; 3], t: f64) -> f64 {
    let u = 1.0 - t;
    u * (u * c[0] + 2.0 * t * c[1]) + t * t * c[2]
}

/// The derivative at `t`.
#[must_use]
#[inline]
pub(crate) fn derivative(c: &[f64; 3], t: f64) -> f64 {
    2.0 * ((1.0 - t) * (c[1] - c[0]) + t * (c[2] - c[1]))
}

/// Coefficients by powers of s of `a (1-s)² + b s(1-s) + c s²`: the middle one of the Bernstein form is half of `b`.
#[must_use]
#[inline]
pub(crate) fn powers(a: f64, b: f64, c: f64) -> [f64; 3] {
    [a, b - 2.0 * a, a - b + c]
}
