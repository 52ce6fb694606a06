//! Triangles of GLB files of any program.
//!
//! Read are the triangles, strips and fans of all primitives in the nodes of the scene, with the maps of the nodes: points as the
//! scene has them, in meters, turned so that the axis that glTF has upwards, the second one, is the third. Compressed and
//! sparse data are refused by name; materials, cameras, lines and points are passed over; so is what moves, with a note.

mod accessor;
mod node;

use cyclide::Point3;
use serde_json::Value;

use super::TRIANGLES;
use crate::formats::mesh_entry::ReadMesh;
use crate::input::points::MOST_POINTS;
use crate::input::polygon_mesh::PolygonMesh;
use crate::text::place::{Diagnostic, Source};
use accessor::{Accessors, list};
use node::{Affine, Walk};

/// Modes of primitives beside those that are written.
const STRIP: u64 = 5;
const FAN: u64 = 6;

/// Extensions that a reader of points need not understand, by how their names begin.
const HARMLESS: [&str; 4] = ["KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_"];

/// The triangles of a file, and what was passed over.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct SceneTriangles {
    pub(crate) mesh: PolygonMesh,
    /// Primitives of points and lines, which no surface is made of.
    pub(crate) lines: usize,
    /// True if skins or morph targets move the vertices: they are taken at rest.
    pub(crate) moves: bool,
}

impl From<SceneTriangles> for ReadMesh {
    fn from(scene: SceneTriangles) -> Self {
        let mut remarks = Vec::new();
        if scene.lines > 0 {
            remarks.push(("lines-left-out", format!("{} primitives of points and lines are ignored", scene.lines)));
        }
        if scene.moves {
            let message = "skins and morph targets are ignored: the mesh is used in its rest pose".to_owned();
            remarks.push(("pose-left-aside", message));
        }
        Self { mesh: scene.mesh, remarks, in_metres: true }
    }
}

/// Reads the triangles; `name` is what messages call the file.
///
/// # Errors
/// A message with the file.
pub(crate) fn read_scene(name: &str, bytes: &[u8]) -> Result<SceneTriangles, Box<Diagnostic>> {
    scene(bytes).map_err(|message| Source { name, text: "" }.diagnostic(0..0, "", message))
}

fn scene(bytes: &[u8]) -> Result<SceneTriangles, String> {
    let (text, binary) = chunks(bytes)?;
    let document: Value = serde_json::from_slice(text).map_err(|e| format!("the JSON chunk: {e}"))?;
    for extension in list(&document, "extensionsRequired") {
        let extension = extension.as_str().unwrap_or_default();
        if !HARMLESS.iter().any(|start| extension.starts_with(start)) {
            return Err(format!(
                "the file requires the extension {extension}, which is not supported: export without it"
            ));
        }
    }
    let accessors = Accessors::new(&document, binary);
    let mut found = SceneTriangles::default();
    for (map, node) in Walk::new(&document)?.nodes()? {
        let Some(mesh) = node.get("mesh") else { continue };
        found.moves |= node.get("skin").is_some();
        let mesh = accessor::entry(&document, "meshes", Some(mesh))?;
        for primitive in list(mesh, "primitives") {
            found.moves |= primitive.get("targets").is_some();
            found.primitive(primitive, &accessors, &map)?;
        }
    }
    if found.mesh.faces.is_empty() {
        return Err("the scene contains no triangles".to_owned());
    }
    // Normals of a part of the mesh are not those of the file.
    if found.mesh.corner_normals.len() < found.mesh.faces.len() {
        found.mesh.corner_normals.clear();
        found.mesh.normals.clear();
    }
    Ok(found)
}

