//! Which points a fair fit keeps as corners, and which edges of their polyline it keeps to: what outlines are read as
//! (`docs/math/arc-fitting.md#outlines`), by the same rule as fits of arcs.

use super::options::FairFitOptions;
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::outline::{CORNER_ANGLE, Outline, Scattered};

/// Places on a straight side, at least and at most.
const PLACES: [f64; 2] = [3.0, 64.0];

/// Edges of an outline are at least this many tolerances long, half of them.
const LONG: f64 = 6.0;
/// Among points that are closer together, those beside a corner are this many median edges apart.
const APART: f64 = 4.0;
/// A gap is this many times as long as the median of so many edges on either side.
const GAP: f64 = 6.0;
const ROUND: usize = 5;
/// Straight sides that turn by more than this make a corner: one degree.
const SOME_TURN: f64 = CORNER_ANGLE / 30.0;
/// The neighbors of an outlier are closer to each other than this part of the edge to it.
const SPIKE: f64 = 0.5;
/// At an outlier a polyline turns by more than this, and by less than a part of it in all. One in so many points may be one, of
/// so many at least.
const SPIKE_TURN: f64 = 0.5;
const SPIKE_REST: f64 = 0.4;
const FEW_SPIKES: usize = 10;
/// The points beside it are between these many usual edges apart: those beside a thin tooth are closer together.
const SPREAD: [f64; 2] = [0.33, 32.0];
const FEWEST_TO_TELL: usize = 20;
/// Legs of a corner, in tolerances: points in the tolerance of a smooth curve turn its direction by less than a quarter
/// of a radian over them.
const LEGS: f64 = 8.0;
/// With legs half as long a corner keeps this part of its turn; a circle keeps half.
const SHARP: f64 = 0.75;

/// Corners in ascending order, with their turn, and the straight sides. The ends of an open polyline are no corners.
///
/// `forced` are asked for by index, ascending. The others are corners at the scale of the tolerance too, and no bends:
/// else every dense noisy line would have some. Points closer together than
/// some tolerances hold a curve themselves, and their turns may be noise: of them none are corners but those asked for, and
/// those between edges so long that noise within the tolerance turns them by less.
pub(super) fn outline(points: &[Point3], forced: &[usize], options: &FairFitOptions, tolerance: f64) -> Outline {
    let is_forced = |i: usize| forced.binary_search(&i).is_ok();
    let n = points.len();
    let mut lengths: Vec<f64> = (0..n - 1).map(|i| points[i].distance(points[i + 1])).collect();
    let usual = *lengths.select_nth_unstable_by((n - 1) / 2, f64::total_cmp).1;
    let is_dense = usual < LONG * tolerance;
    let scattered = if options.noise.is_some() || is_dense { Scattered::Noise } else { Scattered::Vertices };
    let mut outline =
        Outline::read(points, options.closed, tolerance.min(f64::MAX), options.corner_angle, forced, scattered);
    // Noise within the tolerance turns no edges by so much that are as long as these.
    let length = |i: usize| points[i].distance(points[(i + 1) % n]);
    let evident =
        |(i, turn): (usize, f64)| length((i + n - 1) % n).min(length(i)) * (0.5 * turn).sin() > 2.0 * tolerance;
    let turn = |i: usize| (points[i] - points[(i + n - 1) % n]).angle(points[(i + 1) % n] - points[i]);
    if options.corner_angle.is_none() && is_dense {
        // Where the points beside one are next to each other, it is an outlier.
        let beside = |i: usize| points[(i + n - 1) % n].distance(points[(i + 1) % n]);
        let is_corner = |corner: (usize, f64)| evident(corner) && beside(corner.0) > APART * usual;
        outline.corners.retain(|corner| is_forced(corner.0) || is_corner(*corner));
        // Straight runs of exact points are what is meant, however far the curve may be from them.
        if options.noise.is_none() {
            outline.corners.extend(outline.firm.iter().map(|i| (*i, turn(*i))));
        }
        outline.corners.sort_unstable_by_key(|corner| corner.0);
        outline.corners.dedup_by_key(|corner| corner.0);
        // In an outline a long edge among short ones is a side too where samples would turn over it by less than the
        // tolerance sees: nothing else holds the curve there.
        let is_side = |i: usize, outline: &Outline| {
            let long = length(i) >= LONG * tolerance;
            long && (outline.straight[i] || (outline.bound[i] && length(i) > APART * usual))
        };
        outline.straight = (0..n).map(|i| is_side(i, &outline)).collect();
        return outline;
    }
    if options.corner_angle.is_none() {
        // No smooth curve keeps to two straight sides that meet, unless they turn by little.
        let meets = |i: &usize| outline.straight[(i + n - 1) % n] && outline.straight[*i];
        let all = if options.closed { 0..n } else { 1..n - 1 };
        let is_corner = |i: usize| outline.corners.binary_search_by_key(&i, |c| c.0).is_ok();
        let more: Vec<(usize, f64)> = all
            .filter(meets)
            .filter(|i| !is_corner(*i))
            .map(|i| (i, turn(i)))
            .filter(|c| c.1 > SOME_TURN && evident(*c))
            .collect();
        outline.corners.extend(more);
        outline.corners.sort_unstable_by_key(|c| c.0);
    }
    let turn_over = |i: usize, length: f64| {
        let [before, after] = [false, true].map(|forward| leg(points, i, length, options.closed, forward));
        before.zip(after).map_or(0.0, |(before, after)| (points[i] - before).angle(after - points[i]))
    };
    let legs = LEGS * tolerance;
    // The turn of a bend grows with the legs, that of a corner does not.
    let lasting = |i: usize| {
        let long = turn_over(i, legs);
        long > options.corner_angle.unwrap_or(CORNER_ANGLE) && turn_over(i, 0.5 * legs) > SHARP * long
    };
    outline.corners.retain(|corner| is_forced(corner.0) || evident(*corner) || lasting(corner.0));
    outline
}

