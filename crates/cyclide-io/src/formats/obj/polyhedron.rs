//! The points and faces of a mesh of any polygons.

use cyclide::Point3;

use super::polygons::{Polygons, parse};
use crate::text::place::{Diagnostic, Source, decode};

/// Points, and faces as loops of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PolygonMesh {
    pub(crate) points: Vec<Point3>,
    pub(crate) faces: Vec<Vec<usize>>,
}

/// Reads the polygons of an OBJ file; `name` is what messages call it.
///
/// # Errors
/// A message with file, line and column.
pub(crate) fn read_polygons(name: &str, bytes: &[u8]) -> Result<PolygonMesh, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let Polygons { points, faces, .. } = parse(source)?;
    if faces.is_empty() {
        return Err(source.diagnostic(0..0, "", "the file holds no faces"));
    }
    Ok(PolygonMesh { points, faces: faces.into_iter().map(|face| face.corners).collect() })
}
