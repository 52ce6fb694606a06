//! `cargo xtask roof`: writes the free-form roofs among the examples.

use cyclide_testkit::roof::roof_obj;
use std::process::ExitCode;

pub fn main() -> ExitCode {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples");
    for (name, faces) in [("roof.obj", 40), ("roof-20.obj", 20)] {
        let path = format!("{examples}/{name}");
        if let Err(error) = std::fs::write(&path, roof_obj(faces)) {
            eprintln!("{path}: {error}");
            return ExitCode::FAILURE;
        }
        println!("examples/{name}: {faces} x {faces} quads");
    }
    ExitCode::SUCCESS
}
