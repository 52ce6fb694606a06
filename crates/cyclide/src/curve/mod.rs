//! Curves: the trait, arcs, circles, chains of arcs.

mod arc;
mod arc4;
mod arc_path;
mod circle;
mod measure;
mod nurbs;
mod param_curve;
mod piece_form;

pub use arc::Arc;
pub use arc::measure::ClosestPoint;
pub use arc::subdivide::DEFAULT_PIECE_ANGLE;
pub use arc_path::ArcPath;
pub use arc4::Arc4;
pub use circle::Circle;
pub use measure::{ExtremeCurvature, Joint, bounds, curvature_comb, extreme_curvature, joints, length};
pub use param_curve::ParamCurve;
pub use piece_form::PieceForm;
