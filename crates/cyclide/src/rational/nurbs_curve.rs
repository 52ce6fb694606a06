//! Clamped rational B-spline curves with positive weights: the exact form that leaves the kernel.

use super::bezier_curve::{RationalBezier, jet_of_rows};
use super::nurbs_weights::{check_even, check_range, scaled_rows};
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{CurveError, ErrorItem, NumberError, NurbsError, PointError, Result};

/// A rational B-spline curve: clamped knots, positive weights, affine control points.
///
/// As a [`ParamCurve`](crate::curve::ParamCurve) its pieces are its knot spans; the knot vector itself may have any domain.
///
/// ```
/// use cyclide::{Point3, curve::ParamCurve, rational::NurbsCurve};
/// let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
/// let parabola = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0; 3])?;
/// assert_eq!(parabola.point(0.5), Point3::new(1.0, 1.0, 0.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsCurve {
    degree: usize,
    knots: Vec<f64>,
    points: Vec<Point3>,
    weights: Vec<f64>,
    /// The Bézier form of the knot spans (homogeneous rows), made once: `degree` rows of each, and the last one. Neighbors
    /// share the row of their joint.
    span_rows: Vec<[f64; 4]>,
    /// The distinct knots, one more than spans.
    breaks: Vec<f64>,
}

impl NurbsCurve {
    /// Largest degree: what CAD systems hold (OpenCASCADE reads no higher one).
    pub const MOST_DEGREE: usize = 25;

    /// Curve from degree (1 to [`MOST_DEGREE`](Self::MOST_DEGREE)), knots (length `points + degree + 1`, clamped,
    /// non-decreasing, no inner knot more often than `degree` times), affine control points and weights. Knots that are
    /// not clamped: [`clamped`](Self::clamped).
    ///
    /// # Errors
    /// `parameter-out-of-range` (degree), `too-few-points`, `count-differs` (weights, knots), `not-finite`,
    /// `weight-not-positive`, `weights-uneven`, `parameter-out-of-range` (coordinates above 1e150, or a size below 1e-150),
    /// `knots-decrease`, `knot-multiplicity`, `not-a-spline` (ends not clamped).
    pub fn new(degree: usize, knots: Vec<f64>, points: Vec<Point3>, weights: Vec<f64>) -> Result<Self> {
        let curve = Self::with_any_weights(degree, knots, points, weights)?;
        check_even(&curve)?;
        Ok(curve)
    }

    /// As [`new`](Self::new), however uneven the weights are.
    pub(crate) fn with_any_weights(
        degree: usize,
        knots: Vec<f64>,
        points: Vec<Point3>,
        weights: Vec<f64>,
    ) -> Result<Self> {
        check_numbers(degree, &knots, &points, &weights)?;
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        // Clamped ends are copies of one number: compared as such.
        if multiplicity(&knots, first) <= degree || multiplicity(&knots, last) <= degree {
            return Err(NurbsError::NotASpline { detail: "end knots do not have multiplicity degree + 1" }.into());
        }
        check_multiplicities(degree, &knots)?;
        let mut breaks = knots.clone();
        breaks.dedup_by(|a, b| *a <= *b); // sorted: equal
        let rows = scaled_rows(&points, &weights);
        // Where every inner knot is there as often as the degree the curve is in Bézier form: no second list is made.
        let is_bezier = rows.len() == degree * (breaks.len() - 1) + 1;
        let span_rows = if is_bezier { rows } else { span_rows(degree, &knots, &rows, &breaks) };
        Ok(Self { degree, knots, points, weights, span_rows, breaks })
    }

    /// Curve from homogeneous control rows `[wx, wy, wz, w]`; errors as [`new`](Self::new).
    pub(super) fn from_rows(degree: usize, knots: Vec<f64>, rows: &[[f64; 4]]) -> Result<Self> {
        let points = rows.iter().map(|r| Point3::new(r[0] / r[3], r[1] / r[3], r[2] / r[3])).collect();
        Self::with_any_weights(degree, knots, points, rows.iter().map(|r| r[3]).collect())
    }

