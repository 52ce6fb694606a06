//! Warnings about valid results, each with the location, the measured value and the limit.
//! They come from one method: `warnings()` of the result (a fit, a spline, a mesh, a polyhedron), or of its construction where the
//! result is a plain [`Body`](crate::topology::Body) that cannot store them (a neck, a bridge, a revolution). [`Warning::reason`] gives the stable
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
