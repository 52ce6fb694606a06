//! Certified arc fitting: the fewest arcs and lines within a tolerance of given points (`60`, sections 1, 3, 4).

mod arc_certificate;
mod bulge_interval;
mod chord;
mod curvature_interval;
mod input;

pub use arc_certificate::{ArcCertificate, certify_arc};
pub use bulge_interval::{BulgeIntervals, feasible_bulges};
pub use curvature_interval::curvature_intervals;
