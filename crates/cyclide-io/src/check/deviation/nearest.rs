//! The triangle nearest to a point, of many: a tree of boxes, so that few of them are looked at.

use super::triangle::Triangle;
use cyclide::{Aabb, Point3};

/// Most triangles of a leaf.
const LEAF: usize = 4;

/// Triangles under a tree of boxes.
pub(super) struct NearestTriangle {
    triangles: Vec<Triangle>,
    /// In the order of a walk that goes down first.
    nodes: Vec<Node>,
    /// The triangle that was nearest last time, which is looked at first: points come one after the other.
    last: usize,
}

/// A box with all triangles of a range.
struct Node {
    bounds: Aabb,
    first: usize,
    count: usize,
    /// The first node that does not lie below this one.
    next: usize,
}

impl NearestTriangle {
    pub(super) fn new(mut triangles: Vec<Triangle>) -> Self {
        let mut nodes = Vec::with_capacity(triangles.len());
        grow(&mut triangles, 0, &mut nodes);
        Self { triangles, nodes, last: 0 }
    }

    /// Distance of a point from the nearest triangle, or what is `enough` at most: then a nearer one is not looked for.
    pub(super) fn distance(&mut self, p: Point3, enough: f64) -> f64 {
        self.search(p, enough, |triangle| triangle.distance(p))
    }

    fn search(&mut self, p: Point3, enough: f64, mut distance: impl FnMut(&Triangle) -> f64) -> f64 {
        let Some(first) = self.triangles.get(self.last) else { return f64::INFINITY };
        let mut found = Found { distance: distance(first), triangle: self.last };
        self.descend(0, p, enough, &mut found, &mut distance);
        self.last = found.triangle;
        found.distance
    }

    /// Looks for a nearer triangle below a node, in the nearer box first.
    fn descend(
        &self,
        at: usize,
        p: Point3,
        enough: f64,
        found: &mut Found,
        distance: &mut impl FnMut(&Triangle) -> f64,
    ) {
        let Some(node) = self.nodes.get(at) else { return };
        if found.distance <= enough || node.bounds.distance(p) >= found.distance {
            return;
        }
        if node.next == at + 1 {
            for (k, triangle) in self.triangles.iter().enumerate().skip(node.first).take(node.count) {
                let distance = distance(triangle);
                if distance < found.distance {
                    *found = Found { distance, triangle: k };
                }
            }
            return;
        }
        let low = at + 1;
        let high = self.nodes[low].next;
        let [to_low, to_high] = [low, high].map(|child| self.nodes[child].bounds.distance(p));
        for child in if to_low <= to_high { [low, high] } else { [high, low] } {
            self.descend(child, p, enough, found, distance);
        }
    }
}

/// The nearest triangle so far.
struct Found {
    distance: f64,
    triangle: usize,
}

/// Appends the nodes of some triangles, of which the first has the number `first`, and puts these in order.
fn grow(triangles: &mut [Triangle], first: usize, nodes: &mut Vec<Node>) {
    let Some(bounds) = Aabb::of_points(triangles.iter().flat_map(|triangle| triangle.corners)) else { return };
    let here = nodes.len();
    nodes.push(Node { bounds, first, count: triangles.len(), next: 0 });
    if triangles.len() > LEAF {
        let size = (bounds.max - bounds.min).to_array();
        let widest = if size[0] >= size[1].max(size[2]) { 0 } else { 1 + usize::from(size[2] > size[1]) };
        let place = |triangle: &Triangle| triangle.corners.iter().map(|p| p.to_array()[widest]).sum::<f64>();
        let half = triangles.len() / 2;
        triangles.select_nth_unstable_by(half, |a, b| place(a).total_cmp(&place(b)));
        let (low, high) = triangles.split_at_mut(half);
        grow(low, first, nodes);
        grow(high, first + half, nodes);
    }
    nodes[here].next = nodes.len();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn height(x: f64, y: f64) -> f64 {
        0.1 * (9.0 * x).sin() * (7.0 * y).cos()
    }

    /// A wavy sheet of `n` by `n` quads cut in two.
    fn sheet(n: usize) -> Vec<Triangle> {
        let at = |i: usize, j: usize| {
            let (x, y) = (i as f64 / n as f64, j as f64 / n as f64);
            Point3::from([x, y, height(x, y)])
        };
        let quad = |i: usize, j: usize| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        let halves = |[a, b, c, d]: [Point3; 4]| [Triangle::new([a, b, c]), Triangle::new([a, c, d])];
        (0..n * n).flat_map(|k| halves(quad(k % n, k / n))).collect()
    }

    fn points() -> impl Iterator<Item = Point3> {
        (0..500_u32).map(|k| {
            let part = |step: f64| (f64::from(k) * step).fract() * 1.4 - 0.2;
            Point3::from([part(0.618_034), part(0.754_878), 0.3 * part(0.569_84)])
        })
    }

    #[test]
    fn it_is_the_nearest_of_all() {
        let triangles = sheet(12);
        let mut nearest = NearestTriangle::new(triangles.clone());
        for p in points() {
            let all = triangles.iter().map(|triangle| triangle.distance(p)).fold(f64::INFINITY, f64::min);
            assert_eq!(nearest.distance(p, 0.0).to_bits(), all.to_bits());
            assert!(nearest.distance(p, all + 0.1) <= all + 0.1);
        }
        assert!(NearestTriangle::new(Vec::new()).distance(Point3::ORIGIN, 0.0).is_infinite());
    }

    /// For points near the sheet, as those of lost cells are, the work hardly grows with the number of triangles.
    #[test]
    fn few_triangles_are_looked_at() {
        let looked = |n: usize, enough: f64| {
            let (mut nearest, mut count) = (NearestTriangle::new(sheet(n)), 0_usize);
            for k in 0..500_u32 {
                let [x, y] = [0.618_034, 0.754_878].map(|step| (f64::from(k) * step).fract());
                let p = Point3::from([x, y, height(x, y) + 1e-3]);
                nearest.search(p, enough, |triangle| {
                    count += 1;
                    triangle.distance(p)
                });
            }
            count / 500
        };
        let [few, many] = [16, 128].map(|n| looked(n, 0.0));
        // 64 times as many triangles.
        assert!(many < 3 * few && many < 100, "{few} {many}");
        assert_eq!(looked(64, 10.0), 1);
    }
}
