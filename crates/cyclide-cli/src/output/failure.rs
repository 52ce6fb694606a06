//! Why a run ended without its result, and the exit code that says so.

use std::fmt::Display;
use std::path::Path;

use cyclide_io::file::NotDurable;

use crate::output::standard::is_standard;

/// The kinds of failure, each with its exit code (documented in the help).
#[derive(Debug)]
pub enum Failure {
    /// The input was read and refused: exit code 1.
    Refused(String),
    /// Invalid usage: exit code 2, as for errors of the argument parser.
    Usage(String),
    /// A file could not be read or written: exit code 3.
    File(String),
    /// A generated file did not pass its check and was not written, a bug in the program: exit code 4.
    Check(String),
}

impl Failure {
    /// A file that could not be read.
    pub fn read(path: &Path, error: &std::io::Error) -> Self {
        let name = if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() };
        Self::File(format!("cannot read {name}: {error}"))
    }

    /// A file that could not be written; the old one is untouched, unless all were written and only their durability is
    /// uncertain.
    pub fn write(path: impl Display, error: &std::io::Error) -> Self {
        if error.get_ref().is_some_and(|inner| inner.is::<NotDurable>()) {
            return Self::File(error.to_string());
        }
        let path = path.to_string();
        let why = missing_folder(Path::new(&path)).unwrap_or_else(|| error.to_string());
        Self::File(format!("cannot write {path}: {why}"))
    }

    /// Adds the files that were written nevertheless.
    pub fn but_wrote(self, files: &[String]) -> Self {
        match self {
            Self::File(message) if !files.is_empty() => {
                Self::File(format!("{message}; already written: {}", files.join(", ")))
            }
            other => other,
        }
    }
}

/// The first folder on the way to a file that does not exist.
fn missing_folder(path: &Path) -> Option<String> {
    let folders: Vec<&Path> = path.ancestors().skip(1).filter(|folder| !folder.as_os_str().is_empty()).collect();
    let missing = folders.into_iter().rev().find(|folder| !folder.is_dir())?;
    let name = missing.display();
    Some(if missing.exists() { format!("{name} is not a folder") } else { format!("the folder {name} does not exist") })
}

impl From<cyclide_io::Error> for Failure {
    fn from(error: cyclide_io::Error) -> Self {
        match error {
            unread @ cyclide_io::Error::Read { .. } => Self::File(unread.to_string()),
            other => Self::Refused(other.to_string()),
        }
    }
}
