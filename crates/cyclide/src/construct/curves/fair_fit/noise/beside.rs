//! How far a point is off the polyline of the points beside it, without what a bend of that explains
//! (`docs/math/fair-fits.md#outliers`).

use crate::base::vector::{Point3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A bend may leave the polyline without a point by this many times what a circle does.
const BEND: f64 = 1.5;
/// Extrapolations go on for this many edges.
const BEYOND: f64 = 2.0;

/// The three points on either side of some that are left out, the nearest first.
pub(super) struct Beside {
    before: [Option<Point3>; 3],
    after: [Option<Point3>; 3],
}

impl Beside {
    /// Of `count` points of a list from a number on.
    pub fn run(list: &[Point3], from: usize, count: usize, closed: bool) -> Self {
        let from = from as isize;
        let before = [1, 2, 3].map(|k| around(list, from - k, closed));
        let after = [0, 1, 2].map(|k| around(list, from + count as isize + k, closed));
        Self { before, after }
    }

    /// Of one.
    pub fn one(list: &[Point3], at: usize, closed: bool) -> Self {
        Self::run(list, at, 1, closed)
    }

    /// Of a point that is none of the list, and would come before a number.
    pub fn between(list: &[Point3], before: usize, closed: bool) -> Self {
        Self::run(list, before, 0, closed)
    }

    /// How far apart the next points on either side are; `None` at an end.
    pub fn apart(&self) -> Option<f64> {
        Some(self.before[0]?.distance(self.after[0]?))
    }

    /// How far a point is off the polyline of the others, whole and without what a bend explains. A corner is on the extrapolations
    /// of both sides.
    pub fn off(&self, point: Point3) -> (f64, f64) {
        let (before, after) = (self.before, self.after);
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
        (whole, (whole - BEND * self.bend(point)).max(0.0))
    }

    /// How far a circle through the points beside it leaves their polyline.
    fn bend(&self, point: Point3) -> f64 {
        let turn = |a: Vec3, b: Vec3| if a.length() > 0.0 && b.length() > 0.0 { a.angle(b) } else { 0.0 };
        let at_end = |side: &[Option<Point3>; 3]| match side {
            [Some(a), Some(b), Some(c)] => a.distance(point) * turn(*b - *a, *c - *b).min(FRAC_PI_2).sin(),
            _ => 0.0,
        };
        match (self.before, self.after) {
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
        }
    }
}

/// The entry of a list at a number, round a closed one.
pub(super) fn around<T: Copy>(list: &[T], k: isize, closed: bool) -> Option<T> {
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

/// Distance of a point from a segment.
pub(super) fn from_segment(p: Point3, a: Point3, b: Point3) -> f64 {
    let (edge, v) = (b - a, p - a);
    let square = edge.length_squared();
    let t = if square > 0.0 { (v.dot(edge) / square).clamp(0.0, 1.0) } else { 0.0 };
    (v - edge * t).length()
}
