//! Weights of rational B-splines: how uneven they may be, and the same curve with more even ones.
//!
//! A common factor of all weights changes nothing, and multiplying those of a Bézier curve by `1, c, c², …` changes its
//! parameter only (`docs/math/rational-curves.md#weights`). The larger `c`, the shorter is the part of the parameter in
//! which most of the curve is run through; where it is below the distance of neighboring doubles, there is no curve.

use super::nurbs_curve::NurbsCurve;
use crate::base::vector::Point3;
use crate::error::{NurbsError, Result};

/// Largest factor by which weights grow from an end of a span with each step. Within its reciprocal of the parameter the curve
/// leaves the end: places are rounded by 1e-16 times as much, 1e-7 of the curve, and its length is still known to 1e-9.
const MOST_GROWTH: f64 = 1e9;
/// Largest ratio of any two weights: their products with coordinates stay in the range of doubles.
const MOST_RATIO_OF_ALL: f64 = 1e150;
/// Weights of a span that grow by more than this factor from one to the next on average are evened.
const EVEN_RATIO: f64 = 30.0;

/// Refuses curves that leave an end of a span in so short a part of its parameter that it has no digits. Small weights
/// between larger ones do no harm.
pub(super) fn check_even(curve: &NurbsCurve) -> Result<()> {
    let degree = curve.degree();
    for (span, &start) in curve.breaks().iter().take(curve.span_count()).enumerate() {
        let rows = curve.span_rows(span);
        // The control points that act on the span.
        let first = curve.knots().partition_point(|knot| *knot <= start) - 1 - degree;
        for steps in 1..=degree {
            let limit = MOST_GROWTH.powi(steps as i32);
            let of_ends = [[0, steps], [degree, degree - steps]].map(|[end, i]| (end, i, rows[i][3] / rows[end][3]));
            if let Some((end, i, ratio)) = of_ends.into_iter().find(|(_, _, ratio)| *ratio > limit) {
                let [first, second] = [end.min(i), end.max(i)].map(|k| first + k);
                return Err(NurbsError::WeightsUneven { first, second, ratio, limit }.into());
            }
        }
    }
    Ok(())
}

/// Refuses positive weights of which two differ so much that their products leave the range of doubles.
pub(super) fn check_range(weights: &[f64]) -> Result<()> {
    let place = |is_better: fn(f64, f64) -> bool| {
        (1..weights.len()).fold(0, |best, i| if is_better(weights[i], weights[best]) { i } else { best })
    };
    let (least, most) = (place(|a, b| a < b), place(|a, b| a > b));
    let ratio = weights[most] / weights[least];
    if ratio <= MOST_RATIO_OF_ALL {
        return Ok(());
    }
    let (first, second) = (least.min(most), least.max(most));
    Err(NurbsError::WeightsUneven { first, second, ratio, limit: MOST_RATIO_OF_ALL }.into())
}

/// Homogeneous rows `[wx, wy, wz, w]` with the weights times a power of two, so that the largest is about 1: the quotients
/// are the same to the bit, and nothing overflows.
pub(super) fn scaled_rows(points: &[Point3], weights: &[f64]) -> Vec<[f64; 4]> {
    let largest = weights.iter().copied().fold(0.0, f64::max);
    let row = |p: &Point3, w: f64| [p.x * w, p.y * w, p.z * w, w];
    // Weights as people give them need no scaling.
    if (1e-100..=1e100).contains(&largest) {
        return points.iter().zip(weights).map(|(p, w)| row(p, *w)).collect();
    }
    // In two steps: the factor itself may be out of range.
    let factor = (-0.5 * largest.log2().floor()).floor().exp2();
    points.iter().zip(weights).map(|(p, w)| row(p, *w * factor * factor)).collect()
}

impl NurbsCurve {
    /// Curve as [`clamped`](Self::clamped), over another parameter where weights are very uneven: if those of a span grow by
    /// more than a factor of 30 from one to the next on average, they are divided by `1, c, c², …` so that both ends have
    /// the same weight. The points are the same; knots of several spans are as many then as the degree.
    ///
    /// ```
    /// use cyclide::{Point3, curve::ParamCurve, rational::NurbsCurve};
    /// let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from).to_vec();
    /// // A parabola; at the parameter 0.5 of these weights nearly nothing of it has been run through.
    /// let curve = NurbsCurve::with_even_weights(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1e18, 1.0, 1e-18])?;
    /// assert!(curve.point(0.5).distance(Point3::new(1.0, 0.5, 0.0)) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`clamped`](Self::clamped); `weights-uneven` where that does not even them.
    pub fn with_even_weights(degree: usize, knots: Vec<f64>, points: Vec<Point3>, weights: Vec<f64>) -> Result<Self> {
        let curve = Self::clamped_with_any_weights(degree, knots, points, weights)?.evened()?;
        check_even(&curve)?;
        Ok(curve)
    }

    /// The curve with spans whose ends have the same weight, where the weights of one are very uneven.
    fn evened(self) -> Result<Self> {
        let (degree, spans) = (self.degree(), self.span_count());
        let growth = |span: usize| {
            let rows = self.span_rows(span);
            (rows[degree][3] / rows[0][3]).powf(1.0 / degree as f64)
        };
        if (0..spans).all(|span| (EVEN_RATIO.recip()..=EVEN_RATIO).contains(&growth(span))) {
            return Ok(self);
        }
        let (mut points, mut weights) = (vec![self.control_points()[0]], vec![1.0]);
        for span in 0..spans {
            let rows = self.span_rows(span);
            let (start, growth) = (rows[0][3], growth(span));
            for (i, row) in rows.iter().enumerate().skip(1) {
                points.push(Point3::new(row[0] / row[3], row[1] / row[3], row[2] / row[3]));
                weights.push(if i == degree { 1.0 } else { row[3] / start / growth.powi(i as i32) });
            }
        }
        let breaks = self.breaks();
        let end = points.len() - 1;
        points[end] = self.control_points()[self.control_points().len() - 1];
        if spans == 1 {
            points.copy_from_slice(self.control_points());
        }
        let knots = breaks
            .iter()
            .enumerate()
            .flat_map(|(i, &knot)| std::iter::repeat_n(knot, degree + usize::from(i == 0 || i == spans)));
        Self::with_any_weights(degree, knots.collect(), points, weights)
    }
}
