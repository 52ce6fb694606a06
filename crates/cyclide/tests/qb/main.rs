//! Laws of QB curves, of curves through points and of Möbius splines (`docs/math/qb-curves.md`, `docs/math/qb-interpolation.md`).

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod any_input;
mod curves;
mod data;
mod degenerate;
mod interpolation;
mod kept_shapes;
mod splines;
