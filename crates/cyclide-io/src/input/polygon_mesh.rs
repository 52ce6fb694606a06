//! Polygons as files of meshes have them.

use cyclide::{Point3, Vec3};

/// Points, faces as loops of them, and normals.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PolygonMesh {
    pub(crate) points: Vec<Point3>,
    pub(crate) faces: Vec<Vec<usize>>,
    /// Normals, and for every face those of its corners; both empty if the file does not have one for each.
    pub(crate) normals: Vec<Vec3>,
    pub(crate) corner_normals: Vec<Vec<usize>>,
    /// The line of each face in its file, from 1; empty where faces have none.
    pub(crate) lines: Vec<usize>,
}
