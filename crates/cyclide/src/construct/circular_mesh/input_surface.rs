//! The input grid as a surface: normals, curvature lines and distances, estimated from its vertices.

use crate::base::vector::{Point3, Vec3};
use crate::surface::QuadGrid;

/// Vertices whose principal curvatures differ by less than this part of their sizes have no clear curvature lines.
const UMBILIC: f64 = 0.1;
/// Curvatures that bend an edge by less than this angle (radians) are those of a plane.
const FLAT: f64 = 1e-6;

/// Neighbours of a vertex along one direction, the vertex itself where there is none.
fn neighbours(grid: &QuadGrid, i: usize, j: usize, direction: usize) -> [usize; 2] {
    let (size, closed) = (grid.size()[direction], grid.closed()[direction]);
    let k = [i, j][direction];
    let before = if k > 0 {
        k - 1
    } else if closed {
        size - 1
    } else {
        k
    };
    let after = if k + 1 < size {
        k + 1
    } else if closed {
        0
    } else {
        k
    };
    [before, after].map(|k| if direction == 0 { grid.index(k, j) } else { grid.index(i, k) })
}

/// Indices of all vertices, s fastest.
fn vertices(grid: &QuadGrid) -> impl Iterator<Item = (usize, usize)> {
    let [m, n] = grid.size();
    (0..n).flat_map(move |j| (0..m).map(move |i| (i, j)))
}

/// Unit normals at the vertices, from central differences (one-sided at the border); `None` where they vanish.
pub(super) fn normals(points: &[Point3], grid: &QuadGrid) -> Vec<Option<Vec3>> {
    let difference = |[before, after]: [usize; 2]| points[after] - points[before];
    let normal = |(i, j)| {
        let along = [0, 1].map(|d| difference(neighbours(grid, i, j, d)).unit());
        along[0]?.cross(along[1]?).unit()
    };
    vertices(grid).map(normal).collect()
}

/// Directions of the curvature lines at a vertex; `None` at the border and where the surface is nearly flat or
/// spherical.
///
/// Least squares of `z = d u + e v + (a u² + 2 b u v + c v²)/2` over the eight vertices around, in the frame of the
/// normal; the directions are those of the quadratic part. Exact in the limit of fine grids.
pub(super) fn curvature_lines(points: &[Point3], grid: &QuadGrid, normals: &[Option<Vec3>]) -> Vec<Option<[Vec3; 2]>> {
    let lines = |(i, j)| {
        let centre = grid.index(i, j);
        let normal = normals[centre]?;
        let [[w, e], [s, n]] = [0, 1].map(|d| neighbours(grid, i, j, d));
        if [w, e, s, n].contains(&centre) {
            return None;
        }
        let column = |k: usize| (k % grid.size()[0], k / grid.size()[0]);
        let diagonal = [w, e].into_iter().flat_map(|k| neighbours(grid, column(k).0, column(k).1, 1));
        // Along the longer cells, so that slim ones are spread along one axis.
        let along = [[w, e], [s, n]].map(|[before, after]| points[after] - points[before]);
        let longer = if along[0].length() >= along[1].length() { along[0] } else { along[1] };
        let u = (longer - normal * longer.dot(normal)).unit()?;
        let v = normal.cross(u);
        let around = [w, e, s, n].into_iter().chain(diagonal).map(|k| points[k] - points[centre]);
        let local: Vec<[f64; 3]> = around.map(|d| [d.dot(u), d.dot(v), d.dot(normal)]).collect();
        let [_, _, a, b, c] = quadric(&local)?;
        let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        let reach = local.iter().map(|d| d[0].hypot(d[1])).fold(0.0, f64::max);
        if !(half > UMBILIC * (mean.abs() + half) && half * reach > FLAT) {
            return None;
        }
        let angle = 0.5 * b.atan2(0.5 * (a - c));
        let first = u * angle.cos() + v * angle.sin();
        Some([first, normal.cross(first)])
    };
    vertices(grid).map(lines).collect()
}

