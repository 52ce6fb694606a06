//! PLY: meshes of surfaces out, polygons in.
//!
//! Polygons of PLY files of any program: text, and binary of either byte order.
//!
//! Read are the element `vertex` with `x`, `y`, `z` (and `nx`, `ny`, `nz`) of any type of number, and the element `face` with its
//! list `vertex_indices` or `vertex_index`. Other elements and properties are passed over, but for strips of triangles, which are
//! refused: without them the mesh would have holes. Numbers of single precision are taken as they are.

mod header;
mod read_back;
mod values;
mod writer;

use cyclide::{Point3, Vec3};

use crate::check::deviation::{Deviations, MeshForm, Normals};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::lowered::Forms;
use crate::formats::entry::{Entry, Kind, Reading};
use crate::formats::mesh_entry::{MeshEntry, NO_NORMAL_OF_A_CORNER, ReadMesh};
use crate::input::points::MOST_POINTS;
use crate::input::polygon_mesh::PolygonMesh;
use crate::text::place::{Diagnostic, Source};
use header::{Element, Encoding, Header, Property};
use values::{Binary, Text, Values};

/// What there is to know of meshes in it.
pub(super) const MESH_ENTRY: MeshEntry = MeshEntry {
    word: "ply",
    field: "Path of a PLY file, binary or text, relative to the document.",
    is_start: |text| text.starts_with("ply\n") || text.starts_with("ply\r\n"),
    read: |name, bytes| read_polygons(name, bytes).map(ReadMesh::from),
    has_quads: false,
    is_single: false,
    shares_vertices: true,
    without_normals: NO_NORMAL_OF_A_CORNER,
};

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "ply",
    title: "PLY",
    suffixes: &["ply"],
    lacks: Some(Kind::Curves),
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write: writer::write,
    reading: Some(Reading { read: read_back::read, compare, rounds_by_model: false }),
};

/// What stands before the unit in a comment; the property of a face, and what stands before the names.
const UNITS: &str = "cyclide, units ";
const OBJECT: &str = "object";

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read_back::read(&made.file.bytes)?;
    let bodies = made.meshes(&content, MeshForm { normals: Normals::OfSurface, numbers_vertices: false })?;
    content.labels.check(&writer::labels(made.ready.model, &made.ready.bodies))?;
    Ok(Deviations { bodies, ..Deviations::default() })
}

/// Most corners of a face.
const MOST_CORNERS: usize = 4096;
/// Coordinates of vertices and of their normals.
const COORDINATES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// Reads the polygons; `name` is what messages call the file.
///
/// # Errors
/// A message with the file, of text with line and column.
fn read_polygons(name: &str, bytes: &[u8]) -> Result<PolygonMesh, Box<Diagnostic>> {
    let (header, start) = Header::read(bytes).map_err(|message| refused(name, message))?;
    let Header { encoding, elements } = header;
    let mesh = match encoding {
        Encoding::Text => {
            let text = std::str::from_utf8(&bytes[start..]);
            let text = text.map_err(|e| refused(name, format!("byte {}: not text", start + e.valid_up_to())))?;
            let mut values = Text::new(text);
            let read = read_elements(&elements, &mut values);
            read.map_err(|message| {
                let whole = std::str::from_utf8(bytes).unwrap_or_default();
                let place = start + values.place();
                Source { name, text: whole }.diagnostic(place..place + 1, "", message)
            })?
        }
        Encoding::Binary { big_endian } => {
            let mut values = Binary::new(&bytes[start..], big_endian);
            let read = read_elements(&elements, &mut values);
            read.map_err(|message| refused(name, format!("byte {}: {message}", start + values.place())))?
        }
    };
    if mesh.faces.is_empty() {
        return Err(refused(name, "the file contains no faces".to_owned()));
    }
    let count = mesh.points.len();
    for (index, face) in mesh.faces.iter().enumerate() {
        if let Some(vertex) = face.iter().find(|vertex| **vertex >= count) {
            let message =
                format!("face {index} (from 0) refers to vertex {vertex} (from 0), but there are only {count}");
            return Err(refused(name, message));
        }
    }
    Ok(mesh)
}

