//! One smooth piece from its data to its nodes: start, first fit, insertion, removal, polish (`66`, section 5).

use super::density;
use super::feet::COLD;
use super::fit::{Data, Fit, Patience};
use super::places::Remap;
use super::removal::{RemovalLimits, remove};
use super::tube_curve::TubeCurve;
use super::whittaker::{Smoothed, smooth};
use crate::base::vector::Point3;

/// Rounds of insertion where the first nodes do not reach the data.
const INSERTIONS: usize = 12;
/// Data nearer to each other than this part of the tolerance tell no directions: they are left out of the start.
const THINNED: f64 = 0.25;
/// Fewer points than this are not thinned further.
const FEWEST: usize = 64;
/// Samples of the smoothed data for the density of nodes, in lengths of the smoother.
const SAMPLES: f64 = 0.5;
/// `J L⁵/T²` below which a curve is as good as straight (`66`, section 3).
const FLOOR: f64 = 3e4;

/// The data of a smooth piece, in the working frame.
pub(super) struct Piece<'a> {
    pub points: &'a [Point3],
    pub closed: bool,
    pub planar: bool,
    /// The curve ends exactly at the first, the last point.
    pub fixed: [bool; 2],
    pub tolerance: f64,
    pub centre: f64,
}

/// How a run ends.
pub(super) enum Outcome {
    Reached(Fit),
    /// Data outside the tolerance after all insertions, and how far the farthest is.
    Missed {
        outside: Vec<usize>,
        farthest: f64,
    },
}

/// Fits one piece.
pub(super) fn run(piece: &Piece<'_>, limits: &RemovalLimits) -> Outcome {
    let chosen = thinned(piece.points, piece.closed, piece.tolerance);
    let length: f64 = chords(&points_of(piece.points, &chosen), piece.closed).iter().sum();
    let data = Data {
        points: piece.points,
        closed: piece.closed,
        planar: piece.planar,
        fixed: piece.fixed,
        tolerance: piece.tolerance,
        centre: piece.centre,
        floor: FLOOR * piece.tolerance * piece.tolerance / length.powi(5),
    };
    let first = Patience { steps: 12, change: 2e-3, grow: true };
    let (smoothed, chosen) = smoothed(&data, chosen);
    // Through a node for each of the smoothed data the curve is in the tube already, if there is such a curve.
    let all = || start(&data, &smoothed.points, &chosen, (0..chosen.len()).map(|i| i as f64).collect());
    let Some(mut fit) = sparse_start(&data, &smoothed, &chosen).or_else(all).map(|fit| fit.fairest(&data, first))
    else {
        return Outcome::Missed { outside: (0..piece.points.len()).collect(), farthest: f64::INFINITY };
    };
    for _ in 0..INSERTIONS {
        if fit.feasible(&data) {
            break;
        }
        let Some(more) = with_more_nodes(&data, &fit) else { break };
        fit = more.fairest(&data, first);
    }
    if !fit.feasible(&data)
        && let Some(dense) = all().map(|fit| fit.fairest(&data, first)).filter(|fit| fit.feasible(&data))
    {
        fit = dense;
    }
    if !fit.feasible(&data) {
        let square = data.tolerance * data.tolerance;
        let outside = fit.feet.iter().enumerate().filter(|(_, f)| f.error.length_squared() > square);
        return Outcome::Missed { outside: outside.map(|(i, _)| i).collect(), farthest: fit.farthest };
    }
    if limits.fits == 0 {
        return Outcome::Reached(fit);
    }
    let fit = remove(&data, fit, limits);
    let polished = fit.clone().fairest(&data, Patience { steps: 12, change: 3e-4, grow: true });
    let scale = fit.fairness.max(data.floor);
    let better = polished.feasible(&data) && polished.objective(&data, scale) < fit.objective(&data, scale);
    Outcome::Reached(if better { polished } else { fit })
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

/// A node in the middle of every segment with a datum outside, and of its neighbours.
fn with_more_nodes(data: &Data<'_>, fit: &Fit) -> Option<Fit> {
    let (curve, m) = (&fit.curve, fit.curve.segments.len());
    let mut split = vec![false; m];
    for foot in fit.feet.iter().filter(|f| f.error.length_squared() > data.tolerance * data.tolerance) {
        let j = foot.place.segment;
        split[j] = true;
        if j > 0 || data.closed {
            split[(j + m - 1) % m] = true;
        }
        if j + 1 < m || data.closed {
            split[(j + 1) % m] = true;
        }
    }
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
