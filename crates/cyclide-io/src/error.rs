//! The error type of reading and writing; it wraps the kernel's.

use std::path::PathBuf;

use crate::place::Diagnostic;

/// Result of a fallible call of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a file was not read, built or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text of an input file was refused, at a place in it.
    #[error("{0}")]
    Input(#[from] Box<Diagnostic>),
    /// A file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file could not be written; what stood there before is untouched.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The suffix of an output file names no format.
    #[error("{}: no format has this suffix; use one of {known}", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
        /// The suffixes known, separated by commas.
        known: String,
    },
    /// An object could not be turned into what a format carries.
    #[error("{object}: {source}")]
    Geometry {
        /// Name of the object.
        object: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// The bytes of a file do not hold what its format promises; `detail` says where.
    #[error("{format}: {detail}")]
    Malformed {
        /// Name of the format.
        format: &'static str,
        /// What is wrong, with the place.
        detail: String,
    },
}
