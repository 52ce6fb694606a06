//! Temporary files that a killed run has left.
//!
//! A run holds a lock on each of its temporary files; the system gives it up however the run ends. A file with the name of
//! a temporary one that can be locked belongs to nobody. Process numbers would not do: they are used again, and another
//! machine or container that shares the folder has its own.

use std::collections::HashMap;
use std::ffi::OsString;
#[cfg(unix)]
use std::fs;
use std::fs::File;
use std::path::Path;

use super::target::{Target, folder_of};
#[cfg(unix)]
use super::temporary::RANDOM;
use super::temporary::prefix;

/// Removes the temporary files for these targets that nobody holds. What cannot be looked at stays.
pub(super) fn remove_stale(targets: &[Target]) {
    let mut folders: HashMap<&Path, Vec<OsString>> = HashMap::new();
    for target in targets {
        if let Target::File { path, .. } = target {
            folders.entry(folder_of(path)).or_default().push(prefix(path));
        }
    }
    for (folder, prefixes) in &folders {
        remove_in(folder, prefixes);
    }
}

#[cfg(unix)]
fn remove_in(folder: &Path, prefixes: &[OsString]) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let is_ours = |name: &[u8]| {
        let rest = prefixes.iter().find_map(|prefix| name.strip_prefix(prefix.as_encoded_bytes()));
        rest.is_some_and(|rest| rest.len() == RANDOM && rest.iter().all(u8::is_ascii_alphanumeric))
    };
    for entry in entries.flatten() {
        if is_ours(entry.file_name().as_encoded_bytes())
            && entry.file_type().is_ok_and(|kind| kind.is_file())
            && File::open(entry.path()).is_ok_and(|file| lock(&file).is_ok())
        {
            // Another run may have been quicker.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Without such locks there is no telling.
#[cfg(not(unix))]
fn remove_in(_: &Path, _: &[OsString]) {}

#[cfg(unix)]
fn lock(file: &File) -> rustix::io::Result<()> {
    rustix::fs::flock(file, rustix::fs::FlockOperation::NonBlockingLockExclusive)
}

/// Takes hold of a new temporary file; false if another run takes it for one that was left.
#[cfg(unix)]
pub(super) fn claim(file: &File) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    match lock(file) {
        Ok(()) => file.metadata().is_ok_and(|found| found.nlink() > 0),
        // Where the file system knows no locks nobody can remove it either.
        Err(error) => error != rustix::io::Errno::WOULDBLOCK,
    }
}

#[cfg(not(unix))]
pub(super) fn claim(_: &File) -> bool {
    true
}