/// The median length of some edges that come before or after one; closed data go on past their seam.
fn usual_beside(points: &[Point3], closed: bool, edge: usize, forward: bool) -> Option<f64> {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let at = |k: usize| if forward { (edge + k) % n } else { (edge + n - k) % n };
    let inside = |k: &usize| closed || (if forward { edge + k < edges } else { *k <= edge });
    let length = |i: usize| points[i].distance(points[(i + 1) % n]);
    let mut lengths: Vec<f64> = (1..=ROUND.min(n - 1)).filter(inside).map(|k| length(at(k))).collect();
    lengths.sort_by(f64::total_cmp);
    lengths.get(lengths.len() / 2).copied()
}

/// The edges that are far longer than those round them, on both sides.
pub(super) fn gaps(points: &[Point3], closed: bool) -> Vec<bool> {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let is_gap = |i: usize| {
        let beside = [false, true].into_iter().filter_map(|forward| usual_beside(points, closed, i, forward));
        let usual = beside.fold(0.0, f64::max);
        usual > 0.0 && points[i].distance(points[(i + 1) % n]) > GAP * usual
    };
    (0..n).map(|i| i < edges && is_gap(i)).collect()
}

/// The runs of wrong points without those among corners, which are corners of the figure too.
pub(super) fn without_figures(
    points: &[Point3],
    closed: bool,
    bursts: Vec<usize>,
    corners: &[(usize, f64)],
) -> Vec<usize> {
    let n = points.len();
    let is_corner = |i: usize| corners.binary_search_by_key(&(i % n), |c| c.0).is_ok();
    let is_wrong = |i: usize| bursts.binary_search(&(i % n)).is_ok();
    // From one of them on, past the point beside the run: the edge to the run turns it.
    let beyond = |i: usize, step: usize| {
        let rest = (0..n).map(|k| i + k * step).skip_while(|i| is_wrong(*i)).skip(1);
        rest.take(ROUND).take_while(|i| closed || (*i % n > 0 && *i % n < n - 1)).filter(|i| is_corner(*i)).count()
    };
    let is_figure = |i: &usize| 2 * beyond(*i, 1).max(beyond(*i + n, n - 1)) > ROUND;
    bursts.iter().filter(|i| !is_figure(i)).copied().collect()
}

/// The sides without those that wrong points make: a single one, whose neighbors are close to each other, and runs of some,
/// `bursts`.
pub(super) fn without_spikes(points: &[Point3], closed: bool, straight: &[bool], bursts: &[usize]) -> Vec<bool> {
    let n = points.len();
    let is_spike = |i: usize, length: f64| {
        let inside = closed || (i > 0 && i + 1 < n);
        let alone = inside && points[(i + n - 1) % n].distance(points[(i + 1) % n]) < SPIKE * length;
        alone || bursts.binary_search(&i).is_ok()
    };
    let is_side = |i: usize| {
        let next = (i + 1) % n;
        let length = points[i].distance(points[next]);
        straight[i] && !is_spike(i, length) && !is_spike(next, length)
    };
    (0..n).map(is_side).collect()
}

