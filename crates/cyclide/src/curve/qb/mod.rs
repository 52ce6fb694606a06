//! Quaternionic Bézier curves: two polynomials with quaternion coefficients, the curve is their right quotient.
//!
//! ```text
//! x(t) = (sum B_i(t) n_i) (sum B_i(t) d_i)^-1,   i = 0..n
//! ```
//! The pairs `(n_i, d_i)` may be multiplied on the right by one common quaternion (the gauge). The curve lies in
//! three-space exactly when the real part of `n(t) conj(d(t))` vanishes; it is then a real rational curve of degree `2n`,
//! and every Möbius map acts on its pairs linearly, from the left (`docs/math/qb-curves.md#pairs`; source: `003`, section 2).
//! Degree 1 are the arcs of circles and straight segments.

mod evaluate;
mod from_arcs;
mod from_blend;
mod modify;
mod rational;
mod reach;
mod rows;
mod spline;
mod spline_edit;

pub(crate) use from_blend::SpanData;
pub use reach::QbReach;
pub use spline::QbSpline;

use rows::Rows;

use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::conformal::hpoint::HPoint;
use crate::error::{Error, ErrorItem, NumberError, PatchError, PointError, Result};
use crate::rational::{Polynomial, QuatPolynomial};

/// Largest real part, relative to what it is a sum of, that counts as rounding of the pairs.
const DEFECT_LIMIT: f64 = 1e-9;

/// Pairs whose largest denominator leaves this range are scaled, by a power of two: squares would leave that of doubles.
const DENOMINATOR_RANGE: [f64; 2] = [1e-30, 1e30];

/// The pair of a numerator and a denominator, entry by entry.
type Row = [f64; 8];

/// A quaternionic Bézier (QB) curve of degree `n` over `[0, 1]`, by its `n + 1` pairs of numerator and denominator.
///
/// Inside, the numerators are measured from a point near the curve, so that it keeps its digits far from the origin.
/// A curve may pass through infinity, where its points are not finite: [`reach`](Self::reach) finds that.
///
/// ```
/// use cyclide::{Point3, Quat, Vec3, conformal::HPoint, curve::{ParamCurve, QbCurve}};
/// // A quarter of the unit circle: degree 1.
/// let ends = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
/// let turn = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
/// let quarter = QbCurve::new(&[HPoint::weighted(ends[0], Quat::ONE), HPoint::weighted(ends[1], turn)])?;
/// assert_eq!(quarter.degree(), 1);
/// assert!((quarter.point(0.5).to_vec().length() - 1.0).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QbCurve {
    /// What the numerators are measured from.
    origin: Point3,
    /// Never empty.
    rows: Rows,
    /// Both ends, known better than the rows; `None` at infinity.
    ends: [Option<Point3>; 2],
}

impl QbCurve {
    /// The curve with these pairs, at least one.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `point-at-infinity` (every denominator is zero), `not-in-space` (the quotient has a real part:
    /// relative [defect](Self::defect) above 1e-9).
    pub fn new(pairs: &[HPoint]) -> Result<Self> {
        if pairs.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        if let Some(index) = pairs.iter().position(|pair| !(pair.n.is_finite() && pair.d.is_finite())) {
            return Err(NumberError::NotFinite { what: ErrorItem::Pair, index }.into());
        }
        if pairs.iter().all(|pair| pair.d == Quat::ZERO) {
            return Err(Error::at_infinity(ErrorItem::Curve, 0));
        }
        let curve = Self::from_local(Point3::ORIGIN, pairs.iter().map(|pair| (pair.n, pair.d)));
        let defect = curve.defect();
        if !(defect <= DEFECT_LIMIT) {
            return Err(PatchError::NotInSpace { defect, limit: DEFECT_LIMIT }.into());
        }
        let near = curve.ends.into_iter().flatten().next();
        Ok(near.map_or(curve.clone(), |point| curve.about(point)))
    }

    /// From pairs whose numerators are measured from a point; finite, at least one, and in space by construction.
    pub(crate) fn from_local(origin: Point3, pairs: impl IntoIterator<Item = (Quat, Quat)>) -> Self {
        Self::from_rows(origin, scaled_rows(pairs))
    }

