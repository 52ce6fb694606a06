//! The fit in space: a beam of biarcs between vertices with freed tangents (`docs/math/arc-fitting.md#space`).
//!
//! A state is a vertex with one of its candidate tangents. From each state, and for each candidate tangent at the end,
//! the longest biarc that stays within the tolerance is found by doubling and bisection, and the ends just before it
//! are kept too. Each layer adds one biarc; the farthest states of a layer go on, and the first layer that reaches
//! the end has the count.

use super::super::biarc::{Biarc, BiarcRule};
use super::options::{ArcFitOptions, FitTarget};
use super::piece::{Piece, Place, Span, merged};
use super::space_tangents::Run;
use super::trace::Trace;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ClosestPoint};

/// Ends before the longest that are kept for each candidate tangent.
const SHORTER_ENDS: usize = 3;
/// A biarc may be this much longer than the polyline under it, and two tolerances more: no loops.
const MAX_LENGTH_RATIO: f64 = 1.3;
/// Feet may step back by this much of a piece's parameter.
const FOOT_SLACK: f64 = 1e-9;

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
    let trace = Trace::of_points(points, options.closed);
    let mut pieces = Vec::new();
    let width = options.effort.space_states();
    let edges = options.target == FitTarget::Polyline;
    let ring = options.closed && corners.is_empty();
    let runs = if ring { vec![(0, n)] } else { trace.runs(corners) };
    for (from, to) in runs {
        let last = if ring { n - 1 } else { to };
        let run: Vec<Point3> = (from..=last).map(|i| points[i % n]).collect();
        let fitter = Fitter::new(Run { points: &run, ring }, tolerance, edges);
        let chain = fitter.chain(width).map_err(|died| (from + died) % n)?;
        for (i, pair) in chain.windows(2).enumerate() {
            let Some(arcs) = fitter.biarc(pair[0], pair[1]) else { return Err((from + pair[0].0) % n) };
            pieces.extend(fitter.pieces(&arcs, pair[0].0, pair[1].0, from, ring || i > 0, &trace));
        }
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
        // Biarcs that are too long mostly show it in the middle.
        let inside = to.0 - from.0;
        let far = |i: usize| i > 0 && Foot::nearest(&arcs, self.run.at(from.0 + i)).distance > self.tolerance;
        if [inside / 2, inside / 4, 3 * inside / 4].into_iter().any(far) {
            return None;
        }
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
    /// distance at its ends (`docs/math/arc-fitting.md#space`). Over the joint it is cut at its point nearest to the
    /// joint.
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

    /// The two arcs of a biarc with the part of the polyline each stands for; the joint stands over the point of the
    /// polyline nearest to it. Places count from `first`.
    fn pieces(&self, arcs: &[Arc; 2], from: usize, to: usize, first: usize, smooth: bool, trace: &Trace) -> [Piece; 2] {
        let beyond = |vertex: &usize| Foot::nearest(arcs, self.run.at(*vertex)).piece == 1;
        let next = (from + 1..to).find(beyond).unwrap_or(to);
        let edge = Span { from: Place::over(first + next - 1), to: Place::over(first + next) };
        let middle = Place::nearest(trace, arcs[0].end(), edge);
        let (start, end) = (Place::over(first + from), Place::over(first + to));
        [
            Piece { arc: arcs[0], span: Span { from: start, to: middle }, smooth },
            Piece { arc: arcs[1], span: Span { from: middle, to: end }, smooth: true },
        ]
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
