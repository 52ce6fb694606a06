//! Any bytes as a PLY file of ours.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::written(cyclide_io::Format::Ply, data));
