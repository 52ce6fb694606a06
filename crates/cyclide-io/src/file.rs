//! Writing files whole or not at all.

use std::io::{self, Write as _};
use std::path::Path;

/// Writes a file by way of a temporary one in the same folder and a rename, so that a failed run leaves the old
/// file untouched and no reader ever sees half of the new one.
///
/// # Errors
/// Those of the file system.
pub fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    Staged::new(path, bytes)?.replace()
}

/// Writes several files as [`write_file`] does: none is replaced before all are on the disk under temporary names.
///
/// # Errors
/// Those of the file system, with the index of the file.
pub fn write_files<P: AsRef<Path>>(files: &[(P, Vec<u8>)]) -> Result<(), (usize, io::Error)> {
    let mut staged = Vec::with_capacity(files.len());
    for (i, (path, bytes)) in files.iter().enumerate() {
        staged.push(Staged::new(path.as_ref(), bytes).map_err(|e| (i, e))?);
    }
    staged.into_iter().enumerate().try_for_each(|(i, file)| file.replace().map_err(|e| (i, e)))
}

/// A file complete under a temporary name beside its own; dropped, it is removed.
struct Staged<'a> {
    file: tempfile::NamedTempFile,
    path: &'a Path,
}

impl<'a> Staged<'a> {
    fn new(path: &'a Path, bytes: &[u8]) -> io::Result<Self> {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."));
        // Said before other files are replaced, and without the temporary name.
        std::fs::metadata(folder)?;
        if path.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".cyclide-");
        #[cfg(unix)]
        builder.permissions(usual_permissions(path));
        let mut file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
        file.write_all(bytes).map_err(|error| io::Error::from(error.kind()))?;
        Ok(Self { file, path })
    }

    fn replace(self) -> io::Result<()> {
        self.file.persist(self.path).map(drop).map_err(|e| e.error)
    }
}

/// Temporary files are private to their owner; the result must be as readable as the file it replaces, or as a
/// file made in the ordinary way (the system takes the user's mask off these bits).
#[cfg(unix)]
fn usual_permissions(path: &Path) -> std::fs::Permissions {
    use std::os::unix::fs::PermissionsExt as _;
    std::fs::Permissions::from_mode(std::fs::metadata(path).map_or(0o666, |m| m.permissions().mode() & 0o777))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_whole_files_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        write_file(&path, b"old").unwrap();
        write_file(&path, b"new").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"new");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_failed_run_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        // A folder of the same name cannot be replaced by a file.
        let path = folder.path().join("taken");
        std::fs::create_dir(&path).unwrap();
        std::fs::write(path.join("inside"), b"old").unwrap();
        assert!(write_file(&path, b"new").is_err());
        assert_eq!(std::fs::read(path.join("inside")).unwrap(), b"old");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(write_file(&folder.path().join("no/such/folder"), b"x").is_err());
    }
}
