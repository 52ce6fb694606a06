//! Polylines and polygon meshes of anything with jets.

mod flatten;
mod parameter_lines;
mod surface_mesh;
mod tessellate;

pub use flatten::{flatten, flatten_into, flatten_places};
pub use parameter_lines::{LineKind, ParameterLine, parameter_lines};
pub use surface_mesh::{MeshCorner, MeshFace, MeshSource, SurfaceMesh};
pub use tessellate::{tessellate, tessellate_all};
