//! One smooth piece from its data to its nodes: start, first fit, insertion, removal, polish
//! (`docs/math/fair-fits.md#nodes`).

use super::density;
use super::feet::COLD;
use super::fit::{Data, Fit, Patience, fewest_nodes};
use super::places::Remap;
use super::removal::{RemovalLimits, Stop, remove};
use super::tube_curve::TubeCurve;
use super::whittaker::{Smoothed, smooth};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::diameter;
use crate::construct::curves::canonical_start::canonical_start;

/// Rounds of insertion where the first nodes do not reach the data.
const INSERTIONS: usize = 12;
/// The start keeps to the tolerance, and to this part of the size of the data: smoothed over more a closed figure shrinks
/// to its center.
const START_SIZE: f64 = 0.1;
/// Smoothed over less than this part of their size the data keep their length but for noise.
const SHAPE_SIZE: f64 = 1.0 / 32.0;
/// Data nearer to each other than this part of the tolerance tell no directions: they are left out of the start.
const THINNED: f64 = 0.25;
/// Fewer points than this are not thinned further.
const FEWEST: usize = 64;
/// Samples of the smoothed data for the density of nodes, in lengths of the smoother.
const SAMPLES: f64 = 0.5;
/// `J L⁵/T²` below which a curve is as good as straight (`docs/math/fair-fits.md#interior-point`).
const FLOOR: f64 = 3e4;

/// How a run ends.
pub(super) enum Outcome {
    Reached(Reached),
    /// Data outside the tolerance after all insertions, and how far the farthest is.
    Missed {
        outside: Vec<usize>,
        farthest: f64,
    },
}

/// A curve in the tolerance of its data.
pub(super) struct Reached {
    pub fit: Fit,
    /// Why it has no fewer nodes.
    pub stop: Stop,
    /// Nodes before any was taken out.
    pub first: usize,
    /// Length of the data without their noise.
    pub length: f64,
}

/// `J` below which a curve counts as straight (`docs/math/fair-fits.md#interior-point`).
pub(super) fn floor(points: &[Point3], closed: bool, tolerance: f64) -> f64 {
    let chosen = thinned(points, closed, tolerance);
    let length: f64 = chords(&points_of(points, &chosen), closed).iter().sum();
    FLOOR * tolerance * tolerance / length.powi(5)
}

/// Fits one piece. Closed data are fitted from the datum they single out themselves, and the curve starts near the first
/// one all the same.
pub(super) fn run(data: &Data<'_>, limits: &RemovalLimits) -> Outcome {
    let start = if data.closed { canonical_start(data.points) } else { 0 };
    let turned = [&data.points[start..], &data.points[..start]].concat();
    match run_in_order(&Data { points: &turned, ..*data }, limits) {
        Outcome::Reached(mut reached) => {
            reached.fit.turn_back(start);
            Outcome::Reached(reached)
        }
        Outcome::Missed { outside, farthest } => {
            let mut outside: Vec<usize> = outside.into_iter().map(|i| (i + start) % data.points.len()).collect();
            outside.sort_unstable();
            Outcome::Missed { outside, farthest }
        }
    }
}

impl Fit {
    /// Gives a closed fit to data that were turned by `start` the order they had, with its first node beside the first
    /// datum.
    fn turn_back(&mut self, start: usize) {
        let n = self.curve.nodes.len();
        if !self.curve.closed {
            return;
        }
        self.feet.rotate_right(start);
        let first = self.feet.first().map_or(0, |f| f.place.position().round() as usize % n);
        self.curve.nodes.rotate_left(first);
        self.curve.tangents.rotate_left(first);
        self.curve.segments.rotate_left(first);
        for foot in &mut self.feet {
            foot.place.segment = (foot.place.segment + n - first) % n;
        }
    }
}

