//! The fit in space: a beam of biarcs between vertices with freed tangents (`10`, section 2.4).
//!
//! A state is a vertex with one of its candidate tangents. From each state, and for each candidate tangent at the end,
//! the longest biarc that stays within the tolerance is found by doubling and bisection, and the ends just before it
//! are kept too. Each layer adds one biarc; the farthest states of a layer go on, and the first layer that reaches
//! the end has the count.

use super::certificate::Span;
use super::options::{ArcFitOptions, FitTarget};
use super::space_tangents::Run;
use super::trace::Trace;
use super::{
    super::biarc::{Biarc, BiarcRule},
    Piece,
};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ClosestPoint};

/// Ends before the longest that are kept for each candidate tangent.
const SHORTER_ENDS: usize = 3;
/// A biarc may be this much longer than the polyline under it, and two tolerances more: no loops.
const MAX_LENGTH_RATIO: f64 = 1.3;
/// Feet may step back by this much of a piece's parameter.
const FOOT_SLACK: f64 = 1e-9;
/// Two arcs that one arc replaces with its end tangent within this angle are one (rounding of their own tangents).
const MERGE_ANGLE: f64 = 1e-12;

/// The polyline between corners, and what binds the curve to it.
struct Fitter<'a> {
    run: Run<'a>,
    tolerance: f64,
    edges: bool,
    /// Length of the polyline up to each vertex.
    lengths: Vec<f64>,
    candidates: Vec<Vec<Vec3>>,
}

#[derive(Clone, Copy)]
struct State {
    vertex: usize,
    tangent: usize,
    parent: Option<usize>,
}

/// The arcs over all runs between corners; the error is the position among `points` where the search died.
pub(super) fn fit(
    points: &[Point3],
    corners: &[usize],
    tolerance: f64,
    options: &ArcFitOptions,
) -> Result<(Trace, Vec<Piece>), usize> {
    let n = points.len();
    let mut trace = Trace::empty(options.closed);
    let mut pieces = Vec::new();
    let width = options.effort.space_states();
    let edges = options.target == FitTarget::Polyline;
    let ring = options.closed && corners.is_empty();
    let runs = if ring { vec![(0, n)] } else { Trace::of_points(points, options.closed).runs(corners) };
    for (from, to) in runs {
        let last = if ring { n - 1 } else { to };
        let run: Vec<Point3> = (from..=last).map(|i| points[i % n]).collect();
        let fitter = Fitter::new(Run { points: &run, ring }, tolerance, edges);
        let chain = fitter.chain(width).map_err(|died| (from + died) % n)?;
        for (i, pair) in chain.windows(2).enumerate() {
            let Some(arcs) = fitter.biarc(pair[0], pair[1]) else { return Err((from + pair[0].0) % n) };
            fitter.emit(&arcs, pair[0].0, pair[1].0, from, n, ring || i > 0, &mut trace, &mut pieces);
        }
    }
    if !options.closed {
        trace.push(points[n - 1], Some(n - 1));
    }
    Ok((trace, merged(pieces)))
}

/// A vertex and its tangent.
type Joint = (usize, Vec3);

impl<'a> Fitter<'a> {
    fn new(run: Run<'a>, tolerance: f64, edges: bool) -> Self {
        let mut lengths = vec![0.0];
        for i in 0..run.edges() {
            lengths.push(lengths[i] + run.at(i).distance(run.at(i + 1)));
        }
        let candidates = (0..run.points.len()).map(|k| run.tangents(k, tolerance)).collect();
        Self { run, tolerance, edges, lengths, candidates }
    }

    fn tangents(&self, vertex: usize) -> &[Vec3] {
        &self.candidates[vertex % self.candidates.len()]
    }

    /// Vertices and tangents of the fewest biarcs found. A ring is tried from every candidate at its first point.
    fn chain(&self, width: usize) -> Result<Vec<Joint>, usize> {
        let starts = 0..self.tangents(0).len();
        if !self.run.ring {
            return self.search(&starts.collect::<Vec<_>>(), width);
        }
        let mut best: Result<Vec<Joint>, usize> = Err(0);
        for start in starts {
            match (self.search(&[start], width), &best) {
                (Ok(chain), Ok(b)) if chain.len() >= b.len() => {}
                (Ok(chain), _) => best = Ok(chain),
                (Err(died), Err(b)) if died > *b => best = Err(died),
                (Err(_), _) => {}
            }
        }
        best
    }

