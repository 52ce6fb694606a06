//! Blends of two circles: the segment of a circle spline.
//!
//! ```text
//! x(l) = x1 + |d| l N/|N|²,   N = l u + (1-l) t(l),   d = x2 - x1 = |d| u
//! ```
//! For a fixed unit vector `t` this is the circular arc from `x1` to `x2` with start tangent `t`. A blend lets `t`
//! run along a great circle from the start tangent of one arc to that of the other; at both ends it touches them to
//! the blend order (`docs/math/circle-blends.md#segment`; source: `004`, (40) to (58)). Fair segments, whose angle
//! moves at the ends, bend there by what the other arc asks for too
//! (`docs/math/fair-splines.md#law-and-end-curvature`). No geometric algebra is needed at run time.

mod angle_law;
mod ends;
mod evaluate;
mod rational_approximation;
mod rational_form;
mod segment;
mod variation;

pub use angle_law::{BlendLaw, BlendVariant};
pub use segment::BlendSegment;
pub(super) use segment::check_order;
pub(crate) use segment::{BlendTangents, check_points, unit_tangent};
pub(crate) use variation::BlendVariation;
