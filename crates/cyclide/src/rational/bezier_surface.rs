//! One rational tensor-product Bézier surface in homogeneous rows `[wx, wy, wz, w]`.

use super::bezier_curve::{RationalBezier, moved_row};
use crate::base::bernstein;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
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
        let [x, y, z, w] = bernstein::eval(&self.along_s(t), s);
        Point3::new(x / w, y / w, z / w)
    }

    /// The point and its derivatives at `(s, t)`.
    #[must_use]
    pub fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        // Derivatives by t of the rows along s, then by s of these.
        let by_t: Vec<[[f64; 4]; 4]> =
            self.rows.chunks(self.degrees[1] + 1).map(|row| bernstein::derivatives(row, t)).collect();
        let along = |k: usize| -> [[f64; 4]; 4] {
            let rows: Vec<[f64; 4]> = by_t.iter().map(|d| d[k]).collect();
            bernstein::derivatives(&rows, s)
        };
        let [h, ht, htt] = [along(0), along(1), along(2)];
        let vector = |row: [f64; 4]| Vec3::new(row[0], row[1], row[2]);
        let w = h[0][3];
        let x = vector(h[0]) / w;
        let ds = (vector(h[1]) - x * h[1][3]) / w;
        let dt = (vector(ht[0]) - x * ht[0][3]) / w;
        let dss = (vector(h[2]) - ds * (2.0 * h[1][3]) - x * h[2][3]) / w;
        let dst = (vector(ht[1]) - ds * ht[0][3] - dt * h[1][3] - x * ht[1][3]) / w;
        let dtt = (vector(htt[0]) - dt * (2.0 * ht[0][3]) - x * htt[0][3]) / w;
        SurfaceJet { point: Point3::ORIGIN + x, ds, dt, dss, dst, dtt }
    }

    /// Unit normal in the direction of `f_s × f_t`; on a side that is one point the limit from inside. Zero where there is
    /// none.
    #[must_use]
    pub fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        let SurfaceJet { ds, dt, dst, .. } = self.jet(s, t);
        // Of a derivative that vanishes on a side, what it is next to it: it grows with the way from the side.
        let inward = |x: f64| if x < 0.5 { 1.0 } else { -1.0 };
        let size = ds.max_abs().max(dt.max_abs());
        let (a, b) = match (ds.max_abs() <= VANISHED * size, dt.max_abs() <= VANISHED * size) {
            (true, false) => (dst * inward(t), dt),
            (false, true) => (ds, dst * inward(s)),
            _ => (ds, dt),
        };
        a.unit().zip(b.unit()).and_then(|(a, b)| a.cross(b).unit()).unwrap_or_default()
    }

    /// The way to a point from one near it, which loses no digits far from the origin.
    pub(crate) fn way_from(&self, origin: Point3, s: f64, t: f64) -> Vec3 {
        let local = self.seen_from(origin);
        let [x, y, z, w] = bernstein::eval(&local.along_s(t), s);
        Vec3::new(x / w, y / w, z / w)
    }

    /// The same surface with coordinates from another origin.
    pub(crate) fn seen_from(&self, origin: Point3) -> Self {
        let o = origin.to_vec();
        let moved = |&[x, y, z, w]: &[f64; 4]| [x - o.x * w, y - o.y * w, z - o.z * w, w];
        Self { degrees: self.degrees, rows: self.rows.iter().map(moved).collect() }
    }

    /// The corners at (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self) -> [Point3; 4] {
        self.corner_rows().map(|k| {
            let [x, y, z, w] = self.rows[k];
            Point3::new(x / w, y / w, z / w)
        })
    }

    fn corner_rows(&self) -> [usize; 4] {
        let [p, q] = self.degrees;
        [0, p * (q + 1), q, p * (q + 1) + q]
    }

    /// The surface with corners that are known better than its rows.
    pub(crate) fn with_corners(mut self, corners: [Point3; 4]) -> Self {
        for (k, p) in self.corner_rows().into_iter().zip(corners) {
            let w = self.rows[k][3];
            self.rows[k] = [p.x * w, p.y * w, p.z * w, w];
        }
        self
    }

    /// The s-line at `t`, with the same parameter s.
    #[must_use]
    pub fn s_line(&self, t: f64) -> RationalBezier {
        RationalBezier::from_rows_unchecked(self.along_s(t))
    }

    /// The t-line at `s`, with the same parameter t.
    #[must_use]
    pub fn t_line(&self, s: f64) -> RationalBezier {
        let q = self.degrees[1];
        let column = |j: usize| self.rows.iter().skip(j).step_by(q + 1).copied().collect::<Vec<_>>();
        RationalBezier::from_rows_unchecked((0..=q).map(|j| bernstein::eval(&column(j), s)).collect())
    }

    /// The rows of the s-line at `t`.
    fn along_s(&self, t: f64) -> Vec<[f64; 4]> {
        self.rows.chunks(self.degrees[1] + 1).map(|row| bernstein::eval(row, t)).collect()
    }

    /// The part over `[s0, s1] × [t0, t1]`, `0 <= s0 < s1 <= 1` and the same for t, as a surface of its own: exact.
    #[must_use]
    pub fn part(&self, s: [f64; 2], t: [f64; 2]) -> Self {
        let [p, q] = self.degrees;
        let mut rows: Vec<[f64; 4]> = self.rows.clone();
        for row in rows.chunks_mut(q + 1) {
            bernstein::restrict(row, t);
        }
        let mut column = Vec::with_capacity(p + 1);
        for j in 0..=q {
            column.clear();
            column.extend(rows.iter().skip(j).step_by(q + 1));
            bernstein::restrict(&mut column, s);
            for (i, row) in column.iter().enumerate() {
                rows[i * (q + 1) + j] = *row;
            }
        }
        Self { degrees: self.degrees, rows }
    }

    /// The image under a similarity or a reflection: control points move, weights stay.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite` if a control point overflows.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        if !map.is_similarity() {
            return Err(Error::NotASimilarity);
        }
        let rows = self.rows.iter().enumerate().map(|(index, row)| moved_row(map, row, index));
        Ok(Self { degrees: self.degrees, rows: rows.collect::<Result<_>>()? })
    }
}

/// A derivative below this part of the other one is rounding of zero: the side is one point there.
const VANISHED: f64 = 1e-13;
