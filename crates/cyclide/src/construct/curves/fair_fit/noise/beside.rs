//! How far a point is off the polyline of the points beside it, without what a bend of that explains
//! (`docs/math/fair-fits.md#outliers`).

use crate::base::vector::{Point3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A bend may leave the polyline without a point by this many times what a circle does.
const BEND: f64 = 1.5;
/// Points on a side whose directions are looked at, at most.
const REACH: usize = 8;

/// The points on either side of some that are left out.
#[derive(Clone, Copy)]
pub(super) struct Beside<'a> {
    list: &'a [Point3],
    from: usize,
    count: usize,
    closed: bool,
}

/// The points on one side, the nearest first.
type Side<'a> = &'a dyn Fn(usize) -> Option<Point3>;

impl<'a> Beside<'a> {
    /// Of `count` points of a list from a number on.
    pub fn run(list: &'a [Point3], from: usize, count: usize, closed: bool) -> Self {
        Self { list, from, count, closed }
    }

    /// Of one.
    pub fn one(list: &'a [Point3], at: usize, closed: bool) -> Self {
        Self::run(list, at, 1, closed)
    }

    /// Of a point that is none of the list, and would come before a number.
    pub fn between(list: &'a [Point3], before: usize, closed: bool) -> Self {
        Self::run(list, before, 0, closed)
    }

    fn before(&self, k: usize) -> Option<Point3> {
        around(self.list, self.from as isize - 1 - k as isize, self.closed)
    }

    fn after(&self, k: usize) -> Option<Point3> {
        around(self.list, (self.from + self.count + k) as isize, self.closed)
    }

    /// How far apart the next points on either side are; `None` at an end.
    pub fn apart(&self) -> Option<f64> {
        Some(self.before(0)?.distance(self.after(0)?))
    }

    /// How far a point is off the polyline of the others, whole and without what a bend explains. A corner is on the extrapolations
    /// of both sides.
    pub fn off(&self, point: Point3) -> (f64, f64) {
        let (before, after): (Side<'_>, Side<'_>) = (&|k| self.before(k), &|k| self.after(k));
        let neighbors: Vec<Point3> = [before(1), before(0), after(0), after(1)].into_iter().flatten().collect();
        let skipping = neighbors.windows(2).map(|w| from_segment(point, w[0], w[1])).fold(f64::INFINITY, f64::min);
        let beyond = |side: Side<'_>| {
            let near = side(0)?;
            let back = base(side, 0, near.distance(point))?.1 - near;
            let length = back.length();
            // A ray, as far as the point.
            let end = if length > 0.0 { near - back * (near.distance(point) / length) } else { near };
            Some(from_segment(point, near, end))
        };
        let sides: Vec<f64> = [beyond(before), beyond(after)].into_iter().flatten().collect();
        let extrapolated = sides.into_iter().reduce(f64::max).unwrap_or(f64::INFINITY);
        let whole = skipping.min(extrapolated);
        if !whole.is_finite() {
            return (0.0, 0.0);
        }
        (whole, (whole - BEND * self.bend(point)).max(0.0))
    }

    /// How far a circle through the points beside it leaves their polyline. Directions are those over bases at least half as long
    /// as the gap: over shorter ones noise turns them.
    fn bend(&self, point: Point3) -> f64 {
        let (before, after): (Side<'_>, Side<'_>) = (&|k| self.before(k), &|k| self.after(k));
        let turn = |a: Vec3, b: Vec3| if a.length() > 0.0 && b.length() > 0.0 { a.angle(b) } else { 0.0 };
        // The turn between two bases, as it goes on over the gap; fewer points say nothing of it.
        let at_end = |side: Side<'_>| {
            let near = side(0)?;
            let length = near.distance(point);
            let (k, far) = base(side, 0, length)?;
            let (_, farther) = base(side, k, length)?;
            let (first, second) = (far - near, farther - far);
            let further = (length + first.length()) / (first.length() + second.length());
            Some(length * (turn(first, second) * further.max(1.0)).min(FRAC_PI_2).sin())
        };
        let (Some(b), Some(a)) = (before(0), after(0)) else {
            let side = if before(0).is_none() { after } else { before };
            return at_end(side).unwrap_or(f64::INFINITY);
        };
        let half = 0.5 * b.distance(a);
        match (base(before, 0, half), base(after, 0, half)) {
            (Some((_, b2)), Some((_, a2))) => half * (turn(b - b2, a2 - a).min(PI) / 4.0).tan(),
            // Second from an end: the turn of one side, as it goes on over the chord.
            (None, Some((_, next))) => half * second(turn(a - b, next - a), a - b, next - a),
            (Some((_, next)), None) => half * second(turn(b - a, next - b), b - a, next - b),
            (None, None) => 0.0,
        }
    }
}

/// The tangent of a quarter of the turn over a chord, if that goes on as from the chord to an edge.
fn second(turn: f64, chord: Vec3, edge: Vec3) -> f64 {
    let whole = turn * 2.0 * chord.length() / (chord.length() + edge.length());
    (whole.min(PI) / 4.0).tan()
}

/// The first point of a side that is so far from its `from`-th, with its number; without one, the last that is looked at.
fn base(side: Side<'_>, from: usize, length: f64) -> Option<(usize, Point3)> {
    let near = side(from)?;
    let mut found = None;
    for k in from + 1..=from + REACH {
        let Some(far) = side(k) else { break };
        found = Some((k, far));
        if far.distance(near) >= length {
            break;
        }
    }
    found
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
pub(in super::super) fn from_segment(p: Point3, a: Point3, b: Point3) -> f64 {
    let (edge, v) = (b - a, p - a);
    let square = edge.length_squared();
    let t = if square > 0.0 { (v.dot(edge) / square).clamp(0.0, 1.0) } else { 0.0 };
    (v - edge * t).length()
}
