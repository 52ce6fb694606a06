//! Exact rational Bézier and B-spline forms.

mod bezier_curve;
mod bezier_surface;
mod exact;
mod nurbs_curve;
mod nurbs_edit;
mod polynomial;
mod smooth_knots;
mod surface_bounds;

pub use bezier_curve::RationalBezier;
pub use bezier_surface::RationalBezierSurface;
pub use exact::ExactRational;
pub use nurbs_curve::NurbsCurve;
pub(crate) use polynomial::{Polynomial, PolynomialRow};
pub(crate) use surface_bounds::SecondDerivatives;
