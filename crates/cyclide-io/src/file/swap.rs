//! A folder whose files are exchanged all at once: the new folder takes the place of the old one in one step.
//!
//! That is done only where nothing else is lost by it: a folder that is not there yet, or one that holds regular files of the names
//! of the set, each with this one name, and nothing else. Not the folder that the program runs in: the shell that has called it
//! would be left in the old one.

use std::collections::HashSet;
use std::ffi::OsStr;
use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use super::calls;
use super::rights::{keep_rights, same_rights};
use super::stage::Stage;
use super::target::{folder_of, followed};
use super::under_way::step;

/// A new folder that will take the place of another one.
#[derive(Debug)]
pub(super) struct NewFolder {
    /// The folder that is filled.
    pub(super) at: PathBuf,
    /// Its place.
    pub(super) target: PathBuf,
    /// True if there is a folder already.
    is_exchanged: bool,
}

impl NewFolder {
    /// A new folder in the place of one that files are in, with a stage beside it; `None` if they have to take their places one by
    /// one.
    pub(super) fn new(folder: &Path, names: &HashSet<&OsStr>) -> io::Result<Option<(Stage, Self)>> {
        let Some(followed) = followed(folder)? else { return Ok(None) };
        let old = match fs::symlink_metadata(&followed) {
            Ok(found) if !found.is_dir() => return Ok(None),
            Ok(found) => Some(found),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let target = match old {
            Some(_) => followed.canonicalize()?,
            None => followed,
        };
        if old.is_some() && (is_where_we_are(&target) || !holds_only(&target, names)) {
            return Ok(None);
        }
        // A folder that may be written may be in one that may not.
        let stage = match Stage::new(folder_of(&target)) {
            Err(_) if old.is_some() => return Ok(None),
            other => other?,
        };
        let at = stage.at("new");
        {
            let _step = step();
            calls::create_folder(&at)?;
        }
        match old {
            Some(old) if !has_taken_rights(&at, &old) => Ok(None),
            old => Ok(Some((stage, Self { at, target, is_exchanged: old.is_some() }))),
        }
    }

    /// Takes its place; false if the files have to take theirs one by one.
    pub(super) fn place(&self, names: &HashSet<&OsStr>) -> io::Result<bool> {
        if !self.is_exchanged {
            return calls::rename(&self.at, &self.target).map(|()| true);
        }
        // Something may have been put there since.
        if !holds_only(&self.target, names) || calls::exchange(&self.at, &self.target).is_err() {
            return Ok(false);
        }
        // Or between the look and the step.
        for entry in fs::read_dir(&self.at).into_iter().flatten().flatten() {
            if !is_ours(&entry, names) {
                let _ = fs::rename(entry.path(), self.target.join(entry.file_name()));
            }
        }
        Ok(true)
    }
}

/// Gives a new folder the owner and rights of the old one; false if that is not permitted.
fn has_taken_rights(new: &Path, old: &Metadata) -> bool {
    let taken = File::open(new).and_then(|file| keep_rights(&file, old)).and_then(|()| fs::metadata(new));
    taken.is_ok_and(|new| same_rights(&new, old))
}

fn is_where_we_are(folder: &Path) -> bool {
    let here = std::env::current_dir().and_then(|here| here.canonicalize());
    here.map_or(true, |here| here.starts_with(folder))
}

/// True if a folder holds regular files of these names, and nothing else.
fn holds_only(folder: &Path, names: &HashSet<&OsStr>) -> bool {
    fs::read_dir(folder).is_ok_and(|mut entries| entries.all(|entry| entry.is_ok_and(|entry| is_ours(&entry, names))))
}

fn is_ours(entry: &fs::DirEntry, names: &HashSet<&OsStr>) -> bool {
    names.contains(entry.file_name().as_os_str())
        && entry.metadata().is_ok_and(|found| found.is_file() && has_one_name(&found))
}

#[cfg(unix)]
fn has_one_name(found: &Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(found) == 1
}

#[cfg(not(unix))]
fn has_one_name(_: &Metadata) -> bool {
    true
}
