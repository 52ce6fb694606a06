//! Lowering knot multiplicity: a parametric C1 curve written with C1 knots.
//!
//! A chain of rational Bézier pieces may be C1 as a curve while its homogeneous form is only C0, because the weight
//! functions meet with a kink. Then the knots need multiplicity `degree`, and CAD systems call the curve C0: they
//! refuse to offset or sweep along it. Multiplying numerator and denominator of each piece by a common positive
//! polynomial `g` changes no point and no parameter. The cubic with Bernstein coefficients
//! `1, 1 + a/3, 1 - b/3, 1`, `a = g'(0)`, `b = g'(1)`, gives the weight functions of both sides of a joint the same
//! logarithmic slope, so the homogeneous form is C1 where the curve is, and the shared control point at the joint can
//! be left out (multiplicity `degree - 1` at degree `n + 3`). (Own derivation.)

use super::bezier_curve::RationalBezier;
use super::nurbs_curve::NurbsCurve;
use crate::base::vector::{Point3, Vec3};

/// Relative jump of the affine derivative that still counts as C1: rounding of the construction.
const C1_LIMIT: f64 = 1e-9;
/// Weights below this part of the largest of their span are looked at.
const UNEVEN: f64 = 1e-4;
/// Points that differ by more than this part of their coordinates are lost: a tenth of what the check of a file forgives.
const LOST_POINT: f64 = 1e-10;
/// Rounds of giving up knots: the second one finds nothing in general.
const ROUNDS: usize = 3;
/// Places looked at toward each end of a span.
const SAMPLED_HALVINGS: usize = 40;
/// Roundings of a control point that its derivative may carry.
const POINT_ROUNDINGS: f64 = 8.0;

impl NurbsCurve {
    /// The same curve with the same parameter and C1 knots (multiplicity `degree - 1`) at every knot where the
    /// derivative is continuous; the degree rises by 3. Where a closed curve joins itself as smoothly, so do its weights. Spans with very uneven weights keep their knots where the other
    /// form would lose points by rounding, and so do those at which a factor would not stay positive. `None` if nothing can be gained (one
    /// span, no C1 knot, or knots that are smooth as they are).
    #[must_use]
    pub fn with_c1_knots(&self) -> Option<Self> {
        let count = self.span_count();
        // What has smooth knots of its own keeps them: this form is C1 only, and of higher degree.
        if self.knots().len() != self.degree() * (count + 1) + 2 {
            return None;
        }
        let intervals: Vec<f64> = self.breaks().windows(2).map(|w| w[1] - w[0]).collect();
        let mut smooth: Vec<bool> = (1..count).map(|j| self.is_c1_at(j, &intervals)).collect();
        let mut seam = self.is_c1_at_seam(&intervals);
        let uneven: Vec<usize> = (0..count).filter(|i| is_uneven(self.span_rows(*i))).collect();
        for _ in 0..ROUNDS {
            let raised = self.raised_where_it_goes(&intervals, &mut smooth, &mut seam)?;
            let lost = uneven.iter().filter(|&&i| !self.keeps_points(&raised, i));
            let mut knots = lost.flat_map(|&i| [i.checked_sub(1), Some(i)]).flatten().peekable();
            if knots.peek().is_none() {
                return Some(raised);
            }
            knots.filter(|j| *j < count - 1).for_each(|j| smooth[j] = false);
        }
        None
    }

    /// With C1 knots at the smooth inner breaks, and weights that fit at the seam: first the seam is given up, then the breaks at which a
    /// factor would not be positive. `None` if there are none left.
    fn raised_where_it_goes(&self, intervals: &[f64], smooth: &mut [bool], seam: &mut bool) -> Option<Self> {
        while smooth.contains(&true) {
            match self.raised(intervals, smooth, *seam) {
                Ok(raised) => return raised,
                Err(_) if *seam => *seam = false,
                // One break less at least in each round: the ends of the spans that fail are smooth ones.
                Err(breaks) => breaks.into_iter().for_each(|j| smooth[j - 1] = false),
            }
        }
        None
    }

