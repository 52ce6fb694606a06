//! The tube beam: the fewest tangent-continuous arcs inside a tube about a polyline
//! (`docs/math/arc-fitting.md#tube-beam`).
//!
//! A state is a vertex, a joint on the normal through it at most one tolerance away, and a tangent. From a state all
//! arcs are one curvature interval per end vertex ([`CurvatureSweep`]). Each level of the search adds one arc, so the
//! first level that reaches the goal has the count. States that fall into one cell (vertex, offset, angle) are
//! represented by one of them, exact and not rounded; the number of cells per level is capped, half of them the
//! farthest and half an even stride over the rest. (Keeping only the farthest falls into a zigzag trap: all states
//! alternate about the middle of the tube and never get long.) The count is near the minimum, not proved to be it.

use super::curvature_interval::{CurvatureSweep, JointFrame, curvature_to};
use super::options::ArcLimits;
use super::trace::Trace;
use crate::base::planar::{Point2, Vec2};
use std::ops::{Range, RangeInclusive};

/// Tangent angles tried at a free start.
const START_ANGLES: usize = 81;
/// No start tangent farther than this from the first edge: beyond, the sweep would soon pass half a turn.
const MAX_START_ANGLE: f64 = 1.5;
/// Places tried on an axis of symmetry, across the tube.
const AXIS_PLACES: usize = 41;
/// Largest sine of the angle between two directions that are one.
const PARALLEL: f64 = 1e-12;
/// Levels fan out over the last `3 + 0.34 (farthest reach - nearest state)` end vertices.
const WINDOW_BASE: f64 = 3.0;
const WINDOW_SLOPE: f64 = 0.34;

/// A part of the trace in the plane.
pub(super) struct Run {
    points: Vec<Point2>,
    slack: Vec<f64>,
    bulge: Vec<f64>,
    straight_ahead: Vec<bool>,
}

impl Run {
    /// The points of the trace at indices that may wrap around, in the plane.
    pub fn new(flat: &[Point2], trace: &Trace, range: RangeInclusive<usize>) -> Self {
        let n = flat.len();
        let pick = |values: &[f64]| range.clone().map(|i| values[i % n]).collect();
        Self {
            points: range.clone().map(|i| flat[i % n]).collect(),
            slack: pick(&trace.slack),
            bulge: pick(&trace.bulge),
            straight_ahead: range.clone().map(|i| trace.straight_ahead[i % n]).collect(),
        }
    }

    /// The part between two places that are counted in half steps: at an odd one it begins or ends in the middle of an edge.
    pub fn between(flat: &[Point2], trace: &Trace, halves: Range<usize>) -> Self {
        let mut run = Self::new(flat, trace, halves.start.div_ceil(2)..=halves.end / 2);
        let n = flat.len();
        let middle = |half: usize| {
            let (from, to) = (half / 2 % n, (half / 2 + 1) % n);
            (flat[from] + (flat[to] - flat[from]) * 0.5, trace.bulge[to], trace.straight_ahead[from])
        };
        for (half, at) in
            [(halves.end, run.points.len()), (halves.start, 0)].into_iter().filter(|(half, _)| half % 2 == 1)
        {
            let (point, slack, straight) = middle(half);
            run.points.insert(at, point);
            run.slack.insert(at, slack);
            run.bulge.insert(at, slack);
            run.straight_ahead.insert(at, straight);
        }
        run
    }

    pub fn tube(&self, tolerance: f64, limits: ArcLimits) -> Tube<'_> {
        Tube::new(self, tolerance, limits)
    }
}

/// A polyline in the plane and the tolerance about it.
pub(super) struct Tube<'a> {
    pub points: &'a [Point2],
    pub tolerance: f64,
    /// What is added to the tolerance at each point: more than 0 where a point only offers a place for a joint.
    slack: &'a [f64],
    /// What is added to the tolerance for the edge that ends in each point.
    bulge: &'a [f64],
    /// What arcs keep to.
    limits: ArcLimits,
    /// Unit direction of the edge that ends in each vertex; the first repeats the second.
    directions: Vec<Vec2>,
    /// Whether a straight run goes on from each vertex.
    straight_ahead: &'a [bool],
}

