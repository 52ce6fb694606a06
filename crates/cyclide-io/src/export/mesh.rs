//! What the mesh formats share: bodies as meshes, curves as polylines, and what single precision costs.

use crate::export::error::ExportError;
use crate::export::exported::Promise;
use crate::export::job::Job;
use crate::export::mesh_plan::{BodyPlan, Cell, MeshPlan};
use crate::export::parts::{BodyOf, Contour};
use crate::export::side_use::side_use;
use cyclide::{
    Point3, Vec3,
    curve::{Correspondence, CurvePlace},
    mesh::{MeshCorner, MeshFace, MeshSource, SurfaceMesh},
};
use std::collections::{HashMap, HashSet};
use std::hash::Hash;

/// Single precision is used between these sizes: products of two numbers must neither vanish nor overflow.
const SINGLE: std::ops::Range<f64> = 1e-15..1e15;

/// A body as a mesh.
pub(crate) struct BodyMesh<'a> {
    /// Index of the body in the job.
    pub(crate) index: usize,
    pub(crate) body: &'a BodyOf<'a>,
    pub(crate) mesh: SurfaceMesh,
}

/// The meshes of all bodies within the job's tolerance.
pub(crate) fn body_meshes<'a>(job: &'a Job<'_>) -> Result<Vec<BodyMesh<'a>>, ExportError> {
    let one = |(index, body): (usize, &'a BodyOf<'_>)| {
        let mesh = job.pieces.tessellate(&body.body, job.mesh_tolerance).map_err(|source| body.unfit(source))?;
        Ok(BodyMesh { index, body, mesh })
    };
    job.bodies.iter().enumerate().map(one).collect()
}

impl BodyMesh<'_> {
    /// What is promised for the mesh with vertices that rounding has moved: proved of faces, sampled of surfaces over triangles.
    pub(crate) fn promise(&self, moved: f64) -> Promise {
        let bound = self.mesh.bound + moved;
        match self.body.body.triangles() {
            None => Promise::proved(bound),
            Some(_) => Promise::sampled(bound),
        }
    }

    /// Notes what the file is checked against, where faces are written whole with the vertices that they share.
    pub(crate) fn plan_whole(&self, plan: &mut MeshPlan) {
        let polygons = self.mesh.faces.iter().map(|face| face.corners().iter().map(|corner| corner.position));
        let merged = self.merged(|position| position);
        plan.bodies.push(BodyPlan { sides: side_use(polygons), merged, moved: self.mesh.gap });
        plan.cells.extend(self.cells(|_| 1));
    }

    /// Notes what the file is checked against, where vertices are known by their places and faces are written whole, or in triangles.
    pub(crate) fn plan_places(&self, in_triangles: bool, plan: &mut MeshPlan) {
        let bits = |position: usize| self.mesh.positions[position].to_array().map(|x| (x + 0.0).to_bits());
        let polygons = self.mesh.faces.iter().flat_map(|face| polygons(face, in_triangles));
        let sides = side_use(polygons.map(|polygon| polygon.into_iter().map(|corner| bits(corner.position))));
        plan.bodies.push(BodyPlan { sides, merged: self.merged(bits), moved: self.mesh.gap });
        plan.cells.extend(self.cells(|face| if in_triangles { triangles(face).len() } else { 1 }));
    }

    /// Notes what the file is checked against, where faces are cut into triangles and vertices known by the bits of
    /// their rounded positions; `count(face)` triangles of a face are written.
    pub(crate) fn plan_triangles(
        &self,
        rounded: &[[f32; 3]],
        moved: f64,
        count: impl FnMut(&MeshFace) -> usize,
        plan: &mut MeshPlan,
    ) {
        let bits = |corner: &MeshCorner| rounded[corner.position].map(f32::to_bits);
        let of_face = |face| triangles(face).iter().map(move |t| t.map(|i| bits(&MeshFace::corners(face)[i])));
        let moved = moved + self.mesh.gap;
        let merged = self.merged(|position| rounded[position].map(f32::to_bits));
        let sides = side_use(self.mesh.faces.iter().flat_map(of_face));
        plan.bodies.push(BodyPlan { sides, merged, moved });
        plan.cells.extend(self.cells(count));
    }

    /// True if several corners of a cell, or several places of the mesh, are one vertex, known by a key.
    fn merged<K: Eq + Hash>(&self, key: impl Fn(usize) -> K) -> bool {
        let distinct: HashSet<K> = (0..self.mesh.positions.len()).map(key).collect();
        distinct.len() < self.mesh.positions.len() || !self.mesh.lost.is_empty()
    }

    /// What the faces of the mesh stand for, where each is written as `polygons(face)` polygons, and the cells that have
    /// none.
    fn cells(&self, mut polygons: impl FnMut(&MeshFace) -> usize) -> impl Iterator<Item = Cell> {
        let cell = |source: &MeshSource, polygons| Cell { body: self.index, source: *source, polygons };
        // Faces of one cell follow each other.
        let mut faces = self.mesh.faces.iter();
        let whole = self.mesh.sources.chunk_by(|a, b| a == b).map(move |own| {
            let count = faces.by_ref().take(own.len()).map(&mut polygons).sum();
            cell(&own[0], count)
        });
        whole.chain(self.mesh.lost.iter().map(move |source| cell(source, 0)))
    }
}

