//! Curves: the trait, arcs, circles, chains of arcs, QB curves.

mod arc;
mod arc4;
mod arc_path;
mod blend;
mod circle;
mod circle_spline;
mod correspondence;
mod measure;
mod node_tangent;
mod nurbs;
mod param_curve;
mod piece_form;
mod piece_hull;
mod qb;
mod smooth_runs;

pub use arc::Arc;
pub use arc::measure::ClosestPoint;
pub use arc::subdivide::DEFAULT_PIECE_ANGLE;
pub use arc_path::ArcPath;
pub use arc4::Arc4;
pub use blend::{BlendLaw, BlendSegment, BlendVariant};
pub(crate) use blend::{BlendTangents, BlendVariation, unit_tangent};
pub use circle::Circle;
pub use circle_spline::{CircleSpline, CircleSplineOptions, SplineEnds, corners_by_angle};
pub(crate) use circle_spline::{SHARP_TURN, chords_between, corner_nodes, inspect_node, rounded_directions};
pub use correspondence::{Correspondence, CurvePlace, Span};
pub use measure::{ArcLength, CurveIndex, ExtremeCurvature, Joint};
pub use measure::{CORNER_ANGLE, Fairness, RoundedTurns, Wavering, fairness, wavering};
pub use measure::{bounds, closest_point, curvature_comb, extreme_curvature, joints, length, resample};
pub(crate) use node_tangent::Chord;
pub use param_curve::ParamCurve;
pub use piece_form::PieceForm;
pub use piece_hull::PieceHull;
pub(crate) use qb::SpanData;
pub use qb::{QbCurve, QbReach, QbSpline};
