//! Files that are complete take their places, and give them up again if one of them cannot.

use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use super::rights::{keep_rights, refuse_read_only};
use super::target::folder_of;
use super::{WriteOptions, calls};

/// A file that is complete under a temporary name.
#[derive(Debug)]
pub(super) struct Complete {
    /// Where it is.
    pub(super) at: PathBuf,
    /// Where it will be.
    pub(super) target: PathBuf,
    /// A name under which the file that it replaces is kept meanwhile, in the same file system.
    kept: PathBuf,
}

impl Complete {
    /// Writes the content that `target` will have, with the rights and, where that is permitted, the owner of the old file.
    pub(super) fn new(
        [at, kept, target]: [PathBuf; 3],
        old: Option<&Metadata>,
        bytes: &[u8],
        options: WriteOptions,
    ) -> io::Result<Self> {
        if let Some(old) = old.filter(|_| !options.force) {
            refuse_read_only(&target, old)?;
        }
        // Without the temporary name.
        let plain = |error: io::Error| io::Error::from(error.kind());
        let mut file = calls::create_file(&at, old.is_some()).map_err(plain)?;
        calls::write(&mut file, bytes).map_err(plain)?;
        if let Some(old) = old {
            keep_rights(&file, old)?;
        }
        if options.durable {
            calls::sync(&file)?;
        }
        Ok(Self { at, target, kept })
    }

    pub(super) fn folder(&self) -> &Path {
        folder_of(&self.target)
    }

    /// Takes the place of the file.
    pub(super) fn place(self) -> io::Result<Placed> {
        let Self { at, target, kept } = self;
        let old = match fs::symlink_metadata(&target) {
            // A pipe may have been made there since.
            Ok(found) if !found.is_file() => {
                return Err(io::Error::other("it is no longer a regular file"));
            }
            // Some file systems have no second names, and some systems give none to files of others.
            Ok(_) if calls::link(&target, &kept).is_ok() => Old::Kept(kept),
            Ok(_) => Old::Lost,
            Err(_) => Old::None,
        };
        calls::rename(&at, &target)?;
        Ok(Placed { target, old })
    }
}

/// What was at the place of a file before.
#[derive(Debug)]
enum Old {
    None,
    Kept(PathBuf),
    Lost,
}

/// A file that has taken its place.
#[derive(Debug)]
pub(super) struct Placed {
    target: PathBuf,
    old: Old,
}

impl Placed {
    /// Lets the old file take its place again, if it was kept; false if the new one stays.
    pub(super) fn undo(self) -> bool {
        match self.old {
            Old::None => calls::remove_file(&self.target).is_ok(),
            Old::Kept(kept) => calls::rename(&kept, &self.target).is_ok(),
            Old::Lost => false,
        }
    }
}