    /// The same points run backwards over the same knot domain.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let (first, last) = self.domain();
        // The mirror image of each end is the other end, to the bit.
        let mirrored = |k: &f64| {
            if *k <= first {
                last
            } else if *k >= last {
                first
            } else {
                first + (last - k)
            }
        };
        Self {
            degree: self.degree,
            knots: self.knots.iter().rev().map(mirrored).collect(),
            points: self.points.iter().rev().copied().collect(),
            weights: self.weights.iter().rev().copied().collect(),
            span_rows: self.span_rows.iter().rev().copied().collect(),
            breaks: self.breaks.iter().rev().map(mirrored).collect(),
        }
    }

    /// The same curve with its end in its start, of which it is rounding away.
    pub(crate) fn closed_by_rounding(mut self) -> Self {
        let first = self.points[0];
        if let (Some(point), Some(row)) = (self.points.last_mut(), self.span_rows.last_mut()) {
            let w = row[3];
            *point = first;
            *row = [first.x * w, first.y * w, first.z * w, w];
        }
        self
    }

    /// Joins Bézier curves of one degree end to end, each over a knot interval of the given length; joints get
    /// full multiplicity (`degree`), and each curve's weights are scaled so that they agree at the joint.
    /// The affine parameter inside each curve is unchanged.
    ///
    /// # Errors
    /// `too-few-points` (no curve), `not-a-spline` (degrees differ, interval not positive), `disconnected` (ends
    /// differ by more than 1e-9 of the larger coordinate), `weight-not-positive`.
    pub fn from_beziers(curves: &[RationalBezier], intervals: &[f64]) -> Result<Self> {
        let Some(first) = curves.first() else {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        };
        let degree = first.degree();
        if intervals.len() != curves.len() || intervals.iter().any(|h| !(h.is_finite() && *h > 0.0)) {
            return Err(NurbsError::NotASpline { detail: "one positive knot interval per Bézier curve needed" }.into());
        }
        let total: f64 = intervals.iter().sum();
        let (mut points, mut weights): (Vec<Point3>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut knots = vec![0.0; degree + 1];
        let mut sum = 0.0;
        for (piece, (curve, h)) in curves.iter().zip(intervals).enumerate() {
            if curve.degree() != degree {
                return Err(NurbsError::NotASpline { detail: "Bézier curves of different degree" }.into());
            }
            let scale = weights.last().map_or(1.0, |w| w / curve.rows()[0][3]);
            for (i, row) in curve.rows().iter().enumerate() {
                let w = row[3];
                if !(w > 0.0) {
                    return Err(NurbsError::WeightNotPositive { index: points.len(), weight: w }.into());
                }
                let p = Point3::new(row[0] / w, row[1] / w, row[2] / w);
                match points.last() {
                    Some(end) if i == 0 => {
                        let (gap, limit) = (end.distance(p), 1e-9 * p.to_vec().max_abs().max(end.to_vec().max_abs()));
                        if gap > limit {
                            return Err(CurveError::Disconnected { piece: piece - 1, next: piece, gap, limit }.into());
                        }
                    }
                    _ => {
                        points.push(p);
                        weights.push(w * scale);
                    }
                }
            }
            sum += h;
            let last = piece + 1 == curves.len();
            knots.extend(std::iter::repeat_n(if last { 1.0 } else { sum / total }, degree + usize::from(last)));
        }
        // Of a closed curve the scales multiply to 1, up to a rounding for each joint: where the end has the weight of the start, it has it to the bit.
        let end = weights.len() - 1;
        if (weights[end] - weights[0]).abs() <= 4.0 * f64::EPSILON * curves.len() as f64 * weights[0] {
            weights[end] = weights[0];
        }
        Self::with_any_weights(degree, knots, points, weights)
    }

    /// Degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Knots, with repetitions.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// First and last knot.
    #[must_use]
    pub fn domain(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    /// Distinct knots with their multiplicities.
    #[must_use]
    pub fn knot_multiplicities(&self) -> Vec<(f64, usize)> {
        self.breaks.iter().map(|&b| (b, multiplicity(&self.knots, b))).collect()
    }

    /// Distinct knots.
    #[must_use]
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// Affine control points.
    #[must_use]
    pub fn control_points(&self) -> &[Point3] {
        &self.points
    }

    /// The points at the means of `degree` neighboring inner knots (T. N. E. Greville), one for each control point: where
    /// data stand that such a spline interpolates.
    ///
    /// ```
    /// use cyclide::{Point3, rational::NurbsCurve};
    /// let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
    /// let parabola = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0; 3])?;
    /// assert_eq!(parabola.greville_points()[1], Point3::new(1.0, 1.0, 0.0));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn greville_points(&self) -> Vec<Point3> {
        // The mean of differences from the first knot: the sum of knots may overflow.
        let first = self.knots[0];
        let mean = |i: usize| {
            self.knots[i + 1..=i + self.degree].iter().map(|k| (k - first) / self.degree as f64).sum::<f64>()
        };
        (0..self.points.len()).map(|i| self.point_at_knot(first + mean(i))).collect()
    }

    /// Weights, all positive.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The knot spans as Bézier curves.
    #[must_use]
    pub fn to_beziers(&self) -> Vec<RationalBezier> {
        (0..self.span_count()).map(|span| self.span_bezier(span)).collect()
    }

    /// A knot span as a Bézier curve.
    pub(super) fn span_bezier(&self, span: usize) -> RationalBezier {
        RationalBezier::from_rows_unchecked(self.span_rows(span).to_vec())
    }

    /// Point at the knot-domain parameter `u` (clamped to the domain).
    #[must_use]
    pub fn point_at_knot(&self, u: f64) -> Point3 {
        let (span, s) = self.span_of(u);
        self.span_point(span, s)
    }

    /// Homogeneous Bézier rows of a knot span. They lie in the hull of the control rows, so weights are positive.
    pub(crate) fn span_rows(&self, span: usize) -> &[[f64; 4]] {
        &self.span_rows[span * self.degree..=(span + 1) * self.degree]
    }

    /// Number of knot spans.
    #[must_use]
    pub fn span_count(&self) -> usize {
        self.breaks.len() - 1
    }

    /// The point of a knot span at its own parameter in `[0, 1]`.
    ///
    /// # Panics
    /// If there is no such span.
    #[must_use]
    pub fn span_point(&self, span: usize, s: f64) -> Point3 {
        let [x, y, z, w] = bernstein::eval(self.span_rows(span), s);
        Point3::new(x / w, y / w, z / w)
    }

    /// Point and derivatives of a knot span by its own parameter in `[0, 1]`.
    ///
    /// # Panics
    /// If there is no such span.
    #[must_use]
    pub fn span_jet(&self, span: usize, s: f64) -> CurveJet {
        jet_of_rows(self.span_rows(span), s)
    }

    /// First derivative of a knot span by its own parameter in `[0, 1]`.
    pub(crate) fn span_velocity(&self, span: usize, s: f64) -> Vec3 {
        let rows = self.span_rows(span);
        let ([x, y, z, w], [dx, dy, dz, dw]) = (bernstein::eval(rows, s), bernstein::first_derivative(rows, s));
        (Vec3::new(dx, dy, dz) - Vec3::new(x, y, z) * (dw / w)) / w
    }

    fn span_of(&self, u: f64) -> (usize, f64) {
        let n = self.span_count();
        let u = u.clamp(self.breaks[0], self.breaks[n]);
        let span = self.breaks.partition_point(|b| *b <= u).saturating_sub(1).min(n - 1);
        let (a, b) = (self.breaks[span], self.breaks[span + 1]);
        (span, (u - a) / (b - a))
    }
}