fn refused(name: &str, message: String) -> Box<Diagnostic> {
    Source { name, text: "" }.diagnostic(0..0, "", message)
}

fn read_elements(elements: &[Element], values: &mut impl Values) -> Result<PolygonMesh, String> {
    let mut mesh = PolygonMesh::default();
    for element in elements {
        // Every element takes a byte at least: no count makes a list longer than the file.
        if element.count > values.left() && !element.properties.is_empty() {
            return Err(format!("the rest of the file is too short for {} {} elements", element.count, element.name));
        }
        match element.name.as_str() {
            "vertex" => read_vertices(element, values, &mut mesh)?,
            "face" => read_faces(element, values, &mut mesh)?,
            "tristrips" => return Err("triangle strips are not supported: save individual faces".to_owned()),
            _ => skip(element, values)?,
        }
    }
    if !mesh.normals.is_empty() {
        mesh.corner_normals.clone_from(&mesh.faces);
    }
    Ok(mesh)
}

fn read_vertices(element: &Element, values: &mut impl Values, mesh: &mut PolygonMesh) -> Result<(), String> {
    if element.count > MOST_POINTS {
        return Err(format!("the file has more than {MOST_POINTS} points"));
    }
    let place = |property: &Property| COORDINATES.iter().position(|name| *name == property.name);
    let has = |name: &str| element.properties.iter().any(|property| property.name == name && property.list.is_none());
    if let Some(missing) = COORDINATES[..3].iter().find(|name| !has(name)) {
        return Err(format!("vertices lack the property {missing}"));
    }
    let with_normals = COORDINATES[3..].iter().all(|name| has(name));
    for index in 0..element.count {
        let mut numbers = [0.0; 6];
        for property in &element.properties {
            match (place(property), property.list) {
                (Some(k), None) => numbers[k] = values.number(property.kind)?,
                _ => skip_property(property, values)?,
            }
        }
        let used = if with_normals { 6 } else { 3 };
        if !numbers[..used].iter().all(|v| v.is_finite()) {
            return Err(format!("vertex {index} (from 0) has a coordinate that is not finite"));
        }
        let [x, y, z, nx, ny, nz] = numbers;
        mesh.points.push(Point3::new(x, y, z));
        if with_normals {
            mesh.normals.push(Vec3::new(nx, ny, nz));
        }
    }
    Ok(())
}

fn read_faces(element: &Element, values: &mut impl Values, mesh: &mut PolygonMesh) -> Result<(), String> {
    let is_loop = |p: &Property| p.list.is_some() && ["vertex_indices", "vertex_index"].contains(&p.name.as_str());
    if element.count > 0 && !element.properties.iter().any(is_loop) {
        return Err("faces lack the list property vertex_indices".to_owned());
    }
    for index in 0..element.count {
        for property in &element.properties {
            let (Some(counted), true) = (property.list, is_loop(property)) else {
                skip_property(property, values)?;
                continue;
            };
            let corners = values.count(counted)?;
            if !(3..=MOST_CORNERS).contains(&corners) {
                return Err(format!("face {index} (from 0) has {corners} corners; 3 to {MOST_CORNERS} are supported"));
            }
            mesh.faces.push((0..corners).map(|_| values.count(property.kind)).collect::<Result<_, _>>()?);
        }
    }
    Ok(())
}

fn skip(element: &Element, values: &mut impl Values) -> Result<(), String> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        element.properties.iter().try_for_each(|property| skip_property(property, values))?;
    }
    Ok(())
}

