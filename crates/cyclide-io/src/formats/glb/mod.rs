//! Binary glTF 2.0: meshes of surfaces and lines of curves, for rendering and browsers.
//!
//! The model keeps its coordinates: one root node turns the third axis up and scales its unit to meters. Below it is
//! one node per object, with a mesh of one primitive per surface (triangles) and per curve (`LINES`, an index pair per
//! segment, which every reader knows). Vertices are in single precision, relative to the center of the object, which is
//! the translation of its node; the promised bound includes the rounding. Materials have the colors of the pictures,
//! surfaces are seen from both sides, lines are unlit.
//!
//! Motions are animations: see `animation.rs`.
//!
//! The edges of the patches can be drawn as lines on the vertices of the mesh.

mod animation;
mod buffer;
mod foreign;
mod material;
mod reader;
mod track;

use crate::check::deviation::{Deviations, MeshForm, Normals, View, check_mesh_edges};
use crate::check::labels::{FileLabels, FileName, Named, push_counted};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::drawing::patch_edges::patch_edges;
use crate::drawing::plane_regions::plane_regions;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::mesh::{
    BodyMesh, MeshVertices, Single, between, body_meshes, check_single, polyline, single, triangles,
};
use crate::export::moving::MovingRoom;
use crate::export::parts::{BodyOf, Contour};
use crate::export::shape::Shape;
use crate::formats::entry::{Entry, Reading};
use crate::formats::mesh_entry::{MeshEntry, NO_NORMAL_OF_A_CORNER, ReadMesh};
use animation::Clip;
use buffer::Buffer;
use cyclide::{
    Aabb, Point3,
    curve::bounds,
    mesh::{MeshCorner, SurfaceMesh},
    model::Item,
    motion::MovingBody,
};
use material::{Look, UNLIT};
use serde_json::{Value, json};

use foreign::read_scene;
pub(crate) use reader::read;

/// What there is to know of meshes in it.
pub(super) const MESH_ENTRY: MeshEntry = MeshEntry {
    word: "glb",
    field: "Path of a binary glTF file, relative to the document: its scene is in metres, and its up axis becomes the third axis.",
    is_start: |text| text.starts_with("glTF"),
    read: |name, bytes| read_scene(name, bytes).map(ReadMesh::from),
    has_quads: false,
    is_single: true,
    shares_vertices: false,
    without_normals: NO_NORMAL_OF_A_CORNER,
};

/// Modes of primitives.
const LINES: u64 = 1;
const TRIANGLES: u64 = 4;
/// The turn that takes the third axis to the second.
const Z_UP: [f64; 4] = [-std::f64::consts::FRAC_1_SQRT_2, 0.0, 0.0, std::f64::consts::FRAC_1_SQRT_2];

/// What the names are those of.
const TITLE: &str = "root node";
const NODE: &str = "node";
const MESH: &str = "mesh";
const MATERIAL: &str = "material";

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let (bodies, written) = (&made.ready.bodies, &made.file.written);
    let curves = made.curves(&content, View::Points)?;
    let form = MeshForm { normals: Normals::OfSurface, numbers_vertices: false };
    let off = made.meshes(&content, form)?;
    check_mesh_edges(bodies, &content.meshes, &content.mesh_lines, &written.mesh, written.mesh_edges)?;
    content.labels.check(&labels(made.named(), bodies, &content.mesh_lines))?;
    let motions = animation::deviations(&made.file.bytes, made.ready)?;
    Ok(Deviations { curves, bodies: off, motions, ..Deviations::default() })
}

/// The labels of a file of the model, whose meshes have these lines on them.
fn labels(named: Named<'_>, bodies: &[BodyOf<'_>], mesh_lines: &[Vec<[usize; 2]>]) -> FileLabels {
    let mut names = vec![FileName::new(TITLE, named.title, 1)];
    for (index, item) in named.model.items.iter().enumerate() {
        let own = || bodies.iter().zip(mesh_lines).filter(|(body, _)| body.item == index);
        let parts = item.curves().len() + own().count();
        if parts == 0 {
            continue;
        }
        names.extend([FileName::new(NODE, &item.name, parts), FileName::new(MESH, &item.name, 1)]);
        let [surface, line] = [Look::surface(item, index), Look::line(item, index)].map(|look| look.to_string());
        for (_, lines) in own() {
            push_counted(&mut names, MATERIAL, &surface);
            if !lines.is_empty() {
                push_counted(&mut names, MATERIAL, &line);
            }
        }
        item.curves().iter().for_each(|_| push_counted(&mut names, MATERIAL, &line));
    }
    FileLabels::new(named.model.units, names)
}

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "glb",
    title: "GLB",
    suffixes: &["glb"],
    lacks: None,
    animates: true,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// Writes the model as GLB.
