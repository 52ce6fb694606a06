//! Points that do not belong to a run of measured points: far from the smoothed curve of the others, and off the polyline
//! of their neighbours by more than any bend of it explains (`docs/math/fair-fits.md#outliers`).

use super::chords::{chords, median};
use super::smoother::{Series, Smoothed, smoothed};
use crate::base::vector::{Point3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A spike stands out from its polyline by this many times what its neighbours do.
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
/// A bend may leave the polyline without a point by this many times what a circle does.
const BEND: f64 = 1.5;
/// Extrapolations go on for this many edges.
const BEYOND: f64 = 2.0;
/// Part of the mean edge below which nothing is off.
const NOTHING: f64 = 1e-6;
/// Largest part of the points that may be outliers.
const MOST: usize = 4;
/// Rounds of each search.
const ROUNDS: usize = 12;
const REFINEMENTS: usize = 5;

/// A run of points smoothed without those that do not belong to it.
pub(super) struct Cleaned {
    /// Positions that belong to the run, rising, and what they are smoothed to.
    pub kept: Vec<usize>,
    pub smoothed: Smoothed,
    /// Positions of the others, rising, and how far each is from the curve of its neighbours.
    pub outliers: Vec<(usize, f64)>,
}

/// Finds the outliers of a run and smooths the rest. `protected`: points that are none in any case.
pub(super) fn cleaned(data: &Series<'_>, protected: &dyn Fn(usize) -> bool) -> Option<Cleaned> {
    let mut flagged = spikes(data.points, data.closed, protected);
    let mut seen: Vec<Vec<usize>> = Vec::new();
    for _ in 0..REFINEMENTS {
        let (kept, smooth) = without(data, &flagged)?;
        let found = confirmed(data, &kept, &smooth, &flagged, protected);
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
    let found = confirmed(data, &kept, &smooth, &flagged, protected);
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
    let smoothed = smoothed(&Series { points: &points, ..*data })?;
    Some((kept, smoothed))
}

/// Those that are outliers by the smoothed curve and by their neighbours, with their distances from the curve.
fn confirmed(
    data: &Series<'_>,
    kept: &[usize],
    smooth: &Smoothed,
    flagged: &[usize],
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
        // The curve between the neighbours, without the point.
        let at = kept.partition_point(|k| k < i) as isize;
        let places: Vec<Point3> = (at - 2..at + 2).filter_map(|k| around(&smooth.points, k, data.closed)).collect();
        let distance =
            places.windows(2).map(|w| from_segment(data.points[*i], w[0], w[1])).fold(f64::INFINITY, f64::min);
        if distance > far * smooth.across && distance.is_finite() {
            candidates.push((*i, distance));
        }
    }
    candidates.sort_by_key(|c| c.0);
    let innocent: Vec<usize> =
        (0..data.points.len()).filter(|i| candidates.binary_search_by_key(i, |c| c.0).is_err()).collect();
    let base: Vec<Point3> = innocent.iter().map(|i| data.points[*i]).collect();
    let usual: Vec<f64> = (0..base.len()).map(|j| off(&base, j, data.closed, None).0).collect();
    candidates.retain(|(i, _)| {
        let at = innocent.partition_point(|k| k < i);
        let (_, off) = off(&base, at, data.closed, Some(data.points[*i]));
        let mut near: Vec<f64> =
            (-AROUND..AROUND).filter_map(|o| around(&usual, at as isize + o, data.closed)).collect();
        let largest = near.iter().copied().fold(0.0, f64::max);
        off > ALONE * median(&mut near) && off > FARTHEST * largest && off > OFF * smooth.across
    });
    candidates
}

/// Points that are far off the polyline of the others, in rounds: next to one that goes another may come.
fn spikes(points: &[Point3], closed: bool, protected: &dyn Fn(usize) -> bool) -> Vec<usize> {
    let least = NOTHING * points.iter().zip(chords(points, closed)).map(|(_, h)| h).sum::<f64>() / points.len() as f64;
    let mut list: Vec<usize> = (0..points.len()).collect();
    let mut found = Vec::new();
    for _ in 0..ROUNDS {
        let at: Vec<Point3> = list.iter().map(|i| points[*i]).collect();
        let offs: Vec<(f64, f64)> = (0..at.len()).map(|j| off(&at, j, closed, None)).collect();
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
        // Of neighbours the farthest alone: it may be why the others seem off.
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

/// The entry of a list at a number, round a closed one.
fn around<T: Copy>(list: &[T], k: isize, closed: bool) -> Option<T> {
    let n = list.len() as isize;
    if n == 0 {
        return None;
    }
    if closed {
        Some(list[k.rem_euclid(n) as usize])
    } else {
        usize::try_from(k).ok().and_then(|k| list.get(k).copied())
    }
}

/// How far a point of a list is off the polyline of its neighbours without it, whole and without what a bend explains.
/// A corner is on the extrapolations of both sides. `extra`: the point is none of the list, and would come before `j`.
fn off(list: &[Point3], j: usize, closed: bool, extra: Option<Point3>) -> (f64, f64) {
    let j = j as isize;
    let point = extra.or_else(|| around(list, j, closed));
    let Some(point) = point else { return (0.0, 0.0) };
    let next = if extra.is_some() { 0 } else { 1 };
    let back = |k: isize| around(list, j - k, closed);
    let ahead = |k: isize| around(list, j + k - 1 + next, closed);
    let (before, after) = ([back(1), back(2), back(3)], [ahead(1), ahead(2), ahead(3)]);
    let neighbours: Vec<Point3> = [before[1], before[0], after[0], after[1]].into_iter().flatten().collect();
    let skipping = neighbours.windows(2).map(|w| from_segment(point, w[0], w[1])).fold(f64::INFINITY, f64::min);
    let beyond = |side: &[Option<Point3>; 3]| {
        let (near, far) = side[0].zip(side[1])?;
        Some(from_segment(point, near, near + (near - far) * BEYOND))
    };
    let sides: Vec<f64> = [beyond(&before), beyond(&after)].into_iter().flatten().collect();
    let extrapolated = sides.into_iter().reduce(f64::max).unwrap_or(f64::INFINITY);
    let whole = skipping.min(extrapolated);
    if !whole.is_finite() {
        return (0.0, 0.0);
    }
    let turn = |a: Vec3, b: Vec3| if a.length() > 0.0 && b.length() > 0.0 { a.angle(b) } else { 0.0 };
    let at_end = |side: &[Option<Point3>; 3]| match side {
        [Some(a), Some(b), Some(c)] => a.distance(point) * turn(*b - *a, *c - *b).min(FRAC_PI_2).sin(),
        _ => 0.0,
    };
    let bend = match (before, after) {
        ([Some(b1), Some(b2), _], [Some(a1), Some(a2), _]) => {
            0.5 * b1.distance(a1) * (turn(b1 - b2, a2 - a1).min(PI) / 4.0).tan()
        }
        ([None, ..], after) => at_end(&after),
        (before, [None, ..]) => at_end(&before),
        // Second from an end: the turn of one side, as it goes on over the chord.
        ([Some(b), None, _], [Some(a), Some(next), _]) | ([Some(a), Some(next), _], [Some(b), None, _]) => {
            let (chord, edge) = (a - b, next - a);
            let turn = turn(chord, edge) * 2.0 * chord.length() / (chord.length() + edge.length());
            0.5 * chord.length() * (turn.min(PI) / 4.0).tan()
        }
        _ => 0.0,
    };
    (whole, (whole - BEND * bend).max(0.0))
}

/// Distance of a point from a segment.
fn from_segment(p: Point3, a: Point3, b: Point3) -> f64 {
    let (edge, v) = (b - a, p - a);
    let square = edge.length_squared();
    let t = if square > 0.0 { (v.dot(edge) / square).clamp(0.0, 1.0) } else { 0.0 };
    (v - edge * t).length()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_bends_are_explained_and_a_spike_is_not() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        // An edge, a corner, another edge.
        let corner = [at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.0), at(3.0, 0.0), at(3.0, 1.0), at(3.0, 2.0), at(3.0, 3.0)];
        assert!(off(&corner, 3, false, None).0 < 1e-12);
        let circle: Vec<Point3> = (0..20).map(|i| at((0.3 * f64::from(i)).cos(), (0.3 * f64::from(i)).sin())).collect();
        assert!((0..20).all(|j| off(&circle, j, false, None).1 < 1e-3));
        let mut line: Vec<Point3> = (0..30).map(|i| at(f64::from(i), 0.01 * f64::from(i * i % 7))).collect();
        line[11].y = 4.0;
        // Ahead of its place: no farther from the line than the others.
        line[20].x += 9.0;
        assert_eq!(spikes(&line, false, &|_| false), [11, 20]);
    }
}
