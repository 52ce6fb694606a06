//! Points that do not belong to a run of measured points: far from the smoothed curve of the others, and off the polyline
//! of their neighbors by more than any bend of it explains (`docs/math/fair-fits.md#outliers`).

use super::beside::{self, Beside, around};
use super::bursts::{bursts, bursts_of_heights};
use super::chords::{chords, median};
use super::jumps::jumps;
use super::predicted::unpredicted;
use super::smoother::{Series, Smoothed, smoothed};
use crate::base::vector::Point3;
use crate::construct::curves::off_neighbors::off_neighbors;

/// A spike stands out from its polyline by this many times what its neighbors do.
const SPIKE: f64 = 8.0;
/// An outlier by this many times,
const ALONE: f64 = 4.0;
/// more than each of them,
const FARTHEST: f64 = 1.2;
/// by this many deviations of the noise,
const OFF: f64 = 3.5;
/// and from the smoothed curve by this many, in one direction across and in two.
const FAR: [f64; 2] = [5.0, 5.5];
/// Points on either side that a point is compared with.
const AROUND: isize = 10;
/// Part of the mean edge below which nothing is off.
const NOTHING: f64 = 1e-6;
/// Largest part of the points that may be outliers.
const MOST: usize = 4;
/// Heights laid over stretched lengths rise by one in so many at most, from a point to the next; and points that closed ones go on by.
const FLAT: f64 = 30.0;
/// From a point to the next is at least this part of the mean length.
const SHORT: f64 = 0.1;
const MARGIN: usize = 40;
/// Rounds of each search.
const ROUNDS: usize = 12;
const REFINEMENTS: usize = 5;

/// A run of points smoothed without those that do not belong to it.
pub(super) struct Cleaned {
    /// Positions that belong to the run, rising, and what they are smoothed to.
    pub kept: Vec<usize>,
    pub smoothed: Smoothed,
    /// Positions of the others, rising, and how far each is from the curve of its neighbors.
    pub outliers: Vec<(usize, f64)>,
}

/// Points that need no other proof than their neighbors, which do not predict them, or from which they jump along the way and back.
#[derive(Default)]
struct Certain {
    unpredicted: Vec<usize>,
    jumps: Vec<usize>,
}

impl Certain {
    fn has(&self, i: usize) -> bool {
        self.unpredicted.binary_search(&i).or(self.jumps.binary_search(&i)).is_ok()
    }

    fn is_unpredicted_only(&self, i: usize) -> bool {
        self.unpredicted.binary_search(&i).is_ok() && self.jumps.binary_search(&i).is_err()
    }
}

/// Finds the outliers of a run and smooths the rest. `protected`: points that are none in any case.
pub(super) fn cleaned(data: &Series<'_>, protected: &dyn Fn(usize) -> bool) -> Option<Cleaned> {
    let laid = Laid::of(data);
    // What their neighbors do not predict needs no other proof.
    let certain = if laid.heights {
        Certain::default()
    } else {
        let [unpredicted, jumps] = [unpredicted, jumps].map(|of| of(data.points, data.closed, protected));
        Certain { unpredicted, jumps }
    };
    let mut flagged = laid.spikes(protected);
    flagged.extend(certain.unpredicted.iter().chain(&certain.jumps));
    flagged.sort_unstable();
    flagged.dedup();
    let mut seen: Vec<Vec<usize>> = Vec::new();
    for _ in 0..REFINEMENTS {
        let (kept, smooth) = without(data, &flagged)?;
        let found = confirmed(data, &laid, &kept, &smooth, (&flagged, &certain), protected);
        let next: Vec<usize> = found.iter().map(|f| f.0).collect();
        if next == flagged {
            return Some(Cleaned { kept, smoothed: smooth, outliers: found });
        }
        // Points that come and go are not certain: fewer are named.
        if seen.contains(&next) {
            flagged.retain(|i| next.contains(i));
            break;
        }
        seen.push(std::mem::replace(&mut flagged, next));
    }
    let (kept, smooth) = without(data, &flagged)?;
    let found = confirmed(data, &laid, &kept, &smooth, (&flagged, &certain), protected);
    let outliers: Vec<(usize, f64)> = found.into_iter().filter(|f| flagged.contains(&f.0)).collect();
    if outliers.len() == flagged.len() {
        return Some(Cleaned { kept, smoothed: smooth, outliers });
    }
    let (kept, smoothed) = without(data, &outliers.iter().map(|f| f.0).collect::<Vec<_>>())?;
    Some(Cleaned { kept, smoothed, outliers })
}

