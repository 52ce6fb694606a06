//! Points as quaternion pairs, Möbius maps, spheres through points.

pub(crate) mod hpoint;
pub(crate) mod mobius;
pub(crate) mod sphere;
