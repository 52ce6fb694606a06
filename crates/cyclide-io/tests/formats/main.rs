//! Every format: written, read back, compared, damaged.

#![allow(clippy::unwrap_used, reason = "what cannot be made or read fails the test")]
#![allow(clippy::float_cmp, reason = "numbers of a file are the same doubles")]

mod analysis;
#[cfg(feature = "png")]
mod coloured_pictures;
mod content_damage;
mod damage;
mod drawings;
mod dxf;
mod exact_surfaces;
mod hard_curves;
mod label_damage;
mod malformed;
mod mesh_damage;
mod meshes;
mod models;
mod part_limits;
#[cfg(feature = "png")]
mod pictures;
mod printing;
mod rational_faces;
mod right_files;
mod round_trip;
#[cfg(feature = "png")]
mod sheets;
mod step;
mod step_bodies;
