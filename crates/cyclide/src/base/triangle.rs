//! Distances of points from triangles.

use super::vector::Point3;

/// Distance of a point from a triangle, and the weights of the corners at the nearest point: of the foot on the plane if
/// that is inside, else on the nearest side. `None` for a triangle without area.
pub fn on_triangle(p: Point3, [a, b, c]: [Point3; 3]) -> Option<(f64, [f64; 3])> {
    let normal = (b - a).cross(c - a).unit()?;
    let sides = [[a, b], [b, c], [c, a]];
    let areas = sides.map(|[from, to]| normal.dot((to - from).cross(p - from)));
    if areas.iter().all(|area| *area >= 0.0) {
        let total = areas[0] + areas[1] + areas[2];
        // A side's area belongs to the corner opposite to it.
        return Some((normal.dot(p - a).abs(), [areas[1], areas[2], areas[0]].map(|area| area / total)));
    }
    let on_side = |k: usize| {
        let [from, to] = sides[k];
        let side = to - from;
        let along = ((p - from).dot(side) / side.length_squared()).clamp(0.0, 1.0);
        let mut weights = [0.0; 3];
        (weights[k], weights[(k + 1) % 3]) = (1.0 - along, along);
        (p.distance(from.lerp(to, along)), weights)
    };
    (0..3).map(on_side).min_by(|x, y| x.0.total_cmp(&y.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_from_a_triangle() {
        let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point3::from);
        for (p, distance) in [
            ([0.5, 0.5, -3.0], 3.0),           // inside
            ([1.0, -3.0, 4.0], 5.0),           // nearest to a side
            ([2.0, 2.0, 0.0], 2.0_f64.sqrt()), // nearest to the slanted side
            ([-3.0, -4.0, 0.0], 5.0),          // nearest to a corner
        ] {
            let p = Point3::from(p);
            let (found, weights) = on_triangle(p, corners).unwrap();
            let [a, b, c] = corners;
            let foot = a + (b - a) * weights[1] + (c - a) * weights[2];
            assert!((found - distance).abs() < 1e-15 && (p.distance(foot) - distance).abs() < 1e-15);
            assert!(weights.iter().all(|w| *w >= 0.0) && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        }
        assert!(on_triangle(Point3::ORIGIN, [corners[0], corners[1], corners[0].lerp(corners[1], 0.5)]).is_none());
    }
}
