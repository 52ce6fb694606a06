//! `cargo xtask scan`: writes the scanned stone among the examples, coarse and fine.

use cyclide_testkit::scan::scan_ply;
use std::process::ExitCode;

/// The files with their vertices: meshes of 500 and of 5,000 triangles.
const SCANS: [(&str, usize); 2] = [("stone.ply", 252), ("stone-5000.ply", 2502)];

pub fn main() -> ExitCode {
    for (name, vertices) in SCANS {
        let path = format!("{}/../examples/{name}", env!("CARGO_MANIFEST_DIR"));
        if let Err(error) = std::fs::write(&path, scan_ply(vertices)) {
            eprintln!("{path}: {error}");
            return ExitCode::FAILURE;
        }
        println!("examples/{name}: {} triangles", 2 * vertices - 4);
    }
    ExitCode::SUCCESS
}