/// Refuses numbers that are no spline of this degree, whether its ends are clamped or not.
pub(super) fn check_numbers(degree: usize, knots: &[f64], points: &[Point3], weights: &[f64]) -> Result<()> {
    if !(1..=NurbsCurve::MOST_DEGREE).contains(&degree) {
        let max = NurbsCurve::MOST_DEGREE as f64;
        return Err(
            NumberError::ParameterOutOfRange { name: ErrorItem::Degree, value: degree as f64, min: 1.0, max }.into()
        );
    }
    if points.len() < degree + 1 {
        return Err(PointError::TooFewPoints { given: points.len(), needed: degree + 1 }.into());
    }
    if weights.len() != points.len() {
        return Err(
            NumberError::CountDiffers { what: ErrorItem::Weight, given: weights.len(), needed: points.len() }.into()
        );
    }
    let needed = points.len() + degree + 1;
    if knots.len() != needed {
        return Err(NumberError::CountDiffers { what: ErrorItem::Knot, given: knots.len(), needed }.into());
    }
    if let Some(index) = points.iter().position(|p| !p.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::ControlPoint, index }.into());
    }
    points.iter().enumerate().try_for_each(|(index, p)| range::check_point(index, p.to_vec()))?;
    range::check_distance(Aabb::of_points(points.iter().copied()).map_or(0.0, |b| b.diagonal()))?;
    if let Some(index) = weights.iter().position(|w| !w.is_finite() || *w <= 0.0) {
        return Err(NurbsError::WeightNotPositive { index, weight: weights[index] }.into());
    }
    if let Some(index) = knots.iter().position(|k| !k.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Knot, index }.into());
    }
    check_range(weights)?;
    // Their differences are divided by each other.
    if !(knots[needed - 1] - knots[0]).is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Knot, index: needed - 1 }.into());
    }
    match knots.windows(2).position(|w| w[1] < w[0]) {
        Some(i) => Err(NurbsError::KnotsDecrease { index: i + 1, knot: knots[i + 1], before: knots[i] }.into()),
        None => Ok(()),
    }
}

