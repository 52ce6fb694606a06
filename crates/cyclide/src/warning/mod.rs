//! What a construction did that its user should know: named, with the place, the measure and the limit.
//!
//! There is one door to them: `warnings()` of that which was made (a fit, a spline, a mesh, a polyhedron), or of that which makes
//! it where the result is a plain [`Body`](crate::Body) that could not keep them (a neck, a bridge, a turn). [`Warning::reason`] gives the stable
//! kebab-case name that reports and the documentation use. Every warning is an entry of the table of its subject (`subjects`).

mod inverted_cause;
mod spike_remedy;
mod subjects;
mod swing_part;
mod waver_remedy;

pub use inverted_cause::InvertedCause;
pub use spike_remedy::SpikeRemedy;
pub use subjects::*;
pub use swing_part::SwingPart;
pub use waver_remedy::WaverRemedy;
