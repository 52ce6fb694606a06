//! The spline of invariant spans.

use super::invariant_span::check_finite;
use super::nodes::{NodeVelocity, Nodes};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::interpolation::{NodeParameters, node_steps};
use crate::curve::{BlendLaw, BlendSegment, BlendTangents, Chord, QbCurve, QbSpline, inspect_node, rounded_directions};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};
use crate::warning::{CurveWarning, Warning};

/// How [`QbSpline::through_points`] makes its curve.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{MoebiusSplineOptions, NodeParameters}, curve::QbSpline};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0]].map(Point3::from);
/// let tangents = vec![Some(Vec3::X * 2.0), None, None];
/// let options = MoebiusSplineOptions { knots: NodeParameters::Given(vec![0.0, 1.0, 2.0]), tangents, ..Default::default() };
/// let spline = QbSpline::through_points(&points, &options)?;
/// assert!((spline.jet_at_knot(0.0).d1 - Vec3::X * 2.0).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MoebiusSplineOptions {
    /// Closed curve through all points; the first point is not repeated at the end.
    pub closed: bool,
    /// The knots at which the curve passes its points. Those by distances are as far apart as these say, from 0; given ones increase, and
    /// of a closed curve there is one more than points. The shape hardly depends on them.
    pub knots: NodeParameters,
    /// Indices of points that stay corners: both sides end there with the circle of their last three points. The ends of an open curve may
    /// be listed without effect.
    pub corners: Vec<usize>,
    /// Derivatives by the knots that are given, one entry for each point, `None` for those of the circles; or no entry at all.
    pub tangents: Vec<Option<Vec3>>,
}

impl QbSpline {
    /// The Möbius spline through points, in their order: C1 by its [knots](Self::knots), local (a span depends on four points), of quadratic
    /// spans, which are rational quartics. At corners, and where the polygon turns right back, it is only connected. Linear in the number of points.
    ///
    /// The image under a Möbius map is the Möbius spline through the images of the points, with the same knots, as long as neither leads
    /// a span the long way round.
    ///
    /// # Errors
    /// `count-differs` (knots, tangents), `too-few-points` (2 open, 3 closed), `not-finite`, `parameters-not-increasing` (knots that do not
    /// increase), `coincident-points` (neighbors closer than 1e-12 of the bounding box's diagonal), `parameter-out-of-range` (a corner that is
    /// no point), `zero-tangent`, `arc-through-infinity`, `ambiguous-half-turn`, `curve-through-infinity`.
    pub fn through_points(points: &[Point3], options: &MoebiusSplineOptions) -> Result<Self> {
        let (n, closed) = (points.len(), options.closed);
        let knots = knots_of(points, options)?;
        let nodes = Nodes::new(points, &knots, closed, &options.corners)?;
        if !(options.tangents.is_empty() || options.tangents.len() == n) {
            return Err(NumberError::CountDiffers {
                what: ErrorItem::Tangent,
                given: options.tangents.len(),
                needed: n,
            }
            .into());
        }
        let mut warnings = Vec::from_iter(rounded_directions(points, &nodes.chords));
        // Not collected: results do not say how many they are, and vectors that grow are half of the work.
        let mut velocities = Vec::with_capacity(n);
        for i in 0..n {
            velocities.push(velocity(&nodes, options, i, &mut warnings)?);
        }
        let kinks = (0..n).filter(|i| velocities[*i].is_cusp).collect();
        let mut spans = Vec::with_capacity(nodes.chords.len());
        for i in 0..nodes.chords.len() {
            let ends = [velocities[i].leaving, velocities[if i + 1 < n { i + 1 } else { 0 }].arriving];
            spans.push(span_between(&nodes, i, ends, &mut warnings)?);
        }
        Ok(Self::from_parts(spans, knots, closed, kinks, warnings))
    }
}