pub(crate) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    check_single(job, job.size(), "GLB")?;
    let mut file = File::default();
    let meshes = body_meshes(job)?;
    let mut rooms = job.moving.iter();
    for (index, item) in job.model.items.iter().enumerate() {
        let own: Vec<&BodyMesh<'_>> = meshes.iter().filter(|mesh| mesh.body.item == index).collect();
        match item.motion().and_then(|body| Some((body, rooms.next()?))) {
            Some((body, room)) => file.motion(job, item, body, *room)?,
            None => file.object(job, index, item, &own)?,
        }
    }
    let File { buffer, nodes, children, clip, meshes, materials, written } = file;
    // The scene's root is the last node.
    let scale = job.units().in_millimetres() / 1000.0;
    let mut nodes = nodes;
    nodes.push(json!({"name": job.title(), "rotation": Z_UP, "scale": [scale, scale, scale], "children": children}));
    let unlit = materials.iter().any(|material| material.get("extensions").is_some());
    let mut document = json!({
        "asset": {"version": "2.0", "generator": "cyclide"},
        "scene": 0,
        "scenes": [{"nodes": [nodes.len() - 1]}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials,
    });
    if let Some(animations) = clip.to_json() {
        document["animations"] = animations;
    }
    if unlit {
        document["extensionsUsed"] = json!([UNLIT]);
    }
    let bytes = buffer.container(document).ok_or_else(|| {
        let object = job.model.items.first().map(|item| item.name.clone()).unwrap_or_default();
        ExportError::NotInFormat { object, format: "GLB", detail: "the file would exceed 4 GiB" }
    })?;
    Ok(written.exported(bytes, animation::other_clocks(job.model).into_iter().collect()))
}

/// The parts of the document as they grow.
#[derive(Default)]
struct File {
    buffer: Buffer,
    nodes: Vec<Value>,
    /// The nodes below the root.
    children: Vec<usize>,
    clip: Clip,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    written: Written,
}

