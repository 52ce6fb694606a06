//! Runs of some wrong points among measured ones, a right one between them or not: the polyline goes on past them as if they were not
//! there (`docs/math/fair-fits.md#outliers`).

use super::beside::{Beside, around};
use super::chords::{chords, median};
use super::neighbors::offs;
use crate::base::vector::Point3;

/// Points of a run.
const COUNTS: [usize; 4] = [2, 3, 4, 5];
/// Each is off by this many times what the points round about are,
const OFF: f64 = 5.0;
/// so many on either side,
const AROUND: isize = 10;
/// which are no exact points: from the polynomials through two neighbors on either side they are off by more than this part of it; heights,
/// of which a wrong one may be a thousand deviations off, by more than the second.
const EXACT: [f64; 2] = [1e-3, 1e-7];
/// And by more than this part of what they are off the next ones alone: a coarse curve is off those by more.
const SCATTERED: f64 = 0.3;
/// The points beside the run are at least and at most this many times as far apart as so many edges usually are: those beside a slit
/// are closer together,
const APART: [f64; 2] = [0.5, 2.0];
/// by more than this many times what noise moves points by.
const MOVED: f64 = 5.0;
/// Points of a run are farther from those beside it than these edges are, by this factor.
const JUMP: f64 = 1.2;
/// Heights go up to those of a run and down from them by this part of what it is off: beside it a right one may be as far off as it.
const RISE: f64 = 0.5;
/// One in so many points may belong to a run, of so many at least: else the figure is so.
const FEW: usize = 10;
const FEWEST: usize = 30;

/// The points of all runs, rising.
pub(in super::super) fn bursts(points: &[Point3], closed: bool) -> Vec<usize> {
    runs(points, closed, true)
}

/// The same of heights over the way, which is no shorter without a run of them: its first and last edges are not longer, but steep.
pub(super) fn bursts_of_heights(points: &[Point3], closed: bool) -> Vec<usize> {
    runs(points, closed, false)
}

fn runs(points: &[Point3], closed: bool, jumping: bool) -> Vec<usize> {
    let n = points.len();
    if n < FEWEST {
        return Vec::new();
    }
    let singles: Vec<f64> = (0..n).map(|j| Beside::one(points, j, closed).off(points[j]).0).collect();
    let lengths = chords(points, closed);
    let [next, two] = [1, 2].map(|k| offs(points, closed, k));
    let usual = |list: &[f64], at: usize| {
        median(&mut (-AROUND..=AROUND).filter_map(|k| around(list, at as isize + k, closed)).collect::<Vec<_>>())
    };
    let mut found: Vec<(f64, usize, Vec<usize>)> = Vec::new();
    for count in COUNTS {
        for from in 0..if closed { n } else { n - count } {
            let beside = Beside::run(points, from, count, closed);
            let run = || (from..from + count).map(|k| points[k % n]);
            let Some(apart) = beside.apart() else { continue };
            let edge = |k: usize| lengths[k % n];
            let jumps = edge((from + n - 1) % n).min(edge(from + count - 1));
            if jumping && jumps <= JUMP * apart / (count + 1) as f64 {
                continue;
            }
            let offs: Vec<f64> = run().map(|p| beside.off(p).1).collect();
            let noise = usual(&singles, from);
            // Between its ends some may be right.
            let is_wrong = |k: usize| k == 0 || k + 1 == count || offs[k] > OFF * noise;
            let wrong: Vec<usize> = (0..count).filter(|k| is_wrong(*k)).collect();
            let off = wrong.iter().map(|k| offs[*k]).fold(f64::INFINITY, f64::min);
            let rise = |k: usize| (points[(k + 1) % n].z - points[k % n].z).abs();
            if !jumping && rise(from + n - 1).min(rise(from + count - 1)) < RISE * off {
                continue;
            }
            let off_two = usual(&two, from);
            let is_noisy = off_two > EXACT[usize::from(!jumping)] * off && off_two > SCATTERED * usual(&next, from);
            let expected = (count + 1) as f64 * usual(&lengths, from);
            let goes_on = apart + MOVED * noise > APART[0] * expected && apart < APART[1] * expected;
            if is_noisy && goes_on && off > OFF * noise {
                found.push((off / noise, from, wrong));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut taken = vec![false; n];
    for (_, from, wrong) in found {
        // What is beside a run is none.
        let count = wrong.last().map_or(0, |last| last + 1);
        if (from + n - 1..=from + n + count).all(|k| !taken[k % n]) {
            wrong.iter().for_each(|k| taken[(from + k) % n] = true);
        }
    }
    let all: Vec<usize> = (0..n).filter(|i| taken[*i]).collect();
    if all.len() * FEW > n { Vec::new() } else { all }
}
