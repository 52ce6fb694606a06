//! Contours on the way to faces: their sides, the places of these in the plane, and how they are cut.

use super::{Plane, Side, even_arc};
use crate::base::planar::{Point2, Vec2};
use crate::curve::ParamCurve as _;
use crate::error::Result;
use crate::topology::EdgeCurve;

/// Curves that leave a joint with less than this angle, radians, between them are as long as each other there: else their chords may
/// leave it the other way round.
const CUSP: f64 = 0.3;
/// As long as each other up to this factor.
const EVEN: f64 = 1.25;
/// Steps in which a place is found.
const HALVINGS: u32 = 40;

pub(super) struct Contours<'a> {
    pub(super) plane: &'a Plane,
    sides: Vec<Vec<Side>>,
}

impl<'a> Contours<'a> {
    pub(super) fn new(plane: &'a Plane, sides: Vec<Vec<Side>>) -> Self {
        Self { plane, sides }
    }

    pub(super) fn into_sides(self) -> Vec<Vec<Side>> {
        self.sides
    }

    /// How many sides there are.
    pub(super) fn count(&self) -> usize {
        self.sides.iter().map(Vec::len).sum()
    }

    /// All sides, contour by contour.
    pub(super) fn all(&self) -> impl Iterator<Item = &EdgeCurve> {
        self.sides.iter().flatten().map(|side| &side.curve)
    }

    /// The places where sides start, contour by contour.
    pub(super) fn places(&self) -> Vec<Point2> {
        self.all().map(|curve| self.plane.locate(curve.start())).collect()
    }

    /// The numbers of the vertices of each contour.
    pub(super) fn rings(&self) -> Vec<Vec<usize>> {
        let mut first = 0;
        let ring = |sides: &Vec<Side>| {
            let ring = (first..first + sides.len()).collect();
            first += sides.len();
            ring
        };
        self.sides.iter().map(ring).collect()
    }

    /// Cuts the longer one of two curves that bend and leave a joint next to each other.
    pub(super) fn even_cusps(&mut self) -> Result<()> {
        let plane = self.plane;
        for sides in &mut self.sides {
            let mut k = 0;
            while k < sides.len() && sides.len() > 1 {
                let before = (k + sides.len() - 1) % sides.len();
                let [arriving, leaving] = [&sides[before].curve, &sides[k].curve];
                let joint = plane.locate(leaving.start());
                if is_bent(arriving) && is_bent(leaving) && is_cusp(plane, arriving, leaving) {
                    let [a, b] =
                        [plane.locate(arriving.start()), plane.locate(leaving.end())].map(|p| p.distance(joint));
                    if a > EVEN * b {
                        let at = parameter_at(plane, &arriving.reversed(), joint, b);
                        let new = cut(&sides[before], 1.0 - at)?;
                        sides.splice(before..=before, new);
                        k += usize::from(before < k);
                    } else if b > EVEN * a {
                        let at = parameter_at(plane, leaving, joint, a);
                        let new = cut(&sides[k], at)?;
                        sides.splice(k..=k, new);
                    }
                }
                k += 1;
            }
        }
        Ok(())
    }

    /// Halves sides, those that bend; false if there are none.
    pub(super) fn halve(&mut self, which: &[usize]) -> Result<bool> {
        let (mut number, mut any) = (0, false);
        for sides in &mut self.sides {
            let mut new = Vec::with_capacity(sides.len());
            for side in sides.drain(..) {
                if which.contains(&number) && is_bent(&side.curve) {
                    new.extend(cut(&side, 0.5)?);
                    any = true;
                } else {
                    new.push(side);
                }
                number += 1;
            }
            *sides = new;
        }
        Ok(any)
    }

