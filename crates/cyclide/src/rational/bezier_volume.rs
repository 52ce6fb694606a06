//! One rational tensor-product Bézier volume in homogeneous rows `[wx, wy, wz, w]`.

use super::RationalBezierSurface;
use crate::base::bernstein;
use crate::base::vector::Point3;
use crate::error::{ErrorItem, NumberError, NurbsError, Result};

/// A rational Bézier volume of degrees `(p, q, r)`. Row `(i (q+1) + j)(r+1) + k` belongs to `B_i(s) B_j(t) B_k(u)`; rows are homogeneous,
/// so one may be a direction (weight 0).
///
/// ```
/// use cyclide::rational::RationalBezierVolume;
/// let rows = (0..8).map(|k| [f64::from(k >> 2), f64::from(k >> 1 & 1), f64::from(k & 1), 1.0]).collect();
/// let cube = RationalBezierVolume::new([1, 1, 1], rows)?; // u runs fastest
/// assert_eq!(cube.point([0.25, 0.5, 0.75]).to_array(), [0.25, 0.5, 0.75]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalBezierVolume {
    degrees: [usize; 3],
    rows: Vec<[f64; 4]>,
}

impl RationalBezierVolume {
    /// Volume from its degrees (at least 1) and homogeneous rows.
    ///
    /// # Errors
    /// `not-a-spline` (the count does not fit), `not-finite`.
    pub fn new(degrees: [usize; 3], rows: Vec<[f64; 4]>) -> Result<Self> {
        if degrees.contains(&0) || rows.len() != degrees.iter().map(|d| d + 1).product::<usize>() {
            return Err(NurbsError::NotASpline {
                detail: "a Bézier volume of degrees (p, q, r) has (p+1)(q+1)(r+1) rows",
            }
            .into());
        }
        match rows.iter().position(|row| row.iter().any(|v| !v.is_finite())) {
            Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Row, index }.into()),
            None => Ok(Self { degrees, rows }),
        }
    }

    /// As [`new`](Self::new) for rows that are finite by construction.
    pub(crate) fn from_rows_unchecked(degrees: [usize; 3], rows: Vec<[f64; 4]>) -> Self {
        Self { degrees, rows }
    }

    /// Degrees along s, t and u.
    #[must_use]
    pub fn degrees(&self) -> [usize; 3] {
        self.degrees
    }

    /// The rows `[wx, wy, wz, w]`, u fastest.
    #[must_use]
    pub fn rows(&self) -> &[[f64; 4]] {
        &self.rows
    }

    /// The row of these indices along s, t and u.
    ///
    /// # Panics
    /// If one is above its degree.
    #[must_use]
    pub fn row(&self, [i, j, k]: [usize; 3]) -> [f64; 4] {
        let [p, q, r] = self.degrees;
        assert!(i <= p && j <= q && k <= r, "row ({i}, {j}, {k}) of degrees ({p}, {q}, {r})");
        self.rows[(i * (q + 1) + j) * (r + 1) + k]
    }

    /// True if every weight is positive.
    #[must_use]
    pub fn has_positive_weights(&self) -> bool {
        self.rows.iter().all(|r| r[3] > 0.0)
    }

    /// The point at `[s, t, u]`.
    #[must_use]
    pub fn point(&self, [s, t, u]: [f64; 3]) -> Point3 {
        let [_, q, r] = self.degrees;
        let lines: Vec<[f64; 4]> = self.rows.chunks(r + 1).map(|line| bernstein::eval(line, u)).collect();
        let sheet: Vec<[f64; 4]> = lines.chunks(q + 1).map(|line| bernstein::eval(line, t)).collect();
        let [x, y, z, w] = bernstein::eval(&sheet, s);
        Point3::new(x / w, y / w, z / w)
    }

    /// The face at the start (`end` 0) or end (1) of direction `axis`, with the two other parameters in order.
    ///
    /// # Panics
    /// If `axis` is above 2 or `end` above 1.
    #[must_use]
    pub fn face(&self, axis: usize, end: usize) -> RationalBezierSurface {
        assert!(axis < 3 && end < 2, "face {end} of direction {axis}");
        let (first, second) = match axis {
            0 => (1, 2),
            1 => (0, 2),
            _ => (0, 1),
        };
        let degrees = [self.degrees[first], self.degrees[second]];
        let places = (0..=degrees[0]).flat_map(|i| (0..=degrees[1]).map(move |j| (i, j)));
        let rows = places.map(|(i, j)| {
            let mut at = [0; 3];
            (at[axis], at[first], at[second]) = (end * self.degrees[axis], i, j);
            self.row(at)
        });
        RationalBezierSurface::from_rows_unchecked(degrees, rows.collect())
    }
}
