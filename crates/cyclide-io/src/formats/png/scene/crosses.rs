//! Where crosses along the lines of curvature are drawn on a surface.

use super::camera::Camera;
use crate::export::given_surface::GivenSurface;
use cyclide::Point3;
use std::collections::{HashMap, HashSet};

/// Two crosses at one place of the picture are on sheets of their own if their depths differ by so many times what crosses are apart.
const SHEETS: f64 = 3.0;

/// Triangles for crosses with arms of so many pixels, at least `apart` arms from each other in the picture: so far as they are on one
/// sheet of the surface and on the same side of it, so that what is hidden takes no place from what is seen. Where arms would reach over
/// the border there are none.
pub(super) fn crosses(surface: &GivenSurface, camera: &Camera, arm: f64, apart: f64) -> Vec<usize> {
    let border = border(surface);
    let side = arm * apart;
    // Places in units of the least distance, by cells of the picture and the side of the surface.
    let mut taken: HashMap<(i64, i64, bool), Vec<[f64; 3]>> = HashMap::new();
    let mut chosen = Vec::new();
    for (index, triangle) in surface.triangles.iter().enumerate() {
        let place = middle(surface, index);
        let (at, from_eye) = (camera.project(place), place - camera.eye());
        let [a, b, c] = triangle.map(|v| surface.points[v]);
        let away = (b - a).cross(c - a).dot(from_eye) > 0.0;
        let depth = from_eye.dot(camera.axes()[2]) / (camera.unit() * side);
        let own = [at.x / side, at.y / side, depth];
        let [column, row] = [own[0], own[1]].map(|v| v.floor() as i64);
        let around = (0..9).filter_map(|k| taken.get(&(column + k % 3 - 1, row + k / 3 - 1, away)));
        let is_near =
            |other: &[f64; 3]| (own[0] - other[0]).hypot(own[1] - other[1]) < 1.0 && (own[2] - other[2]).abs() < SHEETS;
        let reach = arm * camera.unit_at(place);
        if !around.flatten().any(is_near) && border.iter().all(|ends| distance(place, *ends) > reach) {
            taken.entry((column, row, away)).or_default().push(own);
            chosen.push(index);
        }
    }
    chosen
}

/// The middle of a triangle.
pub(super) fn middle(surface: &GivenSurface, triangle: usize) -> Point3 {
    let [a, b, c] = surface.triangles[triangle].map(|v| surface.points[v]);
    a + ((b - a) + (c - a)) / 3.0
}

/// The ends of the edges with one triangle.
fn border(surface: &GivenSurface) -> Vec<[Point3; 2]> {
    let edges = || surface.triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let all: HashSet<[usize; 2]> = edges().collect();
    edges().filter(|[a, b]| !all.contains(&[*b, *a])).map(|ends| ends.map(|v| surface.points[v])).collect()
}

fn distance(p: Point3, [a, b]: [Point3; 2]) -> f64 {
    let (d, along) = (p - a, b - a);
    let t = (d.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    // Ends that are one: the quotient is no number.
    if t.is_nan() { d.length() } else { (d - along * t).length() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::Vec3;
    use std::f64::consts::TAU;

    /// A tube, its triangles from the far side to the near one as files may have them.
    fn tube() -> GivenSurface {
        let (m, n) = (96, 40);
        let point = |k: usize| {
            let (y, x) = (TAU * (k % m) as f64 / m as f64).sin_cos();
            Point3::new(x, y, 3.0 * (k / m) as f64 / n as f64)
        };
        let points: Vec<Point3> = (0..m * (n + 1)).map(point).collect();
        let quads = (0..m * n).map(|k| [k, k / m * m + (k + 1) % m, k / m * m + (k + 1) % m + m, k + m]);
        let mut triangles: Vec<[usize; 3]> = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        triangles.sort_by(|s, t| points[t[0]].y.total_cmp(&points[s[0]].y));
        GivenSurface { normals: vec![Vec3::Z; points.len()], points, triangles }
    }

    #[test]
    fn the_near_side_of_a_tube_has_crosses() {
        let tube = tube();
        for flat in [true, false] {
            let axes = [Vec3::X, Vec3::Z, -Vec3::Y];
            let camera = Camera::new(&tube.points, axes, flat, (1600.0, 1200.0));
            let places: Vec<Point3> = crosses(&tube, &camera, 9.5, 3.0).into_iter().map(|k| middle(&tube, k)).collect();
            // As many before as behind, and on every part of the near side that is as wide as a few crosses.
            let near = |p: &Point3| p.y < 0.0;
            let count = places.iter().filter(|p| near(p)).count();
            assert!(count > 200 && 3 * count > places.len(), "{flat}: {count} of {}", places.len());
            for k in 0..40 {
                let (x, z) = (0.4 * (k % 5) as f64 - 0.8, 0.3 * (k / 5) as f64 + 0.4);
                let apart = |p: &Point3| (p.x - x).hypot(p.z - z);
                assert!(places.iter().filter(|p| near(p)).any(|p| apart(p) < 0.25), "{flat}: {x} {z}");
            }
            // No arm reaches over the ends.
            let arm = |p: &Point3| 9.5 * camera.unit_at(*p);
            assert!(places.iter().all(|p| p.z > arm(p) && 3.0 - p.z > arm(p)));
        }
    }
}
