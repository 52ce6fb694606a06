//! How far a QB curve runs: poles, base points, the farthest point, and a certificate that it stays in a ball
//! (`docs/math/qb-curves.md#poles-and-reach`).
//!
//! With the center `c` and a radius `r` both `W = |d|²` and `Z = |n - c d|²/r²` are real polynomials of degree `2n` without
//! negative values, and `Z/W` is the squared distance from `c` in radii. Dividing by `r²` makes both comparable: no decision
//! below depends on the unit of length.

use super::{QbCurve, Row, denominator, numerator};
use crate::base::bernstein;
use crate::base::bernstein_roots::roots;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{CurveError, Result};
use crate::rational::{Polynomial, QuatPolynomial};

/// `W/(W + Z)` below this is a pole: 1e7 radii from the center.
const POLE: f64 = 1e-14;

/// `W + Z` below this part of its maximum is a base point.
const BASE_POINT: f64 = 1e-14;

/// A curve that runs out to this many times its own size passes through infinity as far as doubles can tell.
pub(crate) const REACH_LIMIT: f64 = 1e7;

/// Places at which the size of a bare curve is taken.
const SAMPLES: u32 = 17;

/// Halvings of a curve in search of a proof, and parts looked at in all.
const HALVINGS: u32 = 50;
const MOST_PARTS: usize = 20_000;

/// What [`QbCurve::reach`] found.
///
/// ```
/// use cyclide::{Point3, Quat, conformal::HPoint, curve::QbCurve};
/// // From 1 through infinity to -1 along the x-axis.
/// let [a, b] = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let line = QbCurve::new(&[HPoint::weighted(a, Quat::ONE), HPoint::weighted(b, -Quat::ONE)])?;
/// assert_eq!(line.reach(Point3::ORIGIN).poles, [0.5]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct QbReach {
    /// Parameters at which the curve passes through infinity, rising.
    pub poles: Vec<f64>,
    /// Parameters at which numerator and denominator vanish together, rising: the curve passes there, but its pairs say nothing.
    pub base_points: Vec<f64>,
    /// Largest distance from the center and its parameter; `None` if there are poles.
    pub farthest: Option<(f64, f64)>,
}

impl QbCurve {
    /// Poles, base points and the largest distance from a center.
    #[must_use]
    pub fn reach(&self, center: Point3) -> QbReach {
        let radius = self.median_distance(center);
        let (mut curve, mut base_points) = (self.about(center), Vec::new());
        while let Some((t, simpler)) = curve.without_base_point(radius) {
            base_points.push(t);
            curve = simpler;
        }
        base_points.sort_by(f64::total_cmp);
        let (w, z) = Self::forms(&curve.rows, radius);
        // The extremes of Z/W, and those of W/(W + Z).
        let changes = &(&derivative(&z) * &w) - &(&z * &derivative(&w));
        let candidates = || roots(changes.coefficients()).into_iter().chain((0..SAMPLES).map(sample));
        let mut poles: Vec<f64> = candidates().filter(|&t| w.value(t) < POLE * (w.value(t) + z.value(t))).collect();
        poles.sort_by(f64::total_cmp);
        poles.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        let distance = |t: f64| ((z.value(t) / w.value(t)).sqrt() * radius, t);
        let farthest = candidates().map(distance).max_by(|a, b| a.0.total_cmp(&b.0)).filter(|_| poles.is_empty());
        QbReach { poles, base_points, farthest }
    }