fn run_in_order(data: &Data<'_>, limits: &RemovalLimits) -> Outcome {
    let wide = START_SIZE * diameter(data.points);
    let start = &Data { tolerance: data.tolerance.min(wide), ..*data };
    let first = Patience { steps: 12, change: 2e-3, grow: true };
    let (smoothed, chosen) = smoothed(start, thinned(data.points, data.closed, start.tolerance));
    let length = shape_length(start, &smoothed);
    let Some(mut fit) = first_curve(start, &smoothed, &chosen).map(|fit| fit.fairest(data, first)) else {
        return Outcome::Missed { outside: (0..data.points.len()).collect(), farthest: diameter(data.points) };
    };
    for _ in 0..INSERTIONS {
        if fit.feasible(data) {
            break;
        }
        let Some(more) = with_more_nodes(data, &fit) else { break };
        fit = more.fairest(data, first);
    }
    if !fit.feasible(data)
        && let Some(dense) = dense_start(start, &smoothed, &chosen).map(|fit| fit.fairest(data, first))
        && dense.farthest < fit.farthest
    {
        fit = dense;
    }
    if !fit.feasible(data) {
        return Outcome::Missed { outside: fit.outside(data).map(|(i, _)| i).collect(), farthest: fit.farthest };
    }
    let first = fit.curve.nodes.len();
    if limits.fits == 0 {
        return Outcome::Reached(Reached { fit, stop: Stop::Fits, first, length });
    }
    let (fit, stop) = remove(data, fit, limits);
    let polished = fit.clone().fairest(data, Patience { steps: 12, change: 3e-4, grow: true });
    let scale = fit.fairness.max(data.floor);
    let better = polished.feasible(data) && polished.objective(data, scale) < fit.objective(data, scale);
    Outcome::Reached(Reached { fit: if better { polished } else { fit }, stop, first, length })
}

/// Length of the data, smoothed as the start was, or less where that takes their shape.
fn shape_length(start: &Data<'_>, as_start: &Smoothed) -> f64 {
    let fine = SHAPE_SIZE * diameter(start.points);
    let length = |points: &[Point3]| chords(points, start.closed).iter().sum();
    if start.tolerance <= fine {
        return length(&as_start.points);
    }
    let finer = Data { tolerance: fine, ..*start };
    length(&smoothed(&finer, thinned(start.points, start.closed, fine)).0.points)
}

/// The curve a fit starts from: through the nodes that the density asks for, else through all smoothed data, else through
/// fewer and fewer of them, as where the data turn back on themselves, and at last a circle or a line among them.
fn first_curve(data: &Data<'_>, smoothed: &Smoothed, chosen: &[usize]) -> Option<Fit> {
    let fewer = || {
        let strides = std::iter::successors(Some(2), |stride| Some(2 * stride));
        strides
            .map(|stride| every(chosen.len(), stride, data.closed))
            .take_while(|kept| kept.len() > fewest_nodes(data.closed))
            .find_map(|kept| start(data, &smoothed.points, chosen, kept.into_iter().map(|k| k as f64).collect()))
    };
    let plain = || {
        let points = plain_figure(data, chosen.len());
        let nodes = if data.closed { 8.min(chosen.len()) } else { 2 };
        let last = if data.closed { chosen.len() } else { chosen.len() - 1 };
        let steps = if data.closed { nodes } else { nodes - 1 };
        start(data, &points, chosen, (0..nodes).map(|i| (i * last) as f64 / steps as f64).collect())
    };
    sparse_start(data, smoothed, chosen).or_else(|| dense_start(data, smoothed, chosen)).or_else(fewer).or_else(plain)
}

/// Points on a circle about the middle of closed data, on a line from the first of open data to the one farthest from it.
fn plain_figure(data: &Data<'_>, count: usize) -> Vec<Point3> {
    let first = data.points[0];
    let offsets = || data.points.iter().map(|p| *p - first);
    let centre = first + offsets().fold(Vec3::ZERO, |sum, v| sum + v) / data.points.len() as f64;
    let radius = 0.25 * diameter(data.points);
    let far = offsets().fold(Vec3::ZERO, |far, v| if v.length() > far.length() { v } else { far });
    let at = |i: usize| {
        if data.closed {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / count as f64).sin_cos();
            centre + Vec3::new(cos, sin, 0.0) * radius
        } else {
            first + far * (i as f64 / (count - 1) as f64)
        }
    };
    (0..count).map(at).collect()
}

