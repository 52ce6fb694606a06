//! What there is to know of a format of meshes that is read, and what its reader gives.

use cyclide::Point3;

use crate::input::polygon_mesh::PolygonMesh;
use crate::text::place::Diagnostic;

/// What there is to know of a format of meshes.
pub(crate) struct MeshEntry {
    /// The suffix of its files, and the field of documents.
    pub(crate) word: &'static str,
    /// What the schema says of the field.
    pub(crate) field: &'static str,
    /// True for the start of a file, as far as it is text, without blanks before it.
    pub(crate) is_start: fn(&str) -> bool,
    /// Reads a file of any program; the first argument is what messages call it.
    pub(crate) read: fn(&str, &[u8]) -> Result<ReadMesh, Box<Diagnostic>>,
    /// True if nets read it too, by its quads.
    pub(crate) has_quads: bool,
    /// True if its numbers have single precision.
    pub(crate) is_single: bool,
    /// True if polygons share vertices there by their numbers.
    pub(crate) shares_vertices: bool,
    /// Why a file has no normals of vertices.
    pub(crate) without_normals: &'static str,
}

/// A mesh as its file has it.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ReadMesh {
    pub(crate) mesh: PolygonMesh,
    /// What was passed over: reason and sentence.
    pub(crate) remarks: Vec<(&'static str, String)>,
    /// True if the file counts in meters, whatever the document does.
    pub(crate) in_metres: bool,
}

impl From<PolygonMesh> for ReadMesh {
    fn from(mesh: PolygonMesh) -> Self {
        Self { mesh, ..Self::default() }
    }
}

impl ReadMesh {
    /// Triangles from their corners, three by three.
    pub(crate) fn of_triangles(points: Vec<Point3>) -> Self {
        let faces = (0..points.len() / 3).map(|k| vec![3 * k, 3 * k + 1, 3 * k + 2]).collect();
        PolygonMesh { points, faces, ..PolygonMesh::default() }.into()
    }
}

/// What is said of formats whose files may have normals.
pub(crate) const NO_NORMAL_OF_A_CORNER: &str =
    "the file does not have a normal for every corner: use \"angle\" or \"sphere\"";
