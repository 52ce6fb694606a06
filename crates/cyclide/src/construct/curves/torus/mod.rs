//! Curves on a torus: biarcs of linear complex functions, quartic biarcs of one type and of two, splines through points, knots.

mod arcs;
mod closed_quartic;
mod detour;
mod knot;
mod local_data;
mod projective_biarc;
mod quartic_biarc;
mod spline;
mod spline_data;
mod spline_options;
mod spline_span;
mod two_type;
mod two_type_loop;
mod unroll;

pub use projective_biarc::ProjectiveBiarc;
pub use spline_options::{TorusSplineOptions, TorusTangent, TorusWinding};
pub use two_type::TwoTypeBiarc;
pub use unroll::{TorusMap, UnrollOptions, UnrolledSpline};
