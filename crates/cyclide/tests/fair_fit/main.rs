//! Fair fits: the figures that must be reached, the laws that hold, and data that nobody wants.
#![allow(clippy::unwrap_used, reason = "a panic is the failure of a test")]

mod data;
mod degenerate;
mod dense_corners;
mod figures;
mod laws;
mod plates;
mod strength;
mod wrong_points;
