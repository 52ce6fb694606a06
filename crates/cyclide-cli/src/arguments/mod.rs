//! Arguments in two stages: what was typed ([`args`]), and the plan that it means ([`plan`]). What belongs to another command is
//! answered with it ([`mistaken`]), and what has no effect is said ([`effect`]).

pub mod args;
pub mod compare;
mod curve;
pub mod effect;
pub mod files;
pub mod make;
pub mod mistaken;
mod numbers;
pub mod plan;
pub mod sample;
pub mod schedule;
pub mod starters;
mod table;
mod words;
