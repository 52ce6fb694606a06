//! Laws of circle splines (`docs/math/circle-blends.md`): what holds for every list of points, with near-degenerate and
//! badly scaled ones among them.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod arcs;
mod data;
mod degenerate;
mod invariance;
mod rational;
mod shape;
