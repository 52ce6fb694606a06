//! The fit in a plane: one circle or arc if it does, else the tube beam, piece by piece between corners.

use super::beam::{Goal, Run, search};
use super::closing;
use super::corners::{rounding_reach, sagitta_quantile, turns};
use super::options::{ArcFitOptions, Effort, FitTarget};
use super::single::{single_arc, single_circle};
use super::trace::{Chain, Trace};
use crate::base::frame::Frame;
use crate::base::planar::Point2;
use crate::base::vector::Point3;
use crate::construct::curves::outline::Outline;

/// Most extra points per edge; tried one number after the other until a chain is found.
const MAX_EXTRA_POINTS: usize = 3;
/// If the sagitta of most edges (this fraction of them) is below this part of the tolerance, samples are dense
/// enough for joints over samples alone.
const DENSE_FRACTION: f64 = 0.9;
const DENSE_SAGITTA: f64 = 0.1;
/// Where on the legs of a turn a joint is offered, as a part of the farthest place a rounding can begin: there its
/// arc has room to either side. (At half of it the only arc is tangent to the leg.)
const ROUNDING_PLACE: f64 = 0.75;
/// Ratio of the distances of further joints from that turn.
const GRADING: f64 = 3.0;
/// With a least radius places are closer to the ends of an edge by this factor, and by this ratio farther and farther from them.
const CLOSER: f64 = 0.5;
const WIDER: f64 = 1.4;
/// At most this many of them: the ratio of a long edge to a tolerance near its rounding.
const MAX_GRADES: usize = 24;
/// Between samples the curve may leave the edge by this part of edge length times turn: twice the sagitta of a
/// circle.
const EDGE_SLACK: f64 = 0.25;
/// A turn stands alone if those at this many vertices to either side are at most this part of it.
const STRAIGHT_EDGES: usize = 2;
const STRAIGHT: f64 = 0.05;
/// and the curve might leave its edges by more than this part of the tolerance.
const MATTERS: f64 = 0.1;
/// Places for joints at least on edges that are meant: where a rounding may begin farther off than the edge is long.
const MEANT_PLACES: usize = 3;

/// The chains between corners over a trace of the polyline; the error is the position among `points` where the
/// search died.
pub(super) fn fit(
    points: &[Point3],
    outline: &Outline,
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
    effort: Effort,
) -> Result<(Trace, Vec<Chain>), usize> {
    let corners: &[usize] = &outline.corners.iter().map(|c| c.0).collect::<Vec<_>>();
    let dense = sagitta_quantile(points, options.closed, DENSE_FRACTION) < DENSE_SAGITTA * tolerance;
    let fewest = match options.target {
        FitTarget::Polyline => 1,
        FitTarget::Points if dense => 0,
        FitTarget::Points => effort.extra_points(),
    };
    // Within a part of the tolerance, with the places that suit it.
    let at = |part: f64| {
        let options = &ArcFitOptions { tolerance: part * options.tolerance, ..options.clone() };
        let mut died = 0;
        for extra in fewest..=MAX_EXTRA_POINTS {
            let trace = densified(points, corners, outline, options, extra);
            let at: Vec<usize> = trace.positions_of(corners);
            match fit_trace(&trace, &at, frame, part * tolerance, options, effort) {
                Ok(chains) => return Ok((trace, chains)),
                Err(vertex) => died = vertex,
            }
        }
        Err(died)
    };
    let fit = at(1.0);
    // Between straight sides half the tolerance gives about as many arcs, and sometimes fewer.
    let has_lone = || lone_turns(points, &smooth_turns(points, corners, options.closed), options).contains(&true);
    match fit {
        Ok(fit) if options.target == FitTarget::Points && has_lone() => {
            let count = |(_, chains): &(Trace, Vec<Chain>)| chains.iter().map(|c| c.joints.len()).sum::<usize>();
            Ok(at(0.5).ok().filter(|narrower| count(narrower) < count(&fit)).unwrap_or(fit))
        }
        fit => fit,
    }
}

fn fit_trace(
    trace: &Trace,
    corners: &[usize],
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
    effort: Effort,
) -> Result<Vec<Chain>, usize> {
    let flat: Vec<Point2> = trace.points.iter().map(|p| frame.to_local(*p).0).collect();
    let n = flat.len();
    // Whether the curve is bound along the trace from one position to another, and not at its vertices alone.
    let edges =
        |mut range: std::ops::Range<usize>| options.target == FitTarget::Polyline || range.all(|i| trace.bound[i % n]);
    let size = effort.beam();
    let source = |died: usize| trace.vertex_before(died % n);
    // The points that bind as they are; the others only offer places for joints.
    let binding = |range: std::ops::RangeInclusive<usize>| -> Vec<usize> {
        range.filter(|i| trace.slack[i % n] == 0.0).collect()
    };
    let place = |indices: &[usize]| -> Vec<Point2> { indices.iter().map(|i| flat[i % n]).collect() };
    if options.closed && corners.is_empty() {
        let anchors = binding(0..=n);
        if let Some(mut joints) =
            single_circle(&place(&anchors[..anchors.len() - 1]), tolerance, edges(0..n), options.limits())
        {
            joints.iter_mut().for_each(|j| j.vertex = anchors[j.vertex]);
            return Ok(vec![Chain { first: 0, joints }]);
        }
        let (first, joints) =
            closing::closed_chain(&flat, trace, tolerance, options.limits(), size, effort.seams()).map_err(source)?;
        return Ok(vec![Chain { first, joints }]);
    }
    let piece = |(from, to): (usize, usize)| {
        let anchors = binding(from..=to);
        if let Some(mut joints) = single_arc(&place(&anchors), tolerance, edges(from..to), options.limits()) {
            joints.iter_mut().for_each(|j| j.vertex = anchors[j.vertex] - from);
            return Ok(Chain { first: from, joints });
        }
        let run = Run::new(&flat, trace, from..=to);
        let tube = run.tube(tolerance, options.limits());
        let joints = search(&tube, &tube.start_fan(), Goal::Point, size).map_err(|died| source(from + died))?;
        Ok(Chain { first: from, joints })
    };
    trace.runs(corners).into_iter().map(piece).collect()
}

