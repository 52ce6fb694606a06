//! Polylines and polygon meshes of anything with jets.

mod flatten;
mod parameter_lines;
mod smooth;
mod surface_mesh;
mod tessellate;

/// Pieces that a polyline (vertices) or a mesh (cells) has at most, unless more are allowed: some 100 bytes each here, and several
/// times as many in what is made of them.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!(cyclide::mesh::flatten(&arc, 1e-9)?.len() < cyclide::mesh::MOST_PIECES);
/// # Ok::<(), cyclide::Error>(())
/// ```
pub const MOST_PIECES: usize = 4_000_000;

pub use flatten::{flatten, flatten_into, flatten_places, flatten_within};
pub use parameter_lines::{LineKind, ParameterLine, parameter_lines};
pub use smooth::SmoothTessellation;
pub use surface_mesh::{MeshCorner, MeshFace, MeshSource, SurfaceMesh};
pub use tessellate::{tessellate, tessellate_all, tessellate_within};
