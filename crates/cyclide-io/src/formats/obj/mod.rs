//! Wavefront OBJ: meshes of surfaces, quads kept; grids of quads in.

mod polygons;
mod polyhedron;
mod quad_grid;
mod read_back;
mod writer;

use crate::check::deviation::{Deviations, MeshForm, Normals, View};
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::lowered::Forms;
use crate::formats::entry::{Entry, Reading};
use crate::formats::mesh_entry::{MeshEntry, NO_NORMAL_OF_A_CORNER, ReadMesh};
use crate::text::lines::lines;

use polyhedron::read_polygons;
pub use quad_grid::{MendedQuads, ObjGrid, ObjLayout, ObjQuads, read_quad_grid, read_quads};
use read_back::read_back;
use writer::{labels, write};

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "obj",
    title: "OBJ",
    suffixes: &["obj"],
    lacks: None,
    animates: false,
    holds_exact_only: false,
    forms: |_| Forms::NONE,
    write,
    reading: Some(Reading { read: read_back, compare, rounds_by_model: false }),
};

/// What there is to know of meshes in it.
pub(super) const MESH_ENTRY: MeshEntry = MeshEntry {
    word: "obj",
    field: "Path of a Wavefront OBJ file, relative to the document.",
    is_start,
    read: |name, bytes| read_polygons(name, bytes).map(ReadMesh::from),
    has_quads: true,
    is_single: false,
    shares_vertices: true,
    without_normals: NO_NORMAL_OF_A_CORNER,
};

/// Lines that are looked at.
const LINES: usize = 20;

/// By the first line that is no remark and has the word of one, before any that is a row of numbers.
fn is_start(text: &str) -> bool {
    let is_number = |word: Option<&str>| word.is_some_and(|word| word.parse::<f64>().is_ok());
    for (_, line) in lines(text).take(LINES) {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("mtllib") => return true,
            Some("v" | "vn" | "vt" | "f") if words.clone().count() >= 2 => {
                // Corners are numbers with others behind slashes.
                let first = words.next().and_then(|word| word.split('/').next());
                if is_number(first) {
                    return true;
                }
            }
            Some(word) if is_number(Some(word)) => return false,
            _ => {}
        }
    }
    false
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read_back(&made.file.bytes)?;
    let curves = made.curves(&content, View::Points)?;
    let bodies = made.meshes(&content, MeshForm { normals: Normals::OfSurface, numbers_vertices: true })?;
    content.labels.check(&labels(made.ready.model, &made.ready.bodies))?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}

#[cfg(test)]
mod tests;
