//! Test helpers of cyclide (unpublished): generators of random input and patches, the roof of the examples, the runner
//! of reference files.

pub mod generators;
pub mod patches;
pub mod reference;
pub mod roof;
