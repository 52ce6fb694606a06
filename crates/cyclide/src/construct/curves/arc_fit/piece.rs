//! The pieces of a fitted path, each with the part of the polyline it stands for.

use super::trace::Trace;
use crate::base::vector::Point3;
use crate::curve::Arc;
use std::ops::Range;

/// Two arcs that one arc replaces with its end tangent within this angle are one (rounding of their own tangents).
const MERGE_ANGLE: f64 = 1e-12;

/// A place on the trace: the point with this index, or a fraction of the edge after it. The index may have wrapped
/// around a closed trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub index: usize,
    pub fraction: f64,
}

impl Place {
    pub fn over(index: usize) -> Self {
        Self { index, fraction: 0.0 }
    }

    pub fn point(self, trace: &Trace) -> Point3 {
        let a = trace.point(self.index);
        if self.fraction > 0.0 { a.lerp(trace.point(self.index + 1), self.fraction) } else { a }
    }

    /// Position along the trace, to compare places.
    pub fn along(self) -> f64 {
        self.index as f64 + self.fraction
    }

    /// The place nearest to `p` on the edges from one place to another.
    pub fn nearest(trace: &Trace, p: Point3, range: Span) -> Self {
        let on_edge = |index: usize| {
            let (a, b) = (trace.point(index), trace.point(index + 1));
            let edge = b - a;
            let fraction = ((p - a).dot(edge) / edge.dot(edge)).clamp(0.0, 1.0);
            (Self { index, fraction }, a.lerp(b, fraction).distance(p))
        };
        let nearest = range.edges().map(on_edge).min_by(|a, b| a.1.total_cmp(&b.1)).map_or(range.from, |n| n.0);
        // The end of one edge is the start of the next.
        if nearest.fraction >= 1.0 { Self::over(nearest.index + 1) } else { nearest }
    }
}

/// The part of the trace a piece stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub from: Place,
    pub to: Place,
}

impl Span {
    /// Edges of the trace, by the index of their start.
    fn edges(&self) -> Range<usize> {
        self.from.index..self.to.index + usize::from(self.to.fraction > 0.0)
    }

    /// Indices of the trace strictly between the ends.
    pub fn inside(&self) -> Range<usize> {
        self.from.index + 1..self.to.index + usize::from(self.to.fraction > 0.0)
    }
}

/// An arc or line of the path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub arc: Arc,
    pub span: Span,
    /// The joint at its start is meant to be tangent-continuous.
    pub smooth: bool,
}

/// Neighboring pieces on one circle or line become one.
pub(super) fn merged(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        if piece.smooth
            && let Some(last) = out.last_mut()
            && let Some(arc) = one_arc(&last.arc, &piece.arc)
        {
            *last = Piece { arc, span: Span { from: last.span.from, to: piece.span.to }, smooth: last.smooth };
        } else {
            out.push(piece);
        }
    }
    out
}

fn one_arc(a: &Arc, b: &Arc) -> Option<Arc> {
    if a.is_straight() && b.is_straight() {
        let aligned = a.end_tangent()?.angle(b.start_tangent()?) <= MERGE_ANGLE;
        return if aligned { Arc::segment(a.start(), b.end()).ok() } else { None };
    }
    let tangent = a.start_tangent()?;
    let arc = Arc::from_start_tangent(a.start(), b.end(), tangent * a.start().distance(b.end())).ok()?;
    let same_way = arc.angle() > a.angle() && arc.end_tangent()?.angle(b.end_tangent()?) <= MERGE_ANGLE;
    let through = arc.closest_point(a.end()).distance <= MERGE_ANGLE * a.length();
    (same_way && through).then_some(arc)
}

/// Both spans as one; the second may count from another lap.
pub(super) fn joined(first: Span, second: Span, wraps: usize) -> Span {
    let lap = |place: Place| Place { index: place.index + wraps, ..place };
    let behind = second.from.along() + 0.5 < first.to.along();
    Span { from: first.from, to: if behind { lap(second.to) } else { second.to } }
}