    /// The parts of `[0, 1]` over which the curve is not proved to stay in a ball, in order; none: it does. The proof halves the curve
    /// until the Bernstein coefficients of `radius² W - |n - c d|²` are positive.
    ///
    /// ```
    /// # use cyclide::{Point3, Quat, Vec3, conformal::HPoint, curve::QbCurve};
    /// let ends = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    /// let turn = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
    /// let quarter = QbCurve::new(&[HPoint::weighted(ends[0], Quat::ONE), HPoint::weighted(ends[1], turn)])?;
    /// assert!(quarter.excursions(Point3::ORIGIN, 1.001).is_empty());
    /// assert_eq!(quarter.excursions(Point3::ORIGIN, 0.999), [[0.0, 1.0]]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn excursions(&self, center: Point3, radius: f64) -> Vec<[f64; 2]> {
        let curve = self.about(center);
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut ahead = vec![(curve.rows.to_vec(), 0.0, 1.0, HALVINGS)];
        let mut left = MOST_PARTS;
        while let Some((rows, from, to, halvings)) = ahead.pop() {
            let (w, z) = Self::forms(&rows, radius);
            let inside = &w - &z;
            left = left.saturating_sub(1);
            if inside.coefficients().iter().all(|c| *c > 0.0) {
                continue;
            }
            if halvings == 0 || left == 0 || inside.coefficients().iter().all(|c| *c <= 0.0) {
                match found.last_mut().filter(|last| last[1] >= from) {
                    Some(last) => last[1] = to,
                    None => found.push([from, to]),
                }
                continue;
            }
            let middle: f64 = 0.5 * (from + to);
            let (first, second) = bernstein::split(&rows, 0.5);
            ahead.extend([(second, middle, to, halvings - 1), (first, from, middle, halvings - 1)]);
        }
        found
    }

    /// Refuses a curve that runs out to infinity, or so far that doubles do not tell.
    ///
    /// # Errors
    /// `curve-through-infinity`: more than 1e7 times its own size away.
    pub fn check_finite(&self) -> Result<()> {
        let points: Vec<Point3> = (0..SAMPLES).map(|i| self.point(sample(i))).filter(|p| p.is_finite()).collect();
        let count = points.len().max(1) as f64;
        let mean = points.iter().map(|p| *p - self.origin).fold(Vec3::ZERO, |a, b| a + b) / count;
        let center = self.origin + mean;
        let radius = self.median_distance(center);
        self.check_reach(center, radius)
    }

    /// Refuses a curve that is not proved to stay within 1e7 radii of a center.
    ///
    /// # Errors
    /// `curve-through-infinity`.
    pub(crate) fn check_reach(&self, center: Point3, radius: f64) -> Result<()> {
        if let Some(end) = [0.0, 1.0].into_iter().zip(self.ends).find(|(_, end)| end.is_none()) {
            return Err(CurveError::ThroughInfinity { t: end.0 }.into());
        }
        match self.excursions(center, REACH_LIMIT * radius).first() {
            Some([from, to]) if radius > 0.0 => Err(CurveError::ThroughInfinity { t: 0.5 * (from + to) }.into()),
            _ => Ok(()),
        }
    }

    /// The size of a bare curve: the median of its distances from a center. Not 0, which would measure nothing.
    fn median_distance(&self, center: Point3) -> f64 {
        let distance = |i: u32| Some(self.point(sample(i)).distance(center)).filter(|d| d.is_finite());
        let mut distances: Vec<f64> = (0..SAMPLES).map(|i| distance(i).unwrap_or(f64::INFINITY)).collect();
        distances.sort_by(f64::total_cmp);
        let median = distances[distances.len() / 2];
        if median > 0.0 && median.is_finite() { median } else { 1.0 }
    }

    /// `W` and `Z` of pairs that are measured from the origin inside, which is the center.
    fn forms(rows: &[Row], radius: f64) -> (Polynomial, Polynomial) {
        let norm = |part: fn(&Row) -> Quat, scale: f64| {
            let entries: Vec<[f64; 4]> = rows.iter().map(|row| (part(row) * scale).to_array()).collect();
            let entry = |d: usize| Polynomial::new(entries.iter().map(|e| e[d]).collect());
            let q = QuatPolynomial([0, 1, 2, 3].map(entry));
            q.dot(&q)
        };
        (norm(denominator, 1.0), norm(numerator, 1.0 / radius))
    }

    /// A base point and the curve with the common factor taken out; `None` if there is none.
    fn without_base_point(&self, radius: f64) -> Option<(f64, Self)> {
        let (w, z) = Self::forms(&self.rows, radius);
        let sum = &w + &z;
        let places = || roots(derivative(&sum).coefficients()).into_iter().chain((0..SAMPLES).map(sample));
        let largest = places().map(|t| sum.value(t)).fold(0.0, f64::max);
        let (least, t) = places().map(|t| (sum.value(t), t)).min_by(|a, b| a.0.total_cmp(&b.0))?;
        if self.degree() == 0 || least >= BASE_POINT * largest {
            return None;
        }
        let rows = bernstein::divided(&self.rows, t)?;
        Some((t, Self { rows: rows.into(), ..self.clone() }))
    }
}

fn sample(i: u32) -> f64 {
    f64::from(i) / f64::from(SAMPLES - 1)
}

fn derivative(p: &Polynomial) -> Polynomial {
    let n = p.degree() as f64;
    Polynomial::new(p.coefficients().windows(2).map(|w| (w[1] - w[0]) * n).collect())
}
