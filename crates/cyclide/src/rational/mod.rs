//! Exact rational Bézier and B-spline forms.

mod bezier_curve;
mod bezier_surface;
mod bezier_volume;
mod nurbs_curve;
mod nurbs_edit;
mod nurbs_mobius;
mod nurbs_weights;
mod polynomial;
mod quaternion_polynomial;
mod smooth_knots;
mod surface_bounds;

pub use bezier_curve::RationalBezier;
pub(crate) use bezier_curve::jet_of_homogeneous;
pub(crate) use bezier_surface::FirstJets;
pub use bezier_surface::RationalBezierSurface;
pub use bezier_volume::RationalBezierVolume;
pub use nurbs_curve::NurbsCurve;
pub(crate) use polynomial::{Polynomial, PolynomialRow};
pub(crate) use quaternion_polynomial::QuatPolynomial;
pub(crate) use surface_bounds::SecondDerivatives;
