//! Straight runs of measured points, and where two of them meet (`docs/math/fair-fits.md#noise`).

use super::FairFitOptions;
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::outline::CORNER_ANGLE;

/// Points on either side of a corner that must lie in a straight line, at least and at most,
pub(super) const SIDE: [usize; 2] = [5, 60];
/// and over at least so many deviations of the noise, of which one edge is this part at most: a wrong point is far off.
const LENGTH: f64 = 12.0;
const EDGE: f64 = 0.5;
/// Points of a straight run are off its line by less than this many deviations of the noise; where the corner has its place from
/// more of them, one of these is farther off more often.
const STRAIGHT: f64 = 3.0;
const STRAIGHT_BETWEEN: f64 = 3.5;
/// The corner itself may be this many times as far off both lines: it lies beyond their ends, where their direction counts too.
const BEYOND: f64 = 1.5;
/// Over a corner between two points these are as far apart as neighbors on its sides are: on average, and by so many deviations of
/// that and this part of it more. Over a rounding they are closer together than the way over the corner.
const SCATTER: f64 = 3.0;
const EVEN: f64 = 0.05;
/// A rounding of a radius of so many edges is told from a corner by that: else none is inserted.
const ROUNDING: f64 = 1.5;
/// Where noise is more than this part of an edge on average, nothing is told from single edges.
pub(super) const NOISE: f64 = 1.0 / 6.0;
/// Points of a line are off it by so many times the noise at most, as a root mean square, and it ends so many times the noise from a crossing.
const UNEVEN: f64 = 1.3;
const ALONG: f64 = 5.0;
/// Lines that bend to each other by more than so many deviations, one or both together, are an arc.
const BENT: f64 = 2.3;
/// A point is the corner itself if it is nearer than so many deviations of the noise.
const NEAR: f64 = 1.5;

/// Points in order from one on, one way or the other.
#[derive(Clone, Copy)]
struct Row<'a> {
    points: &'a [Point3],
    begin: usize,
    forward: bool,
    closed: bool,
}

impl Row<'_> {
    /// So many of them.
    fn first(self, count: usize) -> impl Iterator<Item = Point3> {
        let Self { points, begin, forward, .. } = self;
        let n = points.len();
        (0..count).map(move |k| points[if forward { begin + k } else { begin + n - k } % n])
    }

    /// How many may be of one side.
    fn most(self) -> usize {
        self.all().min(SIDE[1])
    }

    fn all(self) -> usize {
        let n = self.points.len();
        match (self.closed, self.forward) {
            (true, _) => (n - 1) / 2,
            (false, true) => n - self.begin,
            (false, false) => self.begin + 1,
        }
    }
}

/// A straight run of points.
struct Side {
    middle: Point3,
    /// Away from the point it begins with.
    direction: Vec3,
    length: f64,
    /// Lengths of its edges.
    edges: Vec<f64>,
    /// Sum of the squared distances of its points from the line.
    squares: f64,
}

impl Side {
    /// As few points of a row as are long enough to tell, if these are within some distance of a straight line.
    fn new(row: Row<'_>, length: f64, off: f64) -> Option<Self> {
        let mut own: Vec<Point3> = Vec::new();
        for p in row.first(row.most()) {
            own.push(p);
            if own.len() >= SIDE[0] && p.distance(own[0]) >= length {
                return Self::through(&own, off);
            }
        }
        None
    }

    /// The same run with as many of the points beyond it as lie in a straight line with it, by doubling from a count up to the most.
    fn extended(self, row: Row<'_>, off: f64, [from, most]: [usize; 2]) -> Self {
        let mut side = self;
        let mut count = from;
        while count <= most {
            let Some(longer) = Self::through(&row.first(count).collect::<Vec<_>>(), off) else { break };
            side = longer;
            count *= 2;
        }
        side
    }

    /// The straight line through points in order, if they are that.
    fn through(points: &[Point3], off: f64) -> Option<Self> {
        let n = points.len() as f64;
        let middle = points[0] + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - points[0])) / n;
        let step = |(i, p): (usize, &Point3)| (*p - middle) * (i as f64 - 0.5 * (n - 1.0));
        let direction = points.iter().enumerate().map(step).fold(Vec3::ZERO, |sum, v| sum + v).unit()?;
        let length = points[0].distance(points[points.len() - 1]);
        let edges: Vec<f64> = points.windows(2).map(|w| w[0].distance(w[1])).collect();
        let is_even = edges.iter().all(|edge| *edge < EDGE * length);
        let mut side = Self { middle, direction, length, edges, squares: 0.0 };
        side.squares = points.iter().map(|p| side.off(*p).powi(2)).sum();
        (is_even && points.iter().all(|p| side.off(*p) < off)).then_some(side)
    }

    fn off(&self, p: Point3) -> f64 {
        let v = p - self.middle;
        (v - self.direction * v.dot(self.direction)).length()
    }
}

