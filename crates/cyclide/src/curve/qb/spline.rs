//! Chains of QB curves over knots.

use super::QbCurve;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::curve::circle_spline::CircleSpline;
use crate::curve::correspondence::{Correspondence, CurvePlace, Span};
use crate::curve::param_curve::ParamCurve;
use crate::curve::piece_form::PieceForm;
use crate::curve::piece_hull::PieceHull;
use crate::curve::smooth_runs::smooth_runs;
use crate::error::{PointError, Result};
use crate::rational::{NurbsCurve, RationalBezier};
use crate::warning::Warning;
use std::ops::Range;

/// QB curves end to end, each over an interval between two knots.
///
/// As a [`ParamCurve`] its pieces are the spans, each over an equal part of `[0, 1]`. What is smooth by the parameter of the
/// [`knots`](Self::knots) is [`jet_at_knot`](Self::jet_at_knot). Möbius maps, inversions included, take it to a chain of the same kind
/// with the same knots ([`Conformal`](crate::conformal::Conformal)).
///
/// ```
/// use cyclide::{Point3, construct::MoebiusSplineOptions, curve::{ParamCurve, QbSpline}};
/// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from);
/// let spline = QbSpline::through_points(&points, &MoebiusSplineOptions { closed: true, ..Default::default() })?;
/// assert_eq!((spline.point(0.25), spline.spans().len()), (points[1], 4));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QbSpline {
    /// Never empty; finite; each starts where the one before ends, to the bit.
    pub(super) spans: Vec<QbCurve>,
    /// One more than spans, increasing.
    pub(super) knots: Vec<f64>,
    pub(super) closed: bool,
    /// Indices of the spans at whose start the tangent jumps, rising. 0 only if closed.
    pub(super) kinks: Vec<usize>,
    pub(super) warnings: Vec<Warning>,
}

impl QbSpline {
    /// Of parts that fit: spans that are finite and meet to the bit, at least one; one more knot, increasing.
    pub(crate) fn from_parts(
        spans: Vec<QbCurve>,
        knots: Vec<f64>,
        closed: bool,
        kinks: Vec<usize>,
        warnings: Vec<Warning>,
    ) -> Self {
        Self { spans, knots, closed, kinks, warnings }
    }

