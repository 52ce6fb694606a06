//! Boxes of things in a row in a tree: pairs whose boxes meet are found without looking at all.

use super::bounds::Aabb;
use std::ops::Range;

/// A balanced tree of boxes, the first half of each before the second.
pub(crate) struct BoxTree {
    nodes: Vec<Node>,
}

struct Node {
    hull: Aabb,
    items: Range<usize>,
    /// The second half; the first one is the next node.
    second: usize,
}

impl BoxTree {
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * boxes.len()) };
        if !boxes.is_empty() {
            tree.add(boxes, 0..boxes.len());
        }
        tree
    }

    fn add(&mut self, boxes: &[Aabb], items: Range<usize>) -> Aabb {
        let own = self.nodes.len();
        let hull = boxes[items.start];
        self.nodes.push(Node { hull, items: items.clone(), second: 0 });
        if items.len() > 1 {
            let middle = items.start.midpoint(items.end);
            let first = self.add(boxes, items.start..middle);
            self.nodes[own].second = self.nodes.len();
            let second = self.add(boxes, middle..items.end);
            self.nodes[own].hull = first.union(second);
        }
        self.nodes[own].hull
    }

    /// Visits each with itself and all pairs, the smaller number first, whose boxes meet, until one gives something; leaves out pairs of all of which `skip` is told true, by
    /// the ranges that they are of.
    pub(crate) fn find_within<T>(
        &self,
        skip: impl Fn(&Range<usize>, &Range<usize>) -> bool,
        visit: impl FnMut(usize, usize) -> Option<T>,
    ) -> Option<T> {
        find([self, self], true, skip, visit)
    }

    /// Visits all pairs of one of this tree and one of another whose boxes meet, until one gives something.
    pub(crate) fn find_between<T>(&self, other: &Self, visit: impl FnMut(usize, usize) -> Option<T>) -> Option<T> {
        find([self, other], false, |_, _| false, visit)
    }
}

fn find<T>(
    [first, second]: [&BoxTree; 2],
    same: bool,
    skip: impl Fn(&Range<usize>, &Range<usize>) -> bool,
    mut visit: impl FnMut(usize, usize) -> Option<T>,
) -> Option<T> {
    if first.nodes.is_empty() || second.nodes.is_empty() {
        return None;
    }
    let mut waiting = vec![[0, 0]];
    while let Some([i, j]) = waiting.pop() {
        let (a, b) = (&first.nodes[i], &second.nodes[j]);
        if !a.hull.meets(b.hull) || skip(&a.items, &b.items) {
            continue;
        }
        match (a.items.len(), b.items.len()) {
            (1, 1) => {
                let found = visit(a.items.start, b.items.start);
                if found.is_some() {
                    return found;
                }
            }
            _ if same && i == j => waiting.extend([[a.second, a.second], [i + 1, a.second], [i + 1, i + 1]]),
            (n, m) if n >= m => waiting.extend([[a.second, j], [i + 1, j]]),
            _ => waiting.extend([[i, b.second], [i, j + 1]]),
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};

    /// Intervals on a line, as boxes.
    fn boxes(intervals: &[[f64; 2]]) -> Vec<Aabb> {
        let at = |x: f64| Point3::ORIGIN + Vec3::new(x, 0.0, 0.0);
        intervals.iter().map(|[a, b]| Aabb::of_point(at(*a)).including(at(*b))).collect()
    }

    #[test]
    fn all_pairs_that_meet_are_visited_once() {
        let intervals: Vec<[f64; 2]> =
            (0..40).map(|k| f64::from(k * 17 % 40)).map(|x| [x, x + 1.0 + x % 3.0]).collect();
        let (own, others) = (boxes(&intervals), boxes(&intervals[..7]));
        let meets = |a: [f64; 2], b: [f64; 2]| a[0] <= b[1] && b[0] <= a[1];
        let mut found = Vec::new();
        let skip = |a: &Range<usize>, b: &Range<usize>| a.end <= 4 && b.end <= 4;
        let none: Option<()> = BoxTree::new(&own).find_within(skip, |i, j| {
            found.push((i, j));
            None
        });
        found.sort_unstable();
        let all = (0..40).flat_map(|i| (i..40).map(move |j| (i, j)));
        let expected: Vec<_> = all.filter(|&(i, j)| meets(intervals[i], intervals[j]) && j >= 4).collect();
        assert_eq!((none, found), (None, expected));
        let mut between = Vec::new();
        let none: Option<()> = BoxTree::new(&own).find_between(&BoxTree::new(&others), |i, j| {
            between.push((i, j));
            None
        });
        between.sort_unstable();
        let all = (0..40).flat_map(|i| (0..7).map(move |j| (i, j)));
        let expected: Vec<_> = all.filter(|&(i, j)| meets(intervals[i], intervals[j])).collect();
        assert_eq!((none, between), (None, expected));
        assert_eq!(BoxTree::new(&[]).find_within(|_, _| false, |_, _| Some(())), None);
    }
}