/// How far apart the points on both sides of a corner are, at most.
fn farthest_apart(before: &Side, after: &Side, noise: f64) -> Option<f64> {
    let turn = (-before.direction).angle(after.direction);
    // The way over the corner of a rounding of radius 1 is longer by this.
    let excess = 2.0 * (0.5 * turn).tan() - turn;
    let edges = || before.edges.iter().chain(&after.edges);
    let count = edges().count() as f64;
    let mean = edges().sum::<f64>() / count;
    let deviation = (edges().map(|edge| (edge - mean).powi(2)).sum::<f64>() / count).sqrt();
    let slack = SCATTER * deviation + EVEN * mean;
    (noise < NOISE * mean && slack < ROUNDING * excess * mean).then_some(mean + slack)
}

fn turns(before: &Side, after: &Side, options: &FairFitOptions) -> bool {
    (-before.direction).angle(after.direction) > options.corner_angle.unwrap_or(CORNER_ANGLE)
}

/// How far one point is off both lines, where the points on both sides of it lie in straight lines that meet in it, at an angle.
pub(super) fn meet(points: &[Point3], at: usize, options: &FairFitOptions, noise: f64) -> Option<f64> {
    let n = points.len();
    let side = |forward: bool| {
        let begin = match (options.closed, forward) {
            (true, _) => (if forward { at + 1 } else { at + n - 1 }) % n,
            (false, true) => Some(at + 1).filter(|i| *i < n)?,
            (false, false) => at.checked_sub(1)?,
        };
        let row = Row { points, begin, forward, closed: options.closed };
        let side = Side::new(row, LENGTH * noise, STRAIGHT * noise)?;
        let off = side.off(points[at]);
        let meets = off < BEYOND * STRAIGHT * noise && points[at].distance(points[begin]) < EDGE * side.length;
        meets.then_some((side, off))
    };
    let ((before, off_before), (after, off_after)) = side(false).zip(side(true))?;
    turns(&before, &after, options).then_some(off_before + off_after)
}

/// Where the points up to one and those after it lie in straight lines that meet between them, at an angle, and how far the points
/// are off these, as a root of squares. Not where one of the points is as near as the noise.
pub(super) fn meet_between(
    points: &[Point3],
    at: usize,
    options: &FairFitOptions,
    noise: f64,
) -> Option<(Point3, f64)> {
    let (n, closed) = (points.len(), options.closed);
    let next = if closed { (at + 1) % n } else { Some(at + 1).filter(|i| *i < n)? };
    let rows = [(at, false), (next, true)].map(|(begin, forward)| Row { points, begin, forward, closed });
    let off = STRAIGHT_BETWEEN * noise;
    let [before, after] = rows.map(|row| Side::new(row, LENGTH * noise, off));
    let (before, after) = before.zip(after)?;
    if !turns(&before, &after, options) {
        return None;
    }
    let misfit = (before.squares + after.squares).sqrt();
    let longer = |side: Side, row: Row<'_>| side.extended(row, off, [2 * SIDE[0], row.most()]);
    let (before, after) = (longer(before, rows[0]), longer(after, rows[1]));
    let (corner, apart) = crossing(&before, &after)?;
    let [from, to] = [(corner - points[at]).dot(-before.direction), (points[next] - corner).dot(after.direction)];
    let near = NEAR * noise;
    let is_between = from > 0.0 && to > 0.0 && from + to < farthest_apart(&before, &after, noise)?;
    let is_own = corner.distance(points[at]).min(corner.distance(points[next])) < near;
    (is_between && !is_own && apart < near).then_some((corner, misfit))
}