/// Through a node for each of the smoothed data the curve is in the tube already, if there is such a curve.
fn dense_start(data: &Data<'_>, smoothed: &Smoothed, chosen: &[usize]) -> Option<Fit> {
    start(data, &smoothed.points, chosen, (0..chosen.len()).map(|i| i as f64).collect())
}

/// The data of the start, smoothed.
fn smoothed(data: &Data<'_>, mut chosen: Vec<usize>) -> (Smoothed, Vec<usize>) {
    loop {
        let points = points_of(data.points, &chosen);
        let smoothed = smooth(&points, &chords(&points, data.closed), data.closed, data.fixed, data.tolerance);
        // Data so dense that not even the stiffest smoother feels them: fewer say the same.
        if !smoothed.stiffest || chosen.len() < FEWEST {
            return (smoothed, chosen);
        }
        chosen = every(chosen.len(), 2, data.closed).into_iter().map(|k| chosen[k]).collect();
    }
}

/// Every so many-th of a number of points: the same ones counted backwards, the ends of open data among them.
fn every(count: usize, stride: usize, closed: bool) -> Vec<usize> {
    let total = if closed { count } else { count - 1 };
    let steps = total.div_ceil(stride);
    // An even number of steps would end half way, where an odd number of places has none.
    let steps = if total % 2 == 1 { steps | 1 } else { steps };
    let at = |i: usize| if 2 * i <= steps { i * total / steps } else { total - (steps - i) * total / steps };
    (0..if closed { steps } else { steps + 1 }).map(at).collect()
}

/// The fair spline through the nodes that the density of the smoothed data asks for.
fn sparse_start(data: &Data<'_>, smoothed: &Smoothed, chosen: &[usize]) -> Option<Fit> {
    // Differences over less than the smoother's length would find what it left of the noise.
    let mean = chords(&smoothed.points, data.closed).iter().sum::<f64>() / chosen.len() as f64;
    let stride = ((SAMPLES * smoothed.length / mean) as usize).clamp(1, (chosen.len() / FEWEST).max(1));
    let kept = every(chosen.len(), stride, data.closed);
    let points: Vec<Point3> = kept.iter().map(|k| smoothed.points[*k]).collect();
    let chosen: Vec<usize> = kept.iter().map(|k| chosen[*k]).collect();
    start(data, &points, &chosen, density::places(&points, data.closed, data.tolerance))
}

/// The fair spline through nodes at positions on smoothed points, which stand for the data `chosen`.
fn start(data: &Data<'_>, smoothed: &[Point3], chosen: &[usize], positions: Vec<f64>) -> Option<Fit> {
    let nodes = positions.iter().map(|p| density::point_at(smoothed, data.closed, *p)).collect();
    let curve = TubeCurve::new(nodes, data.closed, None)?;
    let remap = Remap::new(chords(smoothed, data.closed).into_iter(), data.closed, &positions);
    let near = (0..data.points.len()).map(|i| {
        // Between two chosen data by their number.
        let k = chosen.partition_point(|c| *c <= i) - 1;
        let next = chosen.get(k + 1).copied().unwrap_or(data.points.len());
        remap.place(k as f64 + (i - chosen[k]) as f64 / (next - chosen[k]) as f64)
    });
    Some(Fit::new(data, curve, near, COLD))
}

fn points_of(points: &[Point3], chosen: &[usize]) -> Vec<Point3> {
    chosen.iter().map(|i| points[*i]).collect()
}

