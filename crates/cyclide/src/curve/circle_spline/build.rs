//! Making circle splines from points: node tangents, ends, corners, cusps, warnings.

use super::{CircleSpline, CircleSplineOptions, SplineEnds};
use crate::base::vector::{Point3, Vec3};
use crate::curve::blend::{
    BlendLaw, BlendSegment, BlendTangents, BlendVariant, check_order, check_points, unit_tangent,
};
use crate::curve::node_tangent::Chord;
use crate::error::{ErrorItem, NumberError, PointError, Result};
use crate::warning::{CurveWarning, PointWarning, Warning};

/// Turns above this make very large circles (`docs/math/circle-blends.md#node-tangent`).
pub(crate) const SHARP_TURN: f64 = 175.0 * std::f64::consts::PI / 180.0;
/// Neighboring chords that differ by more make the curve bulge (`docs/math/circle-blends.md#splines`).
const UNEVEN_SPACING: f64 = 3.0;

/// Directions of chords that are known worse than this, radians, are noted.
const ROUNDED_DIRECTION: f64 = 1e-3;

/// What the curve does at a node.
#[derive(Clone, Copy)]
enum Node {
    /// Passes with this unit tangent.
    Through(Vec3),
    /// Turns back: each side leaves along its own chord.
    Cusp,
    /// Ends here (or is cut): takes the circle of the segment's other end.
    Free,
}

impl CircleSpline {
    /// The circle spline through points, in their order.
    ///
    /// Neighbors must differ; a closed curve does not repeat its first point. Three points closed give their
    /// circle, two points open a straight segment. Linear in the number of points.
    ///
    /// # Errors
    /// `too-few-points` (2 open, 3 closed), `order-out-of-range` (1 to 4), `not-finite`, `coincident-points`
    /// (neighbors closer than 1e-12 of the bounding box's diagonal), `parameter-out-of-range` (a corner that is not
    /// a point), and for clamped ends `zero-tangent`, `arc-through-infinity`, `ambiguous-half-turn`.
    pub fn from_points(points: &[Point3], options: &CircleSplineOptions) -> Result<Self> {
        let (n, closed) = (points.len(), options.closed);
        check_order(options.order)?;
        let chords = chords_between(points, closed)?;
        let corners = corner_nodes(&options.corners, n, closed)?;
        let [start_tangent, end_tangent] = end_tangents(options)?;

        let mut warnings = Vec::from_iter(rounded_directions(points, &chords));
        if closed && options.ends != SplineEnds::default() {
            warnings.push(Warning::Curve(CurveWarning::EndsWithoutEffect));
        }
        let node = |i: usize, warnings: &mut Vec<Warning>| {
            if !closed && i == 0 {
                return start_tangent.map_or(Node::Free, Node::Through);
            }
            if !closed && i == n - 1 {
                return end_tangent.map_or(Node::Free, Node::Through);
            }
            if corners.binary_search(&i).is_ok() {
                return Node::Free;
            }
            let (before, after) = (&chords[(i + n - 1) % n], &chords[i]);
            inspect_node(i, before, after, warnings);
            before.tangent_to(after).map_or(Node::Cusp, Node::Through)
        };

        let law = BlendLaw::of(options.variant, options.order);
        let mut segments = Vec::with_capacity(chords.len());
        let mut kinks = Vec::new();
        let first = node(0, &mut warnings);
        let mut from = first;
        for (i, chord) in chords.iter().enumerate() {
            let next = (i + 1) % n;
            let to = if closed && next == 0 { first } else { node(next, &mut warnings) };
            if (closed || i > 0) && !matches!(from, Node::Through(_)) {
                kinks.push(i);
            }
            let tangents = BlendTangents {
                magnification: magnification(points, &chords, i, [from, to], closed),
                ..tangents(chord, from, to)
            };
            let ends = [points[i], points[next]];
            let segment = BlendSegment::from_tangents(ends, chord, &tangents, law, i)?;
            if segment.opposite_circles() {
                warnings.push(Warning::Curve(CurveWarning::OppositeCircles { segment: i }));
            } else if segment.long_way() {
                warnings.push(Warning::Curve(CurveWarning::LongWay { segment: i }));
            }
            segments.push(segment);
            from = to;
        }
        Ok(Self { segments, closed, kinks, warnings })
    }
}

impl BlendSegment {
    /// The segment between the two middle ones of four points, as in the interior of a circle spline.
    ///
    /// # Errors
    /// As [`CircleSpline::from_points`].
    pub fn from_points(points: [Point3; 4], order: u32, variant: BlendVariant) -> Result<Self> {
        let options = CircleSplineOptions { order, variant, ..CircleSplineOptions::default() };
        CircleSpline::from_points(&points, &options).map(|spline| spline.segments[1])
    }
}

/// The points where the polygon turns by more than `limit` (radians): candidates for the corners of a circle spline.
/// The ends of an open polygon and points next to an equal one are not among them.
///
/// ```
/// use cyclide::Point3;
/// let points = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0]].map(Point3::from);
/// assert_eq!(cyclide::curve::corners_by_angle(&points, false, 1.0), [1]);
/// ```
#[must_use]
pub fn corners_by_angle(points: &[Point3], closed: bool, limit: f64) -> Vec<usize> {
    let n = points.len();
    let inner = if closed { 0..n } else { 1..n.saturating_sub(1) };
    let turns = |&i: &usize| {
        let (before, after) =
            (Chord::new(points[(i + n - 1) % n], points[i]), Chord::new(points[i], points[(i + 1) % n]));
        before.length > 0.0 && after.length > 0.0 && before.turn(&after) > limit
    };
    inner.filter(turns).collect()
}

