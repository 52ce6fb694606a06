//! Reads GLB files of our own: triangles and lines of the nodes below the root, in model coordinates, and the tracks of animations.

use super::material::{Look, UNLIT};
use super::track::Track;
use super::{LINES, MATERIAL, MESH, NODE, TITLE, TRIANGLES, Z_UP};
use crate::check::file_content::FileContent;
use crate::check::labels::{FileName, push_counted};
use crate::check::polyline::chain;
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, Vec3,
    mesh::{MeshCorner, MeshFace, SurfaceMesh},
};
use serde_json::Value;
use std::cell::Cell;

/// Reads the meshes and lines.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let (text, binary) = chunks(bytes)?;
    let document = serde_json::from_slice::<Value>(text);
    let document = document.map_err(|e| ReadError::syntax("the JSON chunk", e.to_string()))?;
    let file = File { document: &document, binary, left: Cell::new(2 * binary.len()) };
    let mut content = FileContent::default();
    // The root has no mesh; its turn and scale are no part of the model's coordinates.
    let root = file.root()?;
    if let Some(root) = root {
        content.labels.unit = Some(1000.0 * file.scale(root)?);
    }
    let nodes = file.list("nodes")?;
    // Bodies in motion are compared apart.
    let moved = moved_nodes(&document);
    let holds_moved = |node: &Value| {
        let children = node.get("children").and_then(Value::as_array).into_iter().flatten();
        node.get("mesh").is_none() && children.filter_map(Value::as_u64).any(|child| moved.contains(&(child as usize)))
    };
    let meshes: Vec<usize> =
        (0..nodes.len()).filter(|i| nodes[*i].get("mesh").is_some() && !moved.contains(i)).collect();
    let shown = (0..nodes.len()).filter(|i| meshes.binary_search(i).is_ok() || holds_moved(&nodes[*i]));
    if let Some(root) = root {
        let children = root.get("children").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        if !children.iter().map(|c| c.as_u64().map(|i| i as usize)).eq(shown.map(Some)) {
            return Err(ReadError::syntax("nodes", "the children of the root are not the nodes with meshes"));
        }
        content.labels.names.push(FileName::new(TITLE, name(root), 1));
    }
    for node in meshes.iter().filter_map(|i| nodes.get(*i)) {
        if ["rotation", "scale", "matrix", "children"].iter().any(|key| node.get(key).is_some()) {
            return Err(ReadError::unsupported("a rotated or scaled mesh, or one with children", "nodes"));
        }
        let offset = node.get("translation").map_or(Some([0.0; 3]), triple);
        let offset = offset.ok_or_else(|| ReadError::syntax("nodes", "expected a translation of three numbers"))?;
        let mesh = file.entry("meshes", node.get("mesh"))?;
        let before = content.curves.len() + content.meshes.len();
        let looks = file.mesh(mesh, Vec3::from(offset), &mut content)?;
        let parts = content.curves.len() + content.meshes.len() - before;
        content.labels.names.extend([FileName::new(NODE, name(node), parts), FileName::new(MESH, name(mesh), 1)]);
        looks.iter().for_each(|look| push_counted(&mut content.labels.names, MATERIAL, look));
    }
    Ok(content)
}

/// The name of a node or mesh.
fn name(entry: &Value) -> &str {
    entry.get("name").and_then(Value::as_str).unwrap_or_default()
}

/// The JSON chunk and the binary chunk.
fn chunks(bytes: &[u8]) -> Result<(&[u8], &[u8]), ReadError> {
    let wrong = |place: usize, detail: &str| ReadError::syntax(format!("byte {place}"), detail);
    let number = |at: usize| bytes.get(at..)?.first_chunk().map(|b| u32::from_le_bytes(*b) as usize);
    if bytes.get(..4) != Some(b"glTF") || number(4) != Some(2) || number(8) != Some(bytes.len()) {
        return Err(wrong(0, "expected glTF, version 2 and the length of the file"));
    }
    let chunk = |at: usize, kind: &[u8]| {
        let length = number(at)?;
        if bytes.get(at + 4..at + 8) != Some(kind) {
            return None;
        }
        bytes.get(at + 8..)?.get(..length)
    };
    let text = chunk(12, b"JSON").ok_or_else(|| wrong(12, "expected a JSON chunk"))?;
    let next = 20 + text.len();
    let binary = chunk(next, b"BIN\0").ok_or_else(|| wrong(next, "expected a BIN chunk"))?;
    Ok((text, binary))
}

