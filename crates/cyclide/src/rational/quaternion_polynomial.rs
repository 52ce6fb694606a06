//! Polynomials whose coefficients are quaternions, in Bernstein form: rational families of rotations.

use super::Polynomial;
use crate::base::quat::Quat;
use std::ops::{Add, Mul};

/// A polynomial over `[0, 1]` with values in the quaternions, entry by entry `[w, x, y, z]`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct QuatPolynomial(pub(crate) [Polynomial; 4]);

impl QuatPolynomial {
    pub(crate) fn constant(q: Quat) -> Self {
        Self(q.to_array().map(Polynomial::constant))
    }

    /// The value at a parameter.
    pub(crate) fn value(&self, t: f64) -> Quat {
        Quat::from(self.0.each_ref().map(|entry| entry.value(t)))
    }

    pub(crate) fn conj(&self) -> Self {
        let [w, x, y, z] = &self.0;
        Self([w.clone(), x * -1.0, y * -1.0, z * -1.0])
    }

    /// The real polynomial `conj(p) q + conj(q) p`, halved: `|p|²` for `p = q`.
    pub(crate) fn dot(&self, other: &Self) -> Polynomial {
        let [a, b, c, d] = &self.0;
        let [e, f, g, h] = &other.0;
        &(&(a * e) + &(b * f)) + &(&(c * g) + &(d * h))
    }
}

impl Mul for &QuatPolynomial {
    type Output = QuatPolynomial;
    fn mul(self, other: Self) -> QuatPolynomial {
        let ([a, b, c, d], [e, f, g, h]) = (&self.0, &other.0);
        QuatPolynomial([
            &(&(a * e) - &(b * f)) - &(&(c * g) + &(d * h)),
            &(&(a * f) + &(b * e)) + &(&(c * h) - &(d * g)),
            &(&(a * g) - &(b * h)) + &(&(c * e) + &(d * f)),
            &(&(a * h) + &(b * g)) + &(&(d * e) - &(c * f)),
        ])
    }
}

impl Mul<&Polynomial> for &QuatPolynomial {
    type Output = QuatPolynomial;
    fn mul(self, factor: &Polynomial) -> QuatPolynomial {
        QuatPolynomial(self.0.each_ref().map(|entry| entry * factor))
    }
}

impl Add for &QuatPolynomial {
    type Output = QuatPolynomial;
    fn add(self, other: Self) -> QuatPolynomial {
        QuatPolynomial([0, 1, 2, 3].map(|d| &self.0[d] + &other.0[d]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_those_of_the_values() {
        let linear =
            |a: [f64; 4], b: [f64; 4]| QuatPolynomial(std::array::from_fn(|d| Polynomial::new(vec![a[d], b[d]])));
        let p = linear([1.0, -2.0, 0.5, 3.0], [0.0, 1.0, -1.0, 2.0]);
        let q = linear([0.25, 3.0, -1.0, 2.0], [-1.0, 0.5, 4.0, 1.0]);
        for t in [0.0, 0.3, 1.0] {
            let (x, y) = (p.value(t), q.value(t));
            assert!(((&p * &q).value(t) - x * y).norm() < 1e-14);
            assert!(((&p.conj() + &q).value(t) - (x.conj() + y)).norm() < 1e-14);
            assert!((p.dot(&q).value(t) - x.dot(y)).abs() < 1e-14);
        }
    }
}
