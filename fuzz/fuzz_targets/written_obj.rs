//! Any bytes as an OBJ file of ours.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::written(cyclide_io::Format::Obj, data));
