//! Recipes of several steps: curves through and near points, bodies.

mod bodies;
mod curves;

pub use bodies::{
    Ball, ConvexPolyhedron, CrossingPipe, CrossingSide, EllipseBridge, MadeCrossing, MadeTee, NeckBlend, NeckBody,
    NeckSide, NeckVariant, Pipe, PipeCrossing, PipeEnds, PipeTee, PlateShape, PolyhedronEdge, RadiusLaw, RailSurface,
    Revolution, SphericalPolygon, Sweep, SweepFrame, SweepOptions, SweptSurface, TaperedTube, TeeBlend, TeeBlendFacts,
    TeeBranch, TeeEnds, TeeMain, TorusSeam, Tube,
};
pub use bodies::{BallCenters, BlendBase, BlendRing, BlendTube, ContactBlend, MadeContactBlend, RingBlend};
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
