//! Laws of surfaces as a whole: boxes, areas and volumes, meshes.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod bounds;
mod checks;
mod closed;
mod data;
mod developable;
mod mesh;
