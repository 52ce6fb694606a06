//! The distance of a point from a triangle, for coordinates of any size.

use cyclide::{Point3, Vec3};

/// A triangle, which may be flat, with what the distances of many points from it share.
///
/// Cross products of its sides are of the fourth power where they are squared: they are taken of the sides in units of the
/// longest one, which neither vanish nor overflow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Triangle {
    pub(super) corners: [Point3; 3],
    longest: f64,
    /// From each corner to the next, in units of the longest.
    sides: [Vec3; 3],
    /// Of the sides in these units, with its length; no length for a flat triangle.
    normal: Vec3,
    height: f64,
}

impl Triangle {
    pub(super) fn new(corners: [Point3; 3]) -> Self {
        let [a, b, c] = corners;
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let (mut sides, mut normal) = ([Vec3::default(); 3], Vec3::default());
        if longest > 0.0 {
            sides = [b - a, c - b, a - c].map(|side| side / longest);
            normal = sides[0].cross((c - a) / longest);
        }
        Self { corners, longest, sides, normal, height: normal.length() }
    }

    /// Distance of a point.
    pub(super) fn distance(&self, p: Point3) -> f64 {
        let [a, b, c] = self.corners;
        let inside = |k: usize| self.sides[k].cross((p - self.corners[k]) / self.longest).dot(self.normal) >= 0.0;
        if self.normal.length_squared() > 0.0 && (0..3).all(inside) {
            return (p - a).dot(self.normal).abs() / self.height;
        }
        [(a, b), (b, c), (c, a)].into_iter().map(|(from, to)| to_segment(p, from, to).1).fold(f64::INFINITY, f64::min)
    }

    /// The place nearest to a point, as weights of the corners.
    pub(super) fn nearest(&self, p: Point3) -> [f64; 3] {
        // The weight of a corner is the area beside the side across.
        let areas: [f64; 3] = std::array::from_fn(|k| {
            let across = (k + 1) % 3;
            self.sides[across].cross((p - self.corners[across]) / self.longest).dot(self.normal)
        });
        let sum = areas[0] + areas[1] + areas[2];
        if sum > 0.0 && areas.iter().all(|area| *area >= 0.0) {
            return areas.map(|area| area / sum);
        }
        let mut best = ([1.0, 0.0, 0.0], f64::INFINITY);
        for k in 0..3 {
            let next = (k + 1) % 3;
            let (part, distance) = to_segment(p, self.corners[k], self.corners[next]);
            if distance < best.1 {
                best = ([0.0; 3], distance);
                best.0[k] = 1.0 - part;
                best.0[next] = part;
            }
        }
        best.0
    }
}

/// The part of a segment up to the place nearest to a point, and its distance.
fn to_segment(p: Point3, from: Point3, to: Point3) -> (f64, f64) {
    let along = to - from;
    let squared = along.length_squared();
    let part = if squared > 0.0 { ((p - from).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (part, p.distance(from + along * part))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_from_a_triangle() {
        for scale in [1.0, 1e-150, 1e-80, 1e80, 1e120] {
            let at = |p: [f64; 3]| Point3::from(p.map(|v| v * scale));
            let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(at);
            for (p, distance) in [
                ([1.0, 1.0, 2.0], 2.0),
                ([2.0, -1.5, 0.0], 1.5),
                ([7.0, 0.0, 4.0], 5.0),
                ([4.0, 3.0, 0.0], 2.4), // 12/5 from the long side
            ] {
                let triangle = Triangle::new(triangle);
                assert!((triangle.distance(at(p)) / scale - distance).abs() < 2e-15, "{p:?} {scale:e}");
                let [x, y, z] = triangle.nearest(at(p));
                let foot = Point3::from([4.0 * y * scale, 3.0 * z * scale, 0.0]);
                assert!((x + y + z - 1.0).abs() < 1e-15 && (foot.distance(at(p)) / scale - distance).abs() < 2e-15);
            }
            let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(at);
            assert!((Triangle::new(flat).distance(at([2.0, 3.0, 0.0])) / scale - 3.0).abs() < 2e-15);
            assert!((Triangle::new([at([0.0; 3]); 3]).distance(at([3.0, 4.0, 0.0])) / scale - 5.0).abs() < 2e-15);
        }
    }
}
