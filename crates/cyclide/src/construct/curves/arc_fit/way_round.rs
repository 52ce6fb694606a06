//! The order in which the search takes the points: from a start and in a direction that they themselves single out, so
//! that the arcs do not depend on the point that happens to be first in a list, nor on its direction
//! (`docs/math/arc-fitting.md#limits`).

use super::input::Distinct;
use crate::base::vector::Point3;
use crate::construct::curves::canonical_start::{canonical_start, runs_backwards};
use crate::curve::Arc;

/// An order of the points of a list.
pub(super) struct WayRound {
    /// The number each point has in the list, in this order.
    order: Vec<usize>,
    /// The first point of the list.
    first: Point3,
    backwards: bool,
    closed: bool,
}

impl WayRound {
    /// Of a list of at least one point.
    pub fn of(points: &[Point3], closed: bool) -> Self {
        let n = points.len();
        let backwards = runs_backwards(points, closed);
        let mut order: Vec<usize> = (0..n).collect();
        if backwards {
            order.reverse();
        }
        if closed {
            let start = canonical_start(points);
            order.rotate_left(if backwards { n - 1 - start } else { start });
        }
        Self { order, first: points[0], backwards, closed }
    }

    /// The other direction from there.
    pub fn turned(mut self) -> Self {
        self.order[usize::from(self.closed)..].reverse();
        self.backwards = !self.backwards;
        self
    }

    /// The points in this order, and the rising places in it of those that a list numbers so.
    pub fn taken(&self, list: &Distinct, numbers: &[usize]) -> (Distinct, Vec<usize>) {
        let mut place = vec![0; self.order.len()];
        for (at, number) in self.order.iter().enumerate() {
            place[*number] = at;
        }
        let mut places: Vec<usize> = numbers.iter().map(|number| place[*number]).collect();
        places.sort_unstable();
        (list.in_order(&self.order), places)
    }

    /// The arcs in the direction of the list, closed ones from the joint nearest to its first point on; and the place
    /// of the one that was first.
    pub fn back(&self, mut arcs: Vec<Arc>) -> (Vec<Arc>, impl Fn(usize) -> usize) {
        let n = arcs.len();
        if self.backwards {
            arcs = arcs.iter().rev().map(Arc::reversed).collect();
        }
        let away = |i: &usize| arcs[*i].start().distance(self.first);
        let start = (0..n).filter(|_| self.closed).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(0);
        arcs.rotate_left(start);
        let backwards = self.backwards;
        (arcs, move |place| (if backwards { n - 1 - place } else { place } + n - start) % n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_order_from_every_start_and_both_ways() {
        let points: Vec<Point3> = (0..12)
            .map(|i| {
                let (s, c) = (0.5 * f64::from(i)).sin_cos();
                Point3::new((3.0 + 0.1 * f64::from(i * i % 7)) * c, 3.0 * s, 0.0)
            })
            .collect();
        let taken = |points: &[Point3]| {
            let list = Distinct::of(points.to_vec(), (0..points.len()).collect(), Vec::new());
            let (taken, corners) = WayRound::of(points, true).taken(&list, &[0, 5]);
            // What was the first of the list is among the corners.
            assert!(corners.iter().any(|c| taken.points[*c] == points[0] && taken.source[*c] == 0));
            taken.points
        };
        let reference = taken(&points);
        for start in 0..points.len() {
            let mut turned = points.clone();
            turned.rotate_left(start);
            assert_eq!(taken(&turned), reference, "{start}");
            turned.reverse();
            assert_eq!(taken(&turned), reference, "{start} back");
        }
        let list = Distinct::of(points.clone(), (0..points.len()).collect(), Vec::new());
        let mut other = WayRound::of(&points, true).turned().taken(&list, &[]).0.points;
        other[1..].reverse();
        assert_eq!(other, reference);
    }

    #[test]
    fn arcs_go_back_to_the_first_point_of_the_list() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let corners = [at(0.0, 0.0), at(4.0, 0.0), at(4.0, 3.0)];
        let triangle: Vec<Arc> = (0..3).map(|i| Arc::segment(corners[i], corners[(i + 1) % 3]).unwrap()).collect();
        let way = WayRound { order: vec![0, 2, 1], first: corners[1], backwards: true, closed: true };
        let (back, place) = way.back(triangle.clone());
        let starts: Vec<Point3> = back.iter().map(Arc::start).collect();
        assert_eq!(starts, [corners[1], corners[0], corners[2]]);
        for (i, arc) in triangle.iter().enumerate() {
            assert_eq!(back[place(i)].start(), arc.end(), "{i}");
        }
    }
}
