//! How much a fit may turn: no more than its data do within the tolerance.
//!
//! A fit can pass near every point and still hide corners in tiny arcs, or swing to and fro between the points: both
//! show in its total turning, the integral of the curvature and the angles at its corners. What the data turn is
//! measured on the smooth curve through them whose tangents are those of the circles through three neighbors (own
//! derivation). With `a` and `b` the angles between the chord of an edge and the tangents at its two ends, positive
//! where the curve turns on,
//!
//! ```text
//! turning of an edge = |a| + |b|      if it turns on in one direction (a b >= 0)
//!                    = 2 (|a| + |b|)  if it turns back (a b < 0): an S swings past its chord by (|a| + |b|)/2
//! ```
//! A curve within `tau` of another over a length `L` differs from it in direction by at most `8 tau/L` where the
//! difference is a parabola (Markov's inequality), which is turning by `16 tau/L`: what the tolerance adds per piece.
//! Pieces shorter than the edges of the data are given the edge's length: they get no more for being short.

use super::options::{ArcFitOptions, FitTarget};
use super::piece::{Piece, Span};
use super::trace::Trace;
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::outline::Outline;
use crate::warning::{FitWarning, Warning};
use std::ops::Range;

/// How much the smooth curve through coarse samples is in doubt.
const DOUBT: f64 = 1.1;
/// Turning that the tolerance allows per piece, times length over tolerance.
const ALLOWANCE: f64 = 16.0;
/// Arcs this many times tighter than the tightest circle of the data near them are reported.
const TIGHT: f64 = 4.0;

/// The data a fit is judged by.
pub(super) struct Data<'a> {
    points: &'a [Point3],
    outline: &'a Outline,
    options: &'a ArcFitOptions,
    /// Turn at each point about its axis, zero at the ends of open data.
    turns: Vec<Vec3>,
}

impl<'a> Data<'a> {
    /// Neighboring points must differ; corners in ascending order.
    pub fn new(points: &'a [Point3], outline: &'a Outline, options: &'a ArcFitOptions) -> Self {
        let n = points.len();
        let turn = |i: usize| {
            if !options.closed && (i == 0 || i == n - 1) {
                return Vec3::ZERO;
            }
            let (u, v) = (points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]);
            u.cross(v).unit().map_or(Vec3::ZERO, |axis| axis * u.angle(v))
        };
        let turns = (0..n).map(turn).collect();
        Self { points, outline, options, turns }
    }

    fn length(&self, edge: usize) -> f64 {
        let n = self.points.len();
        self.points[edge % n].distance(self.points[(edge + 1) % n])
    }

    /// True where a run ends: its last edge turns like the one before it.
    fn is_end(&self, vertex: usize) -> bool {
        let open_end = !self.options.closed && (vertex == 0 || vertex + 1 == self.points.len());
        open_end || self.outline.corners.binary_search_by_key(&vertex, |c| c.0).is_ok()
    }

    /// What the smooth curve through the points turns, corners included.
    pub fn turning(&self) -> f64 {
        let n = self.points.len();
        let edges = if self.options.closed { n } else { n - 1 };
        let of_edge = |i: usize| {
            let (from, to) = (i, (i + 1) % n);
            let length = self.length(i);
            let at = |vertex: usize, other: usize| self.turns[vertex] * (length / (length + self.length(other)));
            let ends = (self.is_end(from), self.is_end(to));
            let (a, b) = match ends {
                (true, true) => return 0.0,
                (true, false) => (at(to, to), at(to, to)),
                (false, true) => (at(from, (i + n - 1) % n), at(from, (i + n - 1) % n)),
                (false, false) => (at(from, (i + n - 1) % n), at(to, to)),
            };
            let sum = a.length() + b.length();
            if a.dot(b) < 0.0 { 2.0 * sum } else { sum }
        };
        (0..edges).map(of_edge).sum::<f64>() + self.outline.corners.iter().map(|c| c.1).sum::<f64>()
    }

    /// The points near a span of the trace: indices that may wrap around.
    fn near(&self, span: Span, trace: &Trace) -> Range<usize> {
        let n = trace.points.len();
        let first = trace.vertex_before(span.from.index % n);
        let inside = span.inside().filter(|i| trace.vertex[i % n].is_some()).count();
        first..first + inside + 2
    }

    /// The most the pieces may turn.
    pub fn limit(&self, pieces: &[Piece], trace: &Trace) -> f64 {
        let allowance = |piece: &Piece| {
            let edges = self.near(piece.span, trace);
            let spacing = (edges.start..edges.end - 1).map(|i| self.length(i)).fold(0.0, f64::max);
            ALLOWANCE * self.options.tolerance / piece.arc.length().max(spacing)
        };
        DOUBT * self.turning() + pieces.iter().map(allowance).sum::<f64>()
    }

    /// Radius of the tightest circle of the data at a point: the circle through it and its neighbors; where the edges
    /// themselves are meant, at most the largest that rounds the turn within the tolerance
    /// (`docs/math/arc-fitting.md#corners`).
    fn circle_at(&self, vertex: usize) -> f64 {
        let n = self.points.len();
        let turn = self.turns[vertex % n].length();
        if turn == 0.0 {
            return f64::INFINITY;
        }
        let (before, after) = (self.points[(vertex + n - 1) % n], self.points[(vertex + 1) % n]);
        let through = 0.5 * before.distance(after) / turn.sin().max(f64::MIN_POSITIVE);
        let meant = |edge: usize| self.options.target == FitTarget::Polyline || self.outline.straight[edge % n];
        if meant(vertex) || meant(vertex + n - 1) {
            through.min(self.options.tolerance / (0.25 * turn).tan().powi(2))
        } else {
            through
        }
    }

    /// A warning if arcs are much tighter than every circle of the data, corners excepted, with the tightest of them.
    pub fn tight_arcs(&self, pieces: &[Piece], trace: &Trace, source: &[usize]) -> Option<Warning> {
        let circles = (0..self.points.len()).filter(|i| !self.is_end(*i)).map(|i| self.circle_at(i));
        let data = circles.fold(f64::INFINITY, f64::min);
        let limit = data / TIGHT;
        let tight = |(piece, p): (usize, &Piece)| p.arc.radius().filter(|r| *r < limit).map(|r| (r, piece));
        let all: Vec<_> = pieces.iter().enumerate().filter_map(tight).collect();
        let &(radius, piece) = all.iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let vertex = source[trace.vertex_before(pieces[piece].span.from.index % trace.points.len())];
        // Straight data have no circle: any arc is tighter.
        data.is_finite().then_some(Warning::Fit(FitWarning::TightArc {
            piece,
            vertex,
            radius,
            data,
            limit,
            count: all.len(),
        }))
    }
}

