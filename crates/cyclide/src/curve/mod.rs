//! Curves: the trait, arcs, circles, chains of arcs.

mod arc;
mod arc_path;
mod circle;
mod nurbs;
mod param_curve;

pub use arc::Arc;
pub use arc::measure::ClosestPoint;
pub use arc::subdivide::DEFAULT_PIECE_ANGLE;
pub use arc_path::ArcPath;
pub use circle::Circle;
pub use param_curve::ParamCurve;