    /// With C1 knots at the smooth inner breaks, and weights that fit at the seam.
    ///
    /// # Errors
    /// The inner breaks at which a factor would not be positive.
    fn raised(&self, intervals: &[f64], smooth: &[bool], seam: bool) -> Result<Option<Self>, Vec<usize>> {
        let (count, breaks) = (self.span_count(), self.breaks());
        let slopes = self.common_slopes(intervals, smooth, seam);
        let mut spans = Vec::with_capacity(count);
        let mut failing = Vec::new();
        for j in 0..count {
            match with_slopes(&self.span_bezier(j), [slopes[j], slopes[j + 1]].map(|s| s.map(|s| s * intervals[j]))) {
                Ok(raised) => spans.push(raised),
                Err(ends) => failing.extend((0..2).filter(|end| ends[*end]).map(|end| j + end)),
            }
        }
        if spans.len() < count {
            failing.retain(|j| (1..count).contains(j) && smooth[j - 1]);
            return Err(failing);
        }
        let degree = self.degree() + 3;
        // The joint rows of smooth knots are combinations of their neighbors: left out.
        let kept = count * degree + 1 - smooth.iter().filter(|smooth| **smooth).count();
        let (mut points, mut weights) = (Vec::with_capacity(kept), Vec::with_capacity(kept));
        let mut knots = Vec::with_capacity(kept + degree + 1);
        let (mut scale, mut last) = (1.0, None);
        for (j, raised) in spans.iter().enumerate() {
            let first = raised.rows()[0];
            if let Some(last) = last {
                scale = last / first[3];
            }
            knots.extend(std::iter::repeat_n(
                breaks[j],
                if j == 0 { degree + 1 } else { degree - usize::from(smooth[j - 1]) },
            ));
            let own = raised.rows().iter().map(|r| r.map(|v| v * scale)).enumerate();
            for (i, r) in own.skip(usize::from(j > 0)) {
                last = Some(r[3]);
                if !(i == degree && smooth.get(j) == Some(&true)) {
                    points.push(Point3::new(r[0] / r[3], r[1] / r[3], r[2] / r[3]));
                    weights.push(r[3]);
                }
            }
        }
        knots.extend(std::iter::repeat_n(breaks[count], degree + 1));
        Ok(Self::new(degree, knots, points, weights).ok())
    }

    /// True if the points of a span are those of its other form, looked at the closer the nearer to its ends, where
    /// weights of very different size meet.
    fn keeps_points(&self, raised: &Self, span: usize) -> bool {
        let halvings = std::iter::successors(Some(0.5), |s: &f64| Some(0.5 * s)).take(SAMPLED_HALVINGS);
        let places = || halvings.clone().flat_map(|s| [s, 1.0 - s]);
        let size = places().map(|s| self.span_point(span, s).to_vec().max_abs()).fold(0.0, f64::max);
        places().all(|s| self.span_point(span, s).distance(raised.span_point(span, s)) <= LOST_POINT * size)
    }

    /// True if the affine derivative is continuous at the inner break `j`, up to the rounding of the control points.
    fn is_c1_at(&self, j: usize, intervals: &[f64]) -> bool {
        self.is_c1_between([j - 1, j], intervals)
    }

    /// True if the curve is closed and its derivative continuous there.
    fn is_c1_at_seam(&self, intervals: &[f64]) -> bool {
        let points = self.control_points();
        points[0] == points[points.len() - 1] && self.is_c1_between([intervals.len() - 1, 0], intervals)
    }

    /// True if the affine derivative at the end of one span is that at the start of another.
    fn is_c1_between(&self, [i, j]: [usize; 2], intervals: &[f64]) -> bool {
        let (before, after) = (self.span_jet(i, 1.0), self.span_jet(j, 0.0));
        let (before_d1, after_d1): (Vec3, Vec3) = (before.d1 / intervals[i], after.d1 / intervals[j]);
        let unit = POINT_ROUNDINGS * f64::EPSILON * after.point.to_vec().max_abs() * self.degree() as f64;
        let (left, right) = (self.span_rows(i), self.span_rows(j));
        let n = self.degree();
        let rounding = unit * (left[n - 1][3] / left[n][3] / intervals[i] + right[1][3] / right[0][3] / intervals[j]);
        (after_d1 - before_d1).length() <= C1_LIMIT * after_d1.length().max(before_d1.length()) + rounding
    }

    /// For every break the logarithmic slope by the knot parameter that both sides are given, chosen so that the factors
    /// stay positive: 0 or the nearest to it between the slopes of the two sides where the weights have a crest there,
    /// and what changes both sides alike where they have a dent. `None` at ends that are no seam and at kinks: nothing to join there.
    fn common_slopes(&self, intervals: &[f64], smooth: &[bool], seam: bool) -> Vec<Option<f64>> {
        let count = self.span_count();
        let mut slopes = vec![None; count + 1];
        for j in (1..count).filter(|j| smooth[j - 1]) {
            slopes[j] = Some(self.common_slope([j - 1, j], intervals));
        }
        if seam {
            slopes[0] = Some(self.common_slope([count - 1, 0], intervals));
            slopes[count] = slopes[0];
        }
        slopes
    }

