//! Nearly straight arcs become true lines (`docs/math/arc-fitting.md#tube-beam`, collinear runs).
//!
//! The search offers lines wherever a curvature interval holds 0, but the arcs that close a chain come out of an
//! equation and are straight only up to rounding or tolerance. Such an arc is replaced by a line near its chord, and its
//! two neighbors by the arcs from their far joints that are tangent to that line: from a point `p` with unit tangent
//! `t`, the arc that ends on the line through `q` along `d` with tangent `d` has its chord along `t + d`. The count stays,
//! the tangents at the far joints stay, and the change is taken only if the certificate of the three pieces holds.

use super::certificate::deviation_of;
use super::options::FitTarget;
use super::piece::{Piece, Place, Span, joined};
use super::trace::Trace;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;

/// Arcs are tried whose sagitta, or whose data's distance from their chord, is at most this part of the tolerance, and
/// those that are farther from their data than the chord of the data is: a search within the tolerance bows a straight
/// run as far as it may.
const STRAIGHTNESS: f64 = 0.2;
/// The sweeps of the neighbors change by less than this, radians.
const MAX_SWEEP_CHANGE: f64 = 0.5;
/// The neighbors get at most this many times tighter: a turn squeezed into a short arc is a hidden corner.
const MAX_TIGHTENING: f64 = 2.0;
/// Places of the line between chord (0) and apex (1) of the arc.
const OFFSETS: [f64; 3] = [0.5, 0.0, 1.0];

/// Replaces what can be replaced; `normal` is the normal of the plane of all pieces.
pub(super) fn straighten(pieces: &mut [Piece], trace: &Trace, normal: Vec3, tolerance: f64, target: FitTarget) {
    straighten_between(pieces, [None; 2], trace, normal, tolerance, target);
}

/// The same of a part of a path, whose first and last piece may end on an axis of symmetry: then it is half of an arc, and the line
/// runs in the direction across the axis that is given.
pub(super) fn straighten_between(
    pieces: &mut [Piece],
    axes: [Option<Vec3>; 2],
    trace: &Trace,
    normal: Vec3,
    tolerance: f64,
    target: FitTarget,
) {
    let n = pieces.len();
    for i in 0..n {
        let arc = &pieces[i].arc;
        let axis = Axis::of(i, n, axes);
        // The whole arc bends four times as far from its chord.
        let whole = if axis.is_some() { 4.0 } else { 1.0 };
        let sagitta = whole * 0.5 * arc.chord().length() * arc.bulge_vector().length();
        // Neighbors that share a smooth joint; a fixed end or corner has none.
        let before = pieces[i].smooth.then_some((i + n - 1) % n);
        let after = Some((i + 1) % n).filter(|j| pieces[*j].smooth);
        // A whole side between corners is straight where its chord is within the tolerance.
        let is_side = before.is_none() && after.is_none();
        let limit = if is_side { tolerance } else { STRAIGHTNESS * tolerance };
        if arc.is_straight() || (sagitta > limit && !is_line(&pieces[i], trace, target, limit)) {
            continue;
        }
        let curved = |j: Option<usize>| j.is_none_or(|j| !pieces[j].arc.is_straight());
        if !(curved(before) && curved(after)) || (n < 3 && before.is_some() && after.is_some()) {
            continue;
        }
        let apex = match axis {
            Some(axis) => axis.reach(arc),
            None => arc.midpoint() - arc.start().midpoint(arc.end()),
        };
        for offset in OFFSETS {
            let shift = apex * offset;
            let triple = Triple {
                before: before.map(|j| pieces[j]),
                middle: pieces[i],
                after: after.map(|j| pieces[j]),
                axis,
                wraps: trace.points.len(),
            };
            let Some(new) = triple.with_line(shift, normal, trace) else { continue };
            if !triple.resembles(&new) {
                continue;
            }
            let fits = |p: &Piece| deviation_of(p, trace, target).is_some_and(|d| d <= tolerance);
            if new.before.iter().chain([&new.middle]).chain(&new.after).all(fits) {
                pieces[i] = new.middle;
                before.into_iter().zip(new.before).for_each(|(j, piece)| pieces[j] = piece);
                after.into_iter().zip(new.after).for_each(|(j, piece)| pieces[j] = piece);
                break;
            }
        }
    }
}

/// An axis of symmetry at one end of a piece.
#[derive(Clone, Copy)]
struct Axis {
    /// It is at the start.
    at_start: bool,
    /// Unit vector across it, along the path.
    direction: Vec3,
}

impl Axis {
    /// Of the first or the last of so many pieces.
    fn of(i: usize, count: usize, axes: [Option<Vec3>; 2]) -> Option<Self> {
        let at = |at_start: bool, direction: Option<Vec3>| direction.map(|direction| Self { at_start, direction });
        let first = if i == 0 { at(true, axes[0]) } else { None };
        first.or(if i + 1 == count { at(false, axes[1]) } else { None })
    }

    /// From its end on the axis, along it, to as far as the other end is.
    fn reach(&self, arc: &Arc) -> Vec3 {
        across(if self.at_start { arc.chord() } else { -arc.chord() }, self.direction)
    }
}

