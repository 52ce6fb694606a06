//! Polylines and polygon meshes of anything with jets.

mod flatten;
mod surface_mesh;

pub use flatten::{flatten, flatten_into};
pub use surface_mesh::{MeshCorner, MeshFace, SurfaceMesh};
