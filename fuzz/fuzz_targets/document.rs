//! Any bytes as a model document.
#![no_main]

#[path = "../exercise.rs"]
mod exercise;
#[path = "../mutation.rs"]
mod mutation;

use cyclide_testkit::mutate::Form;

libfuzzer_sys::fuzz_target!(|data: &[u8]| exercise::document(data));

libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    mutation::mutate(data, size, max_size, seed, Form::Lists)
});
