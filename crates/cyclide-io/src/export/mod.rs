//! What every writer works with: the model made ready, the request, meshes, and what is promised of the file that is
//! made.

pub(crate) mod camera;
pub(crate) mod collapsed;
pub(crate) mod drawn_line;
pub(crate) mod error;
pub(crate) mod exported;
pub(crate) mod face_plan;
pub(crate) mod given_surface;
pub(crate) mod job;
pub(crate) mod lowered;
pub(crate) mod mesh;
pub(crate) mod mesh_plan;
pub(crate) mod moving;
pub(crate) mod options;
pub(crate) mod parts;
pub(crate) mod patch_joints;
pub(crate) mod pieces;
pub(crate) mod provenance;
pub(crate) mod rational_cells;
pub(crate) mod ready;
pub(crate) mod scaled_weights;
pub(crate) mod shape;
pub(crate) mod side_use;
pub(crate) mod single_mesh;
pub(crate) mod spline_patches;
pub(crate) mod triangle_cells;

pub use camera::Camera;
pub use error::ExportError;
pub use exported::Exported;
pub use given_surface::{GivenSurface, LaidField};
pub use options::{
    DEFAULT_MOST_PIECES, DxfVersion, ExportOptions, PictureColour, StepEdges, StepFaces, StepProducts, VtuCells,
    VtuEncoding,
};
pub use provenance::Provenance;
