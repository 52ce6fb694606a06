//! One rational tensor-product Bézier surface in homogeneous rows `[wx, wy, wz, w]`.

use crate::base::bernstein;
use crate::base::vector::Point3;
use crate::error::{Error, Result};

/// A rational Bézier surface of degrees `(p, q)`. Row `i (q+1) + j` belongs to `B_i(s) B_j(t)`; rows are homogeneous, so
/// one may be a direction (weight 0).
#[derive(Debug, Clone, PartialEq)]
pub struct RationalBezierSurface {
    degrees: [usize; 2],
    rows: Vec<[f64; 4]>,
}

impl RationalBezierSurface {
    /// Surface from its degrees (at least 1) and homogeneous rows.
    ///
    /// # Errors
    /// `not-a-spline` (the count does not fit), `not-finite`.
    pub fn new(degrees: [usize; 2], rows: Vec<[f64; 4]>) -> Result<Self> {
        if degrees.contains(&0) || rows.len() != (degrees[0] + 1) * (degrees[1] + 1) {
            return Err(Error::NotASpline { detail: "a Bézier surface of degrees (p, q) has (p+1)(q+1) rows" });
        }
        match rows.iter().position(|row| row.iter().any(|v| !v.is_finite())) {
            Some(index) => Err(Error::NotFinite { what: "row", index }),
            None => Ok(Self { degrees, rows }),
        }
    }

    /// As [`new`](Self::new) for rows that are finite by construction.
    pub(crate) fn from_rows_unchecked(degrees: [usize; 2], rows: Vec<[f64; 4]>) -> Self {
        Self { degrees, rows }
    }

    /// Degrees along s and t.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The rows `[wx, wy, wz, w]`, t fastest.
    #[must_use]
    pub fn rows(&self) -> &[[f64; 4]] {
        &self.rows
    }

    /// True if every weight is positive.
    #[must_use]
    pub fn has_positive_weights(&self) -> bool {
        self.rows.iter().all(|r| r[3] > 0.0)
    }

    /// The point at `(s, t)`.
    #[must_use]
    pub fn point(&self, s: f64, t: f64) -> Point3 {
        let along_t: Vec<[f64; 4]> = self.rows.chunks(self.degrees[1] + 1).map(|row| bernstein::eval(row, t)).collect();
        let [x, y, z, w] = bernstein::eval(&along_t, s);
        Point3::new(x / w, y / w, z / w)
    }
}
