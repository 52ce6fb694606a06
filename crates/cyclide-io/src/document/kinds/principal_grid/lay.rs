//! Grids along the lines of curvature of surfaces.

use std::collections::HashSet;

use cyclide::{
    ArcPath, CurveObject, Error as KernelError, ErrorItem, MeshError, NumberError, Point3, PrincipalGridError,
    ShortNumber,
};
use cyclide_grids::{
    FreeLayout, GridBorder, PrincipalField, PrincipalGridOptions, PrincipalGrids, PrincipalStage,
    covering_principal_grids,
};

use crate::document::kinds::principal_grid::PrincipalGridSpec;
use crate::document::kinds::smooth_mesh::Given;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, GridFacts};
use crate::document::objects::idle::{Idle, found};
use crate::document::objects::remark::Remark;
use crate::error::hints::words_of;
use crate::error::{Error, Result};
use crate::export::given_surface::{GivenSurface, LaidField};
use crate::input::exported_faces::Counted;
use crate::input::polygon_mesh::PolygonMesh;
use crate::input::triangle_mesh::TriangleMesh;

/// What is said where a surface is given twice, or not at all.
const ONE_SURFACE: &str =
    "a surface requires exactly one of `mesh` (a file), `nurbs`, `heights`, or `vertices` with `faces`";

impl Builder<'_> {
    /// Lays the grids; their lines are the curves of the object.
    pub(in crate::document) fn principal_grid(&mut self, spec: &PrincipalGridSpec) -> Result<Vec<CurveObject>> {
        let given = self.mesh_to_lay_on(spec)?;
        let mut mesh = TriangleMesh::new(&given.mesh).map_err(|bad| self.bad_polygons(&given, bad))?;
        // Nothing but vertices and neighbours is taken of a mesh: how polygons are cut is nobody's matter.
        mesh.cut = Counted::default();
        self.remark_on_mesh(&given, &mesh);
        let options = PrincipalGridOptions {
            umbilics: spec.umbilics.unwrap_or_default(),
            border: spec.border.unwrap_or_default(),
            closed: spec.closed,
            columns: spec.columns.map(|n| n as usize),
            most_pieces: spec.most_pieces.map(|n| n as usize),
            denoise: spec.denoise,
            ..PrincipalGridOptions::new(spec.edge_length)
        };
        let free = FreeLayout { border: spec.border.is_none(), umbilics: spec.umbilics.is_none() };
        let progress = &mut *self.progress;
        let tell = &mut |stage| progress(words(stage));
        let laid = covering_principal_grids(&mesh.points, &mesh.triangles, &options, free, tell);
        let laid = laid.map_err(|e| self.refused_grid(spec, &given, &mesh, e))?;
        self.remarks.extend(laid.warnings().iter().cloned().map(Remark::from));
        let closed = laid.grids.iter().any(|grid| grid.closed()[0]);
        self.remark_on_idle(idle_in_principal_grid(spec, closed, laid.joined.is_some()));
        let lines = lines(&laid).map_err(|e| self.refused(&e, None))?;
        self.field = Some(field(&laid));
        let facts = GridFacts { grids: laid.grids, joined: laid.joined, report: laid.report };
        self.facts = Facts::Grids(Box::new(facts));
        Ok(lines)
    }

    fn mesh_to_lay_on(&mut self, spec: &PrincipalGridSpec) -> Result<Given> {
        match (&spec.mesh, &spec.vertices, &spec.faces) {
            (None, None, None) => match (&spec.nurbs, &spec.heights) {
                (Some(surface), None) => self.mesh_of_nurbs(surface, spec.edge_length),
                (None, Some(heights)) => self.mesh_of_heights(heights),
                _ => Err(self.unfit(ONE_SURFACE)),
            },
            _ if spec.nurbs.is_some() || spec.heights.is_some() => Err(self.unfit(ONE_SURFACE)),
            (Some(file), None, None) => self.polygon_file(file),
            (None, Some(vertices), Some(faces)) => {
                let count = vertices.len();
                let faces: Vec<Vec<usize>> = faces.iter().map(|f| f.iter().map(|v| *v as usize).collect()).collect();
                for (index, face) in faces.iter().enumerate() {
                    if let Some(place) = face.iter().position(|v| *v >= count) {
                        let error =
                            KernelError::Mesh(MeshError::NoSuchVertex { triangle: index, vertex: face[place], count });
                        return Err(self.refused_at(["faces".into(), index.into(), place.into()], &error));
                    }
                }
                let points = vertices.iter().map(|p| p.point()).collect();
                let mesh = PolygonMesh { points, faces, ..PolygonMesh::default() };
                Ok(Given { mesh, file: None, field: "faces", shared: true, lists_normals: false })
            }
            _ => Err(self.unfit(ONE_SURFACE)),
        }
    }

    /// The message for what the kernel said, in the numbers of the mesh as given.
    fn refused_grid(&self, spec: &PrincipalGridSpec, given: &Given, mesh: &TriangleMesh, error: KernelError) -> Error {
        let error = match error {
            KernelError::PrincipalGrid(PrincipalGridError::NotASurface { fault, index }) => {
                KernelError::PrincipalGrid(PrincipalGridError::NotASurface {
                    fault,
                    index: mesh.polygons.get(index).copied().unwrap_or(index),
                })
            }
            other => other,
        };
        let field = match &error {
            KernelError::Number(NumberError::ParameterOutOfRange { name: ErrorItem::EdgeLength, .. })
            | KernelError::PrincipalGrid(PrincipalGridError::NoGrid { .. }) => "edge_length",
            KernelError::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Columns, .. }) => "columns",
            KernelError::Number(NumberError::ParameterOutOfRange { name: ErrorItem::MostPieces, .. }) => "most_pieces",
            KernelError::Number(NumberError::NotFinite { .. }) if spec.vertices.is_some() => "vertices",
            _ => given.field,
        };
        match (&error, &given.file) {
            (_, Some(file)) if field == given.field && !self.document.text.is_empty() => {
                self.refused_in_words([field.into()], error.reason(), format!("{} (of {file})", words_of(&error)))
            }
            (KernelError::PrincipalGrid(PrincipalGridError::NotASurface { index, .. }), None)
                if spec.faces.is_some() =>
            {
                self.refused_at([field.into(), (*index).into()], &error)
            }
            _ => self.refused_at([field.into()], &error),
        }
    }
}