/// Coefficients `d, e, a, b, c` of the least squares of [`curvature_lines`], by the normal equations in the scale that
/// the points have along each axis; `None` where they lie on a conic.
fn quadric(local: &[[f64; 3]]) -> Option<[f64; 5]> {
    let [reach_u, reach_v] = [0, 1].map(|axis| local.iter().map(|d| d[axis].abs()).fold(0.0, f64::max));
    let mut rows = [[0.0; 6]; 5];
    for [u, v, z] in local.iter().map(|[u, v, z]| [u / reach_u, v / reach_v, *z]) {
        let terms = [u, v, 0.5 * u * u, u * v, 0.5 * v * v, z];
        for i in 0..5 {
            for j in 0..6 {
                rows[i][j] += terms[i] * terms[j];
            }
        }
    }
    for k in 0..5 {
        // Positive definite unless the vertices lie on a conic: the diagonal serves as pivot. Its values are near 1.
        if !(rows[k][k] > 1e-9) {
            return None;
        }
        let pivot = rows[k];
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(pivot).skip(k).for_each(|(x, p)| *x -= factor * p);
        }
    }
    let solution = |k: usize| rows[k][5] / rows[k][k];
    let [uu, uv, vv] = [reach_u * reach_u, reach_u * reach_v, reach_v * reach_v];
    Some([solution(0) / reach_u, solution(1) / reach_v, solution(2) / uu, solution(3) / uv, solution(4) / vv])
}

/// Angles (in `[0, pi/4]`, radians) between the grid lines at each vertex and the nearer of two directions; both grid
/// directions of all vertices that have the two directions.
pub(super) fn line_angles(points: &[Point3], grid: &QuadGrid, lines: &[Option<[Vec3; 2]>]) -> Vec<f64> {
    let mut angles = Vec::new();
    for (i, j) in vertices(grid) {
        let Some([first, second]) = lines[grid.index(i, j)] else { continue };
        for direction in 0..2 {
            let [before, after] = neighbours(grid, i, j, direction);
            let along = points[after] - points[before];
            let (x, y) = (along.dot(first).abs(), along.dot(second).abs());
            angles.push(x.min(y).atan2(x.max(y)));
        }
    }
    angles
}

/// Height of a moved vertex over the input, continued flat beyond its border: over the plane of the nearest triangle,
/// from both splittings of the quads around the nearest vertex, which is found by walking from the vertex's own place.
pub(super) fn height(p: Point3, start: usize, points: &[Point3], grid: &QuadGrid) -> f64 {
    let m = grid.size()[0];
    let mut nearest = start;
    loop {
        let (i, j) = (nearest % m, nearest / m);
        let around = (0..2).flat_map(|d| neighbours(grid, i, j, d));
        let next = around.min_by(|a, b| p.distance(points[*a]).total_cmp(&p.distance(points[*b])));
        match next.filter(|next| p.distance(points[*next]) < p.distance(points[nearest])) {
            Some(next) => nearest = next,
            None => break,
        }
    }
    let (i, j) = (nearest % m, nearest / m);
    let columns = neighbours(grid, i, j, 0).into_iter().chain([nearest]).map(|k| k % m);
    let mut best = (f64::INFINITY, 0.0);
    for i in columns {
        for j in neighbours(grid, i, j, 1).into_iter().chain([nearest]).map(|k| k / m) {
            if i >= grid.quads()[0] || j >= grid.quads()[1] {
                continue;
            }
            let [a0, a1, a2, a3] = grid.corners(i, j).map(|k| points[k]);
            for [a, b, c] in [[a0, a1, a3], [a0, a3, a2], [a0, a1, a2], [a1, a3, a2]] {
                let Some(normal) = (b - a).cross(c - a).unit() else { continue };
                let distance = triangle_distance(p, [a, b, c], normal);
                if distance < best.0 {
                    best = (distance, normal.dot(p - a).abs());
                }
            }
        }
    }
    best.1
}

/// Distance of a point from a triangle: from its plane if the foot is inside, else from the nearest side.
fn triangle_distance(p: Point3, [a, b, c]: [Point3; 3], normal: Vec3) -> f64 {
    let sides = [(a, b), (b, c), (c, a)];
    if sides.iter().all(|(from, to)| normal.dot((*to - *from).cross(p - *from)) >= 0.0) {
        return normal.dot(p - a).abs();
    }
    let from_side = |(from, to): &(Point3, Point3)| {
        let side = *to - *from;
        let along = (p - *from).dot(side) / side.length_squared();
        p.distance(from.lerp(*to, along.clamp(0.0, 1.0)))
    };
    sides.iter().map(from_side).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_from_a_triangle() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point3::from);
        let at = |x: f64, y: f64, z: f64| triangle_distance(Point3::new(x, y, z), [a, b, c], Vec3::Z);
        assert!((at(0.5, 0.5, -3.0) - 3.0).abs() < 1e-15); // inside
        assert!((at(1.0, -3.0, 4.0) - 5.0).abs() < 1e-15); // nearest to a side
        assert!((at(2.0, 2.0, 0.0) - 2.0_f64.sqrt()).abs() < 1e-15); // nearest to the slanted side
        assert!((at(-3.0, -4.0, 0.0) - 5.0).abs() < 1e-15); // nearest to a corner
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
        let lines = curvature_lines(grid.points(), &grid, &normals(grid.points(), &grid));
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
