//! Our own 3MF back from the bytes: one mesh per object.

use super::{OBJECT, TITLE, UNITS, package};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use crate::text::xml::attribute;
use cyclide::{
    Point3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
};

/// Reads the meshes.
pub(super) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text = package::unpack(bytes).map_err(|detail| ReadError::syntax("the container", detail))?;
    let mut content = FileContent::default();
    let mut labels = FileLabels::default();
    let mut items = 0;
    for (number, line) in text.lines().enumerate() {
        let wrong = |detail: &str| ReadError::syntax(format!("line {}", number + 1), detail);
        let (tag, rest) = line.strip_prefix('<').and_then(|line| line.split_once(' ')).unwrap_or((line, ""));
        let number = |name: &str| attribute(rest, name).and_then(|text| text.parse::<usize>().ok());
        match tag {
            "model" => {
                let word = attribute(rest, "unit").ok_or_else(|| wrong("the model has no unit"))?;
                labels.unit = UNITS.iter().find(|(_, own)| *own == word).map(|(units, _)| units.in_millimetres());
            }
            "metadata" if attribute(rest, "name") == Some("Title") => {
                let title = rest.split_once('>').and_then(|(_, rest)| rest.strip_suffix("</metadata>"));
                labels.names.push(FileName::new(TITLE, title.ok_or_else(|| wrong("an unterminated title"))?, 1));
            }
            "object" => {
                if number("id") != Some(content.meshes.len() + 1) || attribute(rest, "type") != Some("model") {
                    return Err(wrong("objects are not models numbered from 1"));
                }
                labels.names.push(FileName::new(OBJECT, attribute(rest, "name").unwrap_or_default(), 1));
                content.meshes.push(SurfaceMesh::default());
            }
            "vertex" => {
                let mesh = content.meshes.last_mut().ok_or_else(|| wrong("a vertex outside an object"))?;
                let coordinate =
                    |name| attribute(rest, name).and_then(|text| text.parse::<f32>().ok()).filter(|v| v.is_finite());
                let place = [coordinate("x"), coordinate("y"), coordinate("z")];
                let [Some(x), Some(y), Some(z)] = place else { return Err(wrong("a vertex needs three coordinates")) };
                mesh.positions.push(Point3::from([x, y, z].map(f64::from)));
            }
            "triangle" => {
                let mesh = content.meshes.last_mut().ok_or_else(|| wrong("a triangle outside an object"))?;
                let corner = |name| {
                    number(name)
                        .filter(|k| *k < mesh.positions.len())
                        .map(|position| MeshCorner { position, normal: 0 })
                };
                let [Some(a), Some(b), Some(c)] = ["v1", "v2", "v3"].map(corner) else {
                    return Err(wrong("a triangle needs three vertices of its object"));
                };
                mesh.faces.push(MeshFace::Triangle([a, b, c]));
            }
            "item" => {
                items += 1;
                if number("objectid") != Some(items) {
                    return Err(wrong("build items are not in the order of the objects"));
                }
            }
            _ => {}
        }
    }
    if items != content.meshes.len() {
        return Err(ReadError::syntax("build", "an object has no build item"));
    }
    content.labels = labels;
    Ok(content)
}