impl<'a> Tube<'a> {
    /// Neighboring points must differ, and there must be at least two, with the slacks of each.
    fn new(run: &'a Run, tolerance: f64, limits: ArcLimits) -> Self {
        let points = &run.points;
        let unit = |w: &[Point2]| (w[1] - w[0]).unit().unwrap_or(Vec2::new(1.0, 0.0));
        let mut directions = Vec::with_capacity(points.len());
        directions.push(unit(&points[..2]));
        directions.extend(points.windows(2).map(unit));
        Self {
            points: &run.points,
            tolerance,
            slack: &run.slack,
            bulge: &run.bulge,
            limits,
            directions,
            straight_ahead: &run.straight_ahead,
        }
    }

    /// Adds a vertex to a sweep from the frame; its frame coordinates, if any curvature is left.
    pub fn advance(&self, sweep: &mut CurvatureSweep, frame: &JointFrame, vertex: usize) -> Option<Vec2> {
        let at = frame.local(self.points[vertex]);
        sweep.advance(at, self.tolerance + self.slack[vertex], Some(self.tolerance + self.bulge[vertex])).then_some(at)
    }

    pub fn last(&self) -> usize {
        self.points.len() - 1
    }

    pub fn sweep_from(&self, frame: &JointFrame, vertex: usize) -> CurvatureSweep {
        let mut sweep = CurvatureSweep::new(frame.local(self.points[vertex]), self.tolerance);
        sweep.lo = sweep.lo.max(-self.limits.curvature);
        sweep.hi = sweep.hi.min(self.limits.curvature);
        sweep
    }

    /// Whether an arc may have this chord; lines may have any.
    pub fn allows(&self, curvature: f64, chord: f64) -> bool {
        curvature == 0.0 || chord >= self.limits.length
    }

    /// States at the first point with a fan of tangents about the first edge: as far as the turn at the second
    /// vertex and the tolerance make sense.
    pub fn start_fan(&self) -> Vec<JointFrame> {
        let first = self.directions[1];
        let turn = self.directions.get(2).map_or(0.0, |d| first.cross(*d).atan2(first.dot(*d)).abs());
        let edge = self.points[0].distance(self.points[1]);
        let spread = (turn + 2.0 * self.tolerance / edge).min(MAX_START_ANGLE);
        let half = (START_ANGLES / 2) as f64;
        let fan = (0..START_ANGLES).map(|i| {
            let (s, c) = (spread * (i as f64 / half - 1.0)).sin_cos();
            JointFrame { joint: self.points[0], tangent: first * c + first.left() * s }
        });
        fan.collect()
    }

    /// States on an axis of symmetry through the first point: across it, as far out as the tolerance reaches.
    pub fn axis_fan(&self, axis: JointFrame) -> Vec<JointFrame> {
        let half = (AXIS_PLACES / 2) as f64;
        let at = |i: usize| self.tolerance * (i as f64 / half - 1.0);
        let place = |i: usize| JointFrame { joint: axis.joint + axis.tangent.left() * at(i), ..axis };
        (0..AXIS_PLACES).map(place).collect()
    }
}

/// How hard to search.
#[derive(Debug, Clone, Copy)]
pub(super) struct BeamSize {
    /// Curvatures tried across each interval.
    pub samples: usize,
    /// Cells kept per level.
    pub cells: usize,
}

/// Where the chain must end.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// In the last point, with any tangent.
    Point,
    /// In this joint with this tangent; it belongs to the last vertex.
    Joint(JointFrame),
    /// With this tangent anywhere on the axis of symmetry across it through this joint, which belongs to the last vertex.
    Axis(JointFrame),
}