/// What the grids of a surface do not look at; `closed` if one of them is.
pub(in crate::document) fn idle_in_principal_grid(spec: &PrincipalGridSpec, closed: bool, joined: bool) -> Vec<Idle> {
    let several = spec.most_pieces.is_some_and(|most| most > 1);
    found(&[
        ("columns", !closed && spec.columns.is_some(), "no grid is closed"),
        ("closed", !closed && spec.closed == Some(true), "the surface is not a tube whose lines of curvature close"),
        ("most_pieces", several && spec.border == Some(GridBorder::Cover), "one grid covers the surface"),
        ("most_pieces", joined && spec.most_pieces.is_some(), "joined grids are all computed"),
    ])
}

/// What pictures show of it.
fn field(laid: &PrincipalGrids) -> LaidField {
    let PrincipalField { points, triangles, normals, along, .. } = laid.field.clone();
    let umbilics = laid.report.umbilics.iter().map(|umbilic| (umbilic.point, umbilic.halves)).collect();
    LaidField { surface: GivenSurface { points, normals, triangles }, along, umbilics, grids: laid.grids.clone() }
}

/// What is being done, for a line of progress.
fn words(stage: PrincipalStage) -> String {
    match stage {
        PrincipalStage::Directions { smoothing, umbilics } => {
            format!("lines of curvature: smoothed by {}, {umbilics} umbilic(s)", ShortNumber(smoothing))
        }
        PrincipalStage::Coordinates => "coordinates along the lines of curvature".to_owned(),
        PrincipalStage::Lattice { grids } => format!("grid {grids}"),
        _ => "curvatures of the mesh".to_owned(),
    }
}

/// The lines of the grids, those along s first; of joined grids what several share is drawn once.
fn lines(laid: &PrincipalGrids) -> cyclide::Result<Vec<CurveObject>> {
    let mut drawn = HashSet::new();
    let mut curves = Vec::new();
    for (k, grid) in laid.grids.iter().enumerate() {
        let numbers = laid.joined.as_ref().map(|mesh| &mesh.pieces()[k].vertices);
        for (vertices, closed) in grid.lines() {
            let is_new = |a: usize, b: usize| match numbers.map(|numbers| [numbers[a], numbers[b]]) {
                Some([a, b]) => drawn.insert([a.min(b), a.max(b)]),
                None => true,
            };
            for part in parts(&vertices, closed, is_new) {
                let points: Vec<Point3> = part.iter().map(|v| grid.points()[*v]).collect();
                let path = ArcPath::rounded_polyline(&points, closed, &vec![0.0; points.len()])?;
                curves.push(CurveObject::ArcPath(path));
            }
        }
    }
    Ok(curves)
}

/// The parts of a line between edges that are not wanted; a closed line is one.
fn parts(line: &[usize], closed: bool, mut wanted: impl FnMut(usize, usize) -> bool) -> Vec<Vec<usize>> {
    if closed {
        return vec![line.to_vec()];
    }
    let mut parts: Vec<Vec<usize>> = Vec::new();
    let mut goes_on = false;
    for pair in line.windows(2) {
        let is_wanted = wanted(pair[0], pair[1]);
        match parts.last_mut() {
            Some(part) if is_wanted && goes_on => part.push(pair[1]),
            _ if is_wanted => parts.push(pair.to_vec()),
            _ => {}
        }
        goes_on = is_wanted;
    }
    parts
}
