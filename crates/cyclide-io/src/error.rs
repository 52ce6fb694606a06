//! The error type of reading models; it wraps the kernel's.

use std::path::{Path, PathBuf};

use crate::place::Diagnostic;

/// Result of a fallible call of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a model was not read or built.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text of an input file was refused, at a place in it.
    #[error("{0}")]
    Input(#[from] Box<Diagnostic>),
    /// A file could not be read.
    #[error("{}", unread(path, source, place.as_deref()))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
        /// The message at the place of the document that names the file; `None` if it was not made from a text.
        place: Option<Box<Diagnostic>>,
    },
    /// The kernel refused an object that was not made from a text.
    #[error("{object}: {source} [{}]", source.reason())]
    Geometry {
        /// Name of the object.
        object: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
}

fn unread(path: &Path, source: &std::io::Error, place: Option<&Diagnostic>) -> String {
    place.map_or_else(|| format!("cannot read {}: {source}", path.display()), ToString::to_string)
}
