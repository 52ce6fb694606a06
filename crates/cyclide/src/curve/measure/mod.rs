//! What can be measured on every curve, written once on [`ParamCurve`](crate::curve::ParamCurve).
//!
//! Pieces that are arcs or circles ([`PieceForm`](crate::curve::PieceForm)) are measured in closed form, all others by
//! their jets to the tolerance each function states.

mod bounds;
mod closest;
mod comb;
mod continuity;
mod curvature;
mod cusps;
mod energy;
mod fairness;
mod farthest;
mod length;
mod maximum;
mod rest;
mod tight;

pub use bounds::bounds;
pub use closest::{CurveIndex, closest_point};
pub use comb::curvature_comb;
pub use continuity::{Joint, joints};
pub use curvature::{ExtremeCurvature, extreme_curvature};
pub use cusps::{CurveCusp, cusps};
pub use energy::bending_energy;
pub use fairness::{
    CORNER_ANGLE, Fairness, RoundedTurns, Wavering, fairness, plane_normal, wavering, wavering_against,
};
pub use farthest::{FarthestPoint, farthest_point};
pub use length::{ArcLength, length, resample};
pub use tight::{TightPlace, tight_places};