/// A joint of a chain; its arc is the one that ends here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ChainJoint {
    pub vertex: usize,
    pub frame: JointFrame,
    /// The arc that ends here is a straight segment.
    pub straight: bool,
}

/// A state of the search.
#[derive(Clone, Copy)]
pub(super) struct Node {
    pub at: ChainJoint,
    parent: Option<usize>,
    /// Straight segments on the way here.
    lines: u32,
}

/// One end vertex a state reaches: its frame coordinates and the curvatures that get there.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub lo: f64,
    pub hi: f64,
    pub at: Vec2,
}

impl End {
    /// Distance of a curvature from the ends of the interval, relative to its width: 1/2 in the middle, negative
    /// outside.
    pub fn margin(&self, kappa: f64) -> f64 {
        (kappa - self.lo).min(self.hi - kappa) / (self.hi - self.lo).max(f64::MIN_POSITIVE)
    }
}

/// All states with the same number of arcs, and what each of them reaches.
pub(super) struct Level {
    /// Indices into the arena.
    pub nodes: Range<usize>,
    ends: Vec<End>,
    /// Where the ends of each node begin; one more at the end.
    offsets: Vec<usize>,
}

impl Level {
    fn new(tube: &Tube<'_>, arena: &[Node], nodes: Range<usize>) -> Self {
        let (mut ends, mut offsets) = (Vec::new(), vec![0]);
        for node in &arena[nodes.clone()] {
            let frame = node.at.frame;
            let mut sweep = tube.sweep_from(&frame, node.at.vertex);
            for vertex in node.at.vertex + 1..=tube.last() {
                let Some(at) = tube.advance(&mut sweep, &frame, vertex) else { break };
                ends.push(End { lo: sweep.lo, hi: sweep.hi, at });
            }
            offsets.push(ends.len());
        }
        Self { nodes, ends, offsets }
    }

    /// What a node of this level reaches: element `i` is the end vertex `vertex + 1 + i`.
    pub fn ends_of(&self, node: usize) -> &[End] {
        let i = node - self.nodes.start;
        &self.ends[self.offsets[i]..self.offsets[i + 1]]
    }
}

/// A chain that reaches the goal, or the farthest vertex any chain came to.
pub(super) fn search(
    tube: &Tube<'_>,
    start: &[JointFrame],
    goal: Goal,
    size: BeamSize,
) -> Result<Vec<ChainJoint>, usize> {
    let root = |frame: &JointFrame| Node {
        at: ChainJoint { vertex: 0, frame: *frame, straight: false },
        parent: None,
        lines: 0,
    };
    let mut arena: Vec<Node> = start.iter().map(root).collect();
    let mut nodes = 0..arena.len();
    loop {
        let level = Level::new(tube, &arena, nodes.clone());
        let finished = match goal {
            Goal::Point => end_in_point(tube, &arena, &level),
            Goal::Joint(target) => super::closing::end_in_joint(tube, &arena, &level, target),
            Goal::Axis(axis) => end_on_axis(tube, &arena, &level, axis),
        };
        if let Some((node, tail)) = finished {
            return Ok(chain(&arena, node, tail));
        }
        let reach = |i: usize| arena[i].at.vertex + level.ends_of(i).len();
        let far = nodes.clone().map(reach).max().unwrap_or(0);
        let children = next_level(tube, &arena, &level, goal, far, size);
        if children.is_empty() {
            return Err(far);
        }
        nodes = arena.len()..arena.len() + children.len();
        arena.extend(children);
    }
}

/// The joints from the start to a node and on along `tail`.
fn chain(arena: &[Node], node: usize, tail: impl IntoIterator<Item = ChainJoint>) -> Vec<ChainJoint> {
    let mut joints: Vec<_> = std::iter::successors(Some(node), |i| arena[*i].parent).map(|i| arena[i].at).collect();
    joints.reverse();
    joints.extend(tail);
    joints
}

