//! Which vertex of the mesh a place of a triangle is.

use super::super::surface_mesh::MeshCorner;
use super::{Place, lambda};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::surface::SmoothMesh;

/// Vertices of the mesh: first those of the surface that have triangles, then those inside edges, then those inside triangles.
/// Normals likewise, with a second row of them on creases.
pub(super) struct Numbering<'a> {
    mesh: &'a SmoothMesh,
    divisions: usize,
    /// Positions of the vertices of the surface; none for those without triangles.
    vertices: Vec<Option<usize>>,
    used: Vec<usize>,
    /// The first normal of each edge, without those of vertices.
    edge_normals: Vec<usize>,
    edge_normal_count: usize,
}

impl<'a> Numbering<'a> {
    pub(super) fn new(mesh: &'a SmoothMesh, divisions: usize) -> Self {
        let (mut vertices, mut used) = (vec![None; mesh.positions().len()], Vec::new());
        for &vertex in mesh.triangles().iter().flatten() {
            if vertices[vertex].is_none() {
                vertices[vertex] = Some(0);
                used.push(vertex);
            }
        }
        used.sort_unstable();
        for (position, &vertex) in used.iter().enumerate() {
            vertices[vertex] = Some(position);
        }
        let mut edge_normal_count = 0;
        let mut edge_normals = Vec::with_capacity(mesh.edges().len());
        for edge in mesh.edges() {
            edge_normals.push(edge_normal_count);
            edge_normal_count += (divisions - 1) * if edge.is_sharp() { 2 } else { 1 };
        }
        Self { mesh, divisions, vertices, used, edge_normals, edge_normal_count }
    }

    /// All positions and normals.
    pub(super) fn places(&self) -> Result<(Vec<Point3>, Vec<Vec3>)> {
        let (mesh, n) = (self.mesh, self.divisions);
        let inside = n.saturating_sub(1) * n.saturating_sub(2) / 2;
        let count = self.used.len() + (n - 1) * mesh.edges().len() + inside * mesh.triangles().len();
        let mut positions = Vec::with_capacity(count);
        positions.extend(self.used.iter().map(|&v| mesh.positions()[v]));
        let mut normals = mesh.normals().to_vec();
        for (index, edge) in mesh.edges().iter().enumerate() {
            let (first, second) = edge.triangles();
            self.along_edge(index, first, |p, normal| {
                positions.push(p);
                normals.push(normal);
            })?;
            if let Some(second) = second.filter(|_| edge.is_sharp()) {
                self.along_edge(index, second, |_, normal| normals.push(normal))?;
            }
        }
        for index in 0..mesh.triangles().len() {
            let Some(triangle) = mesh.triangle(index) else { continue };
            for i in 1..n {
                for j in 1..n - i {
                    let at = lambda([i, j, n - i - j]);
                    let (p, normal) = triangle.point_and_normal(at).map_err(|e| e.in_triangle(index))?;
                    positions.push(p);
                    normals.push(normal);
                }
            }
        }
        Ok((positions, normals))
    }

    /// The places inside an edge from its lower vertex on, with the normals of one of its triangles.
    fn along_edge(&self, edge: usize, triangle: usize, mut place: impl FnMut(Point3, Vec3)) -> Result<()> {
        let opposite = self.mesh.triangle_edges()[triangle].iter().position(|e| *e == edge);
        let (Some(patch), Some(opposite)) = (self.mesh.triangle(triangle), opposite) else { return Ok(()) };
        let [low, high] = self.ends(triangle, opposite);
        for k in 1..self.divisions {
            let mut at = [0; 3];
            (at[low], at[high]) = (self.divisions - k, k);
            let (p, normal) = patch.point_and_normal(lambda(at)).map_err(|e| e.in_triangle(triangle))?;
            place(p, normal);
        }
        Ok(())
    }

    /// The corners of a triangle at the ends of a side, that with the lower vertex first.
    fn ends(&self, triangle: usize, opposite: usize) -> [usize; 2] {
        let [next, last] = [(opposite + 1) % 3, (opposite + 2) % 3];
        let vertices = self.mesh.triangles()[triangle];
        if vertices[next] < vertices[last] { [next, last] } else { [last, next] }
    }

    /// The corner of the mesh at a place of a triangle.
    pub(super) fn corner(&self, triangle: usize, at: Place) -> MeshCorner {
        let (mesh, n) = (self.mesh, self.divisions);
        if let Some(k) = at.iter().position(|v| *v == n) {
            let vertex = mesh.triangles()[triangle][k];
            return MeshCorner {
                position: self.vertices[vertex].unwrap_or(0),
                normal: mesh.corner_normals()[triangle][k],
            };
        }
        let (first_position, first_normal) = (self.used.len(), mesh.normals().len());
        if let Some(opposite) = at.iter().position(|v| *v == 0) {
            let index = mesh.triangle_edges()[triangle][opposite];
            let [_, high] = self.ends(triangle, opposite);
            let edge = &mesh.edges()[index];
            // The second triangle of a crease has the second row of normals.
            let row = if edge.is_sharp() && edge.triangles().1 == Some(triangle) { n - 1 } else { 0 };
            return MeshCorner {
                position: first_position + index * (n - 1) + at[high] - 1,
                normal: first_normal + self.edge_normals[index] + row + at[high] - 1,
            };
        }
        let [i, j, _] = at;
        // Rows of n - 2, n - 3, ... places.
        let inside = triangle * ((n - 1) * (n - 2) / 2) + (i - 1) * (n - 1) - (i - 1) * i / 2 + (j - 1);
        MeshCorner {
            position: first_position + mesh.edges().len() * (n - 1) + inside,
            normal: first_normal + self.edge_normal_count + inside,
        }
    }
}
