//! Laws of principal patches of Dupin cyclides (`docs/math/patches.md`) on random patches, near-degenerate and badly
//! scaled ones among them.
//!
//! Bounds are in units of the last place, times what magnifies rounding (see `PatchCase::rounding`); the factors are some
//! tens of operations, each rounded once.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod derived;
mod evaluation;
mod far;
mod recognition;
mod refusals;
mod rows;

use cyclide::{Point3, Quat};

/// Parameter pairs: corners, sides, inside.
const PLACES: [(f64, f64); 9] =
    [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5), (0.25, 0.75), (0.9, 0.1), (0.0, 0.4), (0.3, 1.0)];

/// How far four points are from one circle: the imaginary part of their cross-ratio as a quaternion, over its length.
fn cross_ratio_defect([a, b, c, d]: [Point3; 4]) -> Option<f64> {
    let q = |p: Point3, r: Point3| Quat::from(p - r);
    let ratio = q(a, b) * q(b, c).inverse()? * q(c, d) * q(d, a).inverse()?;
    Some(ratio.vector().length() / ratio.norm())
}