/// The state whose exact arc to the last point lies deepest inside its interval; more straight segments win first.
fn end_in_point(tube: &Tube<'_>, arena: &[Node], level: &Level) -> Option<(usize, Vec<ChainJoint>)> {
    let last = tube.last();
    let candidate = |i: usize| {
        let node = &arena[i].at;
        let end = level.ends_of(i).get(last - node.vertex - 1)?;
        let kappa = curvature_to(end.at);
        let margin = end.margin(kappa);
        (margin >= 0.0 && tube.allows(kappa, end.at.length())).then_some((i, *end, kappa, margin))
    };
    let better = |a: &(usize, End, f64, f64), b: &(usize, End, f64, f64)| {
        arena[a.0].lines.cmp(&arena[b.0].lines).then(a.3.total_cmp(&b.3))
    };
    let (i, end, kappa, _) = level.nodes.clone().filter_map(candidate).max_by(better)?;
    let tangent = arena[i].at.frame.end_tangent_at(end.at);
    let frame = JointFrame { joint: tube.points[last], tangent };
    Some((i, vec![ChainJoint { vertex: last, frame, straight: kappa == 0.0 }]))
}

/// The state whose arc across the axis lies deepest inside its interval; more straight segments win first. There is one arc from
/// each state, along the middle of its tangent and the goal's.
fn end_on_axis(tube: &Tube<'_>, arena: &[Node], level: &Level, axis: JointFrame) -> Option<(usize, Vec<ChainJoint>)> {
    let last = tube.last();
    let candidate = |i: usize| {
        let node = &arena[i].at;
        let end = level.ends_of(i).get(last - node.vertex - 1)?;
        let from = &node.frame;
        let chord = (from.tangent + axis.tangent).unit()?;
        let length = (axis.joint - from.joint).dot(axis.tangent) / chord.dot(axis.tangent);
        let joint = from.joint + chord * length;
        let straight = from.tangent.cross(axis.tangent).abs() <= PARALLEL;
        let kappa = if straight { 0.0 } else { curvature_to(from.local(joint)) };
        let margin = end.margin(kappa);
        let lines = arena[i].lines + u32::from(straight);
        let allowed = length > 0.0 && margin >= 0.0 && tube.allows(kappa, length);
        allowed.then_some((
            i,
            ChainJoint { vertex: last, frame: JointFrame { joint, ..axis }, straight },
            lines,
            margin,
        ))
    };
    let best = level.nodes.clone().filter_map(candidate).max_by(|a, b| a.2.cmp(&b.2).then(a.3.total_cmp(&b.3)));
    best.map(|(i, joint, ..)| (i, vec![joint]))
}

/// A child not yet made: its cell, its rank inside the cell (less is better), and what makes it.
#[derive(Clone, Copy)]
struct Candidate {
    cell: (i64, i64),
    rank: (u32, u32),
    node: usize,
    kappa: f64,
    /// Sine of the angle between its tangent and the mean direction of the edges at its vertex.
    lean: f64,
}

fn next_level(tube: &Tube<'_>, arena: &[Node], level: &Level, goal: Goal, far: usize, size: BeamSize) -> Vec<Node> {
    let nearest = level.nodes.clone().map(|i| arena[i].at.vertex).min().unwrap_or(0);
    let window = (WINDOW_BASE + WINDOW_SLOPE * (far - nearest) as f64) as usize;
    let highest = far.min(tube.last() - 1);
    let mut children: Vec<(usize, Candidate)> = Vec::new();
    let mut candidates = Vec::new();
    for vertex in (far.saturating_sub(window).max(nearest + 1)..=highest).rev() {
        candidates.clear();
        for i in level.nodes.clone() {
            let node = &arena[i];
            if vertex > node.at.vertex
                && let Some(end) = level.ends_of(i).get(vertex - node.at.vertex - 1)
            {
                fan_out(tube, (i, node), end, vertex, goal, size.samples, &mut candidates);
            }
        }
        candidates.sort_unstable_by_key(|c| (c.cell, c.rank, c.node));
        candidates.dedup_by_key(|c| c.cell);
        // Tangents near that of the data go on farthest: they come first where the cap cuts.
        candidates.sort_by(|a, b| a.lean.total_cmp(&b.lean));
        children.extend(candidates.iter().map(|c| (vertex, *c)));
    }
    let make = |(vertex, c): &(usize, Candidate)| {
        let parent = &arena[c.node];
        let v = parent.at.frame.local(tube.points[*vertex]);
        let straight = c.kappa == 0.0;
        Node {
            at: ChainJoint { vertex: *vertex, frame: parent.at.frame.end_over(c.kappa, v), straight },
            parent: Some(c.node),
            lines: parent.lines + u32::from(straight),
        }
    };
    if children.len() <= size.cells {
        return children.iter().map(make).collect();
    }
    let front = size.cells / 2;
    let (kept, rest) = (size.cells - front, children.len() - front);
    let stride = (0..kept).map(|i| front + i * rest / kept);
    (0..front).chain(stride).map(|i| make(&children[i])).collect()
}