    /// The same, with ends that are known.
    fn from_local_between(ends: [Point3; 2], origin: Point3, pairs: impl IntoIterator<Item = (Quat, Quat)>) -> Self {
        Self { origin, rows: scaled_rows(pairs), ends: ends.map(Some) }
    }

    fn from_rows(origin: Point3, rows: Rows) -> Self {
        let end = |row: &Row| {
            let quotient = HPoint { n: numerator(row), d: denominator(row) }.quotient()?;
            Some(origin + quotient.vector()).filter(|p| p.is_finite())
        };
        let ends = [&rows[0], &rows[rows.len() - 1]].map(end);
        Self { origin, rows, ends }
    }

    /// With ends that are known better than its pairs.
    pub(crate) fn with_ends(mut self, start: Option<Point3>, end: Option<Point3>) -> Self {
        for (slot, known) in self.ends.iter_mut().zip([start, end]) {
            *slot = known.or(*slot);
        }
        self
    }

    /// The same curve with its numerators measured from another point.
    pub(crate) fn about(&self, origin: Point3) -> Self {
        let shift = Quat::from(self.origin - origin);
        let moved = |row: &Row| to_row(numerator(row) + shift * denominator(row), denominator(row));
        Self { origin, rows: self.rows.iter().map(moved).collect(), ends: self.ends }
    }

    /// Degree: one less than there are pairs.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.rows.len() - 1
    }

    /// The pairs of numerators, measured from the origin of the coordinates, and denominators. A middle pair may be a point at
    /// infinity (`d = 0`), and its quotient need not be in three-space.
    #[must_use]
    pub fn pairs(&self) -> Vec<HPoint> {
        self.pairs_about(Point3::ORIGIN)
    }

    /// The pairs with numerators measured from a point.
    pub(crate) fn pairs_about(&self, origin: Point3) -> Vec<HPoint> {
        let pair = |row: &Row| HPoint { n: numerator(row), d: denominator(row) };
        self.about(origin).rows.iter().map(pair).collect()
    }

    /// The largest Bernstein coefficient of the real part of `n conj(d)`, relative to what it is a sum of: 0 if and only if
    /// the curve lies in three-space, up to rounding (`docs/math/qb-curves.md#real-rational-form`).
    #[must_use]
    pub fn defect(&self) -> f64 {
        let (num, den) = self.polynomials();
        let sizes = |part: fn(&Row) -> Quat| Polynomial::new(self.rows.iter().map(|row| part(row).norm()).collect());
        let (real, size) = (num.dot(&den), &sizes(numerator) * &sizes(denominator));
        // Sums that overflow say nothing.
        let part = |(a, b): (&f64, &f64)| match *b {
            b if !b.is_finite() => f64::INFINITY,
            b if b > 0.0 => a.abs() / b,
            _ => 0.0,
        };
        real.coefficients().iter().zip(size.coefficients()).map(part).fold(0.0, f64::max)
    }

    /// Numerator and denominator as polynomials.
    fn polynomials(&self) -> (QuatPolynomial, QuatPolynomial) {
        let entry = |d: usize| Polynomial::new(self.rows.iter().map(|row| row[d]).collect());
        (QuatPolynomial([0, 1, 2, 3].map(entry)), QuatPolynomial([4, 5, 6, 7].map(entry)))
    }
}

/// The rows of pairs, scaled where squares would leave the range of doubles.
fn scaled_rows(pairs: impl IntoIterator<Item = (Quat, Quat)>) -> Rows {
    let mut rows: Rows = pairs.into_iter().map(|(n, d)| to_row(n, d)).collect();
    let largest = rows.iter().map(|row| denominator(row).norm()).fold(0.0, f64::max);
    if !(DENOMINATOR_RANGE[0]..=DENOMINATOR_RANGE[1]).contains(&largest) && largest > 0.0 {
        let factor = 2.0_f64.powi(-largest.log2().round() as i32);
        rows.iter_mut().for_each(|row| *row = row.map(|x| x * factor));
    }
    rows
}

fn to_row(n: Quat, d: Quat) -> Row {
    let ([a, b, c, e], [f, g, h, i]) = (n.to_array(), d.to_array());
    [a, b, c, e, f, g, h, i]
}

fn numerator(row: &Row) -> Quat {
    Quat::new(row[0], row[1], row[2], row[3])
}

fn denominator(row: &Row) -> Quat {
    Quat::new(row[4], row[5], row[6], row[7])
}