/// The run without some of its points, smoothed.
fn without(data: &Series<'_>, left_out: &[usize]) -> Option<(Vec<usize>, Smoothed)> {
    let kept: Vec<usize> = (0..data.points.len()).filter(|i| left_out.binary_search(i).is_err()).collect();
    let points: Vec<Point3> = kept.iter().map(|i| data.points[*i]).collect();
    let lengths = data.chords.map(|chords| over(&kept, chords, data.points.len()));
    let smoothed = smoothed(&Series { points: &points, chords: lengths.as_deref(), ..*data })?;
    Some((kept, smoothed))
}

/// Lengths from each point that is kept to the next, over those that are not.
fn over(kept: &[usize], chords: &[f64], n: usize) -> Vec<f64> {
    let closing = (chords.len() == n).then(|| kept.first().map(|first| first + n)).flatten();
    let ends: Vec<usize> = kept.iter().copied().chain(closing).collect();
    ends.windows(2).map(|w| (w[0]..w[1]).map(|i| chords[i % n]).sum()).collect()
}

/// Those that are outliers by the smoothed curve and by their neighbors, with their distances from the curve.
fn confirmed(
    data: &Series<'_>,
    laid: &Laid,
    kept: &[usize],
    smooth: &Smoothed,
    (flagged, certain): (&[usize], &Certain),
    protected: &dyn Fn(usize) -> bool,
) -> Vec<(usize, f64)> {
    let far = FAR[data.directions - 1];
    let mut candidates: Vec<(usize, f64)> = Vec::new();
    for (i, r) in kept.iter().zip(&smooth.residuals) {
        let across = smooth.across.max(r.around);
        let stands = (r.alone[0] / across).hypot(r.alone[1] / smooth.along.max(across));
        // Off along the curve only, a point does no harm.
        if across > 0.0 && stands > far && r.across > OFF * across && !protected(*i) {
            candidates.push((*i, r.across));
        }
    }
    for i in flagged {
        // The curve between the neighbors, without the point.
        let at = kept.partition_point(|k| k < i) as isize;
        let places: Vec<Point3> = (at - 2..at + 2).filter_map(|k| around(&smooth.points, k, data.closed)).collect();
        let distance = if laid.heights {
            laid.off_heights(*i, kept, &smooth.points)
        } else if let ([a, b, c, d], true) = (&places[..], certain.is_unpredicted_only(*i)) {
            // Among points far apart the curve is not where their polyline is.
            off_neighbors(&[*a, *b, data.points[*i], *c, *d], &[0, 1, 3, 4]).0
        } else {
            places.windows(2).map(|w| beside::from_segment(data.points[*i], w[0], w[1])).fold(f64::INFINITY, f64::min)
        };
        if distance > far * smooth.across && distance.is_finite() {
            candidates.push((*i, distance));
        }
    }
    candidates.sort_by_key(|c| c.0);
    let is_candidate = |i: usize| candidates.binary_search_by_key(&i, |c| c.0).is_ok();
    let innocent: Vec<usize> = (0..laid.points.len()).filter(|e| !is_candidate(laid.number(*e))).collect();
    let base: Vec<Point3> = innocent.iter().map(|e| laid.points[*e]).collect();
    let usual: Vec<f64> = (0..base.len()).map(|j| Beside::one(&base, j, laid.closed).off(base[j]).0).collect();
    candidates.retain(|(i, _)| {
        if certain.has(*i) {
            return true;
        }
        let at = innocent.partition_point(|e| *e < i + laid.margin);
        let (_, off) = Beside::between(&base, at, laid.closed).off(laid.points[i + laid.margin]);
        let mut near: Vec<f64> =
            (-AROUND..AROUND).filter_map(|o| around(&usual, at as isize + o, laid.closed)).collect();
        let largest = near.iter().copied().fold(0.0, f64::max);
        off > ALONE * median(&mut near) && off > FARTHEST * largest && off > OFF * smooth.across
    });
    candidates
}

