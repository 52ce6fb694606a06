//! The points and faces of a mesh of any polygons.

use cyclide::{Point3, Vec3};

use super::polygons::{Normals, Polygons, parse};
use crate::place::{Diagnostic, Source, decode};

/// Points, and faces as loops of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PolygonMesh {
    pub(crate) points: Vec<Point3>,
    pub(crate) faces: Vec<Vec<usize>>,
    /// Normals, and for every face those of its corners; both empty if the file does not have one for each.
    pub(crate) normals: Vec<Vec3>,
    pub(crate) corner_normals: Vec<Vec<usize>>,
}

/// Reads the polygons of an OBJ file; `name` is what messages call it.
///
/// # Errors
/// A message with file, line and column.
pub(crate) fn read_polygons(name: &str, bytes: &[u8]) -> Result<PolygonMesh, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let Polygons { points, faces, normals, .. } = parse(source, Normals::Read)?;
    if faces.is_empty() {
        return Err(source.diagnostic(0..0, "", "the file holds no faces"));
    }
    let whole = faces.iter().all(|face| face.normals.is_some());
    let (normals, corner_normals) = if whole {
        (normals, faces.iter().filter_map(|face| face.normals.clone()).collect())
    } else {
        Default::default()
    };
    let faces = faces.into_iter().map(|face| face.corners).collect();
    Ok(PolygonMesh { points, faces, normals, corner_normals })
}
