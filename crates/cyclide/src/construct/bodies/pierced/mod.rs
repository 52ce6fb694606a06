//! Pipes with holes in them: the faces round a hole whose border is a rational curve, or within it, the rings at the ends, and what closes them. All of it
//! is exact, of four-sided faces that share edges (`docs/math/pipe-tees.md#faces`).

mod cap;
mod ends;
mod lines;
mod mantle;
mod rail;
mod rows;
mod skin;

pub(super) use lines::{Hole, HolePiece, Node};
pub(super) use mantle::Mantle;
pub(super) use rail::Pairing;
pub(super) use rows::HoleRow;
pub(super) use skin::{Ring, Skin};