/// Refuses knots that are there too often: inner ones more than `degree` times, those at the ends once more.
pub(super) fn check_multiplicities(degree: usize, knots: &[f64]) -> Result<()> {
    let mut index = 0;
    for run in knots.chunk_by(|a, b| a >= b) {
        let at_end = index == 0 || index + run.len() == knots.len();
        let limit = degree + usize::from(at_end);
        if run.len() > limit {
            return Err(NurbsError::KnotMultiplicity { index, multiplicity: run.len(), limit }.into());
        }
        index += run.len();
    }
    Ok(())
}

/// How many of the sorted knots are this number.
pub(super) fn multiplicity(knots: &[f64], k: f64) -> usize {
    knots.partition_point(|x| *x <= k) - knots.partition_point(|x| *x < k)
}

/// Bézier rows of every span: its two end knots are inserted up to full multiplicity, in the window of the knots and
/// rows that act on the span. Neighbors share the row of their joint.
fn span_rows(degree: usize, knots: &[f64], rows: &[[f64; 4]], breaks: &[f64]) -> Vec<[f64; 4]> {
    let mut all: Vec<[f64; 4]> = Vec::with_capacity(degree * (breaks.len() - 1) + 1);
    for ends in breaks.windows(2) {
        let k = knots.partition_point(|x| *x <= ends[0]) - 1;
        let mut local_knots = knots[k - degree..=k + degree + 1].to_vec();
        let mut local = rows[k - degree..=k].to_vec();
        for &u in ends {
            for _ in multiplicity(&local_knots, u)..degree {
                insert_knot(degree, &mut local_knots, &mut local, u);
            }
        }
        let k = local_knots.partition_point(|x| *x <= ends[0]) - 1;
        let span = &local[k - degree..=k];
        all.extend_from_slice(if all.is_empty() { span } else { &span[1..] });
    }
    all
}

