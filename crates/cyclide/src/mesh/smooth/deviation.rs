//! Distance of a surface over triangles from its mesh, sampled.
//!
//! Only what leaves the surface counts: where parameter lines bend within it, as they do round a corner of the border, a place
//! lies over a triangle next to its own.

use super::{Place, cells, lambda};
use crate::base::triangle::on_triangle;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;

/// Edges of the mesh in few parts are looked at in this many, those in many at their middle: an edge that bends to both sides
/// passes through its chord there.
const FINE: usize = 4;
const COARSE: usize = 2;
/// The center of a triangle, and three places between it and the corners.
const INNER: [[usize; 3]; 4] = [[1, 1, 1], [4, 1, 1], [1, 4, 1], [1, 1, 4]];
/// Parts of an edge of the surface from which on there are many.
const MANY: usize = 5;
/// The steps from a vertex of the mesh to its neighbors, in the order in which they lie round it.
const AROUND: [[isize; 3]; 6] = [[1, -1, 0], [1, 0, -1], [0, 1, -1], [-1, 1, 0], [-1, 0, 1], [0, -1, 1]];

/// Where a mesh with so many divisions is farthest from its patch.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Farthest {
    pub(super) distance: f64,
    pub(super) divisions: usize,
    pub(super) cell: [Place; 3],
}

/// The largest distance of a patch from its mesh with so many divisions, at places on the edges and inside the triangles of the
/// mesh. `borders` tells of each side, opposite to the corner of its place, whether it is free or a crease.
pub(super) fn of_patch(
    divisions: usize,
    borders: [bool; 3],
    point: impl Fn([f64; 3]) -> Result<Point3>,
) -> Result<Farthest> {
    // All places of several times as many divisions: some are vertices of the mesh, the others inside its edges and triangles.
    let steps = steps(divisions);
    let n = steps * divisions;
    let points = (0..=n)
        .flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]))
        .map(|at| point(lambda(at)))
        .collect::<Result<Vec<Point3>>>()?;
    // Row i begins behind rows of n + 1, n, ... places.
    let at = |[i, j, _]: Place| Ok(points[i * (n + 1) - (i * i - i) / 2 + j]);
    Places { steps, borders, at, point }.farthest(divisions, cells(divisions))
}

/// The same of the mesh with twice as many divisions, in the triangle where the coarser one is farthest.
pub(super) fn of_halves(
    coarse: Farthest,
    borders: [bool; 3],
    point: impl Fn([f64; 3]) -> Result<Point3>,
) -> Result<Farthest> {
    let divisions = 2 * coarse.divisions;
    let sum = |i: usize, j: usize| [0, 1, 2].map(|c| coarse.cell[i][c] + coarse.cell[j][c]);
    let corners = [0, 1, 2].map(|k| [sum(k, k), sum(k, (k + 1) % 3), sum(k, (k + 2) % 3)]);
    let middle = [sum(0, 1), sum(1, 2), sum(2, 0)];
    let places = Places { steps: steps(divisions), borders, at: |at| point(lambda(at)), point: &point };
    places.farthest(divisions, corners.into_iter().chain([middle]))
}

fn steps(divisions: usize) -> usize {
    if divisions < MANY { FINE } else { COARSE }
}

/// The places of a patch; `at` has those of `steps` times as many divisions as the mesh has.
struct Places<At, Point> {
    steps: usize,
    borders: [bool; 3],
    at: At,
    point: Point,
}

impl<At: Fn(Place) -> Result<Point3>, Point: Fn([f64; 3]) -> Result<Point3>> Places<At, Point> {
    fn farthest(&self, divisions: usize, cells: impl Iterator<Item = [Place; 3]>) -> Result<Farthest> {
        let mut farthest = Farthest { divisions, ..Farthest::default() };
        for (k, cell) in cells.enumerate() {
            let distance = self.of_cell(cell, farthest.distance)?;
            if k == 0 || distance > farthest.distance {
                farthest = Farthest { distance, cell, ..farthest };
            }
        }
        Ok(farthest)
    }

    /// The largest of a distance that is known and those of one triangle of the mesh.
    fn of_cell(&self, cell: [Place; 3], mut largest: f64) -> Result<f64> {
        let steps = self.steps;
        let inside = |weights: [usize; 3]| [0, 1, 2].map(|c| (0..3).map(|k| weights[k] * cell[k][c]).sum());
        let corners = self.corners(cell)?;
        for k in 0..3 {
            let (one, two) = (k, (k + 1) % 3);
            let is_border = (0..3).any(|c| self.borders[c] && cell[one][c] == 0 && cell[two][c] == 0);
            for step in 1..steps {
                let mut weights = [0; 3];
                (weights[one], weights[two]) = (step, steps - step);
                let p = (self.at)(inside(weights))?;
                let off = if is_border {
                    off_line(p, corners[one], corners[two])
                } else {
                    self.off_mesh(p, cell, corners, largest)?
                };
                largest = largest.max(off);
            }
        }
        for a in 1..steps {
            for b in 1..steps - a {
                let p = (self.at)(inside([a, b, steps - a - b]))?;
                largest = largest.max(self.off_mesh(p, cell, corners, largest)?);
            }
        }
        for weights in INNER {
            let p = (self.point)(lambda(inside(weights)))?;
            largest = largest.max(self.off_mesh(p, cell, corners, largest)?);
        }
        Ok(largest)
    }

    fn corners(&self, cell: [Place; 3]) -> Result<[Point3; 3]> {
        let [a, b, c] = cell.map(|place| (self.at)(place.map(|v| self.steps * v)));
        Ok([a?, b?, c?])
    }

    /// Distance of a place from its triangle of the mesh and those that share a corner with it. What is `enough` is not made smaller.
    fn off_mesh(&self, p: Point3, cell: [Place; 3], corners: [Point3; 3], enough: f64) -> Result<f64> {
        let mut best = off_triangle(p, corners);
        // Beyond a smooth side the mesh goes on, in nearly the same plane.
        if best > enough && cell.iter().any(|at| (0..3).any(|c| at[c] == 0 && !self.borders[c])) {
            best = best.min(off_plane(p, corners));
        }
        for at in cell {
            for k in 0..AROUND.len() {
                if best <= enough {
                    return Ok(best);
                }
                let ends = [AROUND[k], AROUND[(k + 1) % AROUND.len()]].map(|step| moved(at, step));
                if let [Some(one), Some(two)] = ends {
                    best = best.min(off_triangle(p, self.corners([at, one, two])?));
                }
            }
        }
        Ok(best)
    }
}

/// The place after a step; `None` outside of the triangle.
fn moved(at: Place, step: [isize; 3]) -> Option<Place> {
    let [i, j, k] = [0, 1, 2].map(|c| at[c].checked_add_signed(step[c]));
    Some([i?, j?, k?])
}

/// Distance from a triangle; from its first corner where it has no area.
fn off_triangle(p: Point3, corners: [Point3; 3]) -> f64 {
    on_triangle(p, corners).map_or(p.distance(corners[0]), |(distance, _)| distance)
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
