//! Points as quaternion pairs, Möbius maps, spheres through points and oriented ones.

pub(crate) mod hpoint;
pub(crate) mod lie_sphere;
pub(crate) mod mapped_pairs;
pub(crate) mod mobius;
mod plane_and_line;
pub(crate) mod sphere;
mod three_points;

pub use hpoint::HPoint;
pub use mobius::{Conformal, Mobius};
pub use plane_and_line::{Line, Plane};
pub use sphere::Sphere;
