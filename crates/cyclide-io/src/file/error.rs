//! Why files were not written, and which were all the same.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::PathBuf;

/// Why files were not written.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let files = ["a.txt", "no/such/folder/b.txt"].map(|name| (folder.path().join(name), b""));
/// let failed = cyclide_io::file::write_files(&files, cyclide_io::file::WriteOptions::default()).unwrap_err();
/// assert_eq!((failed.index, failed.written.len(), files[0].0.exists()), (1, 0, false));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct WriteError {
    /// Index of the file that could not be written.
    pub index: usize,
    /// The error of the system.
    pub error: io::Error,
    /// Indices of earlier files that remain written, because their old content could not be restored.
    pub written: Vec<usize>,
}

impl WriteError {
    pub(super) fn of(index: usize, error: io::Error) -> Self {
        Self { index, error, written: Vec::new() }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.fmt(f)
    }
}

impl Error for WriteError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&self.error)
    }
}

/// All files are in place, but the names in a folder could not be flushed to disk: inside an [`io::Error`].
///
/// ```
/// use cyclide_io::file::{NotDurable, WriteOptions, write_file};
/// let folder = tempfile::tempdir()?;
/// match write_file(&folder.path().join("a.txt"), b"text", WriteOptions { durable: true, ..WriteOptions::default() }) {
///     Err(error) if error.get_ref().is_some_and(|inner| inner.is::<NotDurable>()) => eprintln!("written, but: {error}"),
///     other => other?,
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct NotDurable {
    pub(super) folder: PathBuf,
    pub(super) error: io::Error,
}

impl fmt::Display for NotDurable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { folder, error } = self;
        let folder = folder.display();
        write!(f, "all files are written, but they may not survive a power failure: folder {folder}: {error}")
    }
}

impl Error for NotDurable {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&self.error)
    }
}
