//! Polynomials in Bernstein form as values: products add degrees, sums raise the lower one. What rational surfaces are
//! composed from.

use super::RationalBezierSurface;
use crate::base::bernstein;
use crate::base::vector::Vec3;
use crate::error::Result;
use std::ops::{Add, Mul, Sub};

/// A polynomial over `[0, 1]` by its Bernstein coefficients; a constant has one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomial(Vec<f64>);

impl Polynomial {
    /// From at least one coefficient; from none the zero.
    pub(crate) fn new(coefficients: Vec<f64>) -> Self {
        if coefficients.is_empty() { Self::constant(0.0) } else { Self(coefficients) }
    }

    pub(crate) fn constant(value: f64) -> Self {
        Self(vec![value])
    }

    pub(crate) fn degree(&self) -> usize {
        self.0.len() - 1
    }

    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.0
    }

    /// The value at a parameter.
    pub(crate) fn value(&self, t: f64) -> f64 {
        self.jet::<1>(t)[0]
    }

    /// Value and derivatives of the next orders at a parameter, `K` in all.
    pub(crate) fn jet<const K: usize>(&self, t: f64) -> [f64; K] {
        let rows: Vec<[f64; 1]> = self.0.iter().map(|&c| [c]).collect();
        bernstein::derivatives::<1, K>(&rows, t).map(|[value]| value)
    }

    /// The derivative; of a constant the zero.
    pub(crate) fn derivative(&self) -> Self {
        let degree = self.degree() as f64;
        Self::new(self.0.windows(2).map(|pair| (pair[1] - pair[0]) * degree).collect())
    }

    /// The same run backwards: at `1 - t`.
    pub(crate) fn reversed(&self) -> Self {
        Self(self.0.iter().rev().copied().collect())
    }

    /// As a constant, if all coefficients are equal.
    pub(crate) fn settled(&self) -> Self {
        if self.0.iter().all(|c| c - self.0[0] == 0.0) { Self::constant(self.0[0]) } else { self.clone() }
    }

    /// The same polynomial with coefficients of a degree that is not lower.
    pub(crate) fn elevated(&self, degree: usize) -> Self {
        match degree.saturating_sub(self.degree()) {
            0 => self.clone(),
            by => Self(bernstein::product(&self.0, &vec![1.0; by + 1])),
        }
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        Polynomial(bernstein::product(&self.0, &other.0))
    }
}

impl Mul<f64> for &Polynomial {
    type Output = Polynomial;
    fn mul(self, factor: f64) -> Polynomial {
        Polynomial(self.0.iter().map(|c| c * factor).collect())
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &(other * -1.0)
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let degree = self.degree().max(other.degree());
        let (a, b) = (self.elevated(degree), other.elevated(degree));
        Polynomial(a.0.iter().zip(&b.0).map(|(a, b)| a + b).collect())
    }
}

/// A homogeneous row `[wx, wy, wz, w]` whose entries are polynomials.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PolynomialRow(pub(crate) [Polynomial; 4]);

impl PolynomialRow {
    /// From the rows of a curve; weights that are all equal give a constant weight.
    pub(crate) fn of_rows(rows: &[[f64; 4]]) -> Self {
        let entry = |d: usize| Polynomial::new(rows.iter().map(|row| row[d]).collect());
        let mut entries = [0, 1, 2, 3].map(entry);
        entries[3] = entries[3].settled();
        Self(entries)
    }

    /// A direction, which has no weight.
    pub(crate) fn direction(vector: [Polynomial; 3]) -> Self {
        let [x, y, z] = vector;
        Self([x, y, z, Polynomial::constant(0.0)])
    }

    pub(crate) fn weight(&self) -> &Polynomial {
        &self.0[3]
    }

    /// The row of the points moved by a vector.
    pub(crate) fn moved(self, by: Vec3) -> Self {
        let Self([x, y, z, w]) = self;
        let (x, y, z) = (&x + &(&w * by.x), &y + &(&w * by.y), &z + &(&w * by.z));
        Self([x, y, z, w])
    }
}

impl Mul<&Polynomial> for &PolynomialRow {
    type Output = PolynomialRow;
    fn mul(self, factor: &Polynomial) -> PolynomialRow {
        PolynomialRow(self.0.each_ref().map(|entry| entry * factor))
    }
}

impl Mul<f64> for &PolynomialRow {
    type Output = PolynomialRow;
    fn mul(self, factor: f64) -> PolynomialRow {
        PolynomialRow(self.0.each_ref().map(|entry| entry * factor))
    }
}

impl Add for &PolynomialRow {
    type Output = PolynomialRow;
    fn add(self, other: Self) -> PolynomialRow {
        PolynomialRow([0, 1, 2, 3].map(|d| &self.0[d] + &other.0[d]))
    }
}

impl RationalBezierSurface {
    /// The surface whose rows in t are these polynomials in s; at least two, and one of them not constant.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(crate) fn from_polynomial_rows(rows: &[PolynomialRow]) -> Result<Self> {
        let degree = rows.iter().flat_map(|row| &row.0).map(Polynomial::degree).max().unwrap_or(0);
        let rows: Vec<[Polynomial; 4]> =
            rows.iter().map(|row| row.0.each_ref().map(|entry| entry.elevated(degree))).collect();
        let at = |i: usize| rows.iter().map(move |row| row.each_ref().map(|entry| entry.0[i]));
        Self::new([degree, rows.len().saturating_sub(1)], (0..=degree).flat_map(at).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(p: &Polynomial, t: f64) -> f64 {
        let rows: Vec<[f64; 1]> = p.coefficients().iter().map(|&c| [c]).collect();
        bernstein::eval(&rows, t)[0]
    }

    #[test]
    fn sums_and_products_are_those_of_the_values() {
        let (a, b) = (Polynomial::new(vec![1.0, -2.0, 0.5]), Polynomial::new(vec![0.25, 3.0, -1.0, 2.0]));
        for t in [0.0, 0.3, 0.75, 1.0] {
            let (x, y) = (value(&a, t), value(&b, t));
            let sums = [(&a + &b, x + y), (&a - &b, x - y), (&a * &b, x * y), (&b * -3.0, -3.0 * y)];
            for (got, want) in sums {
                assert!((value(&got, t) - want).abs() < 4e-15, "{t}");
            }
        }
        assert!((b.value(0.3) - value(&b, 0.3)).abs() < 1e-15);
        let [_, slope] = b.jet::<2>(0.3);
        assert!((b.derivative().value(0.3) - slope).abs() < 1e-14);
        assert_eq!((&a * &b).degree(), 5);
        assert_eq!((&a + &Polynomial::constant(1.0)).coefficients(), [2.0, -1.0, 1.5]);
    }
}
