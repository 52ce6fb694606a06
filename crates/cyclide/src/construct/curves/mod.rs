//! Curves through and near points: biarcs and arc splines, fair splines, fits, rounded polylines, and arcs in place of curves.

mod arc_approximation;
mod arc_fit;
mod arc_spline;
mod biarc;
mod biarc_cover;
mod canonical_start;
mod ellipse;
mod fair_fit;
mod fair_spline;
mod helix;
mod interpolation;
mod moebius_spline;
mod nurbs_arcs;
mod off_neighbors;
mod outline;
mod plane_axes;
mod qb_arcs;
mod rational_runs;
mod rounded_polyline;
mod torus;

pub use arc_fit::{
    ArcCertificate, ArcFit, ArcFitOptions, BulgeIntervals, Effort, FitCertificate, FitTarget, certify_arc,
    curvature_intervals, feasible_bulges,
};
pub use arc_spline::{ArcSplineOptions, estimate_tangents};
pub use biarc::{Biarc, BiarcRule};
pub use ellipse::Ellipse;
pub use fair_fit::{FairFit, FairFitCertificate, FairFitOptions, Heights, Noise, Outliers};
pub use fair_spline::{FairEnd, FairSplineOptions, blends_by_turn};
pub use helix::Helix;
pub use interpolation::{NodeParameters, QbInterpolation, QbNode};
pub use moebius_spline::{MoebiusSplineOptions, circle_tangents};
pub use outline::outline_corners;
pub use rational_runs::RationalRun;
pub use torus::{
    ProjectiveBiarc, TorusMap, TorusSplineOptions, TorusTangent, TorusWinding, TwoTypeBiarc, UnrollOptions,
    UnrolledSpline,
};
