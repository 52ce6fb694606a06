//! Surfaces: the trait, principal patches of Dupin cyclides, nets of them, shells of patches that share edges.

mod bounds;
mod dupin;
mod joints;
mod net;
mod param_surface;
mod patch;
mod quad_grid;
mod seam;
mod shell;

pub use dupin::{CyclideKind, DupinCyclide};
pub use joints::{SurfaceJoint, surface_joints};
pub use net::{CyclidicNet, NetFrame, SingularPatch};
pub use param_surface::ParamSurface;
pub use patch::{CyclidePatch, ImplicitForm, PatchKind, PatchLocation, PatchRow};
pub use quad_grid::QuadGrid;
pub use seam::{Seam, SeamMeasure};
pub use shell::{Body, FaceEdge, Shell, ShellEdge, ShellFace};