/// The polyline with extra points on its edges for joints to sit over: `extra` uniform ones and, on edges that are meant
/// themselves, those where the rounding of the turns at the two ends can begin.
fn densified(points: &[Point3], corners: &[usize], outline: &Outline, options: &ArcFitOptions, extra: usize) -> Trace {
    let n = points.len();
    let turns = smooth_turns(points, corners, options.closed);
    let lone = lone_turns(points, &turns, options);
    let meant = |from: usize| {
        let lone = lone[from] || lone[(from + 1) % n];
        options.target == FitTarget::Polyline || lone || outline.straight[from]
    };
    let slack = |from: usize| {
        let end = (from + 1) % n;
        let length = points[from].distance(points[end]);
        if meant(from) || outline.bound[from] { 0.0 } else { EDGE_SLACK * length * turns[from].max(turns[end]) }
    };
    // A line over a long straight run needs its direction exactly from the start.
    let ahead = |from: usize| outline.straight[from % n] || (1..=STRAIGHT_EDGES).any(|k| lone[(from + n + 1 - k) % n]);
    let mut trace = Trace::empty(options.closed);
    for (i, p) in points.iter().enumerate() {
        trace.push(*p, i, slack((i + n - 1) % n));
        let edges = meant(i);
        if (extra == 0 && !edges) || (i + 1 == n && !options.closed) {
            continue;
        }
        let (next, end) = (points[(i + 1) % n], (i + 1) % n);
        let length = p.distance(next);
        let places = if edges { extra.max(MEANT_PLACES) } else { extra };
        let mut at: Vec<f64> = (1..=places).map(|j| j as f64 / (places + 1) as f64).collect();
        if edges {
            let reach = |turn: f64| ROUNDING_PLACE * rounding_reach(turn, options.tolerance) / length;
            let apart = options.tolerance / length;
            at.extend(graded(reach(turns[i])).filter(|t| *t > apart));
            at.extend(graded(reach(turns[end])).filter(|t| *t > apart).map(|t| 1.0 - t));
            // A rounding that has to be wider than that of the points begins on their sides.
            let wider = options.min_radius.map(|_| CLOSER * apart).into_iter().flat_map(|apart| spread(apart, WIDER));
            let apart = if options.min_radius.is_some() { CLOSER * apart } else { apart };
            at.extend(wider.flat_map(|t| [t, 1.0 - t]));
            at.sort_by(f64::total_cmp);
            at.dedup_by(|a, b| *a - *b < apart);
        }
        for t in at {
            trace.push_loose(p.lerp(next, t), slack(i));
        }
    }
    // On the edges behind the turn: points on them, and the vertices at which they end.
    let mut from = 0;
    for (place, vertex) in trace.vertex.iter().enumerate() {
        trace.straight_ahead[place] = match vertex {
            Some(vertex) => {
                from = *vertex;
                outline.straight[from] || (!lone[from] && ahead((from + n - 1) % n))
            }
            None => ahead(from),
        };
        trace.bound[place] = outline.bound[from];
    }
    trace
}

/// Turns of what runs smoothly through the vertices: at a corner nothing does.
fn smooth_turns(points: &[Point3], corners: &[usize], closed: bool) -> Vec<f64> {
    let mut turns = turns(points, closed);
    corners.iter().for_each(|corner| turns[*corner] = 0.0);
    turns
}

/// The vertices that turn between straight runs, below the angle of a corner: a curve through samples would swing out
/// over both edges to get round, and nothing else in the data asks for that. Their two edges
/// are meant as they are.
fn lone_turns(points: &[Point3], turns: &[f64], options: &ArcFitOptions) -> Vec<bool> {
    let n = points.len();
    let inside = |i: usize| options.closed || (STRAIGHT_EDGES <= i && i + STRAIGHT_EDGES < n);
    let lone = |i: usize| {
        let (before, after) = (points[(i + n - 1) % n], points[(i + 1) % n]);
        let shorter = points[i].distance(before).min(points[i].distance(after));
        let straight = |j: usize| turns[j % n] <= STRAIGHT * turns[i];
        n > 2 * STRAIGHT_EDGES
            && inside(i)
            && EDGE_SLACK * shorter * turns[i] > MATTERS * options.tolerance
            && (1..=STRAIGHT_EDGES).all(|k| straight(i + k) && straight(i + n - k))
    };
    (0..n).map(lone).collect()
}

/// Places ever farther from an end, up to the middle of the edge: each arc can then be a few times longer than the
/// one before, as the angle its tangent must keep gets finer.
fn graded(first: f64) -> impl Iterator<Item = f64> {
    spread(first, GRADING)
}

/// The same by another ratio.
fn spread(first: f64, ratio: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(first), move |t| Some(t * ratio)).take(MAX_GRADES).take_while(|t| *t < 0.5)
}
