//! The points and faces of a mesh of any polygons.

use super::polygons::{Normals, Polygons, parse};
use crate::input::polygon_mesh::PolygonMesh;
use crate::text::lines::LineStarts;
use crate::text::place::{Diagnostic, Source, decode};

/// Reads the polygons of an OBJ file; `name` is what messages call it.
///
/// # Errors
/// A message with file, line and column.
pub(crate) fn read_polygons(name: &str, bytes: &[u8]) -> Result<PolygonMesh, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let Polygons { points, faces, normals, .. } = parse(source, Normals::Read)?;
    if faces.is_empty() {
        return Err(source.diagnostic(0..0, "", "the file contains no faces"));
    }
    let whole = faces.iter().all(|face| face.normals.is_some());
    let (normals, corner_normals) = if whole {
        (normals, faces.iter().filter_map(|face| face.normals.clone()).collect())
    } else {
        Default::default()
    };
    let starts = LineStarts::new(source.text);
    let lines = faces.iter().map(|face| starts.line_of(face.span.start)).collect();
    let faces = faces.into_iter().map(|face| face.corners).collect();
    Ok(PolygonMesh { points, faces, normals, corner_normals, lines })
}
