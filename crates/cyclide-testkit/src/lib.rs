//! Test helpers of cyclide (unpublished): generators of random input and patches, files broken on purpose, a set of closed
//! curves, the roof of the examples, the runner of reference files.

pub mod circuits;
pub mod generators;
pub mod mutate;
pub mod patches;
pub mod reference;
pub mod roof;