fn skip_property(property: &Property, values: &mut impl Values) -> Result<(), String> {
    let count = property.list.map_or(Ok(1), |counted| values.count(counted))?;
    if count > values.left() {
        return Err(format!("the rest of the file is too short for a list of {count} values"));
    }
    for _ in 0..count {
        values.number(property.kind)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "comment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const POINTS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.5, 0.0], [0.0, 1.0, -0.25]];
    const FACES: [&[i32]; 2] = [&[0, 1, 2], &[0, 2, 3]];

    fn text() -> String {
        let mut text = format!("ply\nformat ascii 1.0\n{HEAD}");
        POINTS.iter().for_each(|[x, y, z]| text += &format!("{x} {y} {z} 7\n"));
        FACES.iter().for_each(|f| text += &format!("{} {} {} {}\n", f.len(), f[0], f[1], f[2]));
        text
    }

    fn binary(big: bool) -> Vec<u8> {
        let order = if big { "big" } else { "little" };
        let mut bytes = format!("ply\nformat binary_{order}_endian 1.0\n{HEAD}").into_bytes();
        for p in POINTS {
            p.iter().for_each(|v| bytes.extend(if big { v.to_be_bytes() } else { v.to_le_bytes() }));
            bytes.push(7);
        }
        for face in FACES {
            bytes.push(face.len() as u8);
            face.iter().for_each(|v| bytes.extend(if big { v.to_be_bytes() } else { v.to_le_bytes() }));
        }
        bytes
    }

    #[test]
    fn text_and_both_binary_forms_say_the_same() {
        let points = POINTS.map(|p| Point3::from(p.map(f64::from)));
        for bytes in [text().into_bytes(), binary(false), binary(true)] {
            let mesh = read_polygons("a.ply", &bytes).unwrap();
            assert_eq!(mesh.points, points);
            assert_eq!(mesh.faces, [vec![0, 1, 2], vec![0, 2, 3]]);
            assert!(mesh.normals.is_empty());
        }
    }

    #[test]
    fn normals_come_with_their_vertices() {
        let normal = "property double nx\nproperty double ny\nproperty double nz\nelement face";
        let text = text().replace("property uchar red\nelement face", normal).replace(" 7\n", " 0 0.5 2\n");
        let mesh = read_polygons("a.ply", text.as_bytes()).unwrap();
        assert_eq!(mesh.normals, [Vec3::new(0.0, 0.5, 2.0); 4]);
        assert_eq!(mesh.corner_normals, mesh.faces);
    }

    #[test]
    fn what_cannot_be_read_is_refused_at_its_place() {
        let message = |text: String| read_polygons("a.ply", text.as_bytes()).unwrap_err().to_string();
        assert!(message(text().replace("1 1.5 0 7", "1 one 0 7")).starts_with("a.ply:14:3: `one` is not a number"));
        assert!(
            message(text().replace("3 0 2 3", "3 0 2 4"))
                .contains("face 1 (from 0) refers to vertex 4 (from 0), but there are only 4")
        );
        assert!(message(text().replace("3 0 2 3", "3 0 2 -1")).contains("`-1` is not a non-negative integer"));
        assert!(message(text().replace("3 0 2 3", "3 0 2")).contains("the file ends"));
        assert!(message(text().replace("3 0 2 3\n", "2 0 2\n")).contains("face 1 (from 0) has 2 corners"));
        assert!(message(text().replace("1 0 0 7", "nan 0 0 7")).contains("not finite"));
        assert!(message(text().replace("element face 2", "element tristrips 1")).contains("strips"));
        assert!(message(text().replace("float z", "float w")).contains("lack the property z"));
        assert!(message(text().replace("face 2", "face 0")).contains("no faces"));
        assert!(message(text().replace("vertex 4", "vertex 400000000")).contains("the rest of the file is too short"));
        assert!(message(text().replace("ascii", "binary")).contains("format"));
        assert!(message(text()[..60].to_owned()).contains("the header has no end_header line"));
        assert!(message(text().replace("end_header", "end")).contains("unknown keyword `end`"));
        for end in 0..binary(false).len() {
            assert!(read_polygons("a.ply", &binary(false)[..end]).is_err(), "{end} bytes");
        }
    }
}
