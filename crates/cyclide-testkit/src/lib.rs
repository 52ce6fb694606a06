//! Test helpers of cyclide (unpublished): generators of random input, the runner of reference files.

pub mod generators;
pub mod reference;
