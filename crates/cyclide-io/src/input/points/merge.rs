//! Repeated points: neighbors that coincide, and a closed contour's last point that repeats its first.

use super::point_table::PointList;
use cyclide::{Aabb, Warning, warning::PointWarning};

/// Neighbors closer than this part of the contour's size are one point: the rounding of coordinates that were
/// computed (`cos` and `sin` of a full turn differ from the start by about this), far below any intended feature.
/// The kernel's constructions refuse neighbors this close.
const RELATIVE_LIMIT: f64 = 1e-12;

/// Fewer points may be neighbors by chance; and edges may differ by this part.
const FEWEST_ROUND: usize = 6;
const UNEVEN: f64 = 0.05;

impl PointList {
    /// Distances up to this count as equal; infinite coordinates make nothing equal.
    fn limit(&self) -> f64 {
        let bounds = Aabb::of_points(self.points.iter().copied());
        bounds.map(|b| RELATIVE_LIMIT * b.diagonal()).filter(|l| l.is_finite()).unwrap_or(0.0)
    }

    /// True if first and last point are the same point and there is something between them.
    pub(crate) fn ends_meet(&self) -> bool {
        match self.points.as_slice() {
            [first, .., last] if self.points.len() > 3 => first.distance(*last) <= self.limit(),
            _ => false,
        }
    }

    /// True if the last point is as near to the first as neighbors are there: what lists of closed curves without their last edge are like.
    pub(crate) fn ends_are_neighbors(&self) -> bool {
        match self.points.as_slice() {
            [first, second, .., before, last] if self.points.len() >= FEWEST_ROUND => {
                let edge = first.distance(*second).max(before.distance(*last));
                first.distance(*last) <= edge * (1.0 + UNEVEN)
            }
            _ => false,
        }
    }
}

/// What merging did.
pub(crate) struct Merged {
    /// Index, in the list as it was, of each point that is left.
    pub(crate) kept: Vec<usize>,
    /// A warning for each run of merged points, with indices of the list as it was.
    pub(crate) warnings: Vec<Warning>,
}

impl Merged {
    /// All points of a list as they are.
    pub(crate) fn nothing(list: &PointList) -> Self {
        Self { kept: (0..list.points.len()).collect(), warnings: Vec::new() }
    }
}

/// Merges repeated neighbors, and for a closed contour the last points that repeat the first. A mark on any of the
/// merged points stays; the list's offsets go with the points.
pub(crate) fn merge_repeated(list: &mut PointList, closed: bool) -> Merged {
    let limit = list.limit();
    let n = list.points.len();
    let mut kept: Vec<usize> = Vec::with_capacity(n);
    let mut runs: Vec<(usize, usize)> = Vec::new();
    let mut marked = vec![false; n];
    for &corner in &list.corners {
        marked[corner] = true;
    }
    for i in 0..n {
        match kept.last() {
            Some(&last) if list.points[i].distance(list.points[last]) <= limit => {
                marked[last] |= marked[i];
                match runs.last_mut() {
                    Some((first, count)) if *first + *count == i => *count += 1,
                    _ => runs.push((i, 1)),
                }
            }
            _ => kept.push(i),
        }
    }
    let (mut closing, mut distance) = (0, 0.0_f64);
    while let [first, .., last] = *kept.as_slice()
        && closed
        && list.points[last].distance(list.points[first]) <= limit
    {
        marked[first] |= marked[last];
        kept.pop();
        closing = last;
        distance = distance.max(list.points[last].distance(list.points[first]));
    }
    if kept.len() == n {
        return Merged { kept, warnings: Vec::new() };
    }
    list.points = kept.iter().map(|&i| list.points[i]).collect();
    list.offsets = kept.iter().filter_map(|&i| list.offsets.get(i).copied()).collect();
    list.labels = kept.iter().filter_map(|&i| list.labels.get(i).cloned()).collect();
    list.corners = kept.iter().enumerate().filter(|&(_, &i)| marked[i]).map(|(k, _)| k).collect();
    let merged =
        runs.into_iter().map(|(first, count)| Warning::Point(PointWarning::PointsMerged { first, count, limit }));
    let closing =
        (closing > 0).then_some(Warning::Point(PointWarning::ClosingPointMerged { index: closing, distance }));
    Merged { kept, warnings: merged.chain(closing).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{Point3, warning::PointWarning};

    fn list(xy: &[[f64; 2]], corners: &[usize]) -> PointList {
        PointList {
            points: xy.iter().map(|p| Point3::new(p[0], p[1], 0.0)).collect(),
            corners: corners.to_vec(),
            offsets: (0..xy.len()).collect(),
            labels: Vec::new(),
        }
    }

    #[test]
    fn a_repeated_closing_point_is_merged_only_if_closed() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let mut closed = list(&square, &[4]);
        assert!(closed.ends_meet());
        assert_eq!(
            merge_repeated(&mut closed, true).warnings,
            [Warning::Point(PointWarning::ClosingPointMerged { index: 4, distance: 0.0 })]
        );
        assert_eq!((closed.points.len(), &closed.corners[..]), (4, &[0][..]));
        let mut open = list(&square, &[4]);
        assert!(merge_repeated(&mut open, false).warnings.is_empty());
        assert_eq!(open.points.len(), 5);
    }

    #[test]
    fn runs_of_equal_neighbors_are_merged_and_marks_kept() {
        let mut l = list(&[[0.0, 0.0], [0.0, 0.0], [0.0, 1e-13], [2.0, 0.0], [3.0, 0.0], [3.0, 0.0]], &[2, 3]);
        let limit = 3e-12;
        assert_eq!(
            merge_repeated(&mut l, false).warnings,
            [
                Warning::Point(PointWarning::PointsMerged { first: 1, count: 2, limit }),
                Warning::Point(PointWarning::PointsMerged { first: 5, count: 1, limit })
            ]
        );
        assert_eq!((&l.offsets[..], &l.corners[..]), (&[0, 3, 4][..], &[0, 1][..]));
    }

    #[test]
    fn rounding_of_a_full_turn_counts_as_repeated() {
        let circle: Vec<[f64; 2]> =
            (0..=12).map(|i| std::f64::consts::TAU * f64::from(i) / 12.0).map(|a| [a.cos(), a.sin()]).collect();
        let mut l = list(&circle, &[]);
        assert_eq!(merge_repeated(&mut l, true).kept, (0..12).collect::<Vec<_>>());
        assert_eq!(l.points.len(), 12);
    }

    #[test]
    fn points_that_are_all_equal_become_one() {
        let mut l = list(&[[1.0, 1.0]; 4], &[]);
        assert_eq!(merge_repeated(&mut l, true).warnings.len(), 1);
        assert_eq!(l.points.len(), 1);
    }
}
