//! Who may read and write a file that takes the place of another one.

use std::fs::{File, Metadata, OpenOptions};
use std::io;
use std::path::Path;

use super::calls;

/// Refuses to replace a file whose rights forbid writing, for everybody or for this user: the folder alone would allow it.
pub(super) fn refuse_read_only(path: &Path, old: &Metadata) -> io::Result<()> {
    let refused = |what| Err(io::Error::new(io::ErrorKind::PermissionDenied, what));
    // The administrator may open it all the same.
    if old.permissions().readonly() {
        return refused("the file is read-only (--force replaces it)");
    }
    match OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            refused("no permission to write the file (--force replaces it)")
        }
        _ => Ok(()),
    }
}

/// Gives a file or a folder the owner, where that is permitted, and the rights of another one.
#[cfg(unix)]
pub(super) fn keep_rights(file: &File, old: &Metadata) -> io::Result<()> {
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
    calls::set_permissions(file, std::fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
pub(super) fn keep_rights(file: &File, old: &Metadata) -> io::Result<()> {
    calls::set_permissions(file, old.permissions())
}

/// True if two files or folders have the same owner, group and rights.
#[cfg(unix)]
pub(super) fn same_rights(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let rights = |found: &Metadata| (found.uid(), found.gid(), found.mode() & 0o7777);
    rights(a) == rights(b)
}

#[cfg(not(unix))]
pub(super) fn same_rights(_: &Metadata, _: &Metadata) -> bool {
    true
}
