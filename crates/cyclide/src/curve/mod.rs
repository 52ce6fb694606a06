//! Curves: the trait, arcs, circles, chains of arcs, QB curves.
//!
//! | topic | names |
//! |---|---|
//! | circles and arcs | [`Circle`], [`Arc`], [`Arc4`], [`ArcPath`], [`DEFAULT_PIECE_ANGLE`] |
//! | spheres, planes, circles and lines: where they meet, angles, nearest points | [`SphereOrPlane`], [`CircleOrLine`], [`SurfaceMeeting`], [`CurveMeeting`], [`CircleAngle`], [`NearestPoint`] |
//! | curves through points | [`CircleSpline::fair`], [`CircleSpline::from_points`], [`CircleSplineOptions`], [`SplineEnds`], [`ArcPath::spline`], [`ArcPath::rounded_polyline`], [`QbSpline::through_points`], [`BlendSegment`], [`BlendVariant`], [`BlendLaw`], [`corners_by_angle`] |
//! | quotients of quaternion polynomials | [`QbCurve`], [`QbReach`], [`QbSpline`] |
//! | evaluation | [`ParamCurve::point`], [`ParamCurve::jet`], [`PieceForm`], [`PieceHull`] |
//! | measures of curves | [`length()`], [`resample`], [`ArcLength`], [`closest_point`], [`ClosestPoint`], [`CurveIndex`], [`farthest_point`], [`FarthestPoint`], [`bounds()`] |
//! | frames along curves | [`CurveFrames`], [`FrameRule`], [`ClosedTwist`], [`CurveFrame`] |
//! | continuity and fairness | [`joints`], [`Joint`], [`extreme_curvature`], [`ExtremeCurvature`], [`bending_energy`], [`tight_places`], [`TightPlace`], [`cusps`], [`CurveCusp`], [`plane_normal`], [`curvature_comb`], [`fairness()`], [`Fairness`], [`wavering()`], [`wavering_against()`], [`Wavering`], [`RoundedTurns`], [`CORNER_ANGLE`] |
//! | places and pieces | [`Correspondence`], [`CurvePlace`], [`Span`] |

mod arc;
mod arc4;
mod arc_path;
mod blend;
mod circle;
mod circle_spline;
mod correspondence;
mod frames;
mod measure;
mod node_tangent;
mod nurbs;
mod param_curve;
mod piece_form;
mod piece_hull;
mod qb;
mod round;
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
pub use frames::{ClosedTwist, CurveFrame, CurveFrames, FrameRule};
pub use measure::{ArcLength, CurveIndex, ExtremeCurvature, Joint};
pub use measure::{CORNER_ANGLE, Fairness, RoundedTurns, Wavering, fairness, plane_normal, wavering, wavering_against};
pub use measure::{CurveCusp, FarthestPoint, TightPlace, bending_energy, cusps, farthest_point, tight_places};
pub use measure::{bounds, closest_point, curvature_comb, extreme_curvature, joints, length, resample};
pub(crate) use node_tangent::Chord;
pub use param_curve::ParamCurve;
pub use piece_form::PieceForm;
pub use piece_hull::PieceHull;
pub(crate) use qb::SpanData;
pub use qb::{QbCurve, QbReach, QbSpline};
pub use round::{CircleAngle, CircleOrLine, CurveMeeting, NearestPoint, SphereOrPlane, SurfaceMeeting};
