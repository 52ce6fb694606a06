//! What all interpolations end with: the curve back in place, looked at for poles, far runs and needles.

use super::frame::DataFrame;
use super::turning_back::{SHARP, TurnBack, turn_back};
use crate::base::bernstein;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::curve::QbCurve;
use crate::error::Result;
use crate::warning::{CurveWarning, Warning};

/// Nodes of whose weight less is left than this are not attained.
pub(super) const ATTAINED: f64 = 1e-10;

/// Nodes farther from the curve than this, in sizes of the data, are missed.
pub(super) const MISSED: f64 = 1e-9;

/// Nodes with less weight are reached in needles.
const SPIKE: f64 = 1e-3;

/// Curves that run farther, in sizes of the data, are remarked upon.
const FAR: f64 = 3.0;

/// First denominators above this part of the largest are made 1.
const GAUGE: f64 = 1e-3;

/// Largest degree made: control points of higher ones have lost their digits.
pub(super) const MOST_DEGREE: usize = 12;

/// A QB curve through points, with what is known of it.
///
/// ```
/// use cyclide::{Point3, construct::{NodeParameters, QbInterpolation}, curve::ParamCurve};
/// let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [5.0, 1.0, 1.0], [6.0, 0.0, 3.0]].map(Point3::from);
/// let found = QbInterpolation::through_points(&points, &NodeParameters::default())?;
/// assert_eq!(found.curve().degree(), 2); // a rational curve of degree 4
/// assert!(found.curve().point(found.parameters()[3]).distance(points[3]) < 1e-13);
/// assert!(found.warnings().is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QbInterpolation {
    curve: QbCurve,
    parameters: Vec<f64>,
    attainability: Vec<f64>,
    reach: f64,
    warnings: Vec<Warning>,
}

impl QbInterpolation {
    /// The curve. Its degree is as low as the points allow: 1 for points on a circle at parameters that fit.
    #[must_use]
    pub fn curve(&self) -> &QbCurve {
        &self.curve
    }

    /// The parameters of the points.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// For each point what is left of the curve's weight there, from 0 to 1 of what it could be: about the width, in parameters, of the
    /// needle in which the curve reaches the point where the others would have it pass elsewhere.
    #[must_use]
    pub fn attainability(&self) -> &[f64] {
        &self.attainability
    }

    /// Largest distance of the curve from the middle of the points, relative to that of the points.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// What the user should know: needles at points, runs far away, places between points where the curve turns right back.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The curve that data in their frame have: looked at for poles and far runs.
    ///
    /// # Errors
    /// `curve-through-infinity`.
    pub(super) fn finish(
        curve: QbCurve,
        frame: DataFrame,
        parameters: Vec<f64>,
        attainability: Vec<f64>,
    ) -> Result<Self> {
        curve.check_reach(frame.center, frame.radius)?;
        let mut warnings = Vec::new();
        let mut needle = |(point, width): (usize, &f64)| {
            if *width < SPIKE {
                warnings.push(Warning::Curve(CurveWarning::SpikeNearPoint { point, width: *width, limit: SPIKE }));
            }
        };
        attainability.iter().enumerate().for_each(&mut needle);
        let (distance, t) = curve.reach(frame.center).farthest.unwrap_or((0.0, 0.0));
        let reach = if frame.radius > 0.0 { distance / frame.radius } else { 0.0 };
        if reach > FAR && !curve.excursions(frame.center, FAR * frame.radius).is_empty() {
            warnings.push(Warning::Curve(CurveWarning::LargeExcursion { reach, t, limit: FAR }));
        }
        // A needle turns back at its point, and a far run has been named.
        if warnings.is_empty()
            && let Some(TurnBack { t, within, spacing, count }) = turn_back(&curve, &parameters)
        {
            warnings.push(Warning::Curve(CurveWarning::TurnsBack { t, count, within: within / spacing, limit: SHARP }));
        }
        Ok(Self { curve, parameters, attainability, reach, warnings })
    }
}

/// The curve of pairs in the frame of the data; its ends are the points known there.
pub(super) fn placed(
    pairs: impl IntoIterator<Item = (Quat, Quat)>,
    frame: DataFrame,
    ends: [Option<Point3>; 2],
) -> QbCurve {
    let pairs: Vec<(Quat, Quat)> = pairs.into_iter().collect();
    // The first denominator is 1 where it is worth anything: real weights are then those that people know.
    let largest = pairs.iter().map(|(_, d)| d.norm()).fold(0.0, f64::max);
    let first = pairs.first().map(|(_, d)| *d).filter(|d| d.norm() > GAUGE * largest);
    let gauge = first.and_then(Quat::inverse).unwrap_or(Quat::ONE);
    let sized = pairs.into_iter().map(|(n, d)| (n * gauge * frame.radius, d * gauge));
    QbCurve::from_local(frame.center, sized).with_ends(ends[0], ends[1])
}

/// All data one point: degree 0.
pub(super) fn one_point(point: Point3) -> QbCurve {
    QbCurve::from_local(point, [(Quat::ZERO, Quat::ONE)]).with_ends(Some(point), Some(point))
}

/// The Bernstein coefficients of `product of (t - root)`.
pub(super) fn with_roots(roots: impl IntoIterator<Item = f64>) -> Vec<f64> {
    roots.into_iter().fold(vec![1.0], |product, t| bernstein::product(&product, &[-t, 1.0 - t]))
}

/// The points at the parameters 0 and 1, where there are some.
pub(super) fn end_points(parameters: &[f64], points: &[Point3]) -> [Option<Point3>; 2] {
    [0.0, 1.0].map(|end| parameters.iter().position(|t| t.total_cmp(&end).is_eq()).map(|i| points[i]))
}
