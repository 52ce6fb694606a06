//! Fair circle splines: smooth curves through points whose curvature is continuous and varies as little as that of an
//! Euler spiral (`docs/math/fair-splines.md`: circle blends with the angle law of order 1, and tangents that are free).
//!
//! Between two nodes the curve is a [`BlendSegment`] of degree 4 (fair law with `e = 1`). Its curvature at an end depends
//! on both of its tangents, and the tangents at all nodes are found together so that the curvature vectors agree there:
//!
//! ```text
//! K1(segment before) = K0(segment after),   K0 = (2/d) (P1 u + (2e/S) P1 t2),   S = ±|t1 + t2|
//! ```
//! These are the critical points of an energy (`docs/math/fair-splines.md#energy`), found in three to five Newton steps
//! with a tridiagonal matrix, so the whole is linear in the number of points. Circles, lines, planes and spheres are
//! reproduced; the spline commutes with similarities and reversal; a node moves the whole curve, but by a factor of
//! about 0.27 less from node to node. Smaller blends `e` lead continuously to the circle spline of order 2 (`e = 0`):
//! they are the tension, they keep legs beside a corner straight, and they are what is tried where the fairest curve
//! does not exist or swings out.
//!
//! One subject per file: ends, straight runs, cuts and relaxation; equations in the plane and in space; Newton's method;
//! the linear systems.

mod ends;
mod newton;
mod node_tangents;
mod options;
mod pieces;
mod planar;
mod plane;
mod relaxation;
mod run;
mod scalar;
mod space;
mod straight;
mod tridiagonal;

pub(crate) use node_tangents::{TangentLimits, fair_tangents};
pub use options::{FairEnd, FairSplineOptions};

use crate::base::vector::Point3;
use crate::curve::{BlendLaw, BlendSegment, BlendTangents, Chord, CircleSpline, SHARP_TURN};
use crate::curve::{chords_between, corner_nodes, inspect_node, rounded_directions, unit_tangent};
use crate::error::Result;
use crate::warning::{CurveWarning, Warning};
use pieces::Pieces;
use straight::with_tight_corners;

impl CircleSpline {
    /// The fair circle spline through points, in their order.
    ///
    /// Neighbors must differ; a closed curve does not repeat its first point. Two points open give a straight segment,
    /// three points their circle. Linear in the number of points.
    ///
    /// Where the fairest curve does not exist or swings out, smaller blends are taken and a warning says so; points where
    /// the curve turns back on itself become cusps, as do turns above 175 degrees if the curve swings out there.
    ///
    /// ```
    /// use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, joints}};
    /// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [6.0, 5.0, 2.0], [2.0, 6.0, 0.5]].map(Point3::from);
    /// let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
    /// assert!(joints(&spline).iter().all(|joint| joint.curvature_jump < 1e-13));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `too-few-points` (2 open, 3 closed), `not-finite`, `coincident-points` (neighbors closer than 1e-12 of the
    /// bounding box's diagonal), `parameter-out-of-range` (tension, tight, or a corner that is not a point), and for
    /// clamped ends `zero-tangent`, `arc-through-infinity`, `ambiguous-half-turn`.
    pub fn fair(points: &[Point3], options: &FairSplineOptions) -> Result<Self> {
        options.check()?;
        let closed = options.closed;
        let chords = chords_between(points, closed)?;
        let corners = corner_nodes(&options.corners, points.len(), closed)?;
        let ends = if closed { [FairEnd::Circle; 2] } else { unit_ends(options.ends)? };
        let mut warnings = Vec::from_iter(rounded_directions(points, &chords));
        if closed && options.ends != [FairEnd::default(); 2] {
            warnings.push(Warning::Curve(CurveWarning::EndsWithoutEffect));
        }
        let cuts = cuts(&chords, closed, corners, &mut warnings);
        let tight = options.tight.and_then(|rho| with_tight_corners(points, &chords, closed, &cuts, rho));
        let Some((more, source)) = tight else {
            return assembled(points, &chords, options, &cuts, ends, &|i| i, warnings);
        };
        let chords = chords_between(&more, closed)?;
        // Of the points that count as a given one the first is itself.
        let mut place = vec![0; points.len()];
        source.iter().enumerate().rev().for_each(|(i, given)| place[*given] = i);
        let cuts: Vec<usize> = cuts.iter().map(|cut| place[*cut]).collect();
        assembled(&more, &chords, options, &cuts, ends, &|i| source[i], warnings)
    }
}