/// Where the lines through so many points up to one and so many after it cross, at an angle, and how far the points are off these, as a root of
/// squares: where that is no more than noise, and the crossing is near both points.
pub(super) fn cross(
    points: &[Point3],
    at: usize,
    closed: bool,
    count: usize,
    options: &FairFitOptions,
    noise: f64,
) -> Option<(Point3, f64)> {
    let n = points.len();
    let next = if closed { (at + 1) % n } else { at + 1 };
    let rows = [(at, false), (next, true)].map(|(begin, forward)| Row { points, begin, forward, closed });
    if !closed && (at + 1 < count || at + 1 + count > n) {
        return None;
    }
    let side = |row: Row<'_>| Side::through(&row.first(count).collect::<Vec<_>>(), f64::INFINITY);
    let (before, after) = side(rows[0]).zip(side(rows[1]))?;
    let squares = before.squares + after.squares;
    let most = 2.0 * count as f64 * (UNEVEN * noise).powi(2);
    if squares > most || !turns(&before, &after, options) {
        return None;
    }
    let (corner, apart) = crossing(&before, &after)?;
    let is_near = |side: &Side| (corner - side.middle).dot(-side.direction) - 0.5 * side.length;
    let is_near = is_near(&before).abs().max(is_near(&after).abs()) < ALONG * noise;
    if !(is_near && apart < STRAIGHT * noise) {
        return None;
    }
    let bends = [bend(rows[0], &before, &after, count), bend(rows[1], &after, &before, count)].map(|bend| bend / noise);
    let is_straight = bends[0].max(bends[1]).max(bends[0] + bends[1]) < BENT;
    if !is_straight {
        return None;
    }
    let longer = |side: Side, row: Row<'_>| side.extended(row, STRAIGHT_BETWEEN * noise, [2 * count, row.all()]);
    let (corner, _) = crossing(&longer(before, rows[0]), &longer(after, rows[1]))?;
    Some((corner, squares.sqrt()))
}

/// How much the points of a line bend round to the next one, as they do along an arc: of unit deviation for noise of deviation 1.
fn bend(row: Row<'_>, side: &Side, next: &Side, count: usize) -> f64 {
    let u = side.direction;
    let Some(inside) = (next.direction - u * next.direction.dot(u)).unit() else { return 0.0 };
    let along: Vec<f64> = row.first(count).map(|p| (p - side.middle).dot(u)).collect();
    let mean = along.iter().map(|t| t * t).sum::<f64>() / count as f64;
    let parabola: Vec<f64> = along.iter().map(|t| t * t - mean).collect();
    let norm = parabola.iter().map(|q| q * q).sum::<f64>().sqrt();
    row.first(count).zip(&parabola).map(|(p, q)| q * (p - side.middle).dot(inside)).sum::<f64>() / norm
}

/// The point between two lines where they are nearest, and how far apart they are there.
fn crossing(a: &Side, b: &Side) -> Option<(Point3, f64)> {
    let (u, v) = (a.direction, b.direction);
    let normal = u.cross(v);
    let squared = normal.dot(normal);
    if squared == 0.0 {
        return None;
    }
    let w = b.middle - a.middle;
    let p = a.middle + u * (w.cross(v).dot(normal) / squared);
    let q = b.middle + v * (w.cross(u).dot(normal) / squared);
    Some((p.lerp(q, 0.5), p.distance(q)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner_at(shift: f64) -> Vec<Point3> {
        let at = |i: i32| f64::from(i) + shift;
        let before = (-20..0).map(|i| Point3::new(at(i), 0.0, 0.0));
        before.chain((0..20).map(|i| Point3::new(0.0, at(i), 0.0))).collect()
    }

    #[test]
    fn sides_meet_between_points_or_in_one() {
        let options = FairFitOptions::new(f64::INFINITY);
        let between = corner_at(0.6);
        let (corner, misfit) = meet_between(&between, 19, &options, 0.05).unwrap();
        assert!(corner.distance(Point3::ORIGIN) < 1e-12 && misfit < 1e-12, "{corner:?}");
        assert!((0..40).filter(|i| *i != 19).all(|i| meet_between(&between, i, &options, 0.05).is_none()));
        assert!((0..40).all(|i| meet(&between, i, &options, 0.05).is_none()));
        let own = corner_at(0.0);
        assert!((0..40).all(|i| meet_between(&own, i, &options, 0.05).is_none()));
        assert!(meet(&own, 20, &options, 0.05).unwrap() < 1e-12);
        // A rounding that holds a point is none.
        let mut round = corner_at(0.5);
        round[19] = Point3::new(-0.7, 0.2, 0.0);
        assert!((0..40).all(|i| meet_between(&round, i, &options, 0.05).is_none()));
    }
}