/// Total turning of the pieces: sweeps of the arcs, and the angles at the joints.
pub(super) fn of_pieces(pieces: &[Piece], closed: bool) -> f64 {
    let n = pieces.len();
    let joint = |i: usize| {
        let tangents = pieces[(i + n - 1) % n].arc.end_tangent().zip(pieces[i].arc.start_tangent());
        tangents.map_or(0.0, |(before, after)| before.angle(after))
    };
    let sweeps: f64 = pieces.iter().map(|p| p.arc.angle()).sum();
    sweeps + (usize::from(!closed)..n).map(joint).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::construct::curves::arc_fit::piece::Place;
    use crate::construct::curves::outline::Scattered;
    use crate::curve::Arc;
    use crate::warning::FitWarning;

    /// Without corners.
    fn read(points: &[Point3]) -> Outline {
        Outline::read(points, false, 0.01, Some(std::f64::consts::PI), &[], Scattered::Vertices)
    }

    fn piece(arc: Arc, from: usize, to: usize) -> Piece {
        Piece { arc, span: Span { from: Place::over(from), to: Place::over(to) }, smooth: true }
    }

    #[test]
    fn an_arc_far_tighter_than_the_data_is_named_with_its_place() {
        // Points of a circle of radius 10, and an arc of radius 0.5 between two of them.
        let at = |i: usize| {
            let (s, c) = (0.05 * i as f64).sin_cos();
            Point3::new(10.0 * c, 10.0 * s, 0.0)
        };
        let points: Vec<_> = (0..30).map(at).collect();
        let options = ArcFitOptions::new(0.01);
        let outline = read(&points);
        let data = Data::new(&points, &outline, &options);
        let trace = Trace::of_points(&points, false);
        let source: Vec<_> = (0..30).collect();
        let circle =
            |i: usize, j: usize| Arc::from_bulge(at(i), at(j), Vec3::Z, (0.25 * 0.05 * (j - i) as f64).tan()).unwrap();
        let smooth = [piece(circle(0, 12), 0, 12), piece(circle(12, 29), 12, 29)];
        assert!(data.tight_arcs(&smooth, &trace, &source).is_none());
        // The chord of 0.05 radians is 0.49984 long: half the circle of that diameter.
        let half = piece(Arc::from_bulge(at(12), at(13), Vec3::Z, 1.0).unwrap(), 12, 13);
        let hidden = [piece(circle(0, 12), 0, 12), half, piece(circle(13, 29), 13, 29)];
        let Some(Warning::Fit(FitWarning::TightArc { piece, vertex, radius, data: tightest, count, .. })) =
            data.tight_arcs(&hidden, &trace, &source)
        else {
            panic!("no warning")
        };
        assert_eq!((piece, vertex, count), (1, 12, 1));
        assert!((radius - 10.0 * 0.025_f64.sin()).abs() < 1e-9 && (tightest - 10.0).abs() < 1e-9);
    }

    #[test]
    fn a_circle_turns_by_its_angle_and_a_zigzag_twice_its_polygon() {
        let arc: Vec<_> = (0..=40)
            .map(|i| {
                let (s, c) = (0.05 * f64::from(i)).sin_cos();
                Point3::new(c, s, 0.0)
            })
            .collect();
        let options = ArcFitOptions::new(0.01);
        assert!((Data::new(&arc, &read(&arc), &options).turning() - 2.0).abs() < 1e-12);
        // Arcs through a zigzag of slope 1/10 turn by twice the turn of the polygon, but for the two ends.
        let zigzag: Vec<_> = (0..=40).map(|i| Point3::new(f64::from(i), 0.1 * f64::from(i % 2), 0.0)).collect();
        let turn = 2.0 * 0.1_f64.atan();
        let got = Data::new(&zigzag, &read(&zigzag), &options).turning();
        // 38 inner edges swing by twice the turn, the two at the ends run on in their neighbor's circle.
        assert!((got - (38.0 * 2.0 + 2.0) * turn).abs() < 1e-9, "{got}");
    }
}
