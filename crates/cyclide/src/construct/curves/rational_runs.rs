//! Circle splines as rational B-splines: exact for the rational laws, certified for the trigonometric one.
//!
//! One spline per smooth run. Its knots lie a chord length apart, in which parameter the curve is C1
//! (`docs/math/circle-blends.md#angle-laws`); [`NurbsCurve::with_c1_knots`] writes that into the knots.

use crate::curve::{Arc, BlendSegment, CircleSpline, Correspondence, CurvePlace, Span};
use crate::error::Result;
use crate::rational::{NurbsCurve, RationalBezier};
use std::ops::Range;

/// A smooth run of a circle spline in its rational form.
///
/// ```
/// use cyclide::{Point3, construct::RationalRun, curve::{CircleSpline, CircleSplineOptions}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let (runs, bound) = CircleSpline::from_points(&points, &CircleSplineOptions::default())?.to_rational_runs(1e-6)?;
/// assert!(bound == 0.0 && runs.iter().any(|run| matches!(run, RationalRun::Spline(_))));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum RationalRun {
    /// Every segment of the run is one arc or straight segment: these.
    Arcs(Vec<Arc>),
    /// A rational B-spline over the chord lengths.
    Spline(NurbsCurve),
}

impl CircleSpline {
    /// The curve in rational form, one part per [smooth run](Self::smooth_runs), and a bound on its distance from the
    /// curve: 0 (exact) for the rational laws, which give degree `2k + 2` and of fair splines 4, or 6 where a blend of
    /// the run is below 1; at most `tolerance` for the trigonometric law, which gives degree `4k`. Runs that are arcs throughout are exact in both. Ends of runs are
    /// those of the curve, to the bit; all weights are positive.
    ///
    /// # Errors
    /// `too-many-pieces` if a segment of the trigonometric variant would need more than 4096, `arc-through-infinity` for
    /// a segment whose tangents come within 5e-7 of the reversed chord: its points have lost their digits.
    pub fn to_rational_runs(&self, tolerance: f64) -> Result<(Vec<RationalRun>, f64)> {
        self.rational_runs(tolerance).map(|(runs, bound, _)| (runs, bound))
    }

    /// As [`to_rational_runs`](Self::to_rational_runs), with the segments that the pieces stand for.
    pub(crate) fn rational_runs(&self, tolerance: f64) -> Result<(Vec<RationalRun>, f64, Correspondence)> {
        let mut worst: f64 = 0.0;
        let mut runs = Vec::new();
        let all = self.smooth_runs();
        let start = CurvePlace::new(all.first().map_or(0, |range| range.start), 0.0);
        let mut parts = Correspondence { start, spans: Vec::with_capacity(self.segments().len()) };
        for range in all {
            let (run, bound) = rational_run(self, range, tolerance, &mut parts.spans)?;
            worst = worst.max(bound);
            runs.push(run);
        }
        Ok((runs, worst, parts))
    }
}

/// One run; adds how many pieces each of its segments has become.
fn rational_run(
    spline: &CircleSpline,
    range: Range<usize>,
    tolerance: f64,
    spans: &mut Vec<Span>,
) -> Result<(RationalRun, f64)> {
    let n = spline.segments().len();
    let segments = || range.clone().map(|i| (i, &spline.segments()[i % n]));
    let arcs: Option<Vec<Arc>> = segments().map(|(_, s)| BlendSegment::to_arc(s)).collect();
    if let Some(arcs) = arcs {
        spans.extend(range.map(|i| Span { pieces: 1, end: CurvePlace::after(i) }));
        return Ok((RationalRun::Arcs(arcs), 0.0));
    }
    let (mut beziers, mut intervals, mut worst) = (Vec::new(), Vec::new(), 0.0_f64);
    for (i, segment) in segments() {
        let (pieces, bound) = segment.rational_pieces(tolerance, i % n)?;
        worst = worst.max(bound);
        spans.push(Span { pieces: pieces.len(), end: CurvePlace::after(i) });
        for piece in pieces {
            beziers.push(piece.bezier);
            intervals.push(piece.interval);
        }
    }
    raise_to_one_degree(&mut beziers);
    NurbsCurve::from_beziers(&beziers, &intervals).map(|spline| (RationalRun::Spline(spline), worst))
}

/// Fair segments have degree 4 or 6 by their blend; a run has one degree.
fn raise_to_one_degree(beziers: &mut [RationalBezier]) {
    let degree = beziers.iter().map(RationalBezier::degree).max().unwrap_or(0);
    for bezier in beziers.iter_mut().filter(|b| b.degree() < degree) {
        *bezier = bezier.multiplied(&vec![1.0; degree - bezier.degree() + 1]);
    }
}
