//! Where heights step from one point to the next, as at a wall or a kerb: no smooth curve goes there, and no point is wrong
//! (`docs/math/fair-fits.md#noise`).

use super::chords::median;
use std::ops::Range;

/// Points on either side that tell on which line the heights are there: two more than a run of wrong ones has, since one of them may
/// be off.
const SIDE: usize = 7;
/// The others are off it by less than so many deviations of the noise.
const STRAIGHT: f64 = 3.0;
/// The lines are apart by more than so many deviations,
const APART: f64 = 10.0;
/// and by more than so many times the largest change from one point to the next on either side, without what noise makes of that: else
/// the ground is that steep.
const STEEP: f64 = 4.0;
const OF_NOISE: f64 = 4.0;
/// Most of the step is between the two points: else it is a ramp.
const BETWEEN: f64 = 0.75;
/// Heights that differ by less than this part of the largest are the same.
const SAME: f64 = 1e-12;
/// The median of the absolute values of second differences of normal errors, as a part of their deviation.
const MEDIAN: f64 = 0.6745 * 2.449_489_742_783_178;

/// The points after which heights step, rising, and by how much; `lengths` are those between points.
pub(super) fn steps(heights: &[f64], lengths: &[f64], closed: bool) -> Vec<(usize, f64)> {
    let n = heights.len();
    if n < 2 * SIDE {
        return Vec::new();
    }
    let at = |i: usize| heights[i % n];
    let inside = if closed { 0..n } else { 0..n - 2 };
    let mut second: Vec<f64> = inside.map(|i| (at(i) - 2.0 * at(i + 1) + at(i + 2)).abs()).collect();
    let noise = (median(&mut second) / MEDIAN).max(rounding(heights));
    let edges = if closed { 0..n } else { SIDE - 1..n - SIDE };
    let found = edges.filter_map(|i| {
        let before = line((0..SIDE).map(|k| (i + n - k) % n), heights, |k| -lengths[(i + n - k) % n])?;
        let after = line((0..SIDE).map(|k| (i + 1 + k) % n), heights, |k| lengths[(i + k) % n])?;
        // Halfway over the edge between.
        let apart = (after.at(-0.5 * lengths[i]) - before.at(0.5 * lengths[i])).abs();
        let steepest = (before.steepest.max(after.steepest) - OF_NOISE * noise).max(0.0);
        let change = |i: usize| at(i + 1) - at(i);
        let is_between = change(i).abs() > BETWEEN * apart;
        // A run of wrong heights goes back by as much.
        let goes_back = |k: usize| change(k) * change(i) < 0.0 && change(k).abs() > BETWEEN * change(i).abs();
        let is_between = is_between && !(1..SIDE).any(|k| goes_back((i + k) % n) || goes_back((i + n - k) % n));
        let is_step = is_between
            && before.off.max(after.off) < STRAIGHT * noise
            && apart > APART * noise
            && apart > STEEP * steepest;
        is_step.then_some((i, apart, before.misfit + after.misfit))
    });
    let all: Vec<(usize, f64, f64)> = found.collect();
    // Beside a step one of the points is on the wrong side of an edge.
    let apart = |i: usize, j: usize| if closed { i.abs_diff(j).min(n - i.abs_diff(j)) } else { i.abs_diff(j) };
    // They rise: those beside one are next to it in the list.
    let count = all.len();
    let is_least = |(k, a): &(usize, &(usize, f64, f64))| {
        let beside = (1..=SIDE).flat_map(|step| [k + step, k + SIDE * count - step]).map(|other| &all[other % count]);
        let mut beside = beside.filter(|b| b.0 != a.0 && apart(a.0, b.0) < SIDE);
        beside.all(|b| (a.2, a.0) < (b.2, b.0))
    };
    all.iter().enumerate().filter(is_least).map(|(_, step)| (step.0, step.1)).collect()
}

/// The deviation that rounding to some decimals leaves: nearly that of a number anywhere between two values.
pub(super) fn rounding(heights: &[f64]) -> f64 {
    let changes = heights.windows(2).map(|w| (w[1] - w[0]).abs());
    let largest = heights.iter().fold(0.0_f64, |most, z| most.max(z.abs()));
    let least = changes.filter(|change| *change > SAME * largest).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least / 12.0_f64.sqrt() } else { 0.0 }
}

