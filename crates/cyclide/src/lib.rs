//! `cyclide`: a geometric-modelling kernel whose primitive is the circle.
//!
//! Curves are made of circles and are exact: an [`Arc`] is two points and one quaternion, a circle spline in its
//! rational variant is a rational Bézier curve, and both leave the kernel as [`NurbsCurve`] without any tolerance.
//!
//! Everything is `f64`, lengths are unitless, angles are radians, parameters run over `[0, 1]`. The kernel has no
//! I/O, no clock and no global tolerance; bad input gets an [`Error`] with the item, the measure and the limit.

mod base;
mod conformal;
mod construct;
mod curve;
mod error;
mod mesh;
mod model;
mod rational;
mod warning;

pub use base::bounds::Aabb;
pub use base::frame::Frame;
pub use base::jet::CurveJet;
pub use base::planar::{Point2, Vec2};
pub use base::quat::Quat;
pub use base::vector::{Point3, Vec3};
pub use conformal::hpoint::HPoint;
pub use conformal::mobius::{Conformal, Mobius};
pub use conformal::sphere::Sphere;
pub use construct::RationalRun;
pub use construct::{
    ArcCertificate, ArcFit, ArcFitOptions, ArcSplineOptions, Biarc, BiarcRule, BulgeIntervals, Effort, FitCertificate,
    FitTarget, certify_arc, curvature_intervals, estimate_tangents, feasible_bulges,
};
pub use curve::{Arc, Arc4, ArcPath, Circle, ClosestPoint, DEFAULT_PIECE_ANGLE, ParamCurve, PieceForm};
pub use curve::{ArcLength, CurveIndex, ExtremeCurvature, Joint};
pub use curve::{BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, SplineEnds, corners_by_angle};
pub use curve::{bounds, closest_point, curvature_comb, extreme_curvature, joints, length, resample};
pub use error::{Error, Result};
pub use mesh::{flatten, flatten_into};
pub use model::{ChainPiece, CurveChain, CurveObject, Exactness, Item, Lower, Model, Units};
pub use rational::{ExactRational, NurbsCurve, RationalBezier};
pub use warning::Warning;
