//! What leaves the kernel: named objects, lowered to a few carriers with their exactness.

mod chain;
mod circle_spline;
mod derived;
mod grid_object;
mod lower;
mod named;
mod nurbs;
mod object;
mod part;
mod qb_spline;
mod surface_object;
mod torus_spline;

pub use chain::{ChainPiece, CurveChain};
pub use grid_object::GridObject;
pub use lower::{Exactness, Lower, Lowered};
pub use object::{CurveObject, Geometry, Item, Model, Units};
pub use surface_object::SurfaceObject;
