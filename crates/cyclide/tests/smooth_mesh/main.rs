//! Smooth surfaces over triangle meshes: laws of `docs/math/triangle-surfaces.md`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod comparison;
mod creases;
mod hostile;
mod laws;
mod shapes;
mod tessellation;
mod warned;
