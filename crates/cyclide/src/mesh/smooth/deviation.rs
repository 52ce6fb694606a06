//! Distance of a surface over triangles from its mesh, sampled.

use super::{Place, cells, lambda};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;

/// Edges of the mesh in few parts are looked at in this many, those in many at their middle: an edge that bends to both sides
/// passes through its chord there.
const FINE: usize = 4;
const COARSE: usize = 2;
/// The centre of a triangle, and three places between it and the corners.
const INNER: [[usize; 3]; 4] = [[1, 1, 1], [4, 1, 1], [1, 4, 1], [1, 1, 4]];
/// Parts of an edge of the surface from which on there are many.
const MANY: usize = 8;

/// The largest distance of a patch from its mesh with so many divisions, at places on the edges and inside the triangles of the
/// mesh, without what the place has moved along them.
pub(super) fn of_patch(divisions: usize, point: impl Fn([f64; 3]) -> Result<Point3>) -> Result<f64> {
    // All places of several times as many divisions: some are vertices of the mesh, the others inside its edges and triangles.
    let steps = if divisions < MANY { FINE } else { COARSE };
    let n = steps * divisions;
    let points = (0..=n)
        .flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]))
        .map(|at| point(lambda(at)))
        .collect::<Result<Vec<Point3>>>()?;
    // Row i begins behind rows of n + 1, n, ... places.
    let at = |[i, j, _]: Place| points[i * (n + 1) - (i * i - i) / 2 + j];
    let mut largest: f64 = 0.0;
    for cell in cells(divisions) {
        let inside = |weights: [usize; 3]| [0, 1, 2].map(|c| (0..3).map(|k| weights[k] * cell[k][c]).sum());
        let corners = cell.map(|place| at(place.map(|v| steps * v)));
        for k in 0..3 {
            let (one, two) = (k, (k + 1) % 3);
            for step in 1..steps {
                let mut weights = [0; 3];
                (weights[one], weights[two]) = (step, steps - step);
                largest = largest.max(off_line(at(inside(weights)), corners[one], corners[two]));
            }
        }
        for a in 1..steps {
            for b in 1..steps - a {
                largest = largest.max(off_plane(at(inside([a, b, steps - a - b])), corners));
            }
        }
        for weights in INNER {
            largest = largest.max(off_plane(point(lambda(inside(weights)))?, corners));
        }
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
