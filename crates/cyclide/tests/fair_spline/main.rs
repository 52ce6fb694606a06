//! Fair circle splines: continuous curvature for all data, the shapes they reproduce, and what they do at the edges.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod data;
mod degenerate;
mod fairness;
mod laws;
mod reproduced;
mod straight_runs;
