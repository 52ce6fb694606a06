//! What a file of ours holds when it is read back, held against the model: distances, structure, units and names.

pub(crate) mod bodies;
pub(crate) mod deviation;
pub(crate) mod file_content;
pub(crate) mod file_sample;
pub(crate) mod labels;
pub(crate) mod made;
pub(crate) mod polyline;
pub(crate) mod rational_cells;
pub(crate) mod rational_patches;
pub(crate) mod rational_volumes;
pub(crate) mod read_error;
pub(crate) mod spline_patches;
pub(crate) mod tiles;

pub use bodies::{FileBody, FileCurve, FileEdge, FileFace, FilePatch, FileShell, FileSurface, FileVolume};
pub use file_content::FileContent;
pub use file_sample::FileSample;
pub use labels::{FileLabels, FileName};
pub use read_error::ReadError;
