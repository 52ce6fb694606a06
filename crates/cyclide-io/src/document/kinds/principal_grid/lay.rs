//! Grids along the lines of curvature of surfaces.

use cyclide::{
    Error as KernelError, ShortNumber,
    error::{ErrorItem, NumberError, PrincipalGridError},
    model::GridObject,
};
use cyclide_grids::{
    FreeLayout, GridBorder, PrincipalField, PrincipalGridOptions, PrincipalGrids, PrincipalStage,
    covering_principal_grids_watched,
};

use crate::document::kinds::principal_grid::PrincipalGridSpec;
use crate::document::kinds::smooth_mesh::Given;
use crate::document::objects::Builder;
use crate::document::objects::facts::Facts;
use crate::document::objects::idle::{Idle, found};
use crate::document::objects::remark::Remark;
use crate::error::hints::words_of;
use crate::error::{Error, Result};
use crate::export::given_surface::{GivenSurface, LaidField};
use crate::input::exported_faces::Counted;
use crate::input::triangle_mesh::TriangleMesh;

impl Builder<'_> {
    /// Lays the grids.
    pub(in crate::document) fn principal_grid(&mut self, spec: &PrincipalGridSpec) -> Result<GridObject> {
        let given = self.mesh_to_lay_on(spec)?;
        let mut mesh = TriangleMesh::new(&given.mesh).map_err(|bad| self.bad_polygons(&given, bad))?;
        // Nothing but vertices and neighbors is taken of a mesh: how polygons are cut is nobody's matter.
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
        let laid = covering_principal_grids_watched(&mesh.points, &mesh.triangles, &options, free, tell);
        let laid = laid.map_err(|e| self.refused_grid(&given, &mesh, e))?;
        self.remarks.extend(laid.warnings().iter().cloned().map(Remark::from));
        let closed = laid.grids.iter().any(|grid| grid.closed()[0]);
        self.remark_on_idle(idle_in_principal_grid(spec, closed, laid.joined.is_some()));
        let PrincipalGrids { grids, joined, report, field, .. } = laid;
        let PrincipalField { points, triangles, normals, along, .. } = field;
        let umbilics = report.umbilics.iter().map(|umbilic| (umbilic.point, umbilic.halves)).collect();
        self.field = Some(LaidField { surface: GivenSurface { points, normals, triangles }, along, umbilics });
        self.facts = Facts::PrincipalGrid(Box::new(report));
        let made = joined.map_or_else(|| GridObject::apart(grids), GridObject::joined);
        made.map_err(|e| self.refused(&e, None))
    }

    fn mesh_to_lay_on(&mut self, spec: &PrincipalGridSpec) -> Result<Given> {
        match (&spec.mesh, &spec.vertices, &spec.faces, &spec.nurbs, &spec.heights) {
            (Some(file), None, None, None, None) => self.polygon_file(file),
            (None, Some(vertices), Some(faces), None, None) => self.listed_polygons(vertices, faces, "faces"),
            (None, None, None, Some(surface), None) => self.mesh_of_nurbs(surface, spec.edge_length),
            (None, None, None, None, Some(heights)) => self.mesh_of_heights(heights),
            _ => Err(self.unfit(
                "a surface requires exactly one of `mesh` (a file), `nurbs`, `heights`, or `vertices` with `faces`",
            )),
        }
    }

    /// The message for what the kernel said, in the numbers of the mesh as given.
    fn refused_grid(&self, given: &Given, mesh: &TriangleMesh, error: KernelError) -> Error {
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
            KernelError::Number(NumberError::NotFinite { .. }) if given.field == "faces" => "vertices",
            _ => given.field,
        };
        match (&error, &given.file) {
            (_, Some(file)) if field == given.field && !self.document.text.is_empty() => {
                self.refused_in_words([field.into()], error.reason(), format!("{} (of {file})", words_of(&error)))
            }
            (KernelError::PrincipalGrid(PrincipalGridError::NotASurface { index, .. }), _) if field == "faces" => {
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
