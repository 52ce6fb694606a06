//! Which triangles of a mesh meet where: edges, and the fans of corners around vertices.

use super::SharpEdges;
use crate::base::vector::{Point3, Vec3};
use crate::error::{MeshError, Result};
use crate::surface::sphere_blend::check_triangle;

/// One of the two sides of an edge: a triangle, and the corner opposite to the edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct EdgeSide {
    pub(super) triangle: usize,
    pub(super) corner: usize,
}

impl EdgeSide {
    /// The corner of its triangle at which the edge starts, run counter-clockwise, and that at which it ends.
    pub(super) fn ends(self) -> [usize; 2] {
        [(self.corner + 1) % 3, (self.corner + 2) % 3]
    }
}

/// An edge of a mesh: the lower vertex first, and the sides that use it, the one that runs upwards first if there are two.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeshEdge {
    pub(super) vertices: [usize; 2],
    pub(super) first: EdgeSide,
    pub(super) second: Option<EdgeSide>,
    /// The surface bends by a crease there.
    pub(super) sharp: bool,
}

/// What a mesh says before any curve is made.
#[derive(Debug)]
pub(super) struct Connections {
    pub(super) edges: Vec<MeshEdge>,
    /// The edge opposite to each corner of each triangle.
    pub(super) triangle_edges: Vec<[usize; 3]>,
    /// The fan of each corner: corners around one vertex whose triangles share smooth edges.
    pub(super) fans: Vec<[usize; 3]>,
    /// The vertex of each fan.
    pub(super) fan_vertices: Vec<usize>,
    /// Unit normals of the triangles.
    pub(super) flat_normals: Vec<Vec3>,
}

impl Connections {
    /// # Errors
    /// `no-triangles`, `no-such-vertex`, and of one triangle `not-finite`, `parameter-out-of-range`, `degenerate-triangle`;
    /// `non-manifold-edge`, `inconsistent-orientation`.
    pub(super) fn new(positions: &[Point3], triangles: &[[usize; 3]], sharp: &SharpEdges<'_>) -> Result<Self> {
        if triangles.is_empty() {
            return Err(MeshError::NoTriangles { vertices: positions.len(), needed: 1 }.into());
        }
        let flat_normals =
            triangles.iter().enumerate().map(|(i, &t)| flat_normal(positions, i, t)).collect::<Result<Vec<_>>>()?;
        let edges = edges(triangles, &flat_normals, sharp)?;
        let mut triangle_edges = vec![[0; 3]; triangles.len()];
        for (index, edge) in edges.iter().enumerate() {
            for side in [Some(edge.first), edge.second].into_iter().flatten() {
                triangle_edges[side.triangle][side.corner] = index;
            }
        }
        let (fans, fan_vertices) = fans(triangles, &edges);
        Ok(Self { edges, triangle_edges, fans, fan_vertices, flat_normals })
    }
}

/// The unit normal of a triangle that is one.
fn flat_normal(positions: &[Point3], triangle: usize, vertices: [usize; 3]) -> Result<Vec3> {
    let count = positions.len();
    if let Some(&vertex) = vertices.iter().find(|v| **v >= count) {
        return Err(MeshError::NoSuchVertex { triangle, vertex, count }.into());
    }
    let corners = vertices.map(|v| positions[v]);
    let longest = check_triangle(corners).map_err(|cause| cause.in_triangle(triangle))?;
    let [a, b, c] = corners;
    // Not zero: the triangle has an area.
    Ok(((b - a) / longest).cross((c - a) / longest).unit().unwrap_or(Vec3::ZERO))
}

/// All edges, in the order of their vertices.
fn edges(triangles: &[[usize; 3]], flat_normals: &[Vec3], sharp: &SharpEdges<'_>) -> Result<Vec<MeshEdge>> {
    let mut halves: Vec<([usize; 2], bool, EdgeSide)> = Vec::with_capacity(3 * triangles.len());
    for (triangle, vertices) in triangles.iter().enumerate() {
        for corner in 0..3 {
            let side = EdgeSide { triangle, corner };
            let [from, to] = side.ends().map(|k| vertices[k]);
            halves.push(([from.min(to), from.max(to)], from > to, side));
        }
    }
    halves.sort_unstable_by_key(|&(vertices, downwards, side)| (vertices, downwards, side.triangle, side.corner));
    let mut edges = Vec::with_capacity(2 * triangles.len());
    for same in halves.chunk_by(|a, b| a.0 == b.0) {
        let edge = match *same {
            [(vertices, _, first)] => MeshEdge { vertices, first, second: None, sharp: false },
            [(vertices, false, first), (_, true, second)] => {
                let sharp = sharp.includes([first, second], flat_normals);
                MeshEdge { vertices, first, second: Some(second), sharp }
            }
            [([low, high], downwards, first), (_, _, second)] => {
                let vertices = if downwards { [high, low] } else { [low, high] };
                return Err(MeshError::InconsistentOrientation {
                    vertices,
                    triangles: [first.triangle, second.triangle],
                }
                .into());
            }
            ref more => {
                let triangle = more.iter().map(|half| half.2.triangle).min().unwrap_or(0);
                return Err(MeshError::NonManifoldEdge { vertices: more[0].0, triangle, count: more.len() }.into());
            }
        };
        edges.push(edge);
    }
    Ok(edges)
}

/// Numbers the fans by their first corners.
fn fans(triangles: &[[usize; 3]], edges: &[MeshEdge]) -> (Vec<[usize; 3]>, Vec<usize>) {
    let mut parent: Vec<usize> = (0..3 * triangles.len()).collect();
    for edge in edges.iter().filter(|edge| !edge.sharp) {
        let Some(second) = edge.second else { continue };
        let ([a, b], [c, d]) = (edge.first.ends(), second.ends());
        for (k, l) in [(a, d), (b, c)] {
            let [x, y] = [3 * edge.first.triangle + k, 3 * second.triangle + l].map(|corner| root(&mut parent, corner));
            parent[x.max(y)] = x.min(y);
        }
    }
    let (mut numbers, mut vertices) = (vec![0; parent.len()], Vec::new());
    for corner in 0..parent.len() {
        let first = root(&mut parent, corner);
        if first == corner {
            numbers[corner] = vertices.len();
            vertices.push(triangles[corner / 3][corner % 3]);
        } else {
            // The root is the lowest corner of its fan: it has its number.
            numbers[corner] = numbers[first];
        }
    }
    (numbers.chunks_exact(3).map(|n| [n[0], n[1], n[2]]).collect(), vertices)
}

/// The representative of a set, with the way to it halved.
fn root(parent: &mut [usize], mut item: usize) -> usize {
    while parent[item] != item {
        parent[item] = parent[parent[item]];
        item = parent[item];
    }
    item
}
