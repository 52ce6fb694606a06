//! A C1 spline through points, local and covariant under Möbius maps: quadratic QB spans between derivatives of circles
//! (`docs/math/qb-curves.md#splines-of-invariant-spans`; own construction beside `003`).
//!
//! At each point the curve has the derivative of the circle through it and its neighbors, run through at their knots; between two points
//! it is the [invariant span](QbCurve::invariant_span). Points on a circle, a line or a sphere give a curve on it, however they
//! are spaced. Its shape without knots, G1 and by the directions of the tangents alone, is the circle spline of order 1
//! ([`CircleSpline::from_points`](crate::curve::CircleSpline::from_points)).

mod invariant_span;
mod nodes;
mod spline;

pub use nodes::circle_tangents;
pub use spline::MoebiusSplineOptions;
