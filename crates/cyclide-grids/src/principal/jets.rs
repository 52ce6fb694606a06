//! The surface near each vertex as the graph of a polynomial over its tangent plane, fitted to the nearest vertices.

use super::mesh_table::MeshTable;
use super::point_grid::PointGrid;
use cyclide::{Point3, Vec3};

/// Terms of a cubic and of a quadratic in two variables, in the order 1, x, y, xx, xy, yy, xxx, xxy, xyy, yyy.
pub(super) const CUBIC: usize = 10;
pub(super) const QUADRATIC: usize = 6;
/// Added to the normal equations relative to their diagonal: what the vertices do not tell stays small. More at the cubic terms: where
/// long triangles leave three rows of vertices, slopes and cubes across them cannot be told apart, and slopes are small.
const RIDGE: f64 = 1e-10;
const CUBIC_RIDGE: f64 = 1e-4;

/// A graph `z(x, y)` over a plane through a vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct VertexJet {
    /// The vertex, or where it should be: on the graph.
    pub(super) origin: Point3,
    /// Directions of x, y and z.
    pub(super) frame: [Vec3; 3],
    /// The coefficients in x and y over `reach`.
    coefficients: [f64; CUBIC],
    /// Distance of the farthest vertex of the fit.
    reach: f64,
    /// The rms distance of the vertices from the graph.
    pub(super) residual: f64,
}

impl VertexJet {
    /// Second derivatives `[xx, xy, yy]` over the square root of `1 + p^2 + q^2`: the shape operator in the frame.
    pub(super) fn shape(&self) -> [f64; 3] {
        let c = &self.coefficients;
        let (p, q) = (c[1] / self.reach, c[2] / self.reach);
        let scale = 1.0 / (self.reach * self.reach * (1.0 + p * p + q * q).sqrt());
        [2.0 * c[3] * scale, c[4] * scale, 2.0 * c[5] * scale]
    }

    /// The unit normal of the graph at the vertex.
    pub(super) fn normal(&self) -> Vec3 {
        let ([x, y, z], c) = (self.frame, &self.coefficients);
        (z - x * (c[1] / self.reach) - y * (c[2] / self.reach)).unit().unwrap_or(z)
    }

    /// The vertex moved along the normal onto the graph.
    pub(super) fn smoothed(&self) -> Point3 {
        self.origin + self.frame[2] * self.coefficients[0]
    }

    /// The point of the graph over a place near the vertex; `None` beyond the vertices of the fit.
    pub(super) fn above(&self, p: Point3) -> Option<Point3> {
        let d = p - self.origin;
        let [x, y, z] = self.frame.map(|axis| axis.dot(d));
        if x.hypot(y) > self.reach {
            return None;
        }
        let terms = terms(x / self.reach, y / self.reach);
        let height: f64 = terms.iter().zip(&self.coefficients).map(|(t, c)| t * c).sum();
        Some(p + self.frame[2] * (height - z))
    }
}

/// Fits of all vertices to their `count` nearest, with a cubic or a quadratic. A vertex with too few neighbors on its side of the
/// surface has the plane of its normal.
pub(super) fn jets(table: &MeshTable, count: usize, degree: usize) -> Vec<VertexJet> {
    let normals = table.vertex_normals();
    let spacing = (table.areas.iter().sum::<f64>() / table.points.len() as f64).sqrt();
    let grid = PointGrid::new(&table.points, 1.5 * spacing);
    let jet = |(v, p): (usize, &Point3)| {
        let mut near = grid.nearest(*p, count);
        // Where a surface comes back to itself, the other sheet has its normals elsewhere.
        near.retain(|(_, k)| normals[*k].dot(normals[v]) > 0.0);
        let points: Vec<Point3> = near.iter().map(|(_, k)| table.points[*k]).collect();
        let first = fit(*p, normals[v], &points, degree);
        fit(*p, first.normal(), &points, degree)
    };
    table.points.iter().enumerate().map(jet).collect()
}

fn terms(x: f64, y: f64) -> [f64; CUBIC] {
    [1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y]
}

/// The weighted fit in the frame of a normal.
fn fit(origin: Point3, normal: Vec3, points: &[Point3], degree: usize) -> VertexJet {
    let x_axis = normal.any_perpendicular();
    let x_axis = x_axis.unit().unwrap_or(x_axis);
    let frame = [x_axis, normal.cross(x_axis), normal];
    let reach = points.iter().map(|p| p.distance(origin)).fold(0.0, f64::max);
    // Alone on its side of a folded mesh a vertex has a plane, of any reach.
    let of_plane = if reach > 0.0 { reach } else { 1.0 };
    let mut jet = VertexJet { origin, frame, coefficients: [0.0; CUBIC], reach: of_plane, residual: 0.0 };
    let degree = if points.len() > degree { degree } else { QUADRATIC };
    if points.len() < QUADRATIC || !(reach > 0.0) {
        return jet;
    }
    let local = |p: &Point3| {
        let d = *p - origin;
        let [x, y, z] = frame.map(|axis| axis.dot(d));
        let weight = (-d.length_squared() / (reach * reach)).exp();
        (terms(x / reach, y / reach), z, weight)
    };
    let mut matrix = [[0.0; CUBIC]; CUBIC];
    let mut right = [0.0; CUBIC];
    for (terms, z, weight) in points.iter().map(local) {
        for i in 0..degree {
            right[i] += weight * terms[i] * z;
            for j in 0..=i {
                matrix[i][j] += weight * terms[i] * terms[j];
            }
        }
    }
    if solve(&mut matrix, &mut right, degree) {
        jet.coefficients[..degree].copy_from_slice(&right[..degree]);
    }
    let miss = |(terms, z, weight): ([f64; CUBIC], f64, f64)| {
        let height: f64 = terms.iter().zip(&jet.coefficients).map(|(t, c)| t * c).sum();
        (weight * (z - height).powi(2), weight)
    };
    let (sum, weights) = points.iter().map(local).map(miss).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
    jet.residual = (sum / weights).sqrt();
    jet
}

/// Cholesky in place of the lower triangle; false if it is not positive definite.
fn solve(a: &mut [[f64; CUBIC]; CUBIC], b: &mut [f64; CUBIC], size: usize) -> bool {
    for i in 0..size {
        for j in 0..=i {
            let mut sum = a[i][j];
            if i == j {
                sum += sum.abs() * if i < QUADRATIC { RIDGE } else { CUBIC_RIDGE };
            }
            sum -= (0..j).map(|k| a[i][k] * a[j][k]).sum::<f64>();
            if i == j {
                if !(sum > 0.0) {
                    return false;
                }
                a[i][i] = sum.sqrt();
            } else {
                a[i][j] = sum / a[j][j];
            }
        }
    }
    for i in 0..size {
        let sum: f64 = (0..i).map(|k| a[i][k] * b[k]).sum();
        b[i] = (b[i] - sum) / a[i][i];
    }
    for i in (0..size).rev() {
        let sum: f64 = (i + 1..size).map(|k| a[k][i] * b[k]).sum();
        b[i] = (b[i] - sum) / a[i][i];
    }
    true
}
