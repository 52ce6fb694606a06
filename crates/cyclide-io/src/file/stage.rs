//! A temporary folder in which files are made before they take their places, and what killed runs have left of such.
//!
//! A run holds a lock on each of its temporary folders; the system gives it up however the run ends. A folder with such a name that
//! can be locked belongs to nobody. Process numbers would not do: they are used again, and another machine or container that shares
//! the folder has its own. One lock for all files of a folder: a run has as many files open as folders, however many it writes.

use std::fs;
#[cfg(unix)]
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use super::calls;
use super::under_way::{self, step};

/// The names of temporary folders: this, and random letters.
const PREFIX: &str = ".cyclide-";

/// Random letters at the end of a name.
const RANDOM: usize = 8;

/// Times that a folder is made before it is given up: another run may take it for one that was left.
const ATTEMPTS: usize = 8;

/// A temporary folder; dropped, it is removed with what is in it.
#[derive(Debug)]
pub(super) struct Stage {
    path: PathBuf,
    #[cfg(unix)]
    _lock: File,
}

impl Stage {
    /// A new folder within another one, from which those are removed that nobody holds.
    pub(super) fn new(within: &Path) -> io::Result<Self> {
        // Said without the temporary name.
        fs::metadata(within)?;
        remove_left(within);
        let _step = step();
        let plain = |error: io::Error| io::Error::from(error.kind());
        for _ in 0..ATTEMPTS {
            let path = calls::create_hidden_folder(within, PREFIX, RANDOM).map_err(plain)?;
            under_way::note(&path);
            match Self::claim(path) {
                Ok(Some(stage)) => return Ok(stage),
                Ok(None) => {}
                Err(error) => return Err(plain(error)),
            }
        }
        Err(io::ErrorKind::ResourceBusy.into())
    }

    /// Takes hold of a new folder; `None` if another run takes it for one that was left.
    #[cfg(unix)]
    fn claim(path: PathBuf) -> io::Result<Option<Self>> {
        let found = calls::open_folder(&path).map(|lock| (lock_is_ours(&lock, &path), lock));
        match found {
            Ok((true, lock)) => Ok(Some(Self { path, _lock: lock })),
            other => {
                // Another run has removed it, or does.
                let _ = fs::remove_dir(&path);
                under_way::forget(&path);
                match other {
                    Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
                    _ => Ok(None),
                }
            }
        }
    }

    #[cfg(not(unix))]
    fn claim(path: PathBuf) -> io::Result<Option<Self>> {
        Ok(Some(Self { path }))
    }

    /// The path of something in it.
    pub(super) fn at(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        let _step = step();
        // There is no one left to tell of what cannot be removed; the next run tries it again.
        let _ = fs::remove_dir_all(&self.path);
        under_way::forget(&self.path);
    }
}

/// True if the lock was to be had and the folder has not been removed before.
#[cfg(unix)]
fn lock_is_ours(folder: &File, path: &Path) -> bool {
    match lock(folder) {
        Ok(()) => match (folder.metadata(), fs::metadata(path)) {
            (Ok(held), Ok(found)) => super::target::is_one_file(&held, &found),
            _ => false,
        },
        // Where the file system knows no locks nobody can remove it either.
        Err(error) => error != rustix::io::Errno::WOULDBLOCK,
    }
}

#[cfg(unix)]
fn lock(folder: &File) -> rustix::io::Result<()> {
    rustix::fs::flock(folder, rustix::fs::FlockOperation::NonBlockingLockExclusive)
}

/// Removes the temporary folders that nobody holds. What cannot be looked at stays.
#[cfg(unix)]
fn remove_left(within: &Path) {
    let Ok(entries) = fs::read_dir(within) else { return };
    let is_ours = |name: &[u8]| {
        let rest = name.strip_prefix(PREFIX.as_bytes());
        rest.is_some_and(|rest| rest.len() == RANDOM && rest.iter().all(u8::is_ascii_alphanumeric))
    };
    for entry in entries.flatten() {
        if is_ours(entry.file_name().as_encoded_bytes()) && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            // The lock is held until all is gone.
            let Ok(folder) = File::open(entry.path()) else { continue };
            if lock(&folder).is_ok() {
                // Another run may have been quicker.
                let _ = fs::remove_dir_all(entry.path());
            }
        }
    }
}

/// Without such locks there is no telling.
#[cfg(not(unix))]
fn remove_left(_: &Path) {}