/// The blends that segments take for the turns at their nodes where the fairest curve does not exist or swings out
/// (`docs/math/fair-splines.md#relaxation`, without what data in space need beside): `1 - tension` up to turns of 120
/// degrees, 0 from 161.8 degrees on.
///
/// ```
/// use cyclide::Point3;
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]].map(Point3::from);
/// let blends = cyclide::construct::blends_by_turn(&points, true, 0.0)?;
/// assert!(blends.len() == 4 && blends.iter().all(|blend| (0.0..=1.0).contains(blend)));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `too-few-points`, `not-finite`, `coincident-points`, `parameter-out-of-range` (tension).
pub fn blends_by_turn(points: &[Point3], closed: bool, tension: f64) -> Result<Vec<f64>> {
    FairSplineOptions { tension, ..Default::default() }.check()?;
    let mut blends = relaxation::turn_factors(&chords_between(points, closed)?, closed);
    blends.iter_mut().for_each(|e| *e *= 1.0 - tension);
    Ok(blends)
}

/// The clamped tangents, normalized.
fn unit_ends(ends: [FairEnd; 2]) -> Result<[FairEnd; 2]> {
    let unit = |end: FairEnd, index| match end {
        FairEnd::Clamped(t) => unit_tangent(t, index).map(FairEnd::Clamped),
        other => Ok(other),
    };
    Ok([unit(ends[0], 0)?, unit(ends[1], 1)?])
}

/// Corners and cusps, rising; what is unusual at the other nodes is noted.
fn cuts(chords: &[Chord], closed: bool, corners: Vec<usize>, warnings: &mut Vec<Warning>) -> Vec<usize> {
    let m = chords.len();
    let mut cuts = corners;
    let marked = cuts.len();
    for node in usize::from(!closed)..m {
        if cuts[..marked].binary_search(&node).is_ok() {
            continue;
        }
        let before = &chords[if node == 0 { m - 1 } else { node - 1 }];
        inspect_node(node, before, &chords[node], warnings);
        if before.unit.dot(chords[node].unit) < 0.0 && before.tangent_to(&chords[node]).is_none() {
            cuts.push(node);
        }
    }
    cuts.sort_unstable();
    cuts
}

/// Solves the pieces and makes the segments; `source` gives the number of the given point at or before a node.
fn assembled(
    points: &[Point3],
    chords: &[Chord],
    options: &FairSplineOptions,
    cuts: &[usize],
    ends: [FairEnd; 2],
    source: &dyn Fn(usize) -> usize,
    mut warnings: Vec<Warning>,
) -> Result<CircleSpline> {
    let pieces = Pieces::solve(points, chords, options, cuts, ends);
    note_cuts(&pieces, source, &mut warnings);
    let largest = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let (n, m) = (points.len(), chords.len());
    let mut segments = Vec::with_capacity(m);
    for (i, chord) in chords.iter().enumerate() {
        let [start, te] = pieces.tangents[i];
        let beside = chords[i.saturating_sub(1)].length.min(chords[(i + 1).min(m - 1)].length);
        let tangents =
            BlendTangents { start, end: te.reflect(chord.unit), magnification: largest / chord.length.min(beside) };
        let law = BlendLaw::Fair { blend: pieces.blends[i] };
        let next = if i + 1 == n { 0 } else { i + 1 };
        let segment = BlendSegment::from_tangents([points[i], points[next]], chord, &tangents, law, source(i))?;
        if segment.opposite_circles() {
            warnings.push(Warning::Curve(CurveWarning::OppositeCircles { segment: source(i) }));
        } else if segment.long_way() {
            warnings.push(Warning::Curve(CurveWarning::LongWay { segment: source(i) }));
        }
        segments.push(segment);
    }
    let mut kinks = [cuts, &pieces.cut].concat();
    kinks.sort_unstable();
    Ok(CircleSpline::from_segments(segments, options.closed, kinks, warnings))
}

/// Notes the nodes cut and the segments relaxed.
fn note_cuts(pieces: &Pieces, source: &dyn Fn(usize) -> usize, warnings: &mut Vec<Warning>) {
    for warning in warnings.iter_mut() {
        if let Warning::Curve(CurveWarning::SharpTurn { node, angle, .. }) = *warning
            && pieces.cut.iter().any(|cut| source(*cut) == node)
        {
            *warning = Warning::Curve(CurveWarning::SharpTurnCut { node, angle, limit: SHARP_TURN });
        }
    }
    if !pieces.relaxed.is_empty() {
        let mut segments: Vec<(usize, f64)> = pieces.relaxed.iter().map(|i| (source(*i), pieces.blends[*i])).collect();
        segments.dedup_by_key(|(segment, _)| *segment);
        warnings.push(Warning::Curve(CurveWarning::Relaxed { segments }));
    }
}
