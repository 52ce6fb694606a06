//! Readers and writers of cyclide: model documents and point lists in, exchange files and reports out.
//!
//! Everything works on text and bytes; the only functions that touch the file system are the few that say so.

mod error;
mod place;

pub use error::{Error, Result};
pub use place::{Diagnostic, Source, decode};
