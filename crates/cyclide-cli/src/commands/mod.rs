//! The commands: what is done once the plan is known to make sense.

pub mod compare;
pub mod gallery;
pub mod help;
pub mod inspect;
mod load;
pub mod make;
pub mod manuals;
mod outline_doubt;
mod per_object;
pub mod sample;
pub mod schedule;
pub mod start;