/// The tracks of the animations.
///
/// # Errors
/// [`ReadError`] for animations that are not like ours.
pub(super) fn tracks(bytes: &[u8]) -> Result<Vec<ReadTrack>, ReadError> {
    let (text, binary) = chunks(bytes)?;
    let document = serde_json::from_slice::<Value>(text);
    let document = document.map_err(|e| ReadError::syntax("the JSON chunk", e.to_string()))?;
    let file = File { document: &document, binary, left: Cell::new(2 * binary.len()) };
    match document.get("animations") {
        Some(_) => {
            let animations = file.list("animations")?.iter().map(|animation| file.tracks(animation));
            Ok(animations.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
        }
        None => Ok(Vec::new()),
    }
}

/// A track read, with the name of its body and where the body's parent stands.
pub(super) struct ReadTrack {
    pub(super) name: String,
    pub(super) center: Point3,
    pub(super) track: Track,
}

pub(super) struct File<'a> {
    document: &'a Value,
    binary: &'a [u8],
    /// Bytes that may still be read: twice those there are, so that nothing is made many times from the same few.
    left: Cell<usize>,
}

impl<'a> File<'a> {
    fn list(&self, key: &str) -> Result<&'a [Value], ReadError> {
        let list = self.document.get(key).and_then(Value::as_array);
        list.map(Vec::as_slice).ok_or_else(|| ReadError::syntax("the JSON chunk", format!("no array \"{key}\"")))
    }

    fn entry(&self, key: &str, index: Option<&Value>) -> Result<&'a Value, ReadError> {
        let index = index.and_then(Value::as_u64).and_then(|i| usize::try_from(i).ok());
        let entry = index.and_then(|i| self.document.get(key)?.get(i));
        entry.ok_or_else(|| ReadError::syntax(key, format!("there is no entry {index:?}")))
    }

    /// The only node of the scene, if there is a scene.
    fn root(&self) -> Result<Option<&'a Value>, ReadError> {
        let Some(scene) = self.document.get("scene") else { return Ok(None) };
        let nodes = self.entry("scenes", Some(scene))?.get("nodes").and_then(Value::as_array);
        match nodes.map(Vec::as_slice) {
            Some([root]) => self.entry("nodes", Some(root)).map(Some),
            _ => Err(ReadError::syntax("scenes", "expected one node")),
        }
    }

    /// How many meters a unit of the model is under a root, which turns the third axis up.
    fn scale(&self, root: &Value) -> Result<f64, ReadError> {
        let numbers = |key: &str| root.get(key)?.as_array()?.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>();
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        let turned = numbers("rotation").is_some_and(|r| r.len() == 4 && r.iter().zip(Z_UP).all(|(a, b)| same(*a, b)));
        let still = root.get("translation").is_none() && root.get("matrix").is_none();
        match numbers("scale").as_deref() {
            Some(&[x, y, z]) if turned && still && x > 0.0 && same(x, y) && same(y, z) => Ok(x),
            _ => Err(ReadError::unsupported("a root that does more than turn the third axis up and scale", "nodes")),
        }
    }

    /// What a material looks like.
    fn look(&self, index: Option<&Value>) -> Result<String, ReadError> {
        let look = Look::read(self.entry("materials", index)?)?;
        let used = self.document.get("extensionsUsed").and_then(Value::as_array);
        if look.is_unlit() && !used.is_some_and(|used| used.iter().any(|name| name == UNLIT)) {
            return Err(ReadError::syntax("extensionsUsed", format!("{UNLIT} is used but not declared")));
        }
        Ok(look.to_string())
    }

    /// Adds the surfaces and curves of a mesh; gives what their materials look like.
    fn mesh(&self, mesh: &Value, offset: Vec3, content: &mut FileContent) -> Result<Vec<String>, ReadError> {
        let primitives = mesh.get("primitives").and_then(Value::as_array);
        let primitives = primitives.ok_or_else(|| ReadError::syntax("meshes", "no array \"primitives\""))?;
        // Edges of patches are drawn on the vertices of their mesh.
        let mut of_meshes: Vec<&Value> = Vec::new();
        let mut looks = Vec::with_capacity(primitives.len());
        let first = content.meshes.len();
        for primitive in primitives {
            let attributes = primitive.get("attributes").unwrap_or(&Value::Null);
            let position = attributes.get("POSITION").unwrap_or(&Value::Null);
            looks.push(self.look(primitive.get("material"))?);
            let of_mesh = of_meshes.iter().position(|of_mesh| *of_mesh == position).map(|index| first + index);
            match primitive.get("mode").and_then(Value::as_u64) {
                Some(TRIANGLES) => {
                    of_meshes.push(position);
                    content.meshes.push(self.triangles(primitive, position, attributes.get("NORMAL"), offset)?);
                    content.mesh_lines.push(Vec::new());
                }
                Some(LINES) => {
                    if let Some(index) = of_mesh {
                        let indices = self.indices(primitive, content.meshes[index].positions.len())?;
                        let (pairs, rest) = indices.as_chunks();
                        if !rest.is_empty() {
                            return Err(ReadError::syntax("accessors", "lines need two indices each"));
                        }
                        content.mesh_lines[index].extend(pairs);
                        continue;
                    }
                    let line = self.line(primitive, position, offset)?;
                    content.curves.push(chain(&line, || "a curve".to_owned())?);
                }
                _ => return Err(ReadError::unsupported("a primitive with an unexpected mode", "meshes")),
            }
        }
        Ok(looks)
    }

    fn triangles(
        &self,
        primitive: &Value,
        position: &Value,
        normal: Option<&Value>,
        offset: Vec3,
    ) -> Result<SurfaceMesh, ReadError> {
        let positions = self.vectors(Some(position))?.into_iter().map(|v| Point3::from(v) + offset).collect();
        let normals: Vec<Vec3> = self.vectors(normal)?.into_iter().map(Vec3::from).collect();
        let mut mesh = SurfaceMesh { positions, normals, ..SurfaceMesh::default() };
        let indices = self.indices(primitive, mesh.positions.len().min(mesh.normals.len()))?;
        if indices.len() % 3 != 0 {
            return Err(ReadError::syntax("accessors", "triangles need three indices each"));
        }
        let corner = |i: usize| MeshCorner { position: i, normal: i };
        mesh.faces =
            indices.chunks_exact(3).map(|t| MeshFace::Triangle([corner(t[0]), corner(t[1]), corner(t[2])])).collect();
        Ok(mesh)
    }

    /// The vertices of segments that follow each other.
    fn line(&self, primitive: &Value, position: &Value, offset: Vec3) -> Result<Vec<Point3>, ReadError> {
        let points = self.vectors(Some(position))?;
        let indices = self.indices(primitive, points.len())?;
        let connected = indices.len() % 2 == 0 && indices.windows(2).skip(1).step_by(2).all(|w| w[0] == w[1]);
        if indices.is_empty() || !connected {
            return Err(ReadError::syntax("accessors", "the segments of a curve are not consecutive"));
        }
        let order = indices.first().into_iter().chain(indices.iter().skip(1).step_by(2));
        Ok(order.map(|i| Point3::from(points[*i]) + offset).collect())
    }

    fn indices(&self, primitive: &Value, count: usize) -> Result<Vec<usize>, ReadError> {
        let indices = self.numbers(primitive.get("indices"), "SCALAR", 4)?;
        let indices: Vec<usize> = indices.iter().map(|b| u32::from_le_bytes(*b) as usize).collect();
        if indices.iter().any(|i| *i >= count) {
            return Err(ReadError::syntax("accessors", "an index exceeds the number of vertices"));
        }
        Ok(indices)
    }

    /// The numbers of an accessor in rows; all finite.
    fn floats<const D: usize>(&self, accessor: Option<&Value>, kind: &str) -> Result<Vec<[f32; D]>, ReadError> {
        let numbers = self.numbers(accessor, kind, 4 * D)?;
        let rows = numbers.as_chunks::<D>().0.iter().map(|row| row.map(f32::from_le_bytes)).collect::<Vec<_>>();
        if rows.iter().flatten().any(|v| !v.is_finite()) {
            return Err(ReadError::syntax("accessors", "a number is not finite"));
        }
        Ok(rows)
    }

    /// The name of the node that holds another one, and where it stands.
    fn parent_of(&self, node: Option<u64>) -> Result<(String, Point3), ReadError> {
        let holds = |parent: &&Value| {
            let children = parent.get("children").and_then(Value::as_array).into_iter().flatten();
            parent.get("rotation").is_none() && children.map(Value::as_u64).any(|child| child == node)
        };
        let parent = self.list("nodes")?.iter().find(holds);
        let place = parent.and_then(|parent| parent.get("translation")).and_then(triple);
        let place =
            place.map(Point3::from).ok_or_else(|| ReadError::syntax("nodes", "a moving body has no position"))?;
        let name = parent.and_then(|parent| parent.get("name")).and_then(Value::as_str).unwrap_or_default();
        Ok((name.to_owned(), place))
    }

    /// The tracks of an animation: of each body two samplers, of its place and its turn.
    ///
    /// # Errors
    /// [`ReadError`] for one that is not like ours.
    fn tracks(&self, animation: &Value) -> Result<Vec<ReadTrack>, ReadError> {
        let channels = animation.get("channels").and_then(Value::as_array).map_or(0, Vec::len);
        (0..channels.div_ceil(2)).map(|body| self.track(animation, 2 * body)).collect()
    }

    /// The track of the body whose samplers start at this one.
    fn track(&self, animation: &Value, start: usize) -> Result<ReadTrack, ReadError> {
        let wrong = || ReadError::unsupported("an unexpected kind of animation", "animations");
        let sampler = |k: usize| animation.pointer(&format!("/samplers/{k}")).ok_or_else(wrong);
        let samplers = [sampler(start)?, sampler(start + 1)?];
        let is_ours = |k: usize, path: &str| {
            animation.pointer(&format!("/channels/{k}/sampler")).and_then(Value::as_u64) == Some(k as u64)
                && animation.pointer(&format!("/channels/{k}/target/path")).and_then(Value::as_str) == Some(path)
        };
        let node = |k: usize| animation.pointer(&format!("/channels/{k}/target/node")).and_then(Value::as_u64);
        let cubic = samplers.iter().all(|s| s.get("interpolation").and_then(Value::as_str) == Some("CUBICSPLINE"));
        let same = samplers[0].get("input") == samplers[1].get("input") && node(start) == node(start + 1);
        if !(is_ours(start, "translation") && is_ours(start + 1, "rotation") && cubic && same) {
            return Err(wrong());
        }
        let times = self.floats::<1>(samplers[0].get("input"), "SCALAR")?;
        let translations = self.floats::<3>(samplers[0].get("output"), "VEC3")?;
        let rotations = self.floats::<4>(samplers[1].get("output"), "VEC4")?;
        let count = times.len();
        let rising = times.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        if count < 2 || !rising || translations.len() != 3 * count || rotations.len() != 3 * count {
            return Err(ReadError::syntax("animations", "the keys of an animation are inconsistent"));
        }
        let track = Track {
            times: times.into_iter().map(|[t]| t).collect(),
            translations: translations.as_chunks().0.to_vec(),
            rotations: rotations.as_chunks().0.to_vec(),
        };
        let (name, center) = self.parent_of(node(start))?;
        Ok(ReadTrack { name, center, track })
    }

    fn vectors(&self, accessor: Option<&Value>) -> Result<Vec<[f64; 3]>, ReadError> {
        let numbers = self.numbers(accessor, "VEC3", 12)?;
        let vector = |v: &[[u8; 4]]| [0, 1, 2].map(|i| f64::from(f32::from_le_bytes(v[i])));
        let vectors: Vec<[f64; 3]> = numbers.chunks_exact(3).map(vector).collect();
        if vectors.iter().flatten().any(|v| !v.is_finite()) {
            return Err(ReadError::syntax("accessors", "a number is not finite"));
        }
        Ok(vectors)
    }

    /// The words of four bytes of an accessor.
    fn numbers(&self, accessor: Option<&Value>, kind: &str, width: usize) -> Result<Vec<[u8; 4]>, ReadError> {
        let accessor = self.entry("accessors", accessor)?;
        let view = self.entry("bufferViews", accessor.get("bufferView"))?;
        let number = |v: &Value, key: &str| v.get(key).and_then(Value::as_u64).and_then(|n| usize::try_from(n).ok());
        let place = || {
            let (start, length) = (number(view, "byteOffset")?, number(view, "byteLength")?);
            let bytes = self.binary.get(start..)?.get(..length)?;
            self.left.set(self.left.get().checked_sub(length)?);
            let whole = number(accessor, "count")?.checked_mul(width)? == length;
            (whole && accessor.get("type")?.as_str()? == kind).then_some(bytes)
        };
        let bytes = place().ok_or_else(|| ReadError::syntax("accessors", "the bytes of an accessor are missing"))?;
        Ok(bytes.chunks_exact(4).filter_map(|b| b.try_into().ok()).collect())
    }
}

/// The nodes that animations move.
fn moved_nodes(document: &Value) -> Vec<usize> {
    let animations = document.get("animations").and_then(Value::as_array).into_iter().flatten();
    let channels =
        animations.flat_map(|animation| animation.get("channels").and_then(Value::as_array).into_iter().flatten());
    let mut nodes: Vec<usize> = channels
        .filter_map(|channel| channel.pointer("/target/node")?.as_u64())
        .filter_map(|node| usize::try_from(node).ok())
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

fn triple(value: &Value) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    <[f64; 3]>::try_from(numbers?).ok()
}