/// Pieces between two corners whose data are within the tolerance of their chord are sides: these alone become lines.
pub(super) fn sides_only(pieces: &mut [Piece], trace: &Trace, tolerance: f64) {
    let n = pieces.len();
    for i in 0..n {
        let is_side = !pieces[i].smooth && !pieces[(i + 1) % n].smooth;
        if is_side
            && data_height(pieces[i].span, trace) <= tolerance
            && let Ok(line) = Arc::segment(pieces[i].arc.start(), pieces[i].arc.end())
        {
            pieces[i].arc = line;
        }
    }
}

/// Do the data say line: within a little, or no farther from one than from the arc?
fn is_line(piece: &Piece, trace: &Trace, target: FitTarget, limit: f64) -> bool {
    let height = data_height(piece.span, trace);
    height <= limit || deviation_of(piece, trace, target).is_some_and(|deviation| height <= deviation)
}

/// Largest distance of the trace under a span from the span's chord.
fn data_height(span: Span, trace: &Trace) -> f64 {
    let from = span.from.point(trace);
    let Some(along) = (span.to.point(trace) - from).unit() else { return f64::INFINITY };
    span.inside().map(|i| (trace.point(i) - from).cross(along).length()).fold(0.0, f64::max)
}

/// A piece with its smooth neighbors.
struct Triple {
    before: Option<Piece>,
    middle: Piece,
    after: Option<Piece>,
    axis: Option<Axis>,
    /// Points of the trace: what indices wrap by.
    wraps: usize,
}

impl Triple {
    /// The neighbors nearly keep their sweeps and radii: the other circle tangent to the line is a rogue, and
    /// what the line takes from a neighbor must not leave a corner.
    fn resembles(&self, new: &Self) -> bool {
        let near = |a: &Option<Piece>, b: &Option<Piece>| {
            a.iter().zip(b).all(|(a, b)| {
                let tighter = b.arc.curvature() > MAX_TIGHTENING * a.arc.curvature();
                (a.arc.angle() - b.arc.angle()).abs() < MAX_SWEEP_CHANGE && !tighter
            })
        };
        near(&self.before, &new.before) && near(&self.after, &new.after)
    }

    /// The middle piece as a line along its chord, moved by `shift` where its ends are free.
    fn with_line(&self, shift: Vec3, normal: Vec3, trace: &Trace) -> Option<Self> {
        let arc = &self.middle.arc;
        let direction = self.axis.map_or_else(|| arc.chord().unit(), |axis| Some(axis.direction))?;
        let on = match self.axis {
            // Through the end that is kept, else as far along the axis as is asked.
            Some(Axis { at_start: true, .. }) if self.after.is_none() => arc.end(),
            Some(Axis { at_start: false, .. }) if self.before.is_none() => arc.start(),
            Some(Axis { at_start: false, .. }) => arc.end() + shift,
            None if self.before.is_none() || self.after.is_none() => arc.start(),
            _ => arc.start() + shift,
        };
        let mut new = Self { before: self.before, middle: self.middle, after: self.after, ..*self };
        let (mut start, mut end) = (arc.start(), arc.end());
        // On the axis.
        let foot = |p: Point3| p + across(on - p, direction);
        match self.axis {
            Some(Axis { at_start: true, .. }) => start = foot(start),
            Some(_) => end = foot(end),
            None => {}
        }
        if let Some(piece) = &mut new.before {
            let (p, t) = (piece.arc.start(), piece.arc.start_tangent()?);
            start = tangent_point(p, t, on, direction, normal)?;
            piece.arc = Arc::from_start_tangent(p, start, t * p.distance(start)).ok()?;
            let range = joined(piece.span, self.middle.span, self.wraps);
            let place = Place::nearest(trace, start, range);
            piece.span = Span { from: range.from, to: place };
            new.middle.span = Span { from: place, to: range.to };
        }
        if let Some(piece) = &mut new.after {
            let (p, t) = (piece.arc.end(), piece.arc.end_tangent()?);
            end = tangent_point(p, -t, on, -direction, normal)?;
            piece.arc = Arc::from_end_tangent(end, p, t * p.distance(end)).ok()?;
            let range = joined(new.middle.span, piece.span, self.wraps);
            let place = Place::nearest(trace, end, range);
            new.middle.span.to = place;
            piece.span = Span { from: place, to: range.to };
        }
        let forward = (end - start).dot(direction) > 0.0;
        let ordered = |p: &Piece| p.span.from.along() <= p.span.to.along();
        let in_order = new.before.iter().chain([&new.middle]).chain(&new.after).all(ordered);
        new.middle.arc = Arc::segment(start, end).ok()?;
        (forward && in_order).then_some(new)
    }
}

/// What of a vector is across a direction.
fn across(v: Vec3, direction: Vec3) -> Vec3 {
    v - direction * v.dot(direction)
}

/// The end of the arc from `p` with unit tangent `t` that arrives on the line through `q` with its direction `d`.
fn tangent_point(p: Point3, t: Vec3, q: Point3, d: Vec3, normal: Vec3) -> Option<Point3> {
    // The chord is along t + d, which is perpendicular to d - t: well conditioned up to half a turn and beyond.
    let u = if t.dot(d) >= 0.0 { t + d } else { normal.cross(d - t) }.unit()?;
    let length = (q - p).cross(d).dot(normal) / u.cross(d).dot(normal);
    length.is_finite().then(|| p + u * length)
}
