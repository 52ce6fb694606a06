//! The input grid as a surface: normals, curvature lines and the point nearest to a moved vertex, all estimated from its
//! vertices.

use super::curvature::{Curvature, angle_to};
use super::neighbors::{pair, place, vertices};
use cyclide::surface::QuadGrid;
use cyclide::workspace::on_triangle;
use cyclide::{Point3, Vec3};

/// Unit normals at the vertices, from differences over a stride to both sides (to one at the border); `None` where they
/// vanish.
pub(super) fn normals(points: &[Point3], grid: &QuadGrid, stride: [usize; 2]) -> Vec<Option<Vec3>> {
    let normal = |at| {
        let along = [0, 1].map(|d| {
            let [before, after] = pair(grid, at, d, stride[d]);
            (points[after] - points[before]).unit()
        });
        along[0]?.cross(along[1]?).unit()
    };
    vertices(grid).map(normal).collect()
}

/// Directions of the curvature lines at a vertex; `None` at the border and where the surface is nearly flat or
/// spherical.
pub(super) fn curvature_lines(points: &[Point3], grid: &QuadGrid) -> Vec<Option<[Vec3; 2]>> {
    vertices(grid).map(|at| Curvature::at(points, grid, at, [1; 2], 1.0)?.directions()).collect()
}

/// Angles (in `[0, pi/4]`, radians) between the grid lines at each vertex and the nearer of two directions; both grid
/// directions of all vertices that have the two directions.
pub(super) fn line_angles(points: &[Point3], grid: &QuadGrid, lines: &[Option<[Vec3; 2]>]) -> Vec<f64> {
    let mut angles = Vec::new();
    for at in vertices(grid) {
        let Some(lines) = lines[grid.index(at[0], at[1])] else { continue };
        for direction in 0..2 {
            let [before, after] = pair(grid, at, direction, 1);
            angles.push(angle_to(points[after] - points[before], lines));
        }
    }
    angles
}

/// The point of the input nearest to a moved vertex: on a triangle of its vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Foot {
    /// The vertices.
    pub(super) vertices: [usize; 3],
    /// Their weights: not negative, with sum 1.
    pub(super) weights: [f64; 3],
    /// The distance.
    pub(super) distance: f64,
}

impl Foot {
    /// A quantity of the vertices at the foot, if all of them have it.
    pub(super) fn value(&self, of: &[Option<f64>]) -> Option<f64> {
        (0..3).try_fold(0.0, |sum, k| Some(sum + self.weights[k] * of[self.vertices[k]]?))
    }

    /// A vector of the vertices at the foot.
    pub(super) fn vector(&self, of: &[Vec3]) -> Vec3 {
        (0..3).fold(Vec3::ZERO, |sum, k| sum + of[self.vertices[k]] * self.weights[k])
    }

    /// The foot itself.
    pub(super) fn point(&self, points: &[Point3]) -> Point3 {
        let [a, b, c] = self.vertices.map(|k| points[k]);
        a + (b - a) * self.weights[1] + (c - a) * self.weights[2]
    }

    /// True if it is on an edge of the open border.
    pub(super) fn is_on_border(&self, grid: &QuadGrid) -> bool {
        let used = || (0..3).filter(|&k| self.weights[k] > 0.0).map(|k| place(grid, self.vertices[k]));
        if !grid.is_whole() {
            return is_on_steps(grid, &used().collect::<Vec<_>>());
        }
        (0..2).filter(|&d| !grid.closed()[d]).any(|d| {
            let last = grid.size()[d] - 1;
            used().all(|at| at[d] == 0) || used().all(|at| at[d] == last)
        })
    }
}

/// True if vertices are one of a border in steps, or the ends of one of its edges.
fn is_on_steps(grid: &QuadGrid, at: &[[usize; 2]]) -> bool {
    let edge = |a: [usize; 2], b: [usize; 2]| {
        (0..2).any(|d| b[1 - d] == a[1 - d] && b[d] == a[d] + 1 && grid.is_border_edge(a, d))
    };
    match *at {
        [a] => {
            let from = |d: usize| a[d] > 0 && grid.is_border_edge([a[0] + d - 1, a[1] - d], d);
            (0..2).any(|d| grid.is_border_edge(a, d) || from(d))
        }
        [a, b] => edge(a, b) || edge(b, a),
        _ => false,
    }
}

