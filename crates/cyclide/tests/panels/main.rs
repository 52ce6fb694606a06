//! What a workshop must know of panels: measures, nearest simple surfaces, moulds, congruence, flat patterns
//! (`docs/math/panels.md`).
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod congruence;
mod flat;
mod measures;
mod moulds;
mod nearest;
mod shapes;
