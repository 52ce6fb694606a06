//! A file that is complete under a temporary name beside the one whose place it will take.

use std::ffi::{OsStr, OsString};
use std::fs::{self, Metadata};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::WriteOptions;
use super::stale::claim;
use super::target::folder_of;

/// Random letters at the end of a temporary name.
pub(super) const RANDOM: usize = 8;

/// Longest name that a temporary one holds whole; file systems take 255 bytes.
const LONGEST_NAME: usize = 200;

/// Times that a temporary file is made before it is given up: another run may take it for one that was left.
const ATTEMPTS: usize = 8;

/// A file complete under a temporary name; dropped, it is removed.
#[derive(Debug)]
pub(super) struct Temporary {
    file: NamedTempFile,
    path: PathBuf,
}

impl Temporary {
    /// Writes the content that `path` will have, with the rights and, where that is permitted, the owner of the old file.
    pub(super) fn new(path: PathBuf, old: Option<&Metadata>, bytes: &[u8], options: WriteOptions) -> io::Result<Self> {
        // Said without the temporary name.
        fs::metadata(folder_of(&path))?;
        if let Some(old) = old.filter(|_| !options.force) {
            refuse_read_only(&path, old)?;
        }
        let mut file = create(&path, old).map_err(|error| io::Error::from(error.kind()))?;
        file.write_all(bytes).map_err(|error| io::Error::from(error.kind()))?;
        if let Some(old) = old {
            keep_rights(file.as_file(), old)?;
        }
        if options.durable {
            file.as_file().sync_all()?;
        }
        Ok(Self { file, path })
    }

    pub(super) fn folder(&self) -> &Path {
        folder_of(&self.path)
    }

    /// Takes the place of the file.
    pub(super) fn replace(self) -> io::Result<()> {
        // A pipe may have been made there since.
        if fs::symlink_metadata(&self.path).is_ok_and(|found| !found.is_file()) {
            return Err(io::Error::other("it has become something else than a file"));
        }
        self.file.persist(&self.path).map(drop).map_err(|error| error.error)
    }
}

/// The beginning of the temporary names for a target.
pub(super) fn prefix(path: &Path) -> OsString {
    let name = path.file_name().unwrap_or_default();
    let mut prefix = OsString::from(".");
    if name.len() <= LONGEST_NAME {
        prefix.push(name)
    } else {
        prefix.push(hash(name))
    }
    prefix.push(".cyclide-");
    prefix
}

/// FNV-1a of a long name, as 16 digits.
fn hash(name: &OsStr) -> String {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", name.as_encoded_bytes().iter().fold(0xcbf2_9ce4_8422_2325, step))
}

/// A new temporary file that no other run takes for one that was left.
fn create(path: &Path, old: Option<&Metadata>) -> io::Result<NamedTempFile> {
    let prefix = prefix(path);
    for _ in 0..ATTEMPTS {
        let mut builder = tempfile::Builder::new();
        builder.prefix(&prefix).rand_bytes(RANDOM);
        #[cfg(unix)]
        builder.permissions(first_rights(old));
        #[cfg(not(unix))]
        let _ = old;
        let file = builder.tempfile_in(folder_of(path))?;
        if claim(file.as_file()) {
            return Ok(file);
        }
    }
    Err(io::ErrorKind::ResourceBusy.into())
}

/// Temporary files are private to their owner while they get the rights of an old file; a new one is as readable as any
/// file made in the ordinary way (the system takes the user's mask off these bits).
#[cfg(unix)]
fn first_rights(old: Option<&Metadata>) -> fs::Permissions {
    use std::os::unix::fs::PermissionsExt as _;
    fs::Permissions::from_mode(if old.is_some() { 0o600 } else { 0o666 })
}

/// Refuses to replace a file whose rights forbid writing, for everybody or for this user: the folder alone would allow it.
fn refuse_read_only(path: &Path, old: &Metadata) -> io::Result<()> {
    let refused = |what| Err(io::Error::new(io::ErrorKind::PermissionDenied, what));
    // The administrator may open it all the same.
    if old.permissions().readonly() {
        return refused("the file is read-only (--force replaces it)");
    }
    match fs::OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            refused("the file is not yours to write (--force replaces it)")
        }
        _ => Ok(()),
    }
}

/// Gives a file the owner, where that is permitted, and the rights of another one.
#[cfg(unix)]
fn keep_rights(file: &fs::File, old: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, fchown};
    let new = file.metadata()?;
    let owner =
        (new.uid(), new.gid()) == (old.uid(), old.gid()) || fchown(file, Some(old.uid()), Some(old.gid())).is_ok();
    let group = owner || new.gid() == old.gid() || fchown(file, None, Some(old.gid())).is_ok();
    let mut mode = old.mode() & if owner { 0o7777 } else { 0o777 };
    if !group {
        // Another group gets no more than all have.
        mode &= !0o070 | ((mode & 0o007) << 3);
    }
    file.set_permissions(fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
fn keep_rights(file: &fs::File, old: &Metadata) -> io::Result<()> {
    file.set_permissions(old.permissions())
}
