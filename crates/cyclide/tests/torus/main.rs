//! Tori, their circles, and curves on them: defining properties, symmetries, random awkward problems, refusals.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod biarcs;
mod circles;
mod data;
mod knots;
mod moved;
mod places;
mod problems;
mod refusals;
mod seams;
mod splines;
mod unrolled;
