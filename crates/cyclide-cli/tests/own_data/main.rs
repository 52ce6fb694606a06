//! Data as people bring it, one module for each trade: samples of each kind (`cases`), and many random members of it.
//!
//! The right values come from the data, never from the program.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../common/mod.rs"]
mod common;

mod fairness;
mod files;
mod invariance;
mod invariance_of_commands;
mod maps;
mod meshes;
mod moves;
mod outlines;
mod smoothing;
mod solids;
mod step_faces;
mod tables;

/// A sample that somebody brought, as `Folder` writes it.
#[allow(dead_code, reason = "until each module has its cases")]
fn case(name: &str) -> String {
    let path = common::project("crates/cyclide-cli/tests/own_data/cases").join(name);
    std::fs::read_to_string(path).expect("a case is read")
}