/// Inserts the knot `u`, inside the domain and of multiplicity below the degree, once (W. Boehm, 1980).
pub(super) fn insert_knot(degree: usize, knots: &mut Vec<f64>, rows: &mut Vec<[f64; 4]>, u: f64) {
    // k: last knot not above u, s: how often u is there already.
    let k = knots.partition_point(|x| *x <= u) - 1;
    let s = multiplicity(knots, u);
    // Rows k-degree+1 to k-s are replaced by one more combinations of neighbors.
    let replaced: Vec<[f64; 4]> = (k + 1 - degree..=k - s)
        .map(|i| {
            let a = (u - knots[i]) / (knots[i + degree] - knots[i]);
            std::array::from_fn(|d| (1.0 - a) * rows[i - 1][d] + a * rows[i][d])
        })
        .collect();
    rows.splice(k + 1 - degree..k - s, replaced);
    knots.insert(k + 1, u);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows that are taken as they are, are those that knot insertion finds.
    #[test]
    fn rows_of_full_knots_are_those_of_the_spans() {
        let points: Vec<Point3> = (0..7).map(|i| Point3::new(f64::from(i), f64::from(i * i % 5), 0.5)).collect();
        let weights = vec![1.0, 0.5, 1.0, 2.0, 1.0, 0.7, 1.0];
        for (degree, knots) in [
            (2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 3.0, 3.0, 4.0, 4.0, 4.0]),
            (3, vec![0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 5.0, 5.0, 5.0, 5.0]),
            (3, vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 5.0, 5.0, 5.0, 5.0]),
        ] {
            let curve = NurbsCurve::new(degree, knots, points.clone(), weights.clone()).unwrap();
            let rows = scaled_rows(&points, &weights);
            assert_eq!(curve.span_rows, span_rows(degree, &curve.knots, &rows, &curve.breaks));
        }
    }

    /// de Boor's recursion straight from the definition, as an independent judge.
    fn de_boor(c: &NurbsCurve, u: f64) -> Point3 {
        let n = c.degree;
        let k = c.knots.partition_point(|x| *x <= u).saturating_sub(1).clamp(n, c.points.len() - 1);
        let mut d: Vec<[f64; 4]> = (0..=n)
            .map(|j| {
                let (p, w) = (c.points[j + k - n], c.weights[j + k - n]);
                [p.x * w, p.y * w, p.z * w, w]
            })
            .collect();
        for r in 1..=n {
            for j in (r..=n).rev() {
                let (lo, hi) = (c.knots[j + k - n], c.knots[j + 1 + k - r]);
                let a = (u - lo) / (hi - lo);
                d[j] = std::array::from_fn(|i| (1.0 - a) * d[j - 1][i] + a * d[j][i]);
            }
        }
        Point3::new(d[n][0] / d[n][3], d[n][1] / d[n][3], d[n][2] / d[n][3])
    }

    #[test]
    fn spans_agree_with_de_boor() {
        let points: Vec<Point3> =
            (0..7).map(|i| Point3::new(f64::from(i), f64::from(i * i % 5), f64::from(i % 3))).collect();
        let weights = vec![1.0, 0.5, 2.0, 1.0, 0.75, 1.5, 1.0];
        let c =
            NurbsCurve::new(3, vec![0.0, 0.0, 0.0, 0.0, 0.3, 0.3, 0.7, 1.0, 1.0, 1.0, 1.0], points, weights).unwrap();
        assert_eq!(c.span_count(), 3);
        for i in 0..=50 {
            let u = f64::from(i) / 50.0;
            assert!(c.point_at_knot(u).distance(de_boor(&c, u)) < 1e-14, "{u}");
        }
    }
}
