//! Recipes of several steps: curves through and near points, bodies.
//!
//! | topic | names |
//! |---|---|
//! | circles and arcs | [`Ellipse`], [`Helix`], [`Biarc`], [`BiarcRule`] |
//! | curves through points | [`FairSplineOptions`], [`FairEnd`], [`blends_by_turn`], [`ArcSplineOptions`], [`estimate_tangents`], [`MoebiusSplineOptions`], [`circle_tangents`], [`QbInterpolation`], [`NodeParameters`], [`QbNode`] |
//! | corners among points | [`outline_corners`] |
//! | curves near points | [`ArcFit`], [`ArcFitOptions`], [`FitTarget`], [`Effort`], [`FitCertificate`], [`FairFit`], [`FairFitOptions`], [`Noise`], [`Outliers`], [`Heights`], [`FairFitCertificate`], [`certify_arc`], [`ArcCertificate`], [`feasible_bulges`], [`BulgeIntervals`], [`curvature_intervals`] |
//! | exact rational forms | [`RationalRun`] |
//! | tori and curves on them | [`TorusSplineOptions`], [`TorusTangent`], [`TorusWinding`], [`TorusMap`], [`UnrollOptions`], [`UnrolledSpline`], [`TorusSeam`], [`ProjectiveBiarc`], [`TwoTypeBiarc`] |
//! | bodies made from curves | [`Revolution`], [`Pipe`], [`PipeEnds`], [`Sweep`], [`SweepOptions`], [`SweepFrame`], [`TaperedTube`], [`RadiusLaw`], [`Tube`], [`Ball`], [`NeckBlend`], [`NeckBody`], [`NeckSide`], [`NeckVariant`], [`PlateShape`], [`PipeTee`], [`TeeMain`], [`TeeBranch`], [`TeeBlend`], [`TeeEnds`], [`MadeTee`], [`TeeBlendFacts`], [`PipeCrossing`], [`CrossingPipe`], [`CrossingSide`], [`MadeCrossing`], [`ContactBlend`], [`BlendTube`], [`BlendBase`], [`MadeContactBlend`], [`RingBlend`], [`BlendRing`], [`BallCenters`], [`EllipseBridge`], [`RailSurface`] |
//! | motions | [`SweptSurface`] |
//! | bodies made from solids | [`ConvexPolyhedron`], [`PolyhedronEdge`], [`SphericalPolygon`] |

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
