//! Wavefront OBJ: meshes of surfaces, quads kept; grids of quads in.

mod polygons;
mod polyhedron;
mod quad_grid;
mod read_back;
mod writer;

use crate::check::deviation::{Deviations, MeshForm, View};
use crate::check::file_content::ReadError;
use crate::check::made::Made;
use crate::export::lowered::Forms;
use crate::formats::entry::{Entry, Reading};

pub(crate) use polyhedron::read_polygons;
pub use quad_grid::{ObjGrid, read_quad_grid};
use read_back::read_back;
use writer::{labels, write};

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "obj",
    title: "OBJ",
    suffixes: &["obj"],
    lacks: None,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read: read_back, compare, rounds_by_model: false }),
};

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read_back(&made.file.bytes)?;
    let curves = made.curves(&content, View::Points)?;
    let bodies = made.meshes(&content, MeshForm { has_facet_normals: false, numbers_vertices: true })?;
    content.labels.check(&labels(made.ready.model, &made.ready.bodies))?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}

#[cfg(test)]
mod tests;
