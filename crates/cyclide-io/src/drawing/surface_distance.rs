//! Signed distances of points from a surface that was given by its vertices.
//!
//! Between the vertices the surface is taken as smooth: of a place with the barycentric coordinates `λ` in the nearest triangle with
//! corners `p` and normals `n`, the tangent planes at the corners pass at the distances `d = n·(p - q)` from the place `q`, and the surface
//! at half their mean, `q + m Σ λ d/2` along the mean normal `m`. That is exact where it is a quadratic, so that the flatness of the
//! triangles is no deviation.

use crate::export::given_surface::GivenSurface;
use cyclide::{Aabb, Point3, Vec3};

/// Triangles of a leaf.
const LEAF: usize = 4;
/// Beyond the border of the surface it goes on for this many times the size of the nearest triangle.
const BEYOND: f64 = 1.0;

/// A given surface in a tree of boxes.
pub(crate) struct SurfaceDistance<'a> {
    given: &'a GivenSurface,
    /// The triangles in the order of the tree.
    order: Vec<usize>,
    nodes: Vec<Node>,
}

struct Node {
    bounds: Aabb,
    items: std::ops::Range<usize>,
    /// The second half; the first one is the next node. 0 for a leaf.
    second: usize,
}

/// A place on a triangle.
#[derive(Clone, Copy)]
struct Foot {
    triangle: usize,
    at: [f64; 3],
    squared: f64,
}

impl<'a> SurfaceDistance<'a> {
    pub(crate) fn new(given: &'a GivenSurface) -> Self {
        let middles: Vec<Point3> = (0..given.triangles.len()).map(|t| middle(corners(given, t))).collect();
        let mut tree = Self { given, order: (0..middles.len()).collect(), nodes: Vec::new() };
        if !middles.is_empty() {
            tree.add(&middles, 0..middles.len());
        }
        tree
    }

    fn add(&mut self, middles: &[Point3], items: std::ops::Range<usize>) {
        let own = &self.order[items.clone()];
        let bounds =
            Aabb::of_points(own.iter().flat_map(|t| corners(self.given, *t))).unwrap_or(Aabb::of_point(Point3::ORIGIN));
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, items: items.clone(), second: 0 });
        if items.len() <= LEAF {
            return;
        }
        let extent = (bounds.max - bounds.min).to_array();
        let axis = (0..3).max_by(|a, b| extent[*a].total_cmp(&extent[*b])).unwrap_or(0);
        let half = items.len() / 2;
        let at = |t: &usize| middles[*t].to_vec().to_array()[axis];
        self.order[items.clone()].select_nth_unstable_by(half, |a, b| at(a).total_cmp(&at(b)).then(a.cmp(b)));
        self.add(middles, items.start..items.start + half);
        self.nodes[node].second = self.nodes.len();
        self.add(middles, items.start + half..items.end);
    }

    /// How far a point is from the surface along its normal, positive on the side that `outward` points to; `None` where the surface
    /// has ended, or has no normal.
    pub(crate) fn signed(&self, p: Point3, outward: Vec3) -> Option<f64> {
        let foot = self.foot(p)?;
        let corner_ids = self.given.triangles[foot.triangle];
        let places = corners(self.given, foot.triangle);
        let q = combined(places, foot.at);
        let normals = corner_ids.map(|v| self.given.normals.get(v).copied().unwrap_or_default());
        let mean = (0..3).fold(Vec3::ZERO, |sum, k| sum + normals[k] * foot.at[k]).unit()?;
        let rise: f64 = (0..3).map(|k| 0.5 * foot.at[k] * normals[k].dot(places[k] - q) / normals[k].dot(mean)).sum();
        let away = p - q;
        let height = away.dot(mean);
        let aside = (away - mean * height).length();
        let size = (places[1] - places[0]).cross(places[2] - places[0]).length().sqrt();
        if aside > BEYOND * size + 0.5 * height.abs() {
            return None;
        }
        let signed = height - rise;
        Some(if mean.dot(outward) < 0.0 { -signed } else { signed })
    }

    /// The nearest place.
    fn foot(&self, p: Point3) -> Option<Foot> {
        let mut best: Option<Foot> = None;
        let mut open = vec![0];
        while let Some(index) = open.pop() {
            let Some(node) = self.nodes.get(index) else { continue };
            if best.is_some_and(|best| squared_to_box(p, node.bounds) >= best.squared) {
                continue;
            }
            if node.second == 0 {
                for &triangle in &self.order[node.items.clone()] {
                    let at = nearest(p, corners(self.given, triangle));
                    let squared = (combined(corners(self.given, triangle), at) - p).length_squared();
                    if best.is_none_or(|best| squared < best.squared) {
                        best = Some(Foot { triangle, at, squared });
                    }
                }
                continue;
            }
            // The nearer half last, which is looked at first.
            let halves = [index + 1, node.second];
            let far = |k: usize| squared_to_box(p, self.nodes[k].bounds);
            let (near, other) =
                if far(halves[0]) <= far(halves[1]) { (halves[0], halves[1]) } else { (halves[1], halves[0]) };
            open.extend([other, near]);
        }
        best
    }
}

