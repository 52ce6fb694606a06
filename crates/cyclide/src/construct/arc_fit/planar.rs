//! The fit in a plane: one circle or arc if it does, else the tube beam, piece by piece between corners.

use super::beam::{Goal, Tube, search};
use super::closing;
use super::corners::{rounding_reach, turns};
use super::options::{ArcFitOptions, FitTarget};
use super::single::{single_arc, single_circle};
use super::trace::{Chain, Trace};
use crate::base::frame::Frame;
use crate::base::planar::Point2;
use crate::base::vector::Point3;

/// Extra points per edge tried one after the other when the edges themselves are meant.
const EXTRA_POINTS: [usize; 3] = [1, 2, 3];

/// The chains between corners over a trace of the polyline; the error is the position among `points` where the
/// search died.
pub(super) fn fit(
    points: &[Point3],
    corners: &[usize],
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
) -> Result<(Trace, Vec<Chain>), usize> {
    if options.target == FitTarget::Points {
        let trace = Trace::of_points(points, options.closed);
        return fit_trace(&trace, corners, frame, tolerance, options).map(|chains| (trace, chains));
    }
    let mut died = 0;
    for extra in EXTRA_POINTS {
        let trace = densified(points, options, extra);
        let at: Vec<usize> = corners.iter().map(|c| trace.position_of(*c)).collect();
        match fit_trace(&trace, &at, frame, tolerance, options) {
            Ok(chains) => return Ok((trace, chains)),
            Err(vertex) => died = vertex,
        }
    }
    Err(died)
}

fn fit_trace(
    trace: &Trace,
    corners: &[usize],
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
) -> Result<Vec<Chain>, usize> {
    let flat: Vec<Point2> = trace.points.iter().map(|p| frame.to_local(*p).0).collect();
    let n = flat.len();
    let edges = options.target == FitTarget::Polyline;
    let size = options.effort.beam();
    let source = |died: usize| trace.vertex_before(died % n);
    if options.closed && corners.is_empty() {
        if let Some(joints) = single_circle(&flat, tolerance, edges) {
            return Ok(vec![Chain { first: 0, joints }]);
        }
        let (first, joints) =
            closing::closed_chain(&flat, tolerance, edges, size, options.effort.seams()).map_err(source)?;
        return Ok(vec![Chain { first, joints }]);
    }
    let piece = |(from, to): (usize, usize)| {
        let run: Vec<Point2> = (from..=to).map(|i| flat[i % n]).collect();
        if let Some(joints) = single_arc(&run, tolerance, edges) {
            return Ok(Chain { first: from, joints });
        }
        let tube = Tube::new(&run, tolerance, edges);
        let joints = search(&tube, &tube.start_fan(), Goal::Point, size).map_err(|died| source(from + died))?;
        Ok(Chain { first: from, joints })
    };
    trace.runs(corners).into_iter().map(piece).collect()
}

/// The polyline with extra points on its edges for joints to sit over: `extra` uniform ones, and those where the
/// rounding of the turns at the two ends can begin.
fn densified(points: &[Point3], options: &ArcFitOptions, extra: usize) -> Trace {
    let n = points.len();
    let turns = turns(points, options.closed);
    let mut trace = Trace::empty(options.closed);
    for (i, p) in points.iter().enumerate() {
        trace.push(*p, Some(i));
        if i + 1 == n && !options.closed {
            break;
        }
        let (next, end) = (points[(i + 1) % n], (i + 1) % n);
        let length = p.distance(next);
        let reach = |turn: f64| (0.5 * rounding_reach(turn, options.tolerance) / length).min(1.0);
        let mut at: Vec<f64> = (1..=extra).map(|j| j as f64 / (extra + 1) as f64).collect();
        at.extend([reach(turns[i]), 1.0 - reach(turns[end])].into_iter().filter(|t| *t > 0.01 && *t < 0.99));
        at.sort_by(f64::total_cmp);
        at.dedup_by(|a, b| *a - *b < 0.02);
        for t in at {
            trace.push(p.lerp(next, t), None);
        }
    }
    trace
}