    fn search(&self, starts: &[usize], width: usize) -> Result<Vec<Joint>, usize> {
        let goal = self.run.edges();
        let mut arena: Vec<State> = starts.iter().map(|t| State { vertex: 0, tangent: *t, parent: None }).collect();
        let mut layer = 0..arena.len();
        loop {
            let mut next: Vec<State> = Vec::new();
            for i in layer.clone() {
                let state = arena[i];
                let from = (state.vertex, self.tangents(state.vertex)[state.tangent]);
                for candidate in 0..self.tangents(state.vertex + 1).len().max(1) {
                    let longest = self.longest(from, candidate, goal, &arena[0]);
                    for vertex in (longest.saturating_sub(SHORTER_ENDS).max(state.vertex + 1)..=longest).rev() {
                        let tangent = if self.run.ring && vertex == goal { arena[0].tangent } else { candidate };
                        let child = State { vertex, tangent, parent: Some(i) };
                        let known = next.iter().any(|s| s.vertex == vertex && s.tangent == tangent);
                        if !known && self.reaches(from, vertex, tangent) {
                            next.push(child);
                        }
                    }
                }
            }
            next.sort_by_key(|s| std::cmp::Reverse(s.vertex));
            if let Some(end) = next.first().filter(|s| s.vertex == goal) {
                arena.push(*end);
                return Ok(self.joints(&arena));
            }
            if next.is_empty() {
                return Err(layer.map(|i| arena[i].vertex).max().unwrap_or(0));
            }
            next.truncate(width);
            layer = arena.len()..arena.len() + next.len();
            arena.extend(next);
        }
    }

    /// Joints up to the last state of the arena.
    fn joints(&self, arena: &[State]) -> Vec<Joint> {
        let mut joints: Vec<Joint> = std::iter::successors(arena.last(), |s| s.parent.map(|i| &arena[i]))
            .map(|s| (s.vertex, self.tangents(s.vertex)[s.tangent]))
            .collect();
        joints.reverse();
        joints
    }

    fn reaches(&self, from: Joint, vertex: usize, tangent: usize) -> bool {
        let tangents = self.tangents(vertex);
        tangents.get(tangent).is_some_and(|t| self.biarc(from, (vertex, *t)).is_some())
    }

