//! Laws of whole cyclides, cyclidic nets and their shells (`docs/math/cyclides-and-nets.md`).
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod data;
mod derived;
mod dupin;
mod far;
mod limits;
mod models;
mod nets;
mod shells;
mod thick;
