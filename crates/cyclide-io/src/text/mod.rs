//! Text in and out: numbers as the formats write them, places in a text and the messages that show them.

pub(crate) mod csv;
pub(crate) mod encoding;
pub(crate) mod escape;
pub(crate) mod lines;
pub(crate) mod number;
pub(crate) mod place;
pub(crate) mod suggest;
pub(crate) mod xml;

pub use escape::{escaped, escaped_json, escaped_lines};
pub use place::{Diagnostic, Source, decode};
pub use suggest::{did_you_mean, similar};
