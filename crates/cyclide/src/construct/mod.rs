//! Recipes of several steps: biarcs, arc splines, arc fits, fair splines, circular grids.

mod arc_approximation;
mod arc_fit;
mod arc_spline;
mod bands;
mod biarc;
#[cfg(feature = "circular-mesh")]
mod circular_mesh;
mod circular_surface;
mod ellipse_bridge;
mod ellipse_ring;
mod fair_fit;
mod fair_spline;
mod neck;
mod pipe;
mod polyhedron;
mod rails;
mod rational_runs;
mod revolution;
mod rounded_polyline;
mod ruled;
mod rulings;
mod turned_patch;

pub use arc_fit::{
    ArcCertificate, ArcFit, ArcFitOptions, BulgeIntervals, Effort, FitCertificate, FitTarget, certify_arc,
    curvature_intervals, feasible_bulges,
};
pub use arc_spline::{ArcSplineOptions, estimate_tangents};
pub use biarc::{Biarc, BiarcRule};
#[cfg(feature = "circular-mesh")]
pub use circular_mesh::{
    Border, CircularMesh, CircularMeshOptions, CircularMeshReport, CircularMeshStep, LineAngles, VertexMoves,
    make_circular,
};
pub use ellipse_bridge::EllipseBridge;
pub use fair_fit::{FairFit, FairFitCertificate, FairFitOptions};
pub use fair_spline::{FairEnd, FairSplineOptions, blends_by_turn};
pub use neck::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
pub use pipe::{Pipe, PipeEnds};
pub use polyhedron::{ConvexPolyhedron, PolyhedronEdge, SphericalPolygon};
pub use rational_runs::RationalRun;
pub use revolution::Revolution;
