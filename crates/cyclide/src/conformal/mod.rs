//! Points as quaternion pairs, Möbius maps, spheres through points and oriented ones.

pub(crate) mod hpoint;
pub(crate) mod lie_sphere;
pub(crate) mod mapped_pairs;
pub(crate) mod mobius;
pub(crate) mod sphere;

pub use hpoint::HPoint;
pub use mobius::{Conformal, Mobius};
pub use sphere::Sphere;
