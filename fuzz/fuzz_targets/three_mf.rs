//! Any bytes as a 3MF file of ours.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::written(cyclide_io::Format::ThreeMf, data));