impl File {
    fn object(
        &mut self,
        job: &Job<'_>,
        index: usize,
        item: &Item,
        bodies: &[&BodyMesh<'_>],
    ) -> Result<(), ExportError> {
        let curves = item.curves().iter().map(|curve| bounds(curve.as_curve()));
        let Some(extent) = curves.chain(bodies.iter().map(|mesh| mesh.body.body.bounds())).reduce(Aabb::union) else {
            return Ok(());
        };
        let center = extent.min.midpoint(extent.max);
        let mut primitives = Vec::new();
        if !bodies.is_empty() {
            let material = self.material(&Look::surface(item, index));
            let ink = job.options.glb_edges.then(|| self.material(&Look::line(item, index)));
            for body in bodies {
                self.body(body, center, [Some(material), ink], &mut primitives);
            }
        }
        if !item.curves().is_empty() {
            let material = self.material(&Look::line(item, index));
            for contour in job.contours().filter(|contour| contour.item == index) {
                primitives.push(self.curve(job, &contour, center, material)?);
            }
        }
        self.children.push(self.nodes.len());
        self.nodes.push(json!({"name": item.name, "mesh": self.meshes.len(), "translation": center.to_array()}));
        self.meshes.push(json!({"name": item.name, "primitives": primitives}));
        Ok(())
    }

    /// Adds a body in motion.
    fn motion(&mut self, job: &Job<'_>, item: &Item, body: &MovingBody, room: MovingRoom) -> Result<(), ExportError> {
        let (parent, node) = (self.nodes.len(), self.nodes.len() + 1);
        let first_material = self.materials.len();
        let parts = (&mut self.buffer, &mut self.clip);
        let made = animation::animated(item, (body, room), node, first_material, job.tolerance, parts)?;
        self.materials.extend(made.materials.iter().map(Look::to_json));
        self.children.push(parent);
        self.nodes.push(json!({"name": item.name, "translation": made.center.to_array(), "children": [node]}));
        let mut own = made.first;
        own["name"] = json!(format!("{} body", item.name));
        own["mesh"] = json!(self.meshes.len());
        self.nodes.push(own);
        self.meshes.push(json!({"name": item.name, "primitives": made.primitives}));
        self.written.motions.push(made.promise);
        Ok(())
    }

    /// Adds a material; gives its index.
    fn material(&mut self, look: &Look) -> usize {
        self.materials.push(look.to_json());
        self.materials.len() - 1
    }

    /// Adds the triangles of a body and, with a second material, its edges.
    fn body(
        &mut self,
        body: &BodyMesh<'_>,
        center: Point3,
        [material, ink]: [Option<usize>; 2],
        primitives: &mut Vec<Value>,
    ) {
        let mesh = &body.mesh;
        let mut rounding = Single::new(center);
        let mut vertices = MeshVertices::default();
        let mut indices = Vec::new();
        for face in &mesh.faces {
            let corners: Vec<u32> = face.corners().iter().map(|corner| vertices.index(*corner) as u32).collect();
            for triangle in triangles(face) {
                indices.extend(triangle.map(|i| corners[i]));
            }
        }
        let rounded: Vec<[f32; 3]> = mesh.positions.iter().map(|p| rounding.point(*p)).collect();
        let positions: Vec<[f32; 3]> = vertices.corners.iter().map(|corner| rounded[corner.position]).collect();
        let normals = vertices.corners.iter().map(|corner| mesh.normals[corner.normal].to_array().map(single));
        let position = self.buffer.positions(&positions);
        let normal = self.buffer.vectors(normals);
        let attributes = json!({"POSITION": position, "NORMAL": normal});
        let indices = self.buffer.indices(&indices);
        primitives.push(json!({"attributes": attributes, "indices": indices, "material": material, "mode": TRIANGLES}));
        if let Some(ink) = ink {
            let lines = edges(&body.body.body, mesh, &rounded, &mut vertices);
            self.written.mesh_edges = true;
            if !lines.is_empty() {
                let indices = self.buffer.indices(&lines);
                let attributes = json!({"POSITION": position});
                primitives.push(json!({"attributes": attributes, "indices": indices, "material": ink, "mode": LINES}));
            }
        }
        body.plan_triangles(&rounded, rounding.moved, |face| triangles(face).len(), &mut self.written.mesh);
        self.written.bodies.push(body.promise(rounding.moved));
    }

    /// The primitive of a curve.
    fn curve(
        &mut self,
        job: &Job<'_>,
        contour: &Contour<'_>,
        center: Point3,
        material: usize,
    ) -> Result<Value, ExportError> {
        let mut rounding = Single::new(center);
        let vertices = polyline(job, contour)?;
        let mut points: Vec<[f32; 3]> = vertices.iter().map(|(_, p)| rounding.point(*p)).collect();
        let is_same = |a: [f32; 3], b: [f32; 3]| a.iter().zip(&b).all(|(a, b)| a.to_bits() == b.to_bits());
        let segments: Vec<usize> = points.windows(2).map(|w| usize::from(!is_same(w[0], w[1]))).collect();
        points.dedup_by(|a, b| is_same(*a, *b));
        let closed = contour.curve.as_curve().is_closed();
        if closed {
            points.pop();
        }
        let promise = Promise::of_polyline(contour.curve.as_curve(), job.tolerance + rounding.moved);
        self.written.curves.push(promise.of(between(&vertices).recounted(segments)));
        // Two of a closed curve are there and back.
        if points.len() < 2 {
            let (object, detail) =
                (contour.object.to_owned(), "the curve is smaller than the rounding of single precision");
            return Err(ExportError::NotInFormat { object, format: "GLB", detail });
        }
        let count = points.len() as u32;
        let segments = (1..count).map(|i| [i - 1, i]).chain(closed.then_some([count - 1, 0]));
        let indices: Vec<u32> = segments.flatten().collect();
        let attributes = json!({"POSITION": self.buffer.positions(&points)});
        let indices = self.buffer.indices(&indices);
        Ok(json!({"attributes": attributes, "indices": indices, "material": material, "mode": LINES}))
    }
}

/// The edges of the patches of a mesh, parts of one plane as one, as pairs of vertices, where those with the same rounded position are one.
fn edges(body: &Shape<'_>, mesh: &SurfaceMesh, rounded: &[[f32; 3]], vertices: &mut MeshVertices) -> Vec<u32> {
    let regions: Vec<Vec<usize>> = body.shells().map(plane_regions).collect();
    let faces = mesh.faces.iter().zip(&mesh.sources);
    let of_patch = faces.flat_map(|(face, source)| {
        // The triangles of a surface without faces are its patches.
        let region = regions.get(source.shell).and_then(|faces| faces.get(source.face));
        let patch = (source.shell, region.copied().unwrap_or(source.face));
        triangles(face).iter().map(move |t| (patch, t.map(|i| face.corners()[i])))
    });
    let triangles: Vec<((usize, usize), [MeshCorner; 3])> = of_patch.collect();
    let bits = |corner: MeshCorner| rounded[corner.position].map(f32::to_bits);
    let sides = patch_edges(triangles.iter().map(|(patch, corners)| (*patch, corners.map(bits))));
    let ends = |(triangle, from): (usize, usize)| [from, (from + 1) % 3].map(|i| triangles[triangle].1[i]);
    sides.into_iter().flat_map(ends).map(|corner| vertices.index(corner) as u32).collect()
}