fn corners(given: &GivenSurface, triangle: usize) -> [Point3; 3] {
    given.triangles[triangle].map(|v| given.points.get(v).copied().unwrap_or(Point3::ORIGIN))
}

fn middle([a, b, c]: [Point3; 3]) -> Point3 {
    a + ((b - a) + (c - a)) / 3.0
}

fn combined([a, b, c]: [Point3; 3], at: [f64; 3]) -> Point3 {
    a + (b - a) * at[1] + (c - a) * at[2]
}

fn squared_to_box(p: Point3, bounds: Aabb) -> f64 {
    let out = |v: f64, low: f64, high: f64| (low - v).max(v - high).max(0.0).powi(2);
    let (a, b) = (bounds.min, bounds.max);
    out(p.x, a.x, b.x) + out(p.y, a.y, b.y) + out(p.z, a.z, b.z)
}

/// The barycentric coordinates of the nearest place of a triangle, by the region that the point is in (C. Ericson, Real-Time Collision
/// Detection, 2005, 5.1.5).
fn nearest(p: Point3, [a, b, c]: [Point3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let along = |from: Point3| (ab.dot(p - from), ac.dot(p - from));
    let ((d1, d2), (d3, d4), (d5, d6)) = (along(a), along(b), along(c));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let part = |over: f64, under: f64| if under > 0.0 { (over / under).clamp(0.0, 1.0) } else { 0.0 };
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = part(d1, d1 - d3);
        return [1.0 - v, v, 0.0];
    }
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = part(d2, d2 - d6);
        return [1.0 - w, 0.0, w];
    }
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let w = part(d4 - d3, (d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - w, w];
    }
    let sum = va + vb + vc;
    if sum > 0.0 { [va / sum, vb / sum, vc / sum] } else { [1.0, 0.0, 0.0] }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use cyclide::surface::QuadGrid;

    /// A part of a sphere over a coarse grid of angles.
    fn sphere(radius: f64) -> GivenSurface {
        let at = |k: usize| (0.15 * (k % 9) as f64, 0.15 * (k / 9) as f64 - 0.6);
        let point =
            |(a, b): (f64, f64)| Point3::ORIGIN + Vec3::new(b.cos() * a.cos(), b.cos() * a.sin(), b.sin()) * radius;
        GivenSurface::from_grid(&QuadGrid::new((0..81).map(at).map(point).collect(), [9, 9], [false; 2]).unwrap())
    }

    #[test]
    fn the_distance_of_concentric_spheres_is_the_difference_of_their_radii() {
        let given = sphere(2.0);
        let tree = SurfaceDistance::new(&given);
        for (a, b) in (0..400).map(|k| (0.06 * f64::from(k % 20) + 0.01, 0.055 * f64::from(k / 20) - 0.55)) {
            let outward = Vec3::new(b.cos() * a.cos(), b.cos() * a.sin(), b.sin());
            for (radius, sign) in [(2.0, 1.0), (2.03, 1.0), (1.9, 1.0), (2.03, -1.0)] {
                let found = tree.signed(Point3::ORIGIN + outward * radius, outward * sign).unwrap();
                // Chords of 0.3 are 0.006 from the sphere; what is left is of the order of the fourth power of the angle, and of the
                // distance times the square.
                assert!((found - sign * (radius - 2.0)).abs() < 2e-4, "{found} at {a} {b} for {radius}");
            }
        }
    }

    #[test]
    fn beyond_the_border_there_is_no_distance() {
        let given = sphere(2.0);
        let tree = SurfaceDistance::new(&given);
        assert!(tree.signed(Point3::new(-2.0, 0.0, 0.0), -Vec3::X).is_none());
        assert!(SurfaceDistance::new(&GivenSurface::default()).signed(Point3::ORIGIN, Vec3::X).is_none());
    }

    #[test]
    fn the_nearest_place_is_found_in_every_region() {
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(Point3::from);
        for (p, foot) in [
            ([1.0, 1.0, 5.0], [1.0, 1.0, 0.0]),
            ([-1.0, -2.0, 1.0], [0.0, 0.0, 0.0]),
            ([9.0, -1.0, 0.0], [4.0, 0.0, 0.0]),
            ([-1.0, 7.0, 0.0], [0.0, 3.0, 0.0]),
            ([2.0, -3.0, 0.0], [2.0, 0.0, 0.0]),
            ([-2.0, 1.0, 2.0], [0.0, 1.0, 0.0]),
            ([2.0 + 3.0, 1.5 + 4.0, 0.0], [2.0, 1.5, 0.0]),
        ] {
            let found = combined(triangle, nearest(Point3::from(p), triangle));
            assert!(found.distance(Point3::from(foot)) < 1e-12, "{p:?}: {found:?}");
        }
    }
}