    /// The sides whose chords are in the way of a triangulation: of contours of fewer than three, that meet, or that do not lie in each
    /// other as the contours do.
    pub(super) fn chords_in_the_way(&self) -> Option<Vec<usize>> {
        let (rings, places) = (self.rings(), self.places());
        let small: Vec<usize> = rings.iter().filter(|ring| ring.len() < 3).flatten().copied().collect();
        if !small.is_empty() {
            return Some(small);
        }
        let next = next_of(&rings, places.len());
        let mut crossing = Vec::new();
        for a in 0..places.len() {
            for b in a + 1..places.len() {
                if next[a] != b && next[b] != a && meet([places[a], places[next[a]]], [places[b], places[next[b]]]) {
                    crossing.extend([a, b]);
                }
            }
        }
        if !crossing.is_empty() {
            crossing.sort_unstable();
            crossing.dedup();
            return Some(crossing);
        }
        let polygon = |ring: &[usize]| ring.iter().map(|&k| places[k]).collect::<Vec<_>>();
        let polygons: Vec<_> = rings.iter().map(|ring| polygon(ring)).collect();
        let outer: Vec<usize> = (0..polygons.len()).filter(|&k| area(&polygons[k]) > 0.0).collect();
        let nested = |outer: usize| {
            (0..polygons.len()).filter(|&k| k != outer).all(|k| {
                let place = polygons[k][0];
                (0..polygons.len()).all(|j| j == k || is_inside(&polygons[j], place) == (j == outer))
            })
        };
        let right = matches!(outer[..], [outer] if nested(outer));
        (!right).then(|| (0..places.len()).collect())
    }
}

/// The vertex after each one.
pub(super) fn next_of(rings: &[Vec<usize>], count: usize) -> Vec<usize> {
    let mut next = vec![0; count];
    for ring in rings {
        for (k, &vertex) in ring.iter().enumerate() {
            next[vertex] = ring[(k + 1) % ring.len()];
        }
    }
    next
}

/// Whether a side bends.
pub(super) fn is_bent(curve: &EdgeCurve) -> bool {
    !matches!(curve, EdgeCurve::Arc(arc) if arc.is_straight())
}

/// Positive where the last point is to the left of the way through the other two.
pub(super) fn turn(a: Point2, b: Point2, c: Point2) -> f64 {
    (b - a).cross(c - a)
}

/// Whether two segments have a point in common.
pub(super) fn meet(a: [Point2; 2], b: [Point2; 2]) -> bool {
    let boxes = |x: [f64; 2], y: [f64; 2]| x[0].min(x[1]) <= y[0].max(y[1]) && y[0].min(y[1]) <= x[0].max(x[1]);
    let [xs, ys] = [[a, b].map(|s| s.map(|p| p.x)), [a, b].map(|s| s.map(|p| p.y))];
    let splits = |s: [Point2; 2], other: [Point2; 2]| turn(s[0], s[1], other[0]) * turn(s[0], s[1], other[1]) <= 0.0;
    boxes(xs[0], xs[1]) && boxes(ys[0], ys[1]) && splits(a, b) && splits(b, a)
}

/// Twice the area of a polygon, positive if it is to the left.
fn area(polygon: &[Point2]) -> f64 {
    (0..polygon.len()).map(|k| (polygon[k] - polygon[0]).cross(polygon[(k + 1) % polygon.len()] - polygon[0])).sum()
}

fn is_inside(polygon: &[Point2], p: Point2) -> bool {
    let crosses = |k: usize| {
        let [from, to] = [polygon[k], polygon[(k + 1) % polygon.len()]];
        (from.y > p.y) != (to.y > p.y) && (turn(from, to, p) > 0.0) == (to.y > from.y)
    };
    (0..polygon.len()).filter(|&k| crosses(k)).count() % 2 == 1
}

/// Both parts of a side.
fn cut(side: &Side, at: f64) -> Result<[Side; 2]> {
    let (first, second) = side.curve.split(at)?;
    Ok([first, second].map(|curve| Side { source: side.source, curve: even_arc(curve) }))
}

/// Whether two curves leave the joint between them next to each other.
fn is_cusp(plane: &Plane, arriving: &EdgeCurve, leaving: &EdgeCurve) -> bool {
    let direction = |curve: &EdgeCurve| {
        let d = curve.piece_jet(0, 0.0).limit_tangent(1.0).unwrap_or_default();
        Vec2::new(d.dot(plane.axes[0]), d.dot(plane.axes[1])).unit()
    };
    let directions = direction(&arriving.reversed()).zip(direction(leaving));
    directions.is_some_and(|(back, on)| back.dot(on) > 0.0 && back.cross(on).abs() < CUSP)
}

/// The parameter at which a curve is at a distance from its start.
fn parameter_at(plane: &Plane, curve: &EdgeCurve, start: Point2, distance: f64) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if plane.locate(curve.point(middle)).distance(start) < distance { low = middle } else { high = middle }
    }
    // Not an end, which nothing would be cut off at.
    (0.5 * (low + high)).clamp(1e-3, 1.0 - 1e-3)
}
