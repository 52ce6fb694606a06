//! Ending a chain in a given joint with a given tangent, and closing closed curves that way
//! (`docs/math/arc-fitting.md#tube-beam`).
//!
//! The last two arcs meet the goal: over each end vertex the curvature of the first of them is the root of the angle
//! between the goal's tangent and the end tangent of the exact arc to it.

use super::beam::{BeamSize, ChainJoint, Goal, Level, Node, Run, Tube, search};
use super::curvature_interval::{JointFrame, curvature_to};
use super::options::ArcLimits;
use super::trace::Trace;
use crate::base::planar::{Point2, Vec2};
use crate::base::roots;

/// Subintervals of the curvature interval searched for a change of sign.
const SUBINTERVALS: usize = 8;
/// At most this many end vertices are tried per state.
const MAX_END_VERTICES: usize = 60;
/// Largest sine of the angle left at the goal; what is reached is rounding.
const MAX_CLOSING_ANGLE: f64 = 1e-9;

/// The pair of arcs to the goal that lies deepest inside its two intervals, from any state of the level.
pub(super) fn end_in_joint(
    tube: &Tube<'_>,
    arena: &[Node],
    level: &Level,
    goal: JointFrame,
) -> Option<(usize, Vec<ChainJoint>)> {
    let last = tube.last();
    let farthest = level.nodes.clone().map(|i| arena[i].at.vertex + level.ends_of(i).len()).max()?;
    let nearest = level.nodes.clone().map(|i| arena[i].at.vertex).min()?;
    // The second arc reaches about as far as the arcs of this level do.
    let span = (farthest - nearest).max(MAX_END_VERTICES);
    let stride = span.div_ceil(MAX_END_VERTICES);
    let mut best: Option<(f64, usize, [ChainJoint; 2])> = None;
    for i in level.nodes.clone() {
        let node = &arena[i].at;
        let ends = level.ends_of(i);
        let first = last.saturating_sub(span).max(node.vertex + 1);
        let beyond = (node.vertex + ends.len() + 1).min(last);
        for vertex in (first..beyond).rev().step_by(stride) {
            let end = &ends[vertex - node.vertex - 1];
            for kappa in closing_curvatures(&node.frame, end.lo, end.hi, end.at, goal) {
                let middle = node.frame.end_over(kappa, end.at);
                let Some(second) = second_margin(tube, &middle, vertex, goal) else { continue };
                let chords = [node.frame.joint.distance(middle.joint), middle.joint.distance(goal.joint)];
                if !(tube.allows(kappa, chords[0]) && tube.allows(1.0, chords[1])) {
                    continue;
                }
                let margin = end.margin(kappa).min(second);
                if best.as_ref().is_none_or(|b| margin > b.0) {
                    let joints = [
                        ChainJoint { vertex, frame: middle, straight: kappa == 0.0 },
                        ChainJoint { vertex: last, frame: goal, straight: false },
                    ];
                    best = Some((margin, i, joints));
                }
            }
        }
    }
    best.map(|(_, i, joints)| (i, joints.to_vec()))
}

/// Sine of the angle between the goal's tangent and that of the arc from `from` to the goal; `None` if the arc
/// turns by half a turn or more, or the angle is obtuse.
fn closing_error(from: &JointFrame, goal: JointFrame) -> Option<f64> {
    let v = from.local(goal.joint);
    if !(v.x > 0.0) {
        return None;
    }
    let tangent = from.end_tangent_at(v);
    (tangent.dot(goal.tangent) > 0.0).then(|| tangent.cross(goal.tangent))
}

/// Curvatures in `[lo, hi]` over the end vertex at `v` from which one more arc meets the goal.
fn closing_curvatures(from: &JointFrame, lo: f64, hi: f64, v: Vec2, goal: JointFrame) -> impl Iterator<Item = f64> {
    let error = move |kappa: f64| closing_error(&from.end_over(kappa, v), goal);
    let at = move |i: usize| lo + (hi - lo) * (i as f64 / SUBINTERVALS as f64);
    let width = f64::EPSILON / from.joint.distance(goal.joint);
    let mut before = error(at(0));
    (0..SUBINTERVALS).filter_map(move |i| {
        let after = error(at(i + 1));
        let signs = before.zip(after);
        before = after;
        let (a, b) = signs?;
        if (a < 0.0) == (b < 0.0) {
            return None;
        }
        let root = roots::bracketed(|k| error(k).unwrap_or(0.0), at(i), at(i + 1), width);
        error(root).filter(|e| e.abs() < MAX_CLOSING_ANGLE).map(|_| root)
    })
}

/// How deep the exact arc to the goal lies inside its interval; `None` if it is outside.
fn second_margin(tube: &Tube<'_>, from: &JointFrame, vertex: usize, goal: JointFrame) -> Option<f64> {
    let kappa = curvature_to(from.local(goal.joint));
    let mut sweep = tube.sweep_from(from, vertex);
    for next in vertex + 1..=tube.last() {
        tube.advance(&mut sweep, from, next).filter(|_| sweep.lo <= kappa && kappa <= sweep.hi)?;
    }
    Some((kappa - sweep.lo).min(sweep.hi - kappa) / (sweep.hi - sweep.lo).max(f64::MIN_POSITIVE))
}

/// A closed chain over the distinct points of a closed polyline: the vertex it starts at, and its joints, with
/// vertices counted from there; the last joint is the first. `Err` is the vertex where the search died.
pub(super) fn closed_chain(
    points: &[Point2],
    trace: &Trace,
    tolerance: f64,
    limits: ArcLimits,
    size: BeamSize,
    seams: &[f64],
) -> Result<(usize, Vec<ChainJoint>), usize> {
    let n = points.len();
    let around = |from: usize| Run::new(points, trace, from..=from + n);
    let run = around(0);
    let tube = run.tube(tolerance, limits);
    let open = search(&tube, &tube.start_fan(), Goal::Point, size).map_err(|v| v % n)?;
    let mut best: Option<(usize, Vec<ChainJoint>)> = None;
    let mut died = 0;
    for cells in [size.cells, 2 * size.cells] {
        for fraction in seams {
            let seam = open[((open.len() - 1) as f64 * fraction).round() as usize];
            let run = around(seam.vertex);
            let tube = run.tube(tolerance, limits);
            match search(&tube, &[seam.frame], Goal::Joint(seam.frame), BeamSize { cells, ..size }) {
                Ok(joints) if best.as_ref().is_none_or(|b| joints.len() < b.1.len()) => {
                    best = Some((seam.vertex % n, joints));
                }
                Ok(_) => {}
                Err(vertex) => died = (seam.vertex + vertex) % n,
            }
        }
        if best.is_some() {
            break;
        }
    }
    best.ok_or(died)
}