/// The points of a run, in which what is off the others is looked for. Heights are laid over their lengths, which are stretched so
/// that how far one is off is a height; closed ones go on round their seam at both ends.
struct Laid {
    points: Vec<Point3>,
    closed: bool,
    /// So many points before the first are its predecessors.
    margin: usize,
    count: usize,
    heights: bool,
}

impl Laid {
    fn of(data: &Series<'_>) -> Self {
        let count = data.points.len();
        let Some(lengths) = data.chords else {
            return Self { points: data.points.to_vec(), closed: data.closed, margin: 0, count, heights: false };
        };
        let height = |i: usize| data.points[i].z;
        let range = (0..count)
            .map(height)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], z| [least.min(z), most.max(z)]);
        // Noise brings points past each other, or as good as together.
        let least = SHORT * lengths.iter().sum::<f64>() / lengths.len() as f64;
        let lengths = lengths.iter().map(|h| h.max(least));
        let (whole, range) = (lengths.clone().sum::<f64>(), range[1] - range[0]);
        let stretch = if range > 0.0 { FLAT * range * lengths.len() as f64 / whole } else { 1.0 };
        let stations: Vec<f64> =
            lengths.scan(0.0, |sum, h| Some(std::mem::replace(sum, *sum + h))).chain([whole]).collect();
        let at = |i: usize, lap: f64| Point3::new(stretch * (stations[i] + lap * whole), 0.0, height(i));
        let margin = if data.closed { count.min(MARGIN) } else { 0 };
        let before = (count - margin..count).map(|i| at(i, -1.0));
        let after = (0..margin).map(|i| at(i, 1.0));
        let points = before.chain((0..count).map(|i| at(i, 0.0))).chain(after).collect();
        Self { points, closed: false, margin, count, heights: true }
    }

    /// The number in the run of a point.
    fn number(&self, laid: usize) -> usize {
        (laid + self.count - self.margin) % self.count
    }

    /// How far the height of a point is from the smoothed ones before and after it, at its place between these.
    fn off_heights(&self, i: usize, kept: &[usize], smooth: &[Point3]) -> f64 {
        let (n, after) = (kept.len(), kept.partition_point(|k| *k < i));
        let lap = (self.margin > 0).then(|| self.points[self.margin + self.count].x - self.points[self.margin].x);
        let place = |k: usize, lap: f64| (self.points[self.margin + kept[k]].x + lap, smooth[k].z);
        let before = if after > 0 { Some(place(after - 1, 0.0)) } else { lap.map(|lap| place(n - 1, -lap)) };
        let after = if after < n { Some(place(after, 0.0)) } else { lap.map(|lap| place(0, lap)) };
        let own = self.points[self.margin + i];
        let expected = match (before, after) {
            (Some((x, z)), Some((to, next))) if to > x => z + (next - z) * (own.x - x) / (to - x),
            (Some((_, z)), _) | (None, Some((_, z))) => z,
            (None, None) => return f64::INFINITY,
        };
        (own.z - expected).abs()
    }

    fn spikes(&self, protected: &dyn Fn(usize) -> bool) -> Vec<usize> {
        let bursts = if self.heights { bursts_of_heights } else { bursts };
        let runs = bursts(&self.points, self.closed);
        let found = spikes(&self.points, self.closed, &runs, &|e| protected(self.number(e)));
        // Those round the seam are copies.
        let own = self.margin..self.margin + self.count;
        found.into_iter().filter(|e| own.contains(e)).map(|e| e - self.margin).collect()
    }
}

