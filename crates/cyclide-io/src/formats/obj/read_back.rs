//! Reads OBJ files of our own: the meshes and polylines of their groups.

use super::writer::{GROUP, OBJECT, UNITS};
use crate::check::file_content::FileContent;
use crate::check::labels::FileName;
use crate::check::polyline::chain;
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, Vec3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
    model::Units,
};

/// Reads every group as one mesh or one polyline.
pub(crate) fn read_back(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text = std::str::from_utf8(bytes).map_err(|e| ReadError::syntax("the text", e.to_string()))?;
    let mut content = FileContent::default();
    let mut group = Group::default();
    for (index, line) in text.lines().enumerate() {
        let place = || format!("line {}", index + 1);
        let mut words = line.split_ascii_whitespace();
        match words.next().unwrap_or("#") {
            "#" => {
                if let Some(unit) = line.strip_prefix(UNITS).and_then(Units::from_symbol) {
                    content.labels.unit = Some(unit.in_millimetres());
                }
            }
            keyword @ ("o" | "g") => {
                group.close(&mut content);
                let of = if keyword == "o" { OBJECT } else { GROUP };
                let name = line.trim_start()[1..].trim();
                content.labels.names.push(FileName::new(of, name, 0));
            }
            "v" => group.mesh.positions.push(Point3::from(triple(words, place)?)),
            "vn" => group.mesh.normals.push(Vec3::from(triple(words, place)?)),
            "f" => {
                let corners: Option<Vec<MeshCorner>> = words.map(|word| group.corner(word)).collect();
                group.mesh.faces.push(match corners.as_deref() {
                    Some(&[a, b, c]) => MeshFace::Triangle([a, b, c]),
                    Some(&[a, b, c, d]) => MeshFace::Quad([a, b, c, d]),
                    _ => return Err(ReadError::syntax(place(), "expected three or four corners from this group")),
                });
            }
            "l" => {
                let index = |word: &str| group.index(word, group.first[0], group.mesh.positions.len());
                let line: Option<Vec<Point3>> =
                    words.map(|word| index(word).map(|i| group.mesh.positions[i])).collect();
                let line = line.ok_or_else(|| ReadError::syntax(place(), "expected vertices from this group"))?;
                content.curves.push(chain(&line, place)?);
                count(&mut content);
            }
            word => return Err(ReadError::unsupported(word, place())),
        }
    }
    group.close(&mut content);
    Ok(content)
}

/// The group that is read, with the numbers of vertices and normals before it.
#[derive(Default)]
struct Group {
    mesh: SurfaceMesh,
    first: [usize; 2],
}

impl Group {
    /// Ends the group; one without faces was a curve, or a title.
    fn close(&mut self, content: &mut FileContent) {
        let mesh = std::mem::take(&mut self.mesh);
        self.first[0] += mesh.positions.len();
        self.first[1] += mesh.normals.len();
        if !mesh.faces.is_empty() {
            content.meshes.push(mesh);
            count(content);
        }
    }

    /// A number counted from 1 as an index into a list of the group.
    fn index(&self, word: &str, first: usize, count: usize) -> Option<usize> {
        let index = word.parse::<usize>().ok()?.checked_sub(first + 1)?;
        (index < count).then_some(index)
    }

    fn corner(&self, word: &str) -> Option<MeshCorner> {
        let (position, normal) = word.split_once("//")?;
        Some(MeshCorner {
            position: self.index(position, self.first[0], self.mesh.positions.len())?,
            normal: self.index(normal, self.first[1], self.mesh.normals.len())?,
        })
    }
}

/// Counts a curve or a mesh with the name of its group.
fn count(content: &mut FileContent) {
    if let Some(name) = content.labels.names.last_mut() {
        name.count += 1;
    }
}

fn triple<'a>(words: impl Iterator<Item = &'a str>, place: impl Fn() -> String) -> Result<[f64; 3], ReadError> {
    let numbers: Result<Vec<f64>, _> = words.map(str::parse).collect();
    let numbers = numbers.ok().filter(|n| n.iter().all(|v: &f64| v.is_finite()));
    let triple = numbers.and_then(|n| <[f64; 3]>::try_from(n).ok());
    triple.ok_or_else(|| ReadError::syntax(place(), "expected three numbers"))
}