    /// One curve as a chain of one span over `[0, 1]`, open even where its ends meet.
    ///
    /// # Errors
    /// `coincident-points` (a curve of degree 0 is one point), `curve-through-infinity`.
    pub fn from_curve(curve: QbCurve) -> Result<Self> {
        if curve.degree() == 0 {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: 0.0, limit: 0.0 }.into());
        }
        curve.check_finite()?;
        Ok(Self::from_parts(vec![curve], vec![0.0, 1.0], false, Vec::new(), Vec::new()))
    }

    /// A circle spline of order 1 in its rational variant, which is a chain of quadratic QB curves, over the lengths of its chords;
    /// `None` of any other.
    ///
    /// ```
    /// use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions, ParamCurve, QbSpline}};
    /// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from);
    /// let spline = CircleSpline::from_points(&points, &CircleSplineOptions { order: 1, ..Default::default() })?;
    /// let same = QbSpline::from_circle_spline(&spline).expect("it is of order 1");
    /// assert!(same.point(0.4).distance(spline.point(0.4)) < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn from_circle_spline(spline: &CircleSpline) -> Option<Self> {
        let spans: Vec<QbCurve> =
            spline.segments().iter().map(|s| QbCurve::from_blend(s, [1.0; 2])).collect::<Option<_>>()?;
        let knots = knots_over(spline.segments().iter().map(|segment| {
            let [from, to] = segment.range();
            segment.chord_length() * (to - from)
        }));
        let (kinks, warnings) = (spline.kinks().to_vec(), spline.warnings().to_vec());
        Some(Self::from_parts(spans, knots, spline.is_closed(), kinks, warnings))
    }

    /// The spans in order.
    #[must_use]
    pub fn spans(&self) -> &[QbCurve] {
        &self.spans
    }

    /// The parameters at which spans meet, one more than spans, increasing.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The largest degree of a span. Its rational form has twice that degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.spans.iter().map(QbCurve::degree).max().unwrap_or(0)
    }

    /// The joints where the curve is only connected: indices of the spans that start there.
    #[must_use]
    pub fn kinks(&self) -> &[usize] {
        &self.kinks
    }

    /// What the user should know.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The smooth runs between kinks as ranges of spans, in order; in a closed chain with kinks the last one passes the seam, indices
    /// modulo the number of spans.
    #[must_use]
    pub fn smooth_runs(&self) -> Vec<Range<usize>> {
        smooth_runs(self.spans.len(), self.closed, &self.kinks)
    }

    /// The span and its own parameter at a knot-domain parameter (clamped); at a knot the span that starts there.
    #[must_use]
    pub fn locate_knot(&self, u: f64) -> (usize, f64) {
        let last = self.spans.len() - 1;
        let u = u.clamp(self.knots[0], self.knots[last + 1]);
        let span = self.knots.partition_point(|k| *k <= u).saturating_sub(1).min(last);
        let (a, b) = (self.knots[span], self.knots[span + 1]);
        (span, (u - a) / (b - a))
    }

    /// Point and derivatives at a knot-domain parameter (clamped), derivatives by it.
    #[must_use]
    pub fn jet_at_knot(&self, u: f64) -> CurveJet {
        let (span, s) = self.locate_knot(u);
        self.spans[span].jet(s).scaled(1.0 / (self.knots[span + 1] - self.knots[span]))
    }

    /// The exact rational B-splines, one per [smooth run](Self::smooth_runs), of twice the degree and with positive weights; each over its
    /// knots brought to `[0, 1]`. A span whose weights would be uneven or not positive is halved.
    ///
    /// In space each is as smooth as the chain, in its homogeneous form only connected at joints, where its knots have the
    /// multiplicity of the degree: [`NurbsCurve::with_c1_knots`] writes the smoothness into the knots.
    ///
    /// # Errors
    /// `curve-through-infinity`, `weight-not-positive` (numbers that have lost their digits).
    pub fn to_nurbs_runs(&self) -> Result<Vec<NurbsCurve>> {
        self.smooth_runs().into_iter().map(|run| self.nurbs_of_run(run, &mut Vec::new())).collect()
    }

    /// One run as a B-spline; adds how many pieces each of its spans has become.
    pub(crate) fn nurbs_of_run(&self, run: Range<usize>, spans: &mut Vec<Span>) -> Result<NurbsCurve> {
        let n = self.spans.len();
        let end = self.spans[(run.end + n - 1) % n].point(1.0);
        let degree = run.clone().map(|i| self.spans[i % n].degree()).max().unwrap_or(0).max(1);
        let (mut curves, mut intervals, mut joints) = (Vec::<RationalBezier>::new(), Vec::new(), Vec::new());
        for i in run {
            let mut span = self.spans[i % n].clone();
            while span.degree() < degree {
                span = span.elevated();
            }
            let parts = span.positive_parts().map_err(|e| e.in_span(i % n))?;
            let length = self.knots[i % n + 1] - self.knots[i % n];
            spans.push(Span { pieces: parts.len(), end: CurvePlace::after(i) });
            for part in parts {
                joints.push(self.spans[i % n].point(part.from));
                intervals.push(length * (part.to - part.from));
                curves.push(part.curve);
            }
        }
        let curve = NurbsCurve::from_beziers(&curves, &intervals)?;
        // A point times its weight and divided by it again is rounded: joints are put in as they are.
        let mut points = curve.control_points().to_vec();
        for (i, joint) in joints.iter().enumerate() {
            points[i * 2 * degree] = *joint;
        }
        if let Some(last) = points.last_mut() {
            *last = end;
        }
        NurbsCurve::new(2 * degree, curve.knots().to_vec(), points, curve.weights().to_vec())
    }

    /// The whole chain as B-splines with the spans that their pieces stand for.
    pub(crate) fn correspondence_start(&self) -> Correspondence {
        let first = self.smooth_runs().first().map_or(0, |run| run.start);
        Correspondence { start: CurvePlace::new(first, 0.0), spans: Vec::with_capacity(self.spans.len()) }
    }
}

/// Increasing knots from 0 over these lengths. One that is lost in the sum of those before it gets the least step there is.
pub(super) fn knots_over(lengths: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut knots = vec![0.0_f64];
    for length in lengths {
        let last = knots[knots.len() - 1];
        knots.push((last + length).max(last.next_up()));
    }
    knots
}

impl ParamCurve for QbSpline {
    fn piece_count(&self) -> usize {
        self.spans.len()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.spans[piece].jet(s)
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull> {
        self.spans[piece].piece_hull(0, tolerance)
    }
    fn is_closed(&self) -> bool {
        self.closed
    }
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        self.spans[piece].point(s)
    }
    fn piece_form(&self, piece: usize) -> PieceForm {
        self.spans[piece].piece_form(0)
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        self.spans[piece].piece_bounds(0)
    }
}
