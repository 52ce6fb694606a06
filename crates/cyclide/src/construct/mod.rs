//! Recipes of several steps: curves through and near points, bodies, grids along lines of curvature, quad grids made
//! circular.

mod bodies;
#[cfg(feature = "circular-mesh")]
mod circular_mesh;
mod curves;
#[cfg(feature = "circular-mesh")]
mod principal;
mod principal_rules;
#[cfg(feature = "circular-mesh")]
mod sparse_solver;

pub use bodies::{
    Ball, ConvexPolyhedron, CrossingPipe, CrossingSide, EllipseBridge, MadeCrossing, MadeTee, NeckBlend, NeckBody,
    NeckSide, NeckVariant, Pipe, PipeCrossing, PipeEnds, PipeTee, PlateShape, PolyhedronEdge, RadiusLaw, RailSurface,
    Revolution, SphericalPolygon, Sweep, SweepFrame, SweepOptions, SweptSurface, TaperedTube, TeeBlend, TeeBlendFacts,
    TeeBranch, TeeEnds, TeeMain, TorusSeam, Tube,
};
pub use bodies::{BallCenters, BlendBase, BlendRing, BlendTube, ContactBlend, MadeContactBlend, RingBlend};
#[cfg(feature = "circular-mesh")]
pub use circular_mesh::{
    Border, CircularLayout, CircularMesh, CircularMeshOptions, CircularMeshReport, CircularMeshStep, ClosingChange,
    LineAngles, RoundChange, VertexMoves, make_circular, make_layout_circular,
};
pub use curves::{
    ArcCertificate, ArcFit, ArcFitOptions, ArcSplineOptions, Biarc, BiarcRule, BulgeIntervals, Effort, FairEnd,
    FairFit, FairFitCertificate, FairFitOptions, FairSplineOptions, FitCertificate, FitTarget, Heights, Noise,
    Outliers, RationalRun, blends_by_turn, certify_arc, curvature_intervals, estimate_tangents, feasible_bulges,
};
pub use curves::{Ellipse, Helix, outline_corners};
pub use curves::{MoebiusSplineOptions, NodeParameters, QbInterpolation, QbNode, circle_tangents};
pub use curves::{
    ProjectiveBiarc, TorusMap, TorusSplineOptions, TorusTangent, TorusWinding, TwoTypeBiarc, UnrollOptions,
    UnrolledSpline,
};
#[cfg(feature = "circular-mesh")]
pub use principal::{
    FreeLayout, GridPiece, PrincipalField, PrincipalGridOptions, PrincipalGridReport, PrincipalGrids, PrincipalStage,
    Umbilic, covering_principal_grids, principal_grids,
};
pub use principal_rules::{GridBorder, UmbilicRule};
