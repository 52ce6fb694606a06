//! Single points far off the cubic through two neighbors on either side, where that predicts the others well: among points that
//! are far apart for their noise, the bends of the curve hide them from a look at the polyline (`docs/math/fair-fits.md#outliers`).

use super::beside::around;
use super::chords::median;
use crate::base::vector::Point3;
use crate::construct::curves::off_neighbors::off_neighbors;

/// A point is off by this many times what those around it are off their own predictions,
const OFF: f64 = 8.0;
/// and the worst of them, except its neighbors, by this part of it at most: else they bend more than cubics say.
const REST: f64 = 0.25;
/// Without it so are its neighbors, or by this many times the usual.
const WITHOUT: f64 = 4.0;
/// Points on either side that are looked at, and of them the neighbors whose predictions depend on it.
const AROUND: isize = 10;
const NEIGHBORS: isize = 3;
/// One in so many points may be one.
const FEW: usize = 20;
const ROUNDS: usize = 12;

/// The positions of such points, rising; `protected` ones are none.
pub(super) fn unpredicted(points: &[Point3], closed: bool, protected: &dyn Fn(usize) -> bool) -> Vec<usize> {
    let mut list: Vec<usize> = (0..points.len()).collect();
    let mut found = Vec::new();
    for _ in 0..ROUNDS {
        let at: Vec<Point3> = list.iter().map(|i| points[*i]).collect();
        let offs: Vec<Option<f64>> = (0..at.len() as isize).map(|j| off(&at, j, closed)).collect();
        let overall = median(&mut offs.iter().flatten().copied().collect::<Vec<_>>());
        let mut alone: Vec<usize> = (0..at.len())
            .filter(|j| !protected(list[*j]))
            .filter(|j| offs[*j].is_some_and(|off| off > OFF * overall))
            .filter(|j| stands_out(&at, &offs, closed, *j as isize, overall))
            .collect();
        alone.truncate((points.len() / FEW).saturating_sub(found.len()));
        if alone.is_empty() {
            break;
        }
        found.extend(alone.iter().rev().map(|j| list.remove(*j)));
    }
    found.sort_unstable();
    found
}

/// A point is off by far more than those around it, except its neighbors, and without it these are not.
fn stands_out(at: &[Point3], offs: &[Option<f64>], closed: bool, j: isize, overall: f64) -> bool {
    let off_at = |o: isize| around(offs, j + o, closed).flatten();
    let distance = off_at(0).unwrap_or(0.0);
    let beside = |range: std::ops::RangeInclusive<isize>| (-AROUND..=AROUND).filter(move |o| range.contains(&o.abs()));
    let mut near: Vec<f64> = beside(NEIGHBORS + 1..=AROUND).filter_map(off_at).collect();
    let largest = near.iter().copied().fold(0.0, f64::max);
    let usual = median(&mut near).max(overall);
    let is_farthest = beside(1..=NEIGHBORS).filter_map(off_at).all(|off| off < distance);
    if near.is_empty() || !is_farthest || distance <= OFF * usual || largest > REST * distance {
        return false;
    }
    let without: Vec<Point3> = beside(1..=AROUND).filter_map(|o| around(at, j + o, closed)).collect();
    let middle = beside(1..=AROUND).filter(|o| *o < 0 && around(at, j + o, closed).is_some()).count() as isize;
    let limit = (WITHOUT * usual).max(REST * distance);
    (middle - NEIGHBORS..middle + NEIGHBORS).filter_map(|k| off(&without, k, false)).all(|off| off <= limit)
}

/// How far a point is off the cubic through two neighbors on either side; `None` next to an end.
fn off(points: &[Point3], at: isize, closed: bool) -> Option<f64> {
    let place = |o: isize| around(points, at + o, closed);
    let (off, _) = off_neighbors(&[place(-2)?, place(-1)?, place(0)?, place(1)?, place(2)?], &[0, 1, 3, 4]);
    off.is_finite().then_some(off)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wave, 40 points far apart for their noise.
    fn wave() -> Vec<Point3> {
        let noise = |i: u32| 0.003 * (f64::from(i * i) * 0.7).sin();
        (0..40).map(|i| Point3::new(f64::from(i), 4.0 * (0.3 * f64::from(i)).sin() + noise(i), 0.0)).collect()
    }

    #[test]
    fn wrong_points_are_found_among_bends() {
        assert!(unpredicted(&wave(), false, &|_| false).is_empty());
        for wrong in [&[12][..], &[5, 30], &[20, 21]] {
            let mut points = wave();
            wrong.iter().for_each(|i| points[*i].y += 0.3);
            let found = unpredicted(&points, false, &|_| false);
            assert!(found.iter().all(|i| wrong.contains(i)), "{wrong:?} {found:?}");
            assert!(wrong.len() == 2 && wrong[1] == 21 || found == wrong, "{wrong:?} {found:?}");
        }
        let mut points = wave();
        points[12].y += 0.3;
        assert!(unpredicted(&points, false, &|i| i == 12).is_empty());
    }

    #[test]
    fn corners_are_none() {
        let mut points = wave();
        // A corner of 17 degrees, and a step.
        points.iter_mut().skip(20).for_each(|p| p.y += 0.3 * (p.x - 20.0));
        assert!(unpredicted(&points, false, &|_| false).is_empty());
        let mut points = wave();
        points.iter_mut().skip(20).for_each(|p| p.y += 0.5);
        assert!(unpredicted(&points, false, &|_| false).is_empty());
    }
}
