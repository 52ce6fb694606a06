//! Coordinates that run as fast as arc length in the mean: each of them alone, so that its lines stay what they are.

use super::coordinates::Coordinates;
use super::sheet::Sheet;

/// Levels in which the speed is measured, and how many of them are averaged.
const BINS: usize = 24;
const AVERAGED: usize = 5;

/// Replaces both coordinates in every connected part.
pub(super) fn by_arc_length(sheet: &Sheet<'_>, coordinates: &mut Coordinates, weights: &[f64]) {
    let (parts, count) = sheet.parts();
    let mut members = vec![Vec::new(); count];
    (0..parts.len()).filter(|f| sheet.active[*f]).for_each(|f| members[parts[f]].push(f));
    let slopes: Vec<[f64; 2]> =
        (0..parts.len()).map(|f| coordinates.slopes(sheet, f).map(|slope| slope.length())).collect();
    let all: Vec<usize> = members.iter().flatten().copied().collect();
    for d in 0..2 {
        let old_period = coordinates.periods[d];
        // Parts that come back have one period: what bad triangles cut off follows the law of the whole.
        let together = if old_period == 0.0 { &members[..] } else { std::slice::from_ref(&all) };
        for part in together {
            let values = || part.iter().flat_map(|f| coordinates.corners[*f].iter().map(move |c| c[d]));
            let lowest = values().fold(f64::INFINITY, f64::min);
            let width =
                if old_period == 0.0 { values().fold(f64::NEG_INFINITY, f64::max) - lowest } else { old_period.abs() };
            if !(width > 0.0) {
                continue;
            }
            let closed = old_period != 0.0;
            let bin = |x: f64| {
                let k = ((x - lowest) / width * BINS as f64).floor();
                if closed { k.rem_euclid(BINS as f64) as usize } else { (k.max(0.0) as usize).min(BINS - 1) }
            };
            let mut sums = [[0.0; 2]; BINS];
            for f in part {
                let middle = coordinates.corners[*f].iter().map(|c| c[d]).sum::<f64>() / 3.0;
                let weight = sheet.table.areas[*f] * weights[*f].max(1e-3);
                let sums = &mut sums[bin(middle)];
                sums[0] += weight * slopes[*f][d];
                sums[1] += weight;
            }
            let law = SpeedLaw::new(&sums, lowest, width, closed);
            for f in part {
                for corner in &mut coordinates.corners[*f] {
                    corner[d] = law.length(corner[d]);
                }
            }
            if closed {
                coordinates.periods[d] = law.total() * old_period.signum();
            }
        }
    }
}

/// A piecewise linear law from a coordinate to arc length.
struct SpeedLaw {
    lowest: f64,
    width: f64,
    closed: bool,
    /// Lengths at the ends of the bins.
    lengths: [f64; BINS + 1],
}

impl SpeedLaw {
    fn new(sums: &[[f64; 2]; BINS], lowest: f64, width: f64, closed: bool) -> Self {
        let half = AVERAGED / 2;
        let speed = |k: usize| {
            let near = (0..AVERAGED).filter_map(|i| {
                let k = (k + i) as i64 - half as i64;
                let inside = (0..BINS as i64).contains(&k);
                (inside || closed).then(|| sums[k.rem_euclid(BINS as i64) as usize])
            });
            let [slope, weight] = near.fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
            // A level without triangles, in a part that is hardly there: left as it is.
            if slope > 0.0 { weight / slope } else { 1.0 }
        };
        let mut lengths = [0.0; BINS + 1];
        for k in 0..BINS {
            lengths[k + 1] = lengths[k] + speed(k) * width / BINS as f64;
        }
        Self { lowest, width, closed, lengths }
    }

    fn total(&self) -> f64 {
        self.lengths[BINS]
    }

    fn length(&self, x: f64) -> f64 {
        let place = (x - self.lowest) / self.width;
        let turns = if self.closed { place.floor() } else { 0.0 };
        let place = (place - turns) * BINS as f64;
        let k = (place.max(0.0) as usize).min(BINS - 1);
        turns * self.total() + self.lengths[k] + (place - k as f64) * (self.lengths[k + 1] - self.lengths[k])
    }
}
