//! What a path leads to: a file that may be replaced, or something that must not.

use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

/// Links that are followed, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// What a path leads to.
#[derive(Debug)]
pub(super) enum Target {
    /// A regular file, or none yet: its path behind all links, and what is there.
    File { path: PathBuf, old: Option<Metadata> },
    /// A pipe, a device, an open file of a process: it is written into.
    Stream(PathBuf),
}

/// True for a name that can only be a folder: it ends in a separator (`out/`), which paths drop silently.
///
/// ```
/// use std::path::Path;
/// assert!(cyclide_io::file::is_folder_name(Path::new("out.step/")) && !cyclide_io::file::is_folder_name(Path::new("out.step")));
/// ```
#[must_use]
pub fn is_folder_name(path: &Path) -> bool {
    let name = path.as_os_str().as_encoded_bytes();
    let name = name.strip_suffix(b".").unwrap_or(name);
    name.last().is_some_and(|last| std::path::is_separator(char::from(*last)))
}

impl Target {
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        if is_folder_name(path) {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let old = match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => return Ok(Self::Stream(path.to_path_buf())),
            Ok(found) => Some(found),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        Ok(match followed(path)? {
            Some(path) => Self::File { path, old },
            None => Self::Stream(path.to_path_buf()),
        })
    }
}

/// The folder that a file is in.
pub(super) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}

/// The path that links lead to, whether there is a file or not; `None` if they go through the open files of a process
/// (`/dev/stdout`), which have no place of their own.
pub(super) fn followed(path: &Path) -> io::Result<Option<PathBuf>> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        if path.starts_with("/proc") || path.starts_with("/dev/fd") {
            return Ok(None);
        }
        if !fs::symlink_metadata(&path).is_ok_and(|found| found.is_symlink()) {
            return Ok(Some(path));
        }
        let to = fs::read_link(&path)?;
        path = folder_of(&path).join(to);
    }
    Err(io::Error::other("too many symbolic links"))
}

/// True if two paths refer to the same file, whether it exists or not: `a.step` and `./a.step`, links and their
/// targets, two names of one file.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// std::fs::write(&path, "1,2")?;
/// assert!(cyclide_io::file::same_file(&path, &folder.path().join(".").join("a.txt")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn same_file(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| -> Option<PathBuf> {
        let path = followed(path).ok()??;
        Some(folder_of(&path).canonicalize().ok()?.join(path.file_name()?))
    };
    if place(a).is_some_and(|place_a| place(b) == Some(place_a)) {
        return true;
    }
    match (fs::metadata(a), fs::metadata(b)) {
        (Ok(x), Ok(y)) => {
            is_one_file(&x, &y) || a.canonicalize().ok().is_some_and(|a| Some(a) == b.canonicalize().ok())
        }
        _ => a.components().eq(b.components()),
    }
}

#[cfg(unix)]
pub(super) fn is_one_file(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn is_one_file(_: &Metadata, _: &Metadata) -> bool {
    false
}
