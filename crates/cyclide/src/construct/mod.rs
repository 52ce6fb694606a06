//! Recipes of several steps that make curves: biarcs, arc splines.

mod arc_spline;
mod biarc;

pub use arc_spline::{ArcSplineOptions, estimate_tangents};
pub use biarc::{Biarc, BiarcRule};
