//! What is read of users: files and standard input as bytes, lists of points, meshes.

#[cfg(feature = "files")]
pub(crate) mod confined;
pub(crate) mod exported_faces;
#[cfg(feature = "files")]
pub(crate) mod file;
pub(crate) mod points;
pub(crate) mod polygon_mesh;
pub(crate) mod triangle_mesh;

#[cfg(feature = "files")]
pub use confined::ReadFolder;
#[cfg(feature = "files")]
pub use file::{MOST_INPUT_BYTES, read_head, read_input, read_standard_input};
pub use points::{ColumnUnit, PointColumns, PointList, PointRemark, PointTable, read_points, unit_of_columns};
