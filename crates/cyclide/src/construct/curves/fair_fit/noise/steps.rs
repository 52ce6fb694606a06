//! Where heights step from one point to the next, as at a wall or a kerb: no smooth curve goes there, and no point is wrong
//! (`docs/math/fair-fits.md#noise`).

use super::chords::median;
use std::ops::Range;

/// Points on either side that tell on which line the heights are there: more than a run of wrong ones has.
const SIDE: usize = 6;
/// They are off it by less than so many deviations of the noise.
const STRAIGHT: f64 = 3.0;
/// The lines are apart by more than so many deviations,
const APART: f64 = 10.0;
/// and by more than so many times the largest change from one point to the next on either side, without what noise makes of that: else
/// the ground is that steep.
const STEEP: f64 = 4.0;
const OF_NOISE: f64 = 4.0;
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
    let noise = median(&mut second) / MEDIAN;
    let edges = if closed { 0..n } else { SIDE - 1..n - SIDE };
    let found = edges.filter_map(|i| {
        let before = line((0..SIDE).map(|k| (i + n - k) % n), heights, |k| -lengths[(i + n - k) % n])?;
        let after = line((0..SIDE).map(|k| (i + 1 + k) % n), heights, |k| lengths[(i + k) % n])?;
        // Halfway over the edge between.
        let apart = (after.at(-0.5 * lengths[i]) - before.at(0.5 * lengths[i])).abs();
        let steepest = (before.steepest.max(after.steepest) - OF_NOISE * noise).max(0.0);
        let is_step = before.off.max(after.off) < STRAIGHT * noise && apart > APART * noise && apart > STEEP * steepest;
        is_step.then_some((i, apart))
    });
    let mut found: Vec<(usize, f64)> = found.collect();
    // Of neighbors the largest.
    let all = found.clone();
    found.retain(|(i, apart)| all.iter().all(|(j, other)| i.abs_diff(*j) >= SIDE || other <= apart));
    found
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
    mean: [f64; 2],
    slope: f64,
    /// How far a height is off it, and how much heights differ from one to the next, at most.
    off: f64,
    steepest: f64,
}

impl Line {
    fn at(&self, x: f64) -> f64 {
        self.mean[1] + self.slope * (x - self.mean[0])
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
    let count = rows.len() as f64;
    let mean = [0, 1].map(|c| rows.iter().map(|row| row[c]).sum::<f64>() / count);
    let sum = |of: &dyn Fn(f64, f64) -> f64| rows.iter().map(|row| of(row[0] - mean[0], row[1] - mean[1])).sum::<f64>();
    let slope = sum(&|x, z| x * z) / sum(&|x, _| x * x);
    let mut line = Line { mean, slope, off: 0.0, steepest: 0.0 };
    line.off = rows.iter().map(|row| (row[1] - line.at(row[0])).abs()).fold(0.0, f64::max);
    line.steepest = rows.windows(2).map(|w| (w[1][1] - w[0][1]).abs()).fold(0.0, f64::max);
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
