//! Distance of a smooth surface from its mesh, sampled.

use super::{Place, cells, lambda};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::surface::{SmoothMesh, SmoothTriangle};

/// The largest distance at the middles of edges and triangles of the mesh, without what the place has moved along them.
pub(super) fn largest(mesh: &SmoothMesh, divisions: usize) -> Result<f64> {
    let mut largest: f64 = 0.0;
    for index in 0..mesh.triangles().len() {
        let Some(triangle) = mesh.triangle(index) else { continue };
        largest = largest.max(of_triangle(&triangle, divisions).map_err(|e| e.in_triangle(index))?);
    }
    Ok(largest)
}

fn of_triangle(triangle: &SmoothTriangle, divisions: usize) -> Result<f64> {
    // All places of twice as many divisions: the even ones are vertices of the mesh, the others middles of its edges.
    let n = 2 * divisions;
    let points = (0..=n)
        .flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]))
        .map(|at| triangle.point(lambda(at)))
        .collect::<Result<Vec<Point3>>>()?;
    // Row i begins behind rows of n + 1, n, ... places.
    let at = |[i, j, _]: Place| points[i * (n + 1) - (i * i - i) / 2 + j];
    let mut largest: f64 = 0.0;
    for cell in cells(divisions) {
        let corners = cell.map(|place| at(place.map(|v| 2 * v)));
        for k in 0..3 {
            let (one, two) = (k, (k + 1) % 3);
            let middle = at([0, 1, 2].map(|c| cell[one][c] + cell[two][c]));
            largest = largest.max(off_line(middle, corners[one], corners[two]));
        }
        let centre = triangle.point(lambda([0, 1, 2].map(|c| cell[0][c] + cell[1][c] + cell[2][c])))?;
        largest = largest.max(off_plane(centre, corners));
    }
    Ok(largest)
}

/// Distance from the line through two points; from the first where they are one.
fn off_line(p: Point3, a: Point3, b: Point3) -> f64 {
    let along = (b - a).unit().unwrap_or(Vec3::ZERO);
    let v = p - a;
    (v - along * v.dot(along)).length()
}

/// Distance from the plane through three points; from the first where they have none.
fn off_plane(p: Point3, [a, b, c]: [Point3; 3]) -> f64 {
    let v = p - a;
    let directions = (b - a).unit().zip((c - a).unit());
    directions.and_then(|(x, y)| x.cross(y).unit()).map_or(v.length(), |normal| v.dot(normal).abs())
}
