//! Polylines of anything with jets.

mod flatten;

pub use flatten::{flatten, flatten_into};