impl SceneTriangles {
    fn primitive(&mut self, primitive: &Value, accessors: &Accessors<'_>, map: &Affine) -> Result<(), String> {
        if let Some(extension) = primitive.get("extensions").and_then(Value::as_object).and_then(|e| e.keys().next())
            && extension.ends_with("_compression")
        {
            return Err(format!(
                "a primitive is compressed with {extension}, which is not supported: export without it"
            ));
        }
        let mode = primitive.get("mode").map_or(Some(TRIANGLES), Value::as_u64);
        if matches!(mode, Some(0..=3)) {
            self.lines += 1;
            return Ok(());
        }
        let attributes = primitive.get("attributes").unwrap_or(&Value::Null);
        let points = accessors.vectors(attributes.get("POSITION"))?;
        if self.mesh.points.len() + points.len() > MOST_POINTS {
            return Err(format!("the file has more than {MOST_POINTS} points"));
        }
        let corners = match primitive.get("indices") {
            Some(indices) => accessors.indices(indices)?,
            None => (0..points.len()).collect(),
        };
        if let Some(wrong) = corners.iter().find(|index| **index >= points.len()) {
            return Err(format!(
                "a triangle refers to vertex {wrong} (from 0), but the primitive has {}",
                points.len()
            ));
        }
        let triangles = triangles(mode, &corners)?;
        let first = self.mesh.points.len();
        self.mesh.points.extend(points.into_iter().map(|p| turned_up(map.point(p))));
        let turned = map.determinant() < 0.0;
        let placed = |[a, b, c]: [usize; 3]| if turned { vec![a, c, b] } else { vec![a, b, c] };
        if let Some(normal) = attributes.get("NORMAL") {
            let normals = accessors.vectors(Some(normal))?;
            if normals.len() + first == self.mesh.points.len() {
                let before = self.mesh.normals.len();
                self.mesh.normals.extend(normals.into_iter().map(|n| turned_up(map.normal(n)) - Point3::ORIGIN));
                let of = |corners: Vec<usize>| corners.into_iter().map(|v| before + v).collect();
                self.mesh.corner_normals.extend(triangles.iter().map(|t| of(placed(*t))));
            }
        }
        let of = |corners: Vec<usize>| corners.into_iter().map(|v| first + v).collect();
        self.mesh.faces.extend(triangles.into_iter().map(|t| of(placed(t))));
        Ok(())
    }
}

/// The triangles that the corners of a primitive are.
fn triangles(mode: Option<u64>, corners: &[usize]) -> Result<Vec<[usize; 3]>, String> {
    let distinct = |t: &[usize; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    match mode {
        Some(TRIANGLES) if corners.len().is_multiple_of(3) => Ok(corners.as_chunks().0.to_vec()),
        Some(TRIANGLES) => Err("the number of indices is not a multiple of three".to_owned()),
        // Every other triangle of a strip runs the other way; those without area turn it.
        Some(STRIP) => {
            let at = |(k, w): (usize, &[usize])| if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
            Ok(corners.windows(3).enumerate().map(at).filter(distinct).collect())
        }
        Some(FAN) => {
            let hub = corners.first().copied().unwrap_or_default();
            let rim = corners.get(1..).unwrap_or_default();
            Ok(rim.windows(2).map(|w| [hub, w[0], w[1]]).filter(distinct).collect())
        }
        _ => Err("a primitive has a mode that glTF does not define".to_owned()),
    }
}

/// The turn that takes the second axis to the third.
fn turned_up([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, -z, y)
}

/// The JSON chunk and the binary chunk, which may be missing.
fn chunks(bytes: &[u8]) -> Result<(&[u8], &[u8]), String> {
    let word = |at: usize| bytes.get(at..)?.first_chunk().map(|b| u32::from_le_bytes(*b) as usize);
    if bytes.get(..4) != Some(b"glTF") {
        return Err("not a GLB file: it does not start with `glTF`".to_owned());
    }
    if word(4) != Some(2) {
        return Err("not GLB version 2".to_owned());
    }
    let whole = word(8).and_then(|length| bytes.get(..length)).ok_or("the file is shorter than its header states")?;
    let (mut text, mut binary) = (None, &[][..]);
    let mut at = 12;
    while let Some(head) = whole.get(at..at + 8) {
        let length = word(at).unwrap_or_default();
        let chunk = whole
            .get(at + 8..)
            .and_then(|rest| rest.get(..length))
            .ok_or("a chunk extends beyond the end of the file")?;
        match &head[4..] {
            b"JSON" if text.is_none() => text = Some(chunk),
            b"BIN\0" => binary = chunk,
            // Others are for other readers.
            _ => {}
        }
        at += 8 + length;
    }
    Ok((text.ok_or("the JSON chunk is missing")?, binary))
}

#[cfg(test)]
mod tests;
