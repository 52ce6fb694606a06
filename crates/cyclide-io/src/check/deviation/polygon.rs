//! The polygons of a file, and how its format writes them.

use super::triangle::Triangle;
use crate::export::mesh::triangles;
use cyclide::{
    Point3, Vec3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
};

/// The normals that a format has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Normals {
    None,
    OfTriangles,
    OfSurface,
}

/// How a format writes meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MeshForm {
    pub(crate) normals: Normals,
    /// Vertices are known by their numbers, not by their places.
    pub(crate) numbers_vertices: bool,
}

/// A polygon of the file.
#[derive(Clone, Copy)]
pub(super) struct Polygon<'a> {
    /// Its mesh, and the mesh's number in the file.
    pub(super) mesh: &'a SurfaceMesh,
    pub(super) number: usize,
    pub(super) face: &'a MeshFace,
}

impl Polygon<'_> {
    /// Its corners.
    pub(super) fn corners(&self) -> impl Iterator<Item = Point3> {
        self.face.corners().iter().map(|corner| self.point(corner))
    }

    /// The normals at these.
    pub(super) fn normals(&self) -> impl Iterator<Item = Vec3> {
        self.face.corners().iter().map(|corner| self.mesh.normals[corner.normal])
    }

    pub(super) fn point(&self, corner: &MeshCorner) -> Point3 {
        self.mesh.positions[corner.position]
    }

    pub(super) fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let corners = self.face.corners();
        triangles(self.face).iter().map(move |t| Triangle::new(t.map(|i| self.point(&corners[i]))))
    }
}
