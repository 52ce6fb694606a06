//! Loops over many parameters at once, structure of arrays, in the instructions that the machine has.
//!
//! The loops are plain; `multiversion` compiles each for AVX-512, AVX2 and the baseline and picks one at run time. Only
//! additions, multiplications and divisions in a fixed order, never a fused one: results are the same on every machine.

mod rows;

pub(crate) use rows::{points, points_and_directions, points_and_products};
