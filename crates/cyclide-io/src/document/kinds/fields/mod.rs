//! Fields that several kinds of object have.

pub(in crate::document) mod cells;
pub(in crate::document) mod comment;
pub(in crate::document) mod frame;
pub(in crate::document) mod parameters;
pub(in crate::document) mod polygon_mesh_file;
pub(in crate::document) mod radii;
pub(in crate::document) mod torus_numbers;
pub(in crate::document) mod torus_source;
pub(in crate::document) mod type_word;

pub use cells::*;
pub use comment::*;
pub use frame::*;
pub use parameters::*;
pub use polygon_mesh_file::*;
pub use radii::*;
pub use torus_numbers::*;
pub use torus_source::*;
pub use type_word::*;