/// Points that are far off the polyline of the others: those of runs, and single ones, in rounds: next to one that goes another
/// may come.
fn spikes(points: &[Point3], closed: bool, runs: &[usize], protected: &dyn Fn(usize) -> bool) -> Vec<usize> {
    let least = NOTHING * points.iter().zip(chords(points, closed)).map(|(_, h)| h).sum::<f64>() / points.len() as f64;
    let mut found: Vec<usize> = runs.iter().copied().filter(|i| !protected(*i)).collect();
    let mut list: Vec<usize> = (0..points.len()).filter(|i| found.binary_search(i).is_err()).collect();
    for _ in 0..ROUNDS {
        let at: Vec<Point3> = list.iter().map(|i| points[*i]).collect();
        let offs: Vec<(f64, f64)> = (0..at.len()).map(|j| Beside::one(&at, j, closed).off(at[j])).collect();
        let overall = median(&mut offs.iter().map(|o| o.0).collect::<Vec<_>>()).max(least);
        let ratio = |j: usize| {
            let others = (-AROUND..=AROUND).filter(|o| *o != 0);
            let mut near: Vec<f64> =
                others.filter_map(|o| around(&offs, j as isize + o, closed).map(|o| o.0)).collect();
            offs[j].1 / median(&mut near).max(overall)
        };
        let mut spikes: Vec<(f64, usize)> = (0..at.len())
            .filter(|j| offs[*j].1 > SPIKE * overall && !protected(list[*j]))
            .map(|j| (ratio(j), j))
            .filter(|s| s.0 > SPIKE)
            .collect();
        spikes.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let room = (points.len() / MOST).saturating_sub(found.len());
        // Of neighbors the farthest alone: it may be why the others seem off.
        let mut taken: Vec<usize> = Vec::new();
        for (_, j) in spikes {
            let near = |k: &usize| {
                let apart = k.abs_diff(j);
                apart <= 3 || (closed && at.len() - apart <= 3)
            };
            if taken.len() < room && !taken.iter().any(near) {
                taken.push(j);
            }
        }
        if taken.is_empty() {
            break;
        }
        taken.sort_unstable_by(|a, b| b.cmp(a));
        for j in taken {
            found.push(list.remove(j));
        }
    }
    found.sort_unstable();
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_bends_are_explained_and_a_spike_is_not() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        // An edge, a corner, another edge.
        let corner = [at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.0), at(3.0, 0.0), at(3.0, 1.0), at(3.0, 2.0), at(3.0, 3.0)];
        let off = |list: &[Point3], j: usize| Beside::one(list, j, false).off(list[j]);
        assert!(off(&corner, 3).0 < 1e-12);
        let circle: Vec<Point3> = (0..20).map(|i| at((0.3 * f64::from(i)).cos(), (0.3 * f64::from(i)).sin())).collect();
        assert!((0..20).all(|j| off(&circle, j).1 < 1e-3));
        // The end of three points: two say nothing of a bend. Of four, with a long gap beside short bases: they turn as the circle does.
        let bent = [at(0.0, 0.0), at(3.0, 0.0), at(4.0, 1.0)];
        assert!(off(&bent, 0).0 > 0.5 && off(&bent, 0).1 == 0.0);
        let gap: Vec<Point3> = [0.0, 0.9, 1.1, 1.3].map(|a: f64| at(a.cos(), a.sin())).into();
        assert!(off(&gap, 0).0 > 0.3 && off(&gap, 0).1 < 1e-3, "{:?}", off(&gap, 0));
        let mut line: Vec<Point3> = (0..30).map(|i| at(f64::from(i), 0.01 * f64::from(i * i % 7))).collect();
        line[11].y = 4.0;
        // Ahead of its place: no farther from the line than the others.
        line[20].x += 9.0;
        assert_eq!(spikes(&line, false, &[], &|_| false), [11, 20]);
    }
}
