//! Laws of principal patches of Dupin cyclides that hold for every admissible input (`20`, section 7).

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod recognition;
