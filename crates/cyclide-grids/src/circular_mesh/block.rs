//! Blocks of three by three: what one vertex has to do with another in the normal equations.

use cyclide::Vec3;
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

    pub(super) fn column(&self, j: usize) -> [f64; 3] {
        std::array::from_fn(|i| self.0[i][j])
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
