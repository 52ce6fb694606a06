//! `cargo xtask scan`: writes the scanned stone among the examples.

use cyclide_testkit::scan::scan_ply;
use std::process::ExitCode;

/// Vertices of the mesh of 500 triangles.
const VERTICES: usize = 252;

pub fn main() -> ExitCode {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/stone.ply");
    if let Err(error) = std::fs::write(path, scan_ply(VERTICES)) {
        eprintln!("{path}: {error}");
        return ExitCode::FAILURE;
    }
    println!("examples/stone.ply: {} triangles", 2 * VERTICES - 4);
    ExitCode::SUCCESS
}
