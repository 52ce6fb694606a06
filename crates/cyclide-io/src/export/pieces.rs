//! The pieces that one file may be made of: cells of meshes and vertices of polylines, over all objects together.

use crate::export::shape::Shape;
use cyclide::{
    Error, Point3,
    curve::{CurvePlace, ParamCurve},
    error::{NumberError, PartError},
    mesh::{SurfaceMesh, flatten_within, tessellate_within},
};
use std::cell::Cell;

/// A cap on pieces, and how many are used.
pub(crate) struct Pieces {
    most: usize,
    used: Cell<usize>,
}

impl Pieces {
    pub(crate) fn new(most: usize) -> Self {
        Self { most, used: Cell::new(0) }
    }

    /// As [`flatten_places`](cyclide::mesh::flatten_places), with the vertices that are left.
    pub(crate) fn flatten(&self, curve: &dyn ParamCurve, tolerance: f64) -> cyclide::Result<Vec<(CurvePlace, Point3)>> {
        let left = self.left();
        let vertices = flatten_within(curve, tolerance, left).map_err(|e| self.of_file(e, left))?;
        self.used.set(self.used.get() + vertices.len());
        Ok(vertices)
    }

    /// As [`tessellate`](cyclide::mesh::tessellate), with the cells that are left.
    pub(crate) fn tessellate(&self, shape: &Shape<'_>, tolerance: f64) -> cyclide::Result<SurfaceMesh> {
        let left = self.left();
        let mesh = match shape {
            Shape::Faces(body) => tessellate_within([body], tolerance, left),
            Shape::Triangles(surface, _) => surface.tessellate_within(tolerance, left).map(|made| made.mesh),
        };
        let mesh = mesh.map_err(|e| self.of_file(e, left))?;
        self.used.set(self.used.get() + mesh.faces.len());
        Ok(mesh)
    }

    fn left(&self) -> usize {
        self.most.saturating_sub(self.used.get())
    }

    /// What was refused for what is `left`, in terms of the whole file; the kernel's own caps are others.
    fn of_file(&self, error: Error, left: usize) -> Error {
        match error {
            Error::Number(NumberError::TooManyPieces { what, segment, needed, cap, .. }) if cap == left => {
                let (needed, cap) = (needed + self.used.get() as f64, self.most);
                let remedy = match needed.is_finite() {
                    true => "use a larger tolerance, or raise the limit with --max-pieces",
                    false => "use a larger tolerance",
                };
                Error::Number(NumberError::TooManyPieces { what, segment, needed, cap, remedy })
            }
            Error::Part(PartError::InTriangle { triangle, cause }) => self.of_file(*cause, left).in_triangle(triangle),
            other => other,
        }
    }
}
