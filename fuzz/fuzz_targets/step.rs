//! Any bytes as a STEP file of ours.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;
#[path = "../mutation.rs"]
mod mutation;

use cyclide_testkit::mutate::Form;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::written(cyclide_io::Format::Step, data));

libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    mutation::mutate(data, size, max_size, seed, Form::Lists)
});
