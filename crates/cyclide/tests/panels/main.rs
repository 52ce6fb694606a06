//! What a workshop must know of panels: measures, nearest simple surfaces, moulds, congruence, flat patterns
//! (`docs/math/panels.md`).
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod congruence;
mod flat;
mod measures;
mod moulds;
mod nearest;
mod shapes;
