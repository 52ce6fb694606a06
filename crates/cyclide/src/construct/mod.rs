//! Recipes of several steps that make curves: biarcs, arc splines, arc fits.

mod arc_approximation;
mod arc_fit;
mod arc_spline;
mod biarc;
mod rational_runs;

pub use arc_fit::{
    ArcCertificate, ArcFit, ArcFitOptions, BulgeIntervals, Effort, FitCertificate, FitTarget, certify_arc,
    curvature_intervals, feasible_bulges,
};
pub use arc_spline::{ArcSplineOptions, estimate_tangents};
pub use biarc::{Biarc, BiarcRule};
pub use rational_runs::RationalRun;
