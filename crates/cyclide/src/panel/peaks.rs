//! Where a function of a panel's place is far from zero.

use super::least_maximum::ROUNDING;
use super::unit_patch::UnitPatch;

/// Places of the first look, along each direction.
const GRID: u32 = 13;
/// Places from which a search starts reach this part of the largest.
const NEAR: f64 = 0.9;
/// The last step of a search: a smooth maximum is missed by the square of it.
const LAST: f64 = 1e-7;
/// Searches at most.
const MOST: usize = 8;

/// The largest absolute values over the patch, with their places, the largest first: the largest of a grid, and from it and all that are nearly
/// as large uphill in ever smaller steps; of rounding, the largest of the grid.
pub(super) fn peaks(unit: &UnitPatch, value: impl Fn((f64, f64)) -> f64) -> Vec<(f64, (f64, f64))> {
    let value = |place| value(place).abs();
    let places: Vec<(f64, f64)> = unit.grid(GRID).collect();
    let values: Vec<f64> = places.iter().map(|&p| value(p)).collect();
    let largest = values.iter().copied().fold(0.0, f64::max);
    if largest <= ROUNDING {
        // Of rounding nothing is uphill.
        return places
            .into_iter()
            .zip(&values)
            .find(|(_, v)| **v >= largest)
            .map(|(p, v)| (*v, p))
            .into_iter()
            .collect();
    }
    let n = GRID as usize;
    let is_peak = |k: usize| {
        let (i, j) = (k % n, k / n);
        let beside = |a: usize| a.saturating_sub(1)..=(a + 1).min(n - 1);
        beside(j).all(|j| beside(i).all(|i| values[j * n + i] <= values[k]))
    };
    let mut starts: Vec<usize> = (0..n * n).filter(|&k| values[k] >= NEAR * largest && is_peak(k)).collect();
    starts.sort_by(|a, b| values[*b].total_cmp(&values[*a]).then(a.cmp(b)));
    let mut found: Vec<_> = starts.into_iter().take(MOST).map(|k| uphill(&value, places[k], values[k])).collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found
}

fn uphill(value: &impl Fn((f64, f64)) -> f64, from: (f64, f64), at: f64) -> (f64, (f64, f64)) {
    let (mut best, mut step) = ((at, from), 0.5 / f64::from(GRID - 1));
    while step > LAST {
        let (s, t) = best.1;
        let mut moved = false;
        for (ds, dt) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let move_by = |x: f64, d: i32| (x + step * f64::from(d)).clamp(0.0, 1.0);
            let place = (move_by(s, ds), move_by(t, dt));
            let there = value(place);
            if there > best.0 {
                (best, moved) = ((there, place), true);
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    best
}
