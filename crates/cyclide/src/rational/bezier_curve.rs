//! One rational Bézier curve in homogeneous rows `[wx, wy, wz, w]`.

use super::nurbs_curve::NurbsCurve;
use super::{Polynomial, PolynomialRow};
use crate::base::bernstein;
use crate::base::jet::{AT_REST, CurveJet};
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// A rational Bézier curve of degree `rows - 1`. The rows are homogeneous, so a middle row may be a direction
/// (weight 0); only the quotient at evaluated parameters must be finite.
///
/// ```
/// use cyclide::rational::RationalBezier;
/// let parabola = RationalBezier::new(vec![[0.0, 0.0, 0.0, 1.0], [1.0, 2.0, 0.0, 1.0], [2.0, 0.0, 0.0, 1.0]])?;
/// assert_eq!(parabola.point(0.5).to_array(), [1.0, 1.0, 0.0]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalBezier {
    rows: Vec<[f64; 4]>,
}

impl RationalBezier {
    /// Curve from homogeneous rows `[wx, wy, wz, w]`, at least two.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`.
    pub fn new(rows: Vec<[f64; 4]>) -> Result<Self> {
        if rows.len() < 2 {
            return Err(PointError::TooFewPoints { given: rows.len(), needed: 2 }.into());
        }
        match rows.iter().position(|row| row.iter().any(|v| !v.is_finite())) {
            Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Row, index }.into()),
            None => Ok(Self { rows }),
        }
    }

    /// As [`new`](Self::new) for rows that are finite by construction.
    pub(crate) fn from_rows_unchecked(rows: Vec<[f64; 4]>) -> Self {
        Self { rows }
    }

    /// The curve of a row of polynomials.
    pub(crate) fn from_polynomial_row(row: &PolynomialRow) -> Self {
        let degree = row.0.iter().map(Polynomial::degree).max().unwrap_or(0).max(1);
        let entries = row.0.each_ref().map(|p| p.elevated(degree));
        Self::from_rows_unchecked((0..=degree).map(|i| entries.each_ref().map(|p| p.coefficients()[i])).collect())
    }

    /// The rows `[wx, wy, wz, w]`.
    #[must_use]
    pub fn rows(&self) -> &[[f64; 4]] {
        &self.rows
    }

    /// Degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.rows.len() - 1
    }

    /// True if every weight coefficient is positive.
    #[must_use]
    pub fn has_positive_weights(&self) -> bool {
        self.rows.iter().all(|r| r[3] > 0.0)
    }

    /// The point at `t`.
    #[must_use]
    pub fn point(&self, t: f64) -> Point3 {
        let [x, y, z, w] = bernstein::eval(&self.rows, t);
        Point3::new(x / w, y / w, z / w)
    }

    /// Point and derivatives at `t`.
    #[must_use]
    pub fn jet(&self, t: f64) -> CurveJet {
        jet_of_rows(&self.rows, t)
    }

    /// Both parts of the curve cut at `t`.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `0 < t < 1`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        if !(t > 0.0 && t < 1.0) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 }.into());
        }
        let (l, r) = bernstein::split(&self.rows, t);
        Ok((Self { rows: l }, Self { rows: r }))
    }

    /// The same curve as a B-spline of one span over `[0, 1]`.
    ///
    /// # Errors
    /// `weight-not-positive`.
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        NurbsCurve::from_beziers(std::slice::from_ref(self), &[1.0])
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { rows: self.rows.iter().rev().copied().collect() }
    }

    /// The curve with ends that are known better than its rows.
    pub(crate) fn with_ends(mut self, start: Option<Point3>, end: Option<Point3>) -> Self {
        let last = self.rows.len() - 1;
        for (k, point) in [(0, start), (last, end)] {
            if let Some(p) = point {
                let w = self.rows[k][3];
                self.rows[k] = [p.x * w, p.y * w, p.z * w, w];
            }
        }
        self
    }

    /// The image under a similarity or a reflection: control points move, weights stay.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite` if a control point overflows.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let rows = self.rows.iter().enumerate().map(|(index, row)| moved_row(map, row, index));
        Ok(Self { rows: rows.collect::<Result<_>>()? })
    }

    /// The curve times a common factor: same points, rows multiplied by the scalar Bernstein polynomial `factor`
    /// (degree raised by its degree).
    #[must_use]
    pub fn multiplied(&self, factor: &[f64]) -> Self {
        let column = |d: usize| bernstein::product(&self.rows.iter().map(|r| r[d]).collect::<Vec<_>>(), factor);
        let columns: [Vec<f64>; 4] = std::array::from_fn(column);
        Self { rows: (0..columns[0].len()).map(|i| std::array::from_fn(|d| columns[d][i])).collect() }
    }
}

/// A homogeneous row moved by a similarity; one of weight 0 is a direction.
///
/// # Errors
/// `not-finite` if it overflows.
pub(super) fn moved_row(map: &Mobius, &[x, y, z, w]: &[f64; 4], index: usize) -> Result<[f64; 4]> {
    let overflow = Error::Number(NumberError::NotFinite { what: ErrorItem::ControlPoint, index });
    let image = |p: Point3| map.map_point(p).filter(|p| p.is_finite()).ok_or(overflow.clone());
    if w == 0.0 {
        let way = image(Point3::new(x, y, z))? - image(Point3::ORIGIN)?;
        return Ok([way.x, way.y, way.z, 0.0]);
    }
    let p = image(Point3::new(x / w, y / w, z / w))?;
    Ok([p.x * w, p.y * w, p.z * w, w])
}

/// The jet at `s` of homogeneous Bézier rows. At an end where they stand but for rounding it has no derivative.
pub(super) fn jet_of_rows(rows: &[[f64; 4]], s: f64) -> CurveJet {
    let jet = jet_of_homogeneous(bernstein::derivatives(rows, s));
    let last = rows.len() - 1;
    let (end, beside) = match s {
        s if s <= 0.0 => (0, 1),
        s if s >= 1.0 => (last, last - 1),
        _ => return jet,
    };
    // Most curves run at a speed, and need not be measured.
    if jet.d1.max_abs() > AT_REST * jet.d2.max_abs().max(jet.d3.max_abs()) {
        return jet;
    }
    let size = |[x, y, z, w]: &[f64; 4]| if *w == 0.0 { 0.0 } else { (Vec3::new(*x, *y, *z) / *w).max_abs() };
    let largest = rows.iter().map(size).fold(0.0, f64::max);
    let uneven = (rows[beside][3] / rows[end][3]).abs().max(1.0);
    jet.without_rounding(largest * uneven * last as f64)
}

/// The affine jet of homogeneous derivatives `[wx, wy, wz, w]` of orders 0 to 3 (quotient rule).
pub(crate) fn jet_of_homogeneous(h: [[f64; 4]; 4]) -> CurveJet {
    let v = |k: usize| Vec3::new(h[k][0], h[k][1], h[k][2]);
    let (w0, w1, w2, w3) = (h[0][3], h[1][3], h[2][3], h[3][3]);
    let x0 = v(0) / w0;
    let x1 = (v(1) - x0 * w1) / w0;
    let x2 = (v(2) - x1 * (2.0 * w1) - x0 * w2) / w0;
    let x3 = (v(3) - x2 * (3.0 * w1) - x1 * (3.0 * w2) - x0 * w3) / w0;
    CurveJet { point: Point3::ORIGIN + x0, d1: x1, d2: x2, d3: x3 }
}
