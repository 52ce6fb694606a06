//! Our own PLY back from the bytes.

use super::header::{Element, Encoding, Header, Kind};
use super::{OBJECT, UNITS};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, Vec3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
    model::Units,
};

/// Names of the numbers of a vertex.
const VERTEX: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// Reads the one mesh.
pub(super) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let (header, start) = Header::read(bytes).map_err(|detail| ReadError::syntax("the head", detail))?;
    let ours = |what: &str| ReadError::unsupported(what.to_owned(), "the head");
    let [vertex, face] = header.elements.as_slice() else { return Err(ours("an unexpected list of elements")) };
    let names =
        |element: &Element| element.properties.iter().map(|p| (p.name.clone(), p.kind, p.list)).collect::<Vec<_>>();
    let kind = |k: usize| if k < 3 { Kind::F64 } else { Kind::F32 };
    let mut of_vertex: Vec<_> =
        VERTEX.iter().enumerate().map(|(k, name)| ((*name).to_owned(), kind(k), None)).collect();
    of_vertex.push((OBJECT.to_owned(), Kind::I32, None));
    let of_face = [("vertex_indices".to_owned(), Kind::I32, Some(Kind::U8))];
    if header.encoding != (Encoding::Binary { big_endian: false })
        || (vertex.name.as_str(), face.name.as_str()) != ("vertex", "face")
        || names(vertex) != of_vertex
        || names(face) != of_face
    {
        return Err(ours("an unexpected kind of PLY"));
    }
    let mut bytes = Bytes { all: bytes, at: start };
    let mut mesh = SurfaceMesh::default();
    let mut objects: Vec<i32> = Vec::new();
    for _ in 0..vertex.count {
        let place = [bytes.double()?, bytes.double()?, bytes.double()?];
        let normal = [bytes.float()?, bytes.float()?, bytes.float()?];
        if !place.iter().chain(&normal).all(|v| v.is_finite()) {
            return Err(bytes.wrong("a number is not finite"));
        }
        mesh.positions.push(Point3::from(place));
        mesh.normals.push(Vec3::from(normal));
        let object = bytes.int()?;
        if objects.last() != Some(&object) {
            objects.push(object);
        }
    }
    for _ in 0..face.count {
        let count = bytes.take::<1>()?[0];
        let mut corners = [MeshCorner { position: 0, normal: 0 }; 4];
        if !(3..=4).contains(&count) {
            return Err(bytes.wrong("a face that is neither a triangle nor a quad"));
        }
        for corner in &mut corners[..usize::from(count)] {
            let index = usize::try_from(bytes.int()?).ok().filter(|index| *index < mesh.positions.len());
            let index = index.ok_or_else(|| bytes.wrong("a corner that is not a vertex"))?;
            *corner = MeshCorner { position: index, normal: index };
        }
        let [a, b, c, _] = corners;
        mesh.faces.push(if count == 3 { MeshFace::Triangle([a, b, c]) } else { MeshFace::Quad(corners) });
    }
    if bytes.at != bytes.all.len() {
        return Err(bytes.wrong("trailing bytes"));
    }
    let head = String::from_utf8_lossy(&bytes.all[..start]).into_owned();
    let mut labels = labels(&head);
    labels.names.extend(objects.into_iter().map(|object| FileName::new("vertices of", object.to_string(), 1)));
    Ok(FileContent { meshes: vec![mesh], labels, ..FileContent::default() })
}

/// Unit and names of the comments.
fn labels(head: &str) -> FileLabels {
    let mut labels = FileLabels::default();
    for comment in head.lines().filter_map(|line| line.strip_prefix("comment ")) {
        if let Some(symbol) = comment.strip_prefix(UNITS) {
            labels.unit = Units::from_symbol(symbol).map(Units::in_millimetres);
        } else if let Some((_, name)) = comment.strip_prefix(OBJECT).and_then(|rest| rest.split_once(':')) {
            labels.names.push(FileName::new(OBJECT, name.trim(), 1));
        }
    }
    labels
}

/// The bytes behind the head.
struct Bytes<'a> {
    all: &'a [u8],
    at: usize,
}

impl Bytes<'_> {
    fn wrong(&self, detail: &str) -> ReadError {
        ReadError::syntax(format!("byte {}", self.at), detail)
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let own = self.all.get(self.at..).and_then(<[u8]>::first_chunk).copied();
        let own = own.ok_or_else(|| self.wrong("the file ends before its last value"))?;
        self.at += N;
        Ok(own)
    }

    fn double(&mut self) -> Result<f64, ReadError> {
        self.take().map(f64::from_le_bytes)
    }

    fn float(&mut self) -> Result<f64, ReadError> {
        self.take().map(|bytes| f64::from(f32::from_le_bytes(bytes)))
    }

    fn int(&mut self) -> Result<i32, ReadError> {
        self.take().map(i32::from_le_bytes)
    }
}