/// The chords from each point to the next, of points that make a curve.
///
/// # Errors
/// `too-few-points` (2 open, 3 closed), `not-finite`, `coincident-points`.
pub(crate) fn chords_between(points: &[Point3], closed: bool) -> Result<Vec<Chord>> {
    let needed = if closed { 3 } else { 2 };
    if points.len() < needed {
        return Err(PointError::TooFewPoints { given: points.len(), needed }.into());
    }
    let limit = check_points(points)?;
    let n = points.len();
    let count = if closed { n } else { n - 1 };
    let mut chords = Vec::with_capacity(count);
    for first in 0..count {
        let second = (first + 1) % n;
        let chord = Chord::new(points[first], points[second]);
        if chord.length <= limit {
            return Err(PointError::CoincidentPoints { first, second, distance: chord.length, limit }.into());
        }
        chords.push(chord);
    }
    Ok(chords)
}

/// The corners, rising and without repetition; the ends of an open curve are none.
///
/// # Errors
/// `parameter-out-of-range`.
pub(crate) fn corner_nodes(given: &[usize], n: usize, closed: bool) -> Result<Vec<usize>> {
    if let Some(&corner) = given.iter().find(|c| **c >= n) {
        return Err(NumberError::ParameterOutOfRange {
            name: ErrorItem::Corner,
            value: corner as f64,
            min: 0.0,
            max: (n - 1) as f64,
        }
        .into());
    }
    let mut corners: Vec<usize> = given.iter().copied().filter(|&c| closed || (c > 0 && c + 1 < n)).collect();
    corners.sort_unstable();
    corners.dedup();
    Ok(corners)
}

/// The clamped end tangents, normalized.
fn end_tangents(options: &CircleSplineOptions) -> Result<[Option<Vec3>; 2]> {
    match options.ends {
        SplineEnds::Clamped { start, end } if !options.closed => {
            let unit = |tangent: Option<Vec3>, index| tangent.map(|v| unit_tangent(v, index)).transpose();
            Ok([unit(start, 0)?, unit(end, 1)?])
        }
        _ => Ok([None, None]),
    }
}

/// The start tangents at the segment's first point that its two ends ask for (`docs/math/circle-blends.md#splines`).
fn tangents(chord: &Chord, from: Node, to: Node) -> BlendTangents {
    let start = match from {
        Node::Through(tangent) => Some(tangent),
        Node::Cusp => Some(chord.unit),
        Node::Free => None,
    };
    let end = match to {
        // Reflected to the first point. (inv(d) - inv(x3-x1) would cancel when x3 is near x2.)
        Node::Through(tangent) => Some(tangent.reflect(chord.unit)),
        Node::Cusp => Some(chord.unit),
        Node::Free => None,
    };
    BlendTangents {
        start: start.or(end).unwrap_or(chord.unit),
        end: end.or(start).unwrap_or(chord.unit),
        magnification: 0.0,
    }
}

/// Largest coordinate over shortest chord of the points that define the tangents of segment `i`: the factor by which
/// the rounding of the coordinates reaches the tangents.
fn magnification(points: &[Point3], chords: &[Chord], i: usize, ends: [Node; 2], closed: bool) -> f64 {
    let n = points.len();
    let size = |j: usize| points[j % n].to_vec().max_abs();
    let (mut largest, mut shortest) = (size(i).max(size(i + 1)), chords[i].length);
    let inner = |node: usize| closed || (node > 0 && node + 1 < n);
    if matches!(ends[0], Node::Through(_)) && inner(i) {
        largest = largest.max(size(i + n - 1));
        shortest = shortest.min(chords[(i + n - 1) % n].length);
    }
    if matches!(ends[1], Node::Through(_)) && inner(i + 1) {
        largest = largest.max(size(i + 2));
        shortest = shortest.min(chords[(i + 1) % n].length);
    }
    largest / shortest
}

/// Notes chords so short against their coordinates that the rounding of these turns them.
pub(crate) fn rounded_directions(points: &[Point3], chords: &[Chord]) -> Option<Warning> {
    let size = |i: usize| points[i % points.len()].to_vec().max_abs();
    // Each end is off by half a rounding.
    let turn = |(i, chord): (usize, &Chord)| (i, f64::EPSILON * size(i).max(size(i + 1)) / chord.length);
    let turned = || chords.iter().enumerate().map(turn).filter(|(_, angle)| *angle > ROUNDED_DIRECTION);
    let (segment, _) = turned().next()?;
    let angle = turned().map(|(_, angle)| angle).fold(0.0, f64::max).min(std::f64::consts::PI);
    Some(Warning::Point(PointWarning::RoundedDirections {
        segment,
        count: turned().count(),
        angle,
        limit: ROUNDED_DIRECTION,
    }))
}

/// Notes what is unusual at a node between two chords.
pub(crate) fn inspect_node(node: usize, before: &Chord, after: &Chord, warnings: &mut Vec<Warning>) {
    // Cosine first: the angle itself is needed for the few sharp turns only.
    if before.unit.dot(after.unit) < -0.9 {
        let angle = before.turn(after);
        if before.tangent_to(after).is_none() {
            warnings.push(Warning::Curve(CurveWarning::Cusp { node }));
        } else if angle > SHARP_TURN {
            warnings.push(Warning::Curve(CurveWarning::SharpTurn { node, angle, limit: SHARP_TURN }));
        }
    }
    let ratio = before.length.max(after.length) / before.length.min(after.length);
    if ratio > UNEVEN_SPACING {
        warnings.push(Warning::Point(PointWarning::UnevenSpacing { node, ratio, limit: UNEVEN_SPACING }));
    }
}