/// The knots, from 0 but for given ones.
fn knots_of(points: &[Point3], options: &MoebiusSplineOptions) -> Result<Vec<f64>> {
    if let NodeParameters::Given(given) = &options.knots {
        return Ok(given.clone());
    }
    let needed = if options.closed { 3 } else { 2 };
    if points.len() < needed {
        return Err(PointError::TooFewPoints { given: points.len(), needed }.into());
    }
    if let Some(index) = points.iter().position(|p| !p.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into());
    }
    let mut sum = 0.0;
    let steps = node_steps(&options.knots, points, options.closed)?;
    Ok(std::iter::once(0.0)
        .chain(steps.into_iter().map(|h| {
            sum += h;
            sum
        }))
        .collect())
}

/// The velocity at a node: given, or of its circle.
fn velocity(
    nodes: &Nodes,
    options: &MoebiusSplineOptions,
    i: usize,
    warnings: &mut Vec<Warning>,
) -> Result<NodeVelocity> {
    if let Some(given) = options.tangents.get(i).copied().flatten() {
        return match given {
            v if !v.is_finite() => Err(NumberError::NotFinite { what: ErrorItem::Tangent, index: i }.into()),
            v if v.unit().is_none() => Err(PointError::ZeroTangent { index: i }.into()),
            v => Ok(NodeVelocity::smooth(v)),
        };
    }
    let n = nodes.points.len();
    if !nodes.is_cut(i) {
        inspect_node(i, &nodes.chords[(i + n - 1) % n], &nodes.chords[i], warnings);
    }
    Ok(nodes.velocity(i))
}

/// The span behind a node, by the blend of order 1 with the same tangents.
fn span_between(nodes: &Nodes, i: usize, [v0, v1]: [Vec3; 2], warnings: &mut Vec<Warning>) -> Result<QbCurve> {
    let n = nodes.points.len();
    let (chord, next): (&Chord, usize) = (&nodes.chords[i], (i + 1) % n);
    let unit = |v: Vec3, index: usize| v.unit().ok_or(Error::Point(PointError::ZeroTangent { index }));
    let (start, end) = (unit(v0, i)?, unit(v1, next)?.reflect(chord.unit));
    let magnification = magnification(nodes, i);
    let tangents = BlendTangents { start, end, magnification };
    let ends = [nodes.points[i], nodes.points[next]];
    let segment = BlendSegment::from_tangents(ends, chord, &tangents, BlendLaw::Rational { order: 1 }, i)?;
    if segment.opposite_circles() {
        warnings.push(Warning::Curve(CurveWarning::OppositeCircles { segment: i }));
    } else if segment.long_way() {
        warnings.push(Warning::Curve(CurveWarning::LongWay { segment: i }));
    }
    segment.check_finite(i)?;
    let speeds = [v0, v1].map(|v| v.length() * (nodes.steps[i] / chord.length));
    let data = segment.span_data(speeds);
    data.check().map_err(|e| e.in_span(i))?;
    let span = QbCurve::from_span(&data);
    check_finite(&span, chord, [v0, v1]).map_err(|e| e.in_span(i))?;
    Ok(span)
}

/// Largest coordinate over shortest chord of the points behind the tangents of a span.
fn magnification(nodes: &Nodes, i: usize) -> f64 {
    // The place `k - 1` behind `i`, in the circle, or on an open curve the nearest one that there is.
    let near = |k: usize, count: usize| match (i + k).checked_sub(1) {
        Some(place) if place < count => place,
        Some(place) if nodes.closed => place - count,
        Some(_) => count - 1,
        None if nodes.closed => count - 1,
        None => 0,
    };
    let size = |k: usize| nodes.points[near(k, nodes.points.len())].to_vec().max_abs();
    let length = |k: usize| nodes.chords[near(k, nodes.chords.len())].length;
    let largest = size(0).max(size(1)).max(size(2)).max(size(3));
    largest / length(0).min(length(1)).min(length(2))
}
