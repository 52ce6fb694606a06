//! Volumes: the trait, and blocks whose three families of coordinate surfaces are Dupin cyclides that cross at right angles.

mod cyclide_grid;
mod cyclide_volume;
mod fold;
mod grading;
mod param_volume;
mod qb_block;
mod spherical_cube;
mod structured_grid;

pub use cyclide_grid::CyclideGrid;
pub use cyclide_volume::{CyclideVolume, VolumeFrame, VolumeLocation, VolumeMeasure, VolumeMetric, VolumeRow};
pub use fold::FoldVerdict;
pub use grading::{FineEnd, Grading};
pub use param_volume::ParamVolume;
pub use qb_block::{BlockBranch, QbBlock};
pub use spherical_cube::{SphericalCube, miquel_point};
pub use structured_grid::{CellQuality, GridQuality, MOST_CELLS, StructuredGrid};
