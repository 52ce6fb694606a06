//! Laws of motions: frames on both sides, reversal of time, derivatives against differences, exact forms against evaluation,
//! certificates and refusals.

#![allow(clippy::unwrap_used, clippy::panic, reason = "what cannot be made fails the test")]

mod along;
mod cubics;
mod data;
mod decoupled;
mod frames;
mod jets;
mod off_chords;
mod planar;
mod refusals;
mod rounded;
mod stands;
mod swept;
mod timing;
mod told;
mod trajectories;