    /// The slope that the end of one span and the start of another are given.
    fn common_slope(&self, [i, j]: [usize; 2], intervals: &[f64]) -> f64 {
        let (h0, h1) = (intervals[i], intervals[j]);
        let (before, after) = (end_slopes(self.span_rows(i))[1] / h0, end_slopes(self.span_rows(j))[0] / h1);
        if after <= before { 0.0_f64.clamp(after, before) } else { (after * h1 + before * h0) / (h0 + h1) }
    }
}

/// Weights so uneven that a form of higher degree may lose points by rounding.
fn is_uneven(rows: &[[f64; 4]]) -> bool {
    let weights = || rows.iter().map(|row| row[3]);
    weights().fold(f64::INFINITY, f64::min) < UNEVEN * weights().fold(0.0, f64::max)
}

/// Logarithmic slopes `W'/W` of the weight function at both ends, by the curve's own parameter.
fn end_slopes(rows: &[[f64; 4]]) -> [f64; 2] {
    let n = rows.len() - 1;
    let (w0, w1) = (rows[0][3], rows[n][3]);
    [(rows[1][3] - w0) / w0 * n as f64, (w1 - rows[n - 1][3]) / w1 * n as f64]
}

/// The piece multiplied by the cubic that gives its weight function these logarithmic slopes at its ends.
///
/// # Errors
/// The ends, of those with a slope, at which that cubic is not positive.
fn with_slopes(bezier: &RationalBezier, slopes: [Option<f64>; 2]) -> Result<RationalBezier, [bool; 2]> {
    let have = end_slopes(bezier.rows());
    let change = |end: usize| slopes[end].map_or(0.0, |slope| slope - have[end]);
    let factor = [1.0, 1.0 + change(0) / 3.0, 1.0 - change(1) / 3.0, 1.0];
    let raised = bezier.multiplied(&factor);
    if factor.iter().all(|g| *g > 0.0) && raised.has_positive_weights() {
        return Ok(raised);
    }
    let ends = [!(factor[1] > 0.0), !(factor[2] > 0.0)];
    Err(if ends == [false; 2] { slopes.map(|slope| slope.is_some()) } else { ends })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_circles_become_c1_and_keep_every_point() {
        let q = std::f64::consts::FRAC_1_SQRT_2;
        let xy = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, 0.0)];
        let points = xy.iter().map(|&(x, y)| Point3::new(x, y, 0.0)).collect();
        let c = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0], points, vec![1.0, q, 1.0, q, 1.0])
            .unwrap();
        let s = c.with_c1_knots().unwrap();
        assert_eq!(s.degree(), 5);
        assert_eq!(s.knot_multiplicities()[1], (0.5, 4));
        for i in 0..=40 {
            let u = f64::from(i) / 40.0;
            assert!(c.point_at_knot(u).distance(s.point_at_knot(u)) < 1e-15, "{u}");
        }
    }

    #[test]
    fn breaks_at_which_the_factor_fails_stay_and_the_others_are_smooth() {
        // Four spans along a line at one speed; the weights of the second one rise by a logarithmic slope of 3 (w - 1) at both ends.
        let path = |w: f64| {
            let (mut points, mut weights) = (vec![Point3::ORIGIN], vec![1.0]);
            for k in 0..4 {
                let (x, w) = (f64::from(k), if k == 1 { w } else { 1.0 });
                let reach = 1.0 / (3.0 * w);
                points.extend([x + reach, x + 1.0 - reach, x + 1.0].map(|x| Point3::new(x, 0.0, 0.0)));
                weights.extend([w, w, 1.0]);
            }
            let knots = (0..5).flat_map(|k| std::iter::repeat_n(f64::from(k), if k % 4 == 0 { 4 } else { 3 }));
            NurbsCurve::new(3, knots.collect(), points, weights).unwrap()
        };
        let multiplicities = |w: f64| {
            let made = path(w).with_c1_knots().unwrap();
            for k in 0..=80 {
                // Coordinates below 4.
                assert!((made.point_at_knot(f64::from(k) / 20.0).x - f64::from(k) / 20.0).abs() < 1e-14);
            }
            made.knot_multiplicities()[1..4].iter().map(|(_, count)| made.degree() - count).collect::<Vec<_>>()
        };
        assert_eq!(multiplicities(2.0), [1, 1, 1]);
        // A slope of 12: half of it is more than a cubic takes away with positive coefficients.
        assert_eq!(multiplicities(5.0), [0, 0, 1]);
    }
}
