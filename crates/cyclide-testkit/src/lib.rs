//! Test helpers of cyclide (unpublished): the runner of reference files.

pub mod reference;
