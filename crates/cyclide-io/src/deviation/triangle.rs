//! The distance of a point from a triangle, for coordinates of any size.

use cyclide::Point3;

/// Distance of a point from a triangle, which may be flat.
///
/// Cross products of its sides are of the fourth power where they are squared: they are taken of the sides in units of the
/// longest one, which neither vanish nor overflow.
pub(super) fn to_triangle(p: Point3, &[a, b, c]: &[Point3; 3]) -> f64 {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    if longest > 0.0 {
        let side = |from: Point3, to: Point3| (to - from) / longest;
        let normal = side(a, b).cross(side(a, c));
        let inside = |from: Point3, to: Point3| side(from, to).cross(side(from, p)).dot(normal) >= 0.0;
        if normal.length_squared() > 0.0 && inside(a, b) && inside(b, c) && inside(c, a) {
            return (p - a).dot(normal).abs() / normal.length();
        }
    }
    [(a, b), (b, c), (c, a)].into_iter().map(|(from, to)| to_segment(p, from, to)).fold(f64::INFINITY, f64::min)
}

fn to_segment(p: Point3, from: Point3, to: Point3) -> f64 {
    let along = to - from;
    let squared = along.length_squared();
    let part = if squared > 0.0 { ((p - from).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(from + along * part)
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
                assert!((to_triangle(at(p), &triangle) / scale - distance).abs() < 2e-15, "{p:?} {scale:e}");
            }
            let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(at);
            assert!((to_triangle(at([2.0, 3.0, 0.0]), &flat) / scale - 3.0).abs() < 2e-15);
            assert!((to_triangle(at([3.0, 4.0, 0.0]), &[at([0.0; 3]); 3]) / scale - 5.0).abs() < 2e-15);
        }
    }
}