/// Curvatures across one interval, the straight line if it is inside, and the arc that ends along a straight run: a line
/// over a long run needs its direction far more exactly than a few curvatures give it.
fn fan_out(
    tube: &Tube<'_>,
    (index, node): (usize, &Node),
    end: &End,
    vertex: usize,
    goal: Goal,
    samples: usize,
    out: &mut Vec<Candidate>,
) {
    let frame = &node.at.frame;
    let Vec2 { x, y } = end.at;
    let direction = tube.directions[vertex];
    let (along, across) = (frame.tangent.dot(direction), frame.tangent.cross(direction));
    let mean = direction + tube.directions[(vertex + 1).min(tube.last())];
    let (mean_along, mean_across) = (frame.tangent.dot(mean), frame.tangent.cross(mean));
    let squared = end.at.dot(end.at);
    let mut push = |kappa: f64, off_middle: f64| {
        let (a, b) = (kappa * x, 1.0 - kappa * y);
        let z = (a * a + b * b).sqrt();
        let offset = (2.0 * y - kappa * squared) / (1.0 + z);
        // Sine of the angle from the edge to the new tangent (b, a)/z, continued beyond a quarter turn.
        let (sine, cosine) = ((a * along - b * across) / z, (b * along + a * across) / z);
        let angle = if cosine >= 0.0 { sine } else { (2.0 - sine.abs()).copysign(sine) };
        // The joint is at x/z along and a x/(z (z+b)) across.
        let chord = x / z * 1.0_f64.hypot(a / (z + b));
        if !tube.allows(kappa, chord) {
            return;
        }
        let cell = ((offset / (0.5 * tube.tolerance)).round() as i64, (angle * chord / tube.tolerance).round() as i64);
        let lines = node.lines + u32::from(kappa == 0.0);
        let lean = ((a * mean_along - b * mean_across) / z).abs();
        out.push(Candidate { cell, rank: (u32::MAX - lines, (off_middle * 1e6) as u32), node: index, kappa, lean });
    };
    for i in 0..samples {
        let fraction = (i as f64 + 0.5) / samples as f64;
        push(end.lo + (end.hi - end.lo) * fraction, (fraction - 0.5).abs());
    }
    if end.lo < 0.0 && end.hi > 0.0 {
        push(0.0, 0.5 - end.margin(0.0));
    }
    let straight = tube.directions.get(vertex + 1).filter(|_| tube.straight_ahead[vertex]).copied();
    // Across an axis of symmetry a line must run as the goal says.
    let at_goal = if let Goal::Axis(axis) = goal { Some(axis.tangent) } else { None };
    for ahead in straight.into_iter().chain(at_goal) {
        let (cosine, sine) = (frame.tangent.dot(ahead), frame.tangent.cross(ahead));
        let kappa = sine / (x * cosine + y * sine);
        if end.margin(kappa) > 0.0 {
            push(kappa, 0.0);
        }
    }
}