    /// The farthest vertex a biarc with this candidate tangent reaches: doubling steps, then bisection.
    fn longest(&self, from: Joint, candidate: usize, goal: usize, start: &State) -> usize {
        let reaches = |vertex: usize| {
            let tangent = if self.run.ring && vertex == goal { start.tangent } else { candidate };
            self.reaches(from, vertex, tangent)
        };
        let (mut good, mut step) = (from.0, 1);
        let mut bad = goal + 1;
        while good < goal {
            let vertex = (from.0 + step).min(goal);
            if !reaches(vertex) {
                bad = vertex;
                break;
            }
            good = vertex;
            step *= 2;
        }
        while good + 1 < bad {
            let middle = usize::midpoint(good, bad);
            if reaches(middle) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }

    /// The biarc between two joints if it stays within the tolerance of everything between.
    fn biarc(&self, from: Joint, to: Joint) -> Option<[Arc; 2]> {
        let (a, b) = (self.run.at(from.0), self.run.at(to.0));
        if to.0 == from.0 + 1 && a.distance(b) == 0.0 {
            return None;
        }
        let biarc = Biarc::new(a, from.1, b, to.1, BiarcRule::EqualD).ok()?;
        let polyline = self.lengths[to.0] - self.lengths[from.0];
        if biarc.length() > MAX_LENGTH_RATIO * polyline + 2.0 * self.tolerance {
            return None;
        }
        let arcs = *biarc.arcs();
        let mut before = Foot { piece: 0, t: 0.0, distance: 0.0 };
        for vertex in from.0 + 1..=to.0 {
            let foot = if vertex == to.0 {
                Foot { piece: 1, t: 1.0, distance: 0.0 }
            } else {
                Foot::nearest(&arcs, self.run.at(vertex))
            };
            let forward = foot.along() >= before.along() - FOOT_SLACK;
            if !forward
                || foot.distance > self.tolerance
                || (self.edges && !self.edge_fits(&arcs, vertex, before, foot))
            {
                return None;
            }
            before = foot;
        }
        Some(arcs)
    }

    /// The edge that ends in `vertex`, between the feet of its ends: the sagitta of the part under it and the larger
    /// distance at its ends (`10`, section 2.4, step 3). Over the joint it is cut at its point nearest to the joint.
    fn edge_fits(&self, arcs: &[Arc; 2], vertex: usize, from: Foot, to: Foot) -> bool {
        let part = |arc: &Arc, t0: f64, t1: f64| {
            let (l, turn) = (arc.length_to(t1) - arc.length_to(t0), arc.angle_to(t1) - arc.angle_to(t0));
            0.5 * l * (0.25 * turn).tan()
        };
        let ends = from.distance.max(to.distance);
        let worst = if from.piece == to.piece {
            ends + part(&arcs[from.piece], from.t, to.t)
        } else {
            let joint = arcs[0].end();
            let cut = nearest_on_edge(self.run.at(vertex - 1), self.run.at(vertex), joint).distance(joint);
            ends.max(cut) + part(&arcs[0], from.t, 1.0).max(part(&arcs[1], 0.0, to.t))
        };
        worst <= self.tolerance
    }

    /// Adds the two arcs with the part of the polyline each stands for; the joint stands over the point of the
    /// polyline nearest to it.
    #[expect(clippy::too_many_arguments, reason = "one call site; the places of one biarc in the whole curve")]
    fn emit(
        &self,
        arcs: &[Arc; 2],
        from: usize,
        to: usize,
        first: usize,
        total: usize,
        smooth: bool,
        trace: &mut Trace,
        pieces: &mut Vec<Piece>,
    ) {
        let start = trace.points.len();
        let mut middle = start;
        let mut before = from;
        for vertex in from..to {
            let p = self.run.at(vertex);
            if vertex > from && middle == start && Foot::nearest(arcs, p).piece == 1 {
                middle = self.push_joint(arcs, before, trace);
            }
            trace.push(p, Some((first + vertex) % total));
            before = vertex;
        }
        if middle == start {
            middle = self.push_joint(arcs, before, trace);
        }
        let end = trace.points.len();
        pieces.push((arcs[0], Span { from: start, to: middle }, smooth));
        pieces.push((arcs[1], Span { from: middle, to: end }, true));
    }

    /// Adds the point of the edge after `vertex` that is nearest to the biarc's joint, and returns its index.
    fn push_joint(&self, arcs: &[Arc; 2], vertex: usize, trace: &mut Trace) -> usize {
        trace.push(nearest_on_edge(self.run.at(vertex), self.run.at(vertex + 1), arcs[0].end()), None);
        trace.points.len() - 1
    }
}

fn nearest_on_edge(a: Point3, b: Point3, p: Point3) -> Point3 {
    let edge = b - a;
    a.lerp(b, ((p - a).dot(edge) / edge.dot(edge)).clamp(0.0, 1.0))
}

/// The nearest point of a biarc.
#[derive(Clone, Copy)]
struct Foot {
    piece: usize,
    t: f64,
    distance: f64,
}

impl Foot {
    fn nearest(arcs: &[Arc; 2], p: Point3) -> Self {
        let [a, b]: [ClosestPoint; 2] = arcs.each_ref().map(|arc| arc.closest_point(p));
        if b.distance < a.distance {
            Self { piece: 1, t: b.t, distance: b.distance }
        } else {
            Self { piece: 0, t: a.t, distance: a.distance }
        }
    }

    fn along(self) -> f64 {
        self.piece as f64 + self.t
    }
}

/// Neighbouring arcs on one circle or line become one.
fn merged(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        if piece.2
            && let Some(last) = out.last_mut()
            && let Some(arc) = one_arc(&last.0, &piece.0)
        {
            *last = (arc, Span { from: last.1.from, to: piece.1.to }, last.2);
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
