//! Numbers, points, quaternions, frames: what everything else is written in.

pub(crate) mod bernstein;
pub(crate) mod bernstein_roots;
pub(crate) mod bounds;
pub(crate) mod box_tree;
pub(crate) mod complex;
pub(crate) mod cut;
pub(crate) mod elimination;
pub(crate) mod euclidean;
pub(crate) mod frame;
pub(crate) mod golden_section;
mod interop;
pub(crate) mod jet;
pub(crate) mod multilinear;
mod operators;
pub(crate) mod planar;
pub(crate) mod quadratic;
pub(crate) mod quadrature;
pub(crate) mod quat;
pub(crate) mod range;
pub(crate) mod roots;
pub(crate) mod segments;
pub(crate) mod surface_jet;
pub(crate) mod svd3;
pub(crate) mod triangle;
pub(crate) mod vector;
pub(crate) mod volume_jet;
