//! QB curves as motions: the denominators turn the body, the quotients move it.
//!
//! A span with the pairs `(n, d)` is the motion with the rotation `d(t)/|d(t)|` and the translation `n(t) d(t)⁻¹`: its dual quaternion
//! is `d + ε n/2`, on the quadric exactly because the curve is in three-space (`docs/math/motions.md#qb-curves-as-motions`; source: `003`,
//! section 2, whose action moves the origin on −2 times the curve).

use super::pose::Pose;
use super::rational_motion::{MotionSpan, RationalMotion};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::hpoint::HPoint;
use crate::curve::{ParamCurve, QbCurve, QbSpline};
use crate::error::Result;

impl RationalMotion {
    /// The motion that a chain of QB curves carries: the origin of the body runs on the curve, at the times of its
    /// [knots](QbSpline::knots), turned by its denominators. Those of each span are multiplied by a constant from the right, so that the
    /// body has the rotation `start` at the start (any length but zero; `Quat::ONE`: not turned) and does not jump at joints; its angular velocity may. Of degree `n` of the spans: points run
    /// on curves of degree `2n`. Along an arc a direction of the body that is tangent stays so, and those across turn no more than they must; on other curves the
    /// body turns in its own way.
    ///
    /// # Errors
    /// `not-finite`, `zero-rotation`, `motion-through-exceptional-point` (the curve runs out to infinity, as near as rounding tells).
    ///
    /// ```
    /// use cyclide::{Point3, Quat, construct::MoebiusSplineOptions, curve::{ParamCurve, QbSpline}, motion::RationalMotion};
    /// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from);
    /// let spline = QbSpline::through_points(&points, &MoebiusSplineOptions::default())?;
    /// let motion = RationalMotion::along(&spline, Quat::ONE)?;
    /// let time = spline.knots()[1];
    /// assert!((motion.pose(time).translation() - points[1].to_vec()).length() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    pub fn along(spline: &QbSpline, start: Quat) -> Result<Self> {
        let start = Pose::new(start, Vec3::ZERO)?.rotation();
        let (origin, times) = (spline.point(0.0), spline.knots().to_vec());
        let mut spans: Vec<Vec<HPoint>> = Vec::with_capacity(spline.spans().len());
        for span in spline.spans() {
            let before = spans.last().and_then(|pairs| pairs.last()).map_or(start, |pair| pair.d);
            spans.push(gauged(span, origin, before));
        }
        // In the size of the curve, which weights do not change.
        let reached = (0..=4 * spans.len()).map(|k| spline.point(k as f64 / (4 * spans.len()) as f64).distance(origin));
        let unit = Some(reached.fold(0.0, f64::max)).filter(|unit| unit.is_normal()).unwrap_or(1.0);
        let rows = |pairs: &Vec<HPoint>| MotionSpan(pairs.iter().map(|pair| row(pair, unit)).collect());
        let spans: Vec<MotionSpan> = spans.iter().map(rows).collect();
        for (span, domain) in spans.iter().zip(times.windows(2)) {
            span.check_share([domain[0], domain[1]])?;
        }
        Ok(Self::of_spans(times, spans, origin.to_vec(), unit))
    }
}

/// The pairs of a span, multiplied from the right so that its first denominator is this one.
fn gauged(span: &QbCurve, origin: Point3, first: Quat) -> Vec<HPoint> {
    let pairs = span.pairs_about(origin);
    // A denominator of zero is a point at infinity, which the chain does not have.
    let gauge = pairs[0].d.inverse().map_or(Quat::ONE, |inverse| inverse * first);
    pairs.iter().map(|pair| HPoint { n: pair.n * gauge, d: pair.d * gauge }).collect()
}

fn row(pair: &HPoint, unit: f64) -> [f64; 8] {
    let (p, r) = (pair.d.to_array(), (pair.n * (0.5 / unit)).to_array());
    [p[0], p[1], p[2], p[3], r[0], r[1], r[2], r[3]]
}
