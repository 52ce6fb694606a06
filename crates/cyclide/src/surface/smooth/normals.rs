//! Normals of a mesh: one for each fan of corners.

use super::connect::Connections;
use super::triangle::unit_normal;
use super::{NormalWeights, VertexNormals};
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, MeshError, NumberError, Result};
use crate::warning::{MeshWarning, Warning};

/// Face normals around a vertex whose mean is shorter lie back to back.
const BACK_TO_BACK: f64 = 1e-9;

/// One unit normal for each fan.
///
/// # Errors
/// `count-differs`, `not-finite`, `undefined-normal`.
pub(super) fn of_fans(
    positions: &[Point3],
    triangles: &[[usize; 3]],
    connections: &Connections,
    normals: &VertexNormals,
) -> Result<Vec<Vec3>> {
    match normals {
        VertexNormals::Given(given) => {
            if given.len() != positions.len() {
                return Err(NumberError::CountDiffers {
                    what: ErrorItem::Normal,
                    given: given.len(),
                    needed: positions.len(),
                }
                .into());
            }
            connections.fan_vertices.iter().map(|&vertex| unit_normal(given[vertex], vertex)).collect()
        }
        VertexNormals::GivenAtCorners(given) => mean_of_given(triangles, connections, given),
        VertexNormals::AngleWeighted | VertexNormals::Creased { weights: NormalWeights::Angle, .. } => {
            mean_normals(positions, triangles, connections, Vec3::angle)
        }
        VertexNormals::SphereWeighted | VertexNormals::Creased { weights: NormalWeights::Sphere, .. } => {
            mean_normals(positions, triangles, connections, |a, b| {
                // sin/(|a| |b|), the directions first: squares of tiny and of huge edges leave the range of doubles.
                a.unit().zip(b.unit()).map_or(0.0, |(u, v)| u.cross(v).length()) / a.length() / b.length()
            })
        }
    }
}

/// The means of normals given at corners that are one but for their digits.
fn mean_of_given(triangles: &[[usize; 3]], connections: &Connections, given: &[[Vec3; 3]]) -> Result<Vec<Vec3>> {
    let mut sums = vec![Vec3::ZERO; connections.fan_vertices.len()];
    for ((vertices, fans), normals) in triangles.iter().zip(&connections.fans).zip(given) {
        for k in 0..3 {
            sums[fans[k]] += unit_normal(normals[k], vertices[k])?;
        }
    }
    sums.into_iter().zip(&connections.fan_vertices).map(|(sum, &vertex)| unit_normal(sum, vertex)).collect()
}

/// The means of the normals of the triangles around a vertex with weights made from their two edges there.
fn mean_normals(
    positions: &[Point3],
    triangles: &[[usize; 3]],
    connections: &Connections,
    weight: impl Fn(Vec3, Vec3) -> f64,
) -> Result<Vec<Vec3>> {
    let mut sums = vec![(Vec3::ZERO, 0.0); connections.fan_vertices.len()];
    for ((vertices, fans), &normal) in triangles.iter().zip(&connections.fans).zip(&connections.flat_normals) {
        let corners = vertices.map(|v| positions[v]);
        for k in 0..3 {
            let [next, last] = [1, 2].map(|step| corners[(k + step) % 3] - corners[k]);
            let part = weight(next, last);
            let (sum, weights) = &mut sums[fans[k]];
            *sum += normal * part;
            *weights += part;
        }
    }
    let mean = |((sum, weights), &vertex): ((Vec3, f64), &usize)| {
        let length = sum.length() / weights;
        let unit = sum.unit().filter(|_| length > BACK_TO_BACK);
        unit.ok_or(Error::Mesh(MeshError::UndefinedNormal { vertex, length, limit: BACK_TO_BACK }))
    };
    sums.into_iter().zip(&connections.fan_vertices).map(mean).collect()
}

/// The corners whose normal points to the back of their triangle.
pub(super) fn backward(triangles: &[[usize; 3]], connections: &Connections, normals: &[Vec3]) -> Option<Warning> {
    let backward = |triangle: usize, k: usize| {
        normals[connections.fans[triangle][k]].dot(connections.flat_normals[triangle]) <= 0.0
    };
    let corners = (0..triangles.len()).flat_map(|t| (0..3).map(move |k| (t, k)));
    let mut found = corners.filter(|&(t, k)| backward(t, k));
    let (triangle, k) = found.next()?;
    Some(Warning::Mesh(MeshWarning::NormalFacesBackward {
        triangle,
        vertex: triangles[triangle][k],
        count: 1 + found.count(),
    }))
}
