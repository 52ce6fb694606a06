//! What a run leaves: results and messages, files, and the exit code.

pub mod failure;
pub mod files;
pub mod progress;
pub mod signals;
pub mod standard;
pub mod terminal;
