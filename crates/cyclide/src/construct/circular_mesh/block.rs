//! Blocks of three by three: what one vertex has to do with another in the normal equations.

use crate::base::vector::Vec3;
use std::ops::{Add, AddAssign, Mul, Sub};

/// A matrix of three rows.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Block([[f64; 3]; 3]);

impl Block {
    pub(super) const ZERO: Self = Self([[0.0; 3]; 3]);
    pub(super) const IDENTITY: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    pub(super) fn from_columns(columns: [Vec3; 3]) -> Self {
        let c = columns.map(Vec3::to_array);
        Self(std::array::from_fn(|i| std::array::from_fn(|j| c[j][i])))
    }

    /// `v v^T`.
    pub(super) fn square(v: Vec3) -> Self {
        Self::from_columns([v * v.x, v * v.y, v * v.z])
    }

    pub(super) fn transposed(self) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| self.0[j][i])))
    }

    pub(super) fn trace(self) -> f64 {
        self.0[0][0] + self.0[1][1] + self.0[2][2]
    }

    /// The lower triangular factor L of a symmetric matrix `L L^T`, read from its lower triangle; `None` if it is not
    /// positive definite.
    pub(super) fn cholesky(&self) -> Option<Self> {
        let a = &self.0;
        let root = |x: f64| (x > 0.0 && x.is_finite()).then(|| x.sqrt());
        let l00 = root(a[0][0])?;
        let (l10, l20) = (a[1][0] / l00, a[2][0] / l00);
        let l11 = root(a[1][1] - l10 * l10)?;
        let l21 = (a[2][1] - l20 * l10) / l11;
        let l22 = root(a[2][2] - l20 * l20 - l21 * l21)?;
        Some(Self([[l00, 0.0, 0.0], [l10, l11, 0.0], [l20, l21, l22]]))
    }

    /// `X` with `X L^T = self`, for a lower triangular L: each row of X solves `L x = row`.
    pub(super) fn solved_right(&self, l: Self) -> Self {
        Self(self.0.map(|row| l.solved_lower(Vec3::from(row)).to_array()))
    }

    /// Solves `L x = y`; the matrix is lower triangular.
    pub(super) fn solved_lower(&self, y: Vec3) -> Vec3 {
        let l = &self.0;
        let a = y.x / l[0][0];
        let b = (y.y - l[1][0] * a) / l[1][1];
        Vec3::new(a, b, (y.z - l[2][0] * a - l[2][1] * b) / l[2][2])
    }

    /// Solves `L^T x = y`; the matrix is lower triangular.
    pub(super) fn solved_upper(&self, y: Vec3) -> Vec3 {
        let l = &self.0;
        let c = y.z / l[2][2];
        let b = (y.y - l[2][1] * c) / l[1][1];
        Vec3::new((y.x - l[1][0] * b - l[2][0] * c) / l[0][0], b, c)
    }

    /// Subtracts the product of two others: the inner loop of the factorisation.
    #[inline]
    pub(super) fn subtract_product(&mut self, a: &Self, b: &Self) {
        for i in 0..3 {
            for j in 0..3 {
                self.0[i][j] -= a.0[i][0] * b.0[0][j] + a.0[i][1] * b.0[1][j] + a.0[i][2] * b.0[2][j];
            }
        }
    }

    pub(super) fn apply(self, v: Vec3) -> Vec3 {
        let row = |r: [f64; 3]| Vec3::from(r).dot(v);
        Vec3::new(row(self.0[0]), row(self.0[1]), row(self.0[2]))
    }
}

impl Add for Block {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| self.0[i][j] + o.0[i][j])))
    }
}
impl AddAssign for Block {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl Sub for Block {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + o * -1.0
    }
}
impl Mul<f64> for Block {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self(self.0.map(|row| row.map(|x| x * s)))
    }
}
impl Mul for Block {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| self.0[i][k] * o.0[k][j]).sum())))
    }
}
