//! Whether two rails run the same way, and whether the straight lines between them go through each other.
//!
//! Each piece of a ruled surface is checked by the kernel; pieces that are no neighbors may still cross, as they all do where a closed rail runs against
//! the other one.

use cyclide::{Point3, Vec3, topology::EdgeCurve};

/// Rulings that are looked at, at most, and in each piece.
const MOST_RULINGS: usize = 512;

const RULINGS: usize = 6;

/// Where they are: beside the places at which figures that are symmetric meet in corners and edges only.
const BESIDE: f64 = 0.37;

/// Rulings cross a face inside of it by more than this part.
const INSIDE: f64 = 1e-6;

/// Lines between rails that are longer by this factor than with one of them reversed are remarked: of closed rails, and of open ones, which may be twisted on purpose.
const LONGER: [f64; 2] = [1.1, 1.5];

/// Straight lines between two rails, in order.
pub(in crate::document) struct Rulings {
    lines: Vec<[Point3; 2]>,
    closed: bool,
}

impl Rulings {
    /// Between pieces of as many.
    pub(in crate::document) fn of([first, second]: [&[EdgeCurve]; 2], closed: bool) -> Self {
        let count = first.len().min(second.len());
        let each = (MOST_RULINGS / count.max(1)).clamp(1, RULINGS);
        let skip = count.div_ceil(MOST_RULINGS).max(1);
        let mut lines = Vec::new();
        for (a, b) in first.iter().zip(second).step_by(skip) {
            let places = (0..each).map(|k| (k as f64 + BESIDE) / each as f64);
            lines.extend(places.map(|s| [a.point(s), b.point(s)]));
        }
        Self { lines, closed }
    }

    /// Twice the areas that closed rails go round, as vectors.
    fn areas(&self) -> [Vec3; 2] {
        [0, 1].map(|end: usize| {
            let Some(first) = self.lines.first().map(|line| line[end]) else { return Vec3::ZERO };
            let pairs = self.lines.windows(2);
            pairs.fold(Vec3::ZERO, |sum, pair| sum + (pair[0][end] - first).cross(pair[1][end] - first))
        })
    }

    /// True of closed rails that go round in opposite senses.
    pub(in crate::document) fn opposite(&self) -> bool {
        let [a, b] = self.areas();
        self.closed && a.dot(b) < 0.0
    }

    /// The length of all of them together.
    fn length(&self) -> f64 {
        self.lines.iter().map(|[a, b]| a.distance(*b)).sum()
    }

    /// Whether these are so much longer than those with one rail reversed that it may be meant to run that way.
    pub(in crate::document) fn are_longer_than(&self, reversed: &Self) -> bool {
        self.length() > LONGER[usize::from(!self.closed)] * reversed.length()
    }

    /// How alike the two rails are, seen from their middles: 1 if one is the other, larger or smaller, and the cosine of the angle by which it is
    /// turned.
    pub(in crate::document) fn likeness(&self) -> f64 {
        let count = self.lines.len() as f64;
        let middles = [0, 1].map(|end: usize| {
            self.lines.iter().fold(Vec3::ZERO, |sum, line| sum + (line[end] - self.lines[0][end])) / count
        });
        let own = |line: &[Point3; 2], end: usize| line[end] - self.lines[0][end] - middles[end];
        let sum = |a: usize, b: usize| self.lines.iter().map(|line| own(line, a).dot(own(line, b))).sum::<f64>();
        let size = (sum(0, 0) * sum(1, 1)).sqrt();
        if size > 0.0 { sum(0, 1) / size } else { 0.0 }
    }

    /// Whether one of them goes through the surface between two others that are no neighbors of it.
    pub(in crate::document) fn cross(&self) -> bool {
        let count = self.lines.len();
        let faces = if self.closed { count } else { count.saturating_sub(1) };
        (0..faces).any(|face| {
            let next = (face + 1) % count;
            let [[a, b], [c, d]] = [self.lines[face], self.lines[next]];
            let beside = [(face + count - 1) % count, face, next, (next + 1) % count];
            let others = self.lines.iter().enumerate().filter(|(k, _)| !beside.contains(k));
            others.into_iter().any(|(_, line)| goes_through(*line, [a, b, d]) || goes_through(*line, [a, d, c]))
        })
    }
}

/// Whether a segment goes through a triangle inside of both.
fn goes_through([from, to]: [Point3; 2], [a, b, c]: [Point3; 3]) -> bool {
    let (way, u, v) = (to - from, b - a, c - a);
    let normal = u.cross(v);
    let across = normal.dot(way);
    let size = normal.length() * way.length();
    if across.abs() <= INSIDE * size {
        return false;
    }
    let t = normal.dot(a - from) / across;
    let hit = way.cross(from - a);
    let (s, r) = (v.dot(hit) / across, -u.dot(hit) / across);
    let is_inside = |x: f64| x > INSIDE && x < 1.0 - INSIDE;
    is_inside(t) && s > INSIDE && r > INSIDE && s + r < 1.0 - INSIDE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_goes_through_a_triangle_inside_of_both_only() {
        let triangle = [Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0), Point3::new(0.0, 3.0, 0.0)];
        let through = |x: f64, y: f64, z: [f64; 2]| goes_through(z.map(|z| Point3::new(x, y, z)), triangle);
        assert!(through(1.0, 1.0, [-1.0, 2.0]) && through(0.1, 2.5, [2.0, -1.0]) && through(2.5, 0.1, [2.0, -1.0]));
        assert!(!through(2.0, 2.0, [-1.0, 2.0]) && !through(1.0, 1.0, [1.0, 2.0]) && !through(-0.1, 1.0, [-1.0, 2.0]));
        assert!(!through(1.0, -0.1, [-1.0, 2.0]) && !through(1.0, 1.0, [0.0, 2.0]));
    }
}
