//! Reads a binary STL file as one mesh of triangles that share no vertices.

use super::{HEAD, RECORD, SEPARATOR, TITLE, UNITS};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, Vec3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
    model::Units,
};

/// Reads the triangles.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let (head, records) = bytes.split_at_checked(HEAD + 4).ok_or_else(|| ReadError::syntax("byte 0", "no head"))?;
    let count = head.last_chunk().map_or(0, |last| u32::from_le_bytes(*last)) as usize;
    if count.checked_mul(RECORD) != Some(records.len()) {
        let detail = format!("{} bytes do not match the count of {count} triangles", records.len());
        return Err(ReadError::syntax(format!("byte {HEAD}"), detail));
    }
    let mut mesh = SurfaceMesh::default();
    for (index, record) in records.chunks_exact(RECORD).enumerate() {
        let mut numbers = record.chunks_exact(4).map(|b| b.try_into().map_or(f64::NAN, number));
        let mut triple = || std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN));
        mesh.normals.push(Vec3::from(triple()));
        let corners = [0; 3].map(|_| Point3::from(triple()));
        if !corners.iter().all(|p| p.is_finite()) {
            return Err(ReadError::syntax(format!("triangle {index}"), "a coordinate is not finite"));
        }
        let first = mesh.positions.len();
        mesh.positions.extend(corners);
        mesh.faces.push(MeshFace::Triangle([0, 1, 2].map(|i| MeshCorner { position: first + i, normal: index })));
    }
    Ok(FileContent { meshes: vec![mesh], labels: labels(&head[..HEAD]), ..FileContent::default() })
}

/// Unit and title of the head, as far as it is ours.
fn labels(head: &[u8]) -> FileLabels {
    let said = || std::str::from_utf8(head).ok()?.strip_prefix(UNITS)?.split_once(SEPARATOR);
    let Some((symbol, title)) = said() else { return FileLabels::default() };
    let unit = Units::from_symbol(symbol).map(Units::in_millimetres);
    FileLabels { unit, names: vec![FileName::new(TITLE, title.trim_end(), 1)] }
}

fn number(bytes: [u8; 4]) -> f64 {
    f64::from(f32::from_le_bytes(bytes))
}