/// The foot of a moved vertex on the quads around the nearest vertex, which is found by walking from the vertex's own
/// place; every quad is split both ways. `None` where none of these triangles has an area.
pub(super) fn foot(p: Point3, start: usize, points: &[Point3], grid: &QuadGrid) -> Option<Foot> {
    let mut nearest = start;
    loop {
        let around = (0..2).flat_map(|d| pair(grid, place(grid, nearest), d, 1));
        let next = around.min_by(|a, b| p.distance(points[*a]).total_cmp(&p.distance(points[*b])));
        match next.filter(|next| p.distance(points[*next]) < p.distance(points[nearest])) {
            Some(next) => nearest = next,
            None => break,
        }
    }
    let [i, j] = place(grid, nearest);
    let columns = pair(grid, [i, j], 0, 1).into_iter().chain([nearest]).map(|k| place(grid, k)[0]);
    let mut best: Option<Foot> = None;
    for i in columns {
        for j in pair(grid, [i, j], 1, 1).into_iter().map(|k| place(grid, k)[1]).chain([j]) {
            if i >= grid.quads()[0] || j >= grid.quads()[1] || !grid.has_quad(i, j) {
                continue;
            }
            let [a0, a1, a2, a3] = grid.corners(i, j);
            for vertices in [[a0, a1, a3], [a0, a3, a2], [a0, a1, a2], [a1, a3, a2]] {
                let Some((distance, weights)) = on_triangle(p, vertices.map(|k| points[k])) else { continue };
                if best.is_none_or(|best| distance < best.distance) {
                    best = Some(Foot { vertices, weights, distance });
                }
            }
        }
    }
    best
}

/// Height of a moved vertex over the input, continued flat beyond its border: over the plane of its foot's triangle.
pub(super) fn height(p: Point3, start: usize, points: &[Point3], grid: &QuadGrid) -> f64 {
    let Some(foot) = foot(p, start, points, grid) else { return 0.0 };
    let [a, b, c] = foot.vertices.map(|k| points[k]);
    (b - a).cross(c - a).unit().map_or(0.0, |normal| normal.dot(p - a).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feet_beyond_the_border_are_on_it() {
        let points: Vec<Point3> = (0..9).map(|k| Point3::new((k % 3) as f64, (k / 3) as f64, 0.0)).collect();
        let grid = QuadGrid::new(points.clone(), [3, 3], [false; 2]).unwrap();
        for (p, start, border) in [
            ([-0.5, 0.3, 0.2], 0, true),
            ([0.5, 1.3, 0.2], 8, false),
            ([1.0, 2.0, 1.0], 4, true),
            ([1.0, 1.0, 1.0], 4, false),
        ] {
            let p = Point3::from(p);
            let foot = foot(p, start, &points, &grid).unwrap();
            assert_eq!(foot.is_on_border(&grid), border, "{p:?}: {foot:?}");
            // Sums of a few numbers below 3.
            assert!((foot.point(&points).distance(p) - foot.distance).abs() < 1e-15);
        }
    }

    /// A unit cylinder, its grid turned on it, with cells of the given sides.
    fn turned_cylinder(turn: f64, sides: [f64; 2]) -> Vec<f64> {
        let point = |i: usize, j: usize| {
            let (x, y) = (sides[0] * (i as f64 - 4.0), sides[1] * (j as f64 - 4.0));
            let (u, v) = (x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos());
            Point3::new(u.sin(), v, u.cos())
        };
        let points = (0..9).flat_map(|j| (0..9).map(move |i| point(i, j))).collect();
        let grid = QuadGrid::new(points, [9, 9], [false; 2]).unwrap();
        let lines = curvature_lines(grid.points(), &grid);
        line_angles(grid.points(), &grid, &lines)
    }

    #[test]
    fn curvature_lines_of_a_turned_cylinder() {
        for sides in [[0.02, 0.02], [0.02, 0.02 / 300.0], [0.02 / 300.0, 0.02]] {
            let angles = turned_cylinder(0.3, sides);
            assert_eq!(angles.len(), 2 * 7 * 7, "{sides:?}");
            // The estimate is of second order: 0.02² is 4e-4.
            assert!(angles.iter().all(|a| (a - 0.3).abs() < 4e-4), "{sides:?}: {angles:?}");
        }
    }
}