/// Indices of the data the start is made of: none much nearer to the one before than the tolerance. Chosen from both
/// ends (of a closed curve: both ways from its first point) to the middle, so that reversed data give the same ones.
fn thinned(p: &[Point3], closed: bool, tolerance: f64) -> Vec<usize> {
    let limit = (THINNED * tolerance).powi(2);
    let at = |i: usize| p[i % p.len()];
    let apart = |i: usize, k: usize| (at(i) - at(k)).length_squared() >= limit;
    let total = if closed { p.len() } else { p.len() - 1 };
    let along = |from: usize, rest: &mut dyn Iterator<Item = usize>| {
        rest.fold(vec![from], |mut kept, i| {
            if apart(i, kept[kept.len() - 1]) {
                kept.push(i);
            }
            kept
        })
    };
    let mut chosen = along(0, &mut (1..=total / 2));
    let mut back = along(total, &mut (total.div_ceil(2)..total).rev());
    let (middle, other) = (chosen[chosen.len() - 1], back[back.len() - 1]);
    if middle == other {
        back.pop();
    } else if !apart(middle, other) {
        // Neither of the two has more right to stay.
        chosen.truncate((chosen.len() - 1).max(1));
        back.truncate((back.len() - 1).max(1));
    }
    // The end of a closed curve is its first point again.
    chosen.extend(back.into_iter().rev().filter(|i| *i < p.len()));
    // A figure no larger than the tolerance: some of its points.
    if chosen.len() < 8 { every(p.len(), p.len().div_ceil(8), closed) } else { chosen }
}

fn chords(points: &[Point3], closed: bool) -> Vec<f64> {
    let n = points.len();
    (0..if closed { n } else { n - 1 }).map(|j| (points[(j + 1) % n] - points[j]).length()).collect()
}

/// A node in the middle of the segments with data outside, the farthest first, up to a node for each datum. `None` if there
/// are that many.
fn with_more_nodes(data: &Data<'_>, fit: &Fit) -> Option<Fit> {
    let (curve, m) = (&fit.curve, fit.curve.segments.len());
    let room = data.points.len().saturating_sub(curve.nodes.len());
    let mut missed = vec![0.0_f64; m];
    for (_, foot) in fit.outside(data) {
        let missed = &mut missed[foot.place.segment];
        *missed = missed.max(foot.error.length_squared());
    }
    let mut order: Vec<usize> = (0..m).filter(|j| missed[*j] > 0.0).collect();
    order.sort_by(|a, b| missed[*b].total_cmp(&missed[*a]).then(a.cmp(b)));
    order.truncate(room);
    if order.is_empty() {
        return None;
    }
    let mut split = vec![false; m];
    order.into_iter().for_each(|j| split[j] = true);
    let (mut nodes, mut positions) = (Vec::new(), Vec::new());
    for (j, segment) in curve.segments.iter().enumerate() {
        nodes.push(curve.nodes[j]);
        positions.push(j as f64);
        if split[j] {
            nodes.push(segment.point(0.5).point);
            positions.push(j as f64 + 0.5);
        }
    }
    if !data.closed {
        nodes.push(curve.nodes[m]);
        positions.push(m as f64);
    }
    let remap = Remap::new(curve.segments.iter().map(|s| s.chord), data.closed, &positions);
    let curve = TubeCurve::new(nodes, data.closed, None)?;
    Some(Fit::new(data, curve, fit.feet.iter().map(|f| remap.place(f.place.position())), COLD))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fewer_points_are_the_same_counted_backwards() {
        for (count, stride) in [(2, 1), (2, 5), (10, 2), (11, 3), (12, 3), (100, 7), (101, 2), (300, 3), (301, 3)] {
            let open = every(count, stride, false);
            assert_eq!((open[0], open[open.len() - 1]), (0, count - 1));
            let backwards: Vec<usize> = open.iter().rev().map(|i| count - 1 - i).collect();
            assert_eq!(open, backwards, "{count} {stride}");
            let ring = every(count, stride, true);
            let mut backwards: Vec<usize> = ring.iter().map(|i| (count - i) % count).collect();
            backwards.sort_unstable();
            assert_eq!(ring, backwards, "{count} {stride}");
        }
    }
}
