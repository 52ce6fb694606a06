//! The temporary folders of this process, so that a signal can end it without leaving any.
//!
//! Whoever makes, fills or empties one holds the process for a moment: a signal that comes meanwhile is attended to afterwards. So
//! no step is interrupted, and files that take their places together do so before the process ends.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};

static STEPS: RwLock<()> = RwLock::new(());
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A step that is not interrupted. It must not be held twice at a time by one thread.
pub(super) fn step() -> RwLockReadGuard<'static, ()> {
    STEPS.read().unwrap_or_else(PoisonError::into_inner)
}

/// Notes a temporary folder; within a step.
pub(super) fn note(folder: &Path) {
    FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).push(folder.to_path_buf());
}

/// Forgets a temporary folder that has been removed; within a step.
pub(super) fn forget(folder: &Path) {
    FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).retain(|other| other != folder);
}

/// The files of this process that were not yet in place are removed, and nothing is written as long as this value lives.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let files = [(folder.path().join("a.txt"), b"text")];
/// let staged = cyclide_io::file::StagedFiles::new(&files, cyclide_io::file::WriteOptions::default()).map_err(|error| error.error)?;
/// // What a thread does that has been told of a signal, before it ends the process.
/// drop(cyclide_io::file::Abandoned::all());
/// assert_eq!(std::fs::read_dir(folder.path())?.count(), 0);
/// assert!(staged.commit().is_err());
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Abandoned {
    _steps: RwLockWriteGuard<'static, ()>,
}

impl Abandoned {
    /// Waits for the current step, and removes files that are not yet in place.
    #[must_use]
    pub fn all() -> Self {
        let steps = STEPS.write().unwrap_or_else(PoisonError::into_inner);
        for folder in FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
            // There is no one left to tell of what cannot be removed.
            let _ = fs::remove_dir_all(folder);
        }
        Self { _steps: steps }
    }
}
