//! Reading below one folder only, whatever a document names: for documents of people who are not trusted.
//!
//! A path is made canonical, so that `..` and links are followed, and what it leads to must be below the folder. Then it is walked
//! from the open folder component by component without following links: what is exchanged for a link in between is not followed out
//! of the folder.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use crate::input::file::{RegularFile, not_regular};

/// A folder that reading is confined to.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// std::fs::create_dir(folder.path().join("data"))?;
/// std::fs::write(folder.path().join("data/a.csv"), "1,2")?;
/// std::fs::write(folder.path().join("secret"), "x")?;
/// let data = cyclide_io::input::ReadFolder::open(&folder.path().join("data"))?;
/// assert_eq!(data.read(&folder.path().join("data/a.csv"))?, b"1,2");
/// assert!(data.read(&folder.path().join("data/../secret")).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ReadFolder {
    /// Its path as it was given, for messages.
    given: PathBuf,
    /// Its path without links.
    path: PathBuf,
    #[cfg(unix)]
    folder: File,
}

impl ReadFolder {
    /// Opens the folder.
    ///
    /// # Errors
    /// Those of the file system; what is no folder.
    pub fn open(path: &Path) -> io::Result<Self> {
        let canonical = path.canonicalize()?;
        if !fs::metadata(&canonical)?.is_dir() {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        Ok(Self {
            given: path.to_path_buf(),
            #[cfg(unix)]
            folder: rustix::fs::open(&canonical, walk::FOLDER, rustix::fs::Mode::empty())?.into(),
            path: canonical,
        })
    }

    /// The bytes of a regular file below the folder; `path` is not relative to it, it is taken as any program takes it.
    ///
    /// # Errors
    /// As of [`read_input`](crate::input::read_input); a file that is not below the folder, whether it exists or not.
    pub fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let found = self.below(path)?;
        self.open_below(&found)?.read()
    }

    /// Where a path leads to, relative to the folder.
    fn below(&self, path: &Path) -> io::Result<PathBuf> {
        let outside = || {
            let message =
                format!("it is not below the folder {}, to which reading is restricted", self.given.display());
            io::Error::new(io::ErrorKind::PermissionDenied, message)
        };
        let inside = |path: &Path| path.strip_prefix(&self.path).map(Path::to_path_buf).map_err(|_| outside());
        match path.canonicalize() {
            Ok(found) => inside(&found),
            // Nothing is said of what is outside, not even that it does not exist.
            Err(error) => {
                let folder =
                    path.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
                let parent = folder.and_then(|folder| folder.canonicalize().ok()).ok_or_else(outside)?;
                inside(&parent)?;
                let is_link = fs::symlink_metadata(path).is_ok_and(|found| found.is_symlink());
                Err(if is_link { outside() } else { error })
            }
        }
    }

    #[cfg(unix)]
    fn open_below(&self, path: &Path) -> io::Result<RegularFile> {
        RegularFile::new(walk::open(&self.folder, path)?)
    }

    #[cfg(not(unix))]
    fn open_below(&self, path: &Path) -> io::Result<RegularFile> {
        RegularFile::new(File::open(self.path.join(path))?)
    }
}

#[cfg(unix)]
mod walk {
    use std::fs::File;
    use std::io;
    use std::path::Path;

    use super::not_regular;
    use rustix::fs::{AtFlags, FileType, Mode, OFlags, openat, statat};

    /// How folders are opened: on Linux they need not be readable.
    #[cfg(target_os = "linux")]
    pub(super) const FOLDER: OFlags = OFlags::PATH.union(BELOW).union(OFlags::DIRECTORY);
    #[cfg(not(target_os = "linux"))]
    pub(super) const FOLDER: OFlags = BELOW.union(OFlags::DIRECTORY);

    /// No link is followed, and no pipe waited for.
    const BELOW: OFlags = OFlags::CLOEXEC.union(OFlags::NOFOLLOW).union(OFlags::NONBLOCK).union(OFlags::NOCTTY);

    /// Opens a file below a folder by a path without links and `..`.
    pub(super) fn open(folder: &File, path: &Path) -> io::Result<File> {
        let mut folder = folder.try_clone()?;
        let mut names = path.iter().peekable();
        while let Some(name) = names.next() {
            if names.peek().is_some() {
                folder = openat(&folder, name, FOLDER, Mode::empty())?.into();
                continue;
            }
            // Before it is opened: opening is an action on some devices. Of a link it fails.
            let found = statat(&folder, name, AtFlags::SYMLINK_NOFOLLOW)?;
            let kind = FileType::from_raw_mode(found.st_mode);
            if !matches!(kind, FileType::RegularFile | FileType::Directory | FileType::Symlink) {
                return Err(not_regular());
            }
            return Ok(openat(&folder, name, BELOW, Mode::empty())?.into());
        }
        Ok(folder)
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn nothing_outside_is_read_by_any_way() {
        let all = tempfile::tempdir().unwrap();
        let at = |name: &str| all.path().join(name);
        for folder in ["data", "data/sub", "database"] {
            fs::create_dir(at(folder)).unwrap();
        }
        for (name, text) in [("data/a", "a"), ("data/sub/b", "b"), ("secret", "s"), ("database/c", "c")] {
            fs::write(at(name), text).unwrap();
        }
        symlink("sub/b", at("data/inner")).unwrap();
        symlink("../secret", at("data/out")).unwrap();
        symlink("..", at("data/up")).unwrap();
        symlink("../nothing", at("data/dangling")).unwrap();
        symlink("data", at("link")).unwrap();
        for folder in ["data", "link", "database/../data"] {
            let data = ReadFolder::open(&at(folder)).unwrap();
            for (name, text) in [
                ("data/a", "a"),
                ("data/inner", "b"),
                ("link/sub/b", "b"),
                ("data/sub/../a", "a"),
                ("data/up/data/a", "a"),
            ] {
                assert_eq!(data.read(&at(name)).unwrap(), text.as_bytes(), "{name}");
            }
            for name in [
                "secret",
                "data/out",
                "data/up/secret",
                "data/../secret",
                "database/c",
                "data/dangling",
                "nothing",
                "no/such",
            ] {
                let error = data.read(&at(name)).unwrap_err().to_string();
                assert!(error.starts_with("it is not below the folder "), "{name}: {error}");
            }
            assert_eq!(data.read(&at("data/none")).unwrap_err().kind(), io::ErrorKind::NotFound);
            assert!(data.read(&at("data/sub")).unwrap_err().to_string().contains("a folder"));
            assert!(data.read(&at("data")).unwrap_err().to_string().contains("a folder"));
        }
        assert!(ReadFolder::open(&at("secret")).is_err());
    }

    #[test]
    fn links_that_come_after_the_look_are_not_followed() {
        let all = tempfile::tempdir().unwrap();
        let at = |name: &str| all.path().join(name);
        fs::create_dir_all(at("data/sub")).unwrap();
        fs::write(at("data/sub/b"), "b").unwrap();
        fs::create_dir(at("other")).unwrap();
        fs::write(at("other/b"), "secret").unwrap();
        let data = ReadFolder::open(&at("data")).unwrap();
        let found = data.below(&at("data/sub/b")).unwrap();
        fs::rename(at("data/sub"), at("data/gone")).unwrap();
        symlink("../other", at("data/sub")).unwrap();
        assert!(data.open_below(&found).is_err());
        fs::remove_file(at("data/sub")).unwrap();
        fs::create_dir(at("data/sub")).unwrap();
        symlink("../../other/b", at("data/sub/b")).unwrap();
        assert!(data.open_below(&found).is_err());
    }
}