/// The vertices of a contour's polyline with their places; a closed one ends with its first.
pub(crate) fn polyline(job: &Job<'_>, contour: &Contour<'_>) -> Result<Vec<(CurvePlace, Point3)>, ExportError> {
    contour.lowered(job.pieces.flatten(contour.curve.as_curve(), job.tolerance))
}

/// The parts of a curve between the vertices of its polyline.
pub(crate) fn between(vertices: &[(CurvePlace, Point3)]) -> Correspondence {
    Correspondence::of_vertices(vertices.iter().map(|(place, _)| *place))
}

/// The triangles of a face, corners as positions in its list.
pub(crate) fn triangles(face: &MeshFace) -> &'static [[usize; 3]] {
    match face {
        MeshFace::Triangle(_) => &[[0, 1, 2]],
        MeshFace::Quad(_) => &[[0, 1, 2], [0, 2, 3]],
    }
}

/// The corners of a mesh that have a vertex of their own, a place with a normal, in the order in which they are met.
#[derive(Default)]
pub(crate) struct MeshVertices {
    pub(crate) corners: Vec<MeshCorner>,
    index: HashMap<MeshCorner, usize>,
}

impl MeshVertices {
    pub(crate) fn index(&mut self, corner: MeshCorner) -> usize {
        *self.index.entry(corner).or_insert_with(|| {
            self.corners.push(corner);
            self.corners.len() - 1
        })
    }
}

/// A face as it is, or its triangles.
pub(crate) fn polygons(face: &MeshFace, in_triangles: bool) -> Vec<Vec<MeshCorner>> {
    let corners = face.corners();
    if in_triangles {
        triangles(face).iter().map(|t| t.iter().map(|i| corners[*i]).collect()).collect()
    } else {
        vec![corners.to_vec()]
    }
}

/// Rounding of points to single precision, relative to a center, with the largest distance that it moved one.
pub(crate) struct Single {
    center: Point3,
    pub(crate) moved: f64,
}

impl Single {
    pub(crate) fn new(center: Point3) -> Self {
        Self { center, moved: 0.0 }
    }

    /// The rounded coordinates relative to the center.
    pub(crate) fn point(&mut self, p: Point3) -> [f32; 3] {
        let exact = p - self.center;
        let rounded = exact.to_array().map(single);
        let back = Vec3::from(rounded.map(f64::from));
        self.moved = self.moved.max((back - exact).length());
        rounded
    }
}

/// The nearest number of single precision, without a negative zero.
pub(crate) fn single(v: f64) -> f32 {
    v as f32 + 0.0
}

/// Refuses models whose size or place single precision does not reach.
pub(crate) fn check_single(job: &Job<'_>, largest: f64, format: &'static str) -> Result<(), ExportError> {
    if SINGLE.contains(&job.size()) && largest < SINGLE.end {
        return Ok(());
    }
    let object = job.model.items.first().map(|item| item.name.clone()).unwrap_or_default();
    let detail = "its single-precision numbers allow sizes of 1e-15 to 1e15 only";
    Err(ExportError::NotInFormat { object, format, detail })
}
