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
