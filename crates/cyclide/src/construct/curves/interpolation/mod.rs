//! QB curves through points, and through points with tangents or higher derivatives: of all curves that are ratios of two
//! quaternion polynomials of a degree, the one that meets as many conditions as it has coefficients
//! (`docs/math/qb-interpolation.md`; source: `003`, with what its theorem leaves out).
//!
//! The curve is covariant under Möbius maps: that through the images of points, at their parameters, is the image of that
//! through the points. Points on a circle, a sphere or a plane give a curve on it.

mod elimination;
mod finish;
mod frame;
mod hermite;
mod loewner;
mod overdetermined;
mod parameters;
mod three_points;
mod turning_back;

pub use finish::QbInterpolation;
pub use hermite::QbNode;
pub use parameters::NodeParameters;
pub(super) use parameters::node_steps;
