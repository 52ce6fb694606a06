//! Wavefront OBJ: meshes of surfaces, quads kept.

mod read_back;
mod writer;

pub(crate) use read_back::read_back;
pub(crate) use writer::write;
