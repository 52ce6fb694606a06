//! How copies are made: half of them as libFuzzer does, half with tokens and items exchanged for others of their kind.

use cyclide_testkit::mutate::{Form, Mutator};

/// Changes the first `size` bytes; gives the new size, which is at most `max_size`.
pub fn mutate(data: &mut [u8], size: usize, max_size: usize, seed: u32, form: Form) -> usize {
    if seed.is_multiple_of(2) {
        return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
    }
    let copy = Mutator::new(u64::from(seed), &[]).copy(&data[..size], form);
    let length = copy.len().min(max_size);
    data[..length].copy_from_slice(&copy[..length]);
    length
}
