//! Any bytes as a PLY mesh of any program.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::mesh(cyclide_io::formats::MeshFormat::Ply, data));
