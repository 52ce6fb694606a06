//! Wavefront OBJ: meshes of surfaces, quads kept; grids of quads in.

mod polygons;
mod polyhedron;
mod quad_grid;
mod read_back;
mod writer;

pub(crate) use polyhedron::{PolygonMesh, read_polygons};
pub use quad_grid::{ObjGrid, read_quad_grid};
pub(crate) use read_back::read_back;
pub(crate) use writer::{labels, write};

#[cfg(test)]
mod tests;