/// The runs of points between steps: numbers from `start` on, past the end of closed ones.
pub(super) fn between(steps: &[(usize, f64)], n: usize, closed: bool) -> Vec<Range<usize>> {
    let mut ends: Vec<usize> = steps.iter().map(|step| step.0 + 1).collect();
    match (closed, ends.first().copied()) {
        (true, Some(first)) => ends.push(first + n),
        _ => {
            ends.insert(0, 0);
            ends.push(n);
        }
    }
    ends.windows(2).map(|w| w[0]..w[1]).collect()
}

/// The straight line through heights beside an edge.
struct Line {
    height: f64,
    slope: f64,
    /// How far a height is off it, and how much heights differ from one to the next, at most, without one that may be wrong.
    off: f64,
    steepest: f64,
    /// Sum of the distances from it.
    misfit: f64,
}

impl Line {
    fn at(&self, x: f64) -> f64 {
        self.height + self.slope * x
    }
}

/// Through the heights of points, the first at 0, each farther by the length that comes before it.
fn line(numbers: impl Iterator<Item = usize>, heights: &[f64], length: impl Fn(usize) -> f64) -> Option<Line> {
    let mut x = 0.0;
    let mut rows: Vec<[f64; 2]> = Vec::new();
    for (k, number) in numbers.enumerate() {
        if k > 0 {
            x += length(k);
        }
        rows.push([x, heights[number]]);
    }
    // The median slope of all pairs, and the median height over it: one point may be wrong.
    let pairs =
        |(i, a): (usize, &[f64; 2])| rows[..i].iter().map(|b| (a[1] - b[1]) / (a[0] - b[0])).collect::<Vec<_>>();
    let slope = median(&mut rows.iter().enumerate().flat_map(pairs).collect::<Vec<_>>());
    let height = median(&mut rows.iter().map(|row| row[1] - slope * row[0]).collect::<Vec<_>>());
    let mut line = Line { height, slope, off: 0.0, steepest: 0.0, misfit: 0.0 };
    let mut offs: Vec<f64> = rows.iter().map(|row| (row[1] - line.at(row[0])).abs()).collect();
    offs.sort_by(f64::total_cmp);
    line.misfit = offs.iter().sum();
    line.off = offs[rows.len() - 2];
    let mut changes: Vec<f64> = rows.windows(2).map(|w| (w[1][1] - w[0][1]).abs()).collect();
    changes.sort_by(f64::total_cmp);
    // A wrong one is in two of them.
    line.steepest = changes[changes.len() - 3];
    slope.is_finite().then_some(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slope with a wave of noise.
    fn ground(n: usize) -> Vec<f64> {
        (0..n).map(|i| 0.05 * i as f64 + 0.02 * ((i * i) as f64 * 0.7).sin()).collect()
    }

    #[test]
    fn a_wall_is_a_step_and_wrong_heights_are_none() {
        let lengths = vec![1.0; 40];
        let mut heights = ground(40);
        assert!(steps(&heights, &lengths, true).iter().all(|step| step.0 == 39), "the closing edge alone");
        assert!(steps(&heights, &lengths[1..], false).is_empty());
        heights[15..18].iter_mut().for_each(|z| *z += 1.0);
        assert!(steps(&heights, &lengths[1..], false).is_empty());
        let mut heights = ground(40);
        heights[22..].iter_mut().for_each(|z| *z += 1.0);
        let found = steps(&heights, &lengths[1..], false);
        assert!(found.len() == 1 && found[0].0 == 21 && (found[0].1 - 1.0).abs() < 0.05, "{found:?}");
        assert_eq!(between(&found, 40, false), [0..22, 22..40]);
        // A wrong height beside it is one of the others.
        heights[25] += 0.8;
        assert_eq!(steps(&heights, &lengths[1..], false)[0].0, 21);
        // Heights rounded to centimeters, most of them the same.
        let level: Vec<f64> =
            (0..40).map(|i| if i < 20 { 100.0 } else { 101.0 + 0.01 * f64::from(i % 3 / 2) }).collect();
        assert_eq!(steps(&level, &lengths[1..], false)[0].0, 19);
        assert!((rounding(&level) - 0.01 / 12.0_f64.sqrt()).abs() < 1e-9);
        // Steep ground is none.
        let ramp: Vec<f64> = (0..40).map(|i: i32| f64::from((i - 18).clamp(0, 4)) * 0.5).collect();
        assert!(steps(&ramp, &lengths[1..], false).is_empty());
    }

    #[test]
    fn a_closed_list_has_runs_over_its_seam() {
        assert_eq!(between(&[(4, 1.0), (11, 1.0)], 20, true), [5..12, 12..25]);
        assert_eq!(between(&[], 20, true), vec![0..20; 1]);
    }
}
