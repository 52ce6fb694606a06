//! Smooth surfaces over triangle meshes: laws of `50`, sections 8 and 9.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod comparison;
mod creases;
mod hostile;
mod laws;
mod shapes;
mod tessellation;