/// Single points off a polyline that goes on past them as if they were not there, with their neighbors, rising: it turns away,
/// back, and away again, by nothing in all. Of single ones none if they are many: then it is the figure that does so. And runs of
/// wrong points, `bursts`, with their neighbors too.
pub(super) fn spikes(points: &[Point3], closed: bool, bursts: &[usize]) -> Vec<usize> {
    let n = points.len();
    if n < FEWEST_TO_TELL {
        return Vec::new();
    }
    let at = |i: usize| points[i % n];
    let turn = |i: usize| {
        let (u, v) = (at(i) - at(i + n - 1), at(i + 1) - at(i));
        u.cross(v).unit().map_or(Vec3::ZERO, |axis| axis * u.angle(v))
    };
    let turns: Vec<Vec3> = (0..n).map(turn).collect();
    let range = if closed { 0..n } else { 3..n.saturating_sub(3) };
    // The points beside a wrong one are about as close together as those beyond them, and the polyline goes on over them: else it
    // is a corner between sides.
    let goes_on = |i: usize, size: f64| {
        let [far, before, after, beyond] = [n - 2, n - 1, 1, 2].map(|k| at(i + k));
        let over = after - before;
        let turn = (before - far).angle(over).max(over.angle(beyond - after));
        let beside = [((i + n - 1) % n, false), (i, true)];
        let usual = beside.into_iter().filter_map(|(edge, forward)| usual_beside(points, closed, edge, forward));
        let (least, most) = usual.fold((f64::INFINITY, 0.0_f64), |(least, most), h| (least.min(h), most.max(h)));
        turn < SPIKE * size && over.length() < SPREAD[1] * least && over.length() > SPREAD[0] * most
    };
    let is_spike = |i: &usize| {
        let [far, before, own, after, beyond] = [n - 2, n - 1, 0, 1, 2].map(|k| turns[(i + k) % n]);
        let size = own.length();
        size > SPIKE_TURN
            && before.dot(own) < 0.0
            && after.dot(own) < 0.0
            && (before + own + after).length() < SPIKE_REST * size
            && far.length().max(beyond.length()) < SPIKE * size
            && goes_on(*i, size)
    };
    let found: Vec<usize> = range.filter(is_spike).collect();
    let found = if found.len() * FEW_SPIKES > n { Vec::new() } else { found };
    let all = found.into_iter().chain(bursts.iter().copied());
    let mut all: Vec<usize> = all.flat_map(|i| [(i + n - 1) % n, i, (i + 1) % n]).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// The nearest point along the polyline that is a leg's length away; without one, the last on that side.
fn leg(points: &[Point3], corner: usize, length: f64, closed: bool, forward: bool) -> Option<Point3> {
    let n = points.len();
    let far = |p: &Point3| p.distance(points[corner]) >= length;
    let steps = match (closed, forward) {
        (true, _) => n / 2,
        (false, true) => n - 1 - corner,
        (false, false) => corner,
    };
    let at = |k: usize| points[if forward { corner + k } else { corner + n - k } % n];
    (1..=steps).map(at).find(far).or_else(|| (steps > 0).then(|| at(steps)))
}

/// How many places the curve is held to on each edge, so that it keeps to the straight sides. If it is held to places on all
/// edges, those that are far longer than the others count as such.
pub(super) fn places_on_edges(points: &[Point3], straight: &[bool], options: &FairFitOptions) -> Vec<usize> {
    let n = points.len();
    let length = |i: usize| points[i].distance(points[(i + 1) % n]);
    let mut others: Vec<f64> = (0..n).filter(|i| !straight[*i]).map(length).collect();
    others.sort_by(f64::total_cmp);
    let usual = others.get(others.len() / 2).copied().unwrap_or(f64::INFINITY);
    let least = options.edge_points;
    let is_held = |i: usize| straight[i] || (least > 0 && length(i) > APART * usual);
    // As many as make them as dense at its ends as the samples beside it.
    let beside = |i: usize| {
        let around = [(i + n - 1) % n, (i + 1) % n].into_iter().filter(|k| !straight[*k]).map(length);
        around.fold(usual, f64::min)
    };
    let places = |i: usize| (2.0 * (length(i) / beside(i)).sqrt()).clamp(PLACES[0], PLACES[1]) as usize;
    (0..n).map(|i| if is_held(i) { places(i).max(least) } else { least }).collect()
}
