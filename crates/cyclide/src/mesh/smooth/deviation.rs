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

/// Where a mesh with so many divisions is farthest from its patch.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Farthest {
    pub(super) distance: f64,
    pub(super) divisions: usize,
    pub(super) cell: [Place; 3],
}

/// The largest distance of a patch from its mesh with so many divisions, at places on the edges and inside the triangles of the
/// mesh, without what the place has moved along them.
pub(super) fn of_patch(divisions: usize, point: impl Fn([f64; 3]) -> Result<Point3>) -> Result<Farthest> {
    // All places of several times as many divisions: some are vertices of the mesh, the others inside its edges and triangles.
    let steps = steps(divisions);
    let n = steps * divisions;
    let points = (0..=n)
        .flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]))
        .map(|at| point(lambda(at)))
        .collect::<Result<Vec<Point3>>>()?;
    // Row i begins behind rows of n + 1, n, ... places.
    let at = |[i, j, _]: Place| Ok(points[i * (n + 1) - (i * i - i) / 2 + j]);
    let mut farthest = Farthest { divisions, ..Farthest::default() };
    for cell in cells(divisions) {
        let distance = of_cell(cell, steps, at, &point)?;
        if distance > farthest.distance {
            farthest = Farthest { distance, cell, ..farthest };
        }
    }
    Ok(farthest)
}

/// The same of the mesh with twice as many divisions, in the triangle where the coarser one is farthest.
pub(super) fn of_halves(coarse: Farthest, point: impl Fn([f64; 3]) -> Result<Point3>) -> Result<Farthest> {
    let divisions = 2 * coarse.divisions;
    let sum = |i: usize, j: usize| [0, 1, 2].map(|c| coarse.cell[i][c] + coarse.cell[j][c]);
    let corners = [0, 1, 2].map(|k| [sum(k, k), sum(k, (k + 1) % 3), sum(k, (k + 2) % 3)]);
    let middle = [sum(0, 1), sum(1, 2), sum(2, 0)];
    let mut farthest = Farthest { distance: 0.0, divisions, cell: middle };
    for cell in corners.into_iter().chain([middle]) {
        let distance = of_cell(cell, steps(divisions), |at| point(lambda(at)), &point)?;
        if distance > farthest.distance {
            farthest = Farthest { distance, cell, ..farthest };
        }
    }
    Ok(farthest)
}

fn steps(divisions: usize) -> usize {
    if divisions < MANY { FINE } else { COARSE }
}

/// The largest distance of one triangle of the mesh; `at` has the places of `steps` times as many divisions.
fn of_cell(
    cell: [Place; 3],
    steps: usize,
    at: impl Fn(Place) -> Result<Point3>,
    point: impl Fn([f64; 3]) -> Result<Point3>,
) -> Result<f64> {
    let inside = |weights: [usize; 3]| [0, 1, 2].map(|c| (0..3).map(|k| weights[k] * cell[k][c]).sum());
    let [a, b, c] = cell.map(|place| at(place.map(|v| steps * v)));
    let corners = [a?, b?, c?];
    let mut largest: f64 = 0.0;
    for k in 0..3 {
        let (one, two) = (k, (k + 1) % 3);
        for step in 1..steps {
            let mut weights = [0; 3];
            (weights[one], weights[two]) = (step, steps - step);
            largest = largest.max(off_line(at(inside(weights))?, corners[one], corners[two]));
        }
    }
    for a in 1..steps {
        for b in 1..steps - a {
            largest = largest.max(off_plane(at(inside([a, b, steps - a - b]))?, corners));
        }
    }
    for weights in INNER {
        largest = largest.max(off_plane(point(lambda(inside(weights)))?, corners));
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
