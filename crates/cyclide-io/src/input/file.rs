//! Reading input: regular files of a size that can be worked with, and standard input.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

/// Largest input, in bytes: twelve million points.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("large.csv");
/// std::fs::File::create(&path)?.set_len(cyclide_io::input::MOST_INPUT_BYTES + 1)?;
/// assert!(cyclide_io::input::read_input(&path).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const MOST_INPUT_BYTES: u64 = 1 << 29;

/// The bytes of a file.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// std::fs::write(&path, "1,2")?;
/// assert_eq!(cyclide_io::input::read_input(&path)?, b"1,2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the file system; a folder, a pipe or a device; more than [`MOST_INPUT_BYTES`].
pub fn read_input(path: &Path) -> io::Result<Vec<u8>> {
    open(path)?.read()
}

/// The first bytes of a file, at most `count`.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// std::fs::write(&path, "1,2")?;
/// assert_eq!(cyclide_io::input::read_head(&path, 1)?, b"1");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As of [`read_input`].
pub fn read_head(path: &Path, count: u64) -> io::Result<Vec<u8>> {
    open(path)?.read_head(count)
}

/// The bytes of standard input, to its end.
///
/// ```no_run
/// let document: cyclide_io::Document = String::from_utf8(cyclide_io::input::read_standard_input()?)?.parse()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the system; more than [`MOST_INPUT_BYTES`].
pub fn read_standard_input() -> io::Result<Vec<u8>> {
    read(io::stdin().lock())
}

/// Opens a regular file: a pipe would wait for somebody to write, and some devices never end.
fn open(path: &Path) -> io::Result<RegularFile> {
    // Before it is opened: opening is an action on some devices.
    refuse_irregular(&fs::metadata(path)?)?;
    let mut options = OpenOptions::new();
    options.read(true);
    // What has become a pipe since does not wait for a writer.
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, rustix::fs::OFlags::NONBLOCK.bits().cast_signed());
    RegularFile::new(options.open(path)?)
}

/// A regular file, open, of a size that can be worked with.
pub(super) struct RegularFile {
    file: File,
    len: u64,
}

impl RegularFile {
    /// Refuses an open file that is something else.
    pub(super) fn new(file: File) -> io::Result<Self> {
        let found = file.metadata()?;
        refuse_irregular(&found)?;
        let len = found.len();
        if len == 0 && is_made_by_the_system(&file) {
            let message = "it is not a regular file: the system generates its content on reading";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        Ok(Self { file, len })
    }

    /// All bytes.
    pub(super) fn read(self) -> io::Result<Vec<u8>> {
        // Some file systems show queues as files without a length: reading waits for the next entry, and takes it out.
        if self.len == 0 { Ok(Vec::new()) } else { read(self.file) }
    }

    /// The first bytes, at most `count`.
    pub(super) fn read_head(self, count: u64) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        if self.len > 0 {
            self.file.take(count).read_to_end(&mut bytes)?;
        }
        Ok(bytes)
    }
}

pub(super) fn not_regular() -> io::Error {
    let message = "it is not a regular file but a pipe or a device; as standard input its name is `-`";
    io::Error::new(io::ErrorKind::InvalidInput, message)
}

fn refuse_irregular(found: &Metadata) -> io::Result<()> {
    if found.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    if !found.is_file() {
        return Err(not_regular());
    }
    if found.len() > MOST_INPUT_BYTES {
        return Err(too_large(&format!("it has {} bytes", found.len())));
    }
    Ok(())
}

/// True for the files of processes and of the kernel (`/proc`), whose length is not known: reading some of them never ends.
#[cfg(target_os = "linux")]
fn is_made_by_the_system(file: &File) -> bool {
    rustix::fs::fstatfs(file).is_ok_and(|found| found.f_type == rustix::fs::PROC_SUPER_MAGIC)
}

#[cfg(not(target_os = "linux"))]
fn is_made_by_the_system(_: &File) -> bool {
    false
}

fn read(input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(MOST_INPUT_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_INPUT_BYTES {
        return Err(too_large("its content does not end"));
    }
    Ok(bytes)
}

fn too_large(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, format!("{what}, maximum {MOST_INPUT_BYTES}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_files_are_read_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, b"text").unwrap();
        assert_eq!(read_input(&path).unwrap(), b"text");
        assert_eq!(read_head(&path, 2).unwrap(), b"te");
        assert!(read_input(folder.path()).unwrap_err().to_string().contains("a folder"));
        assert!(read_input(&folder.path().join("none")).is_err());
        // A hole of a file: its size is looked at before it is read.
        File::options().write(true).open(&path).unwrap().set_len(MOST_INPUT_BYTES + 1).unwrap();
        let error = read_input(&path).unwrap_err().to_string();
        assert_eq!(error, "it has 536870913 bytes, maximum 536870912");
        if Path::new("/dev/zero").exists() {
            assert!(read_input(Path::new("/dev/zero")).unwrap_err().to_string().contains("not a regular file"));
        }
        for queue in ["/proc/kmsg", "/proc/self/status", "/proc/self/mem"] {
            if Path::new(queue).exists() {
                // Some are not for every user.
                let error = read_input(Path::new(queue)).unwrap_err();
                let denied = error.kind() == io::ErrorKind::PermissionDenied;
                assert!(denied || error.to_string().contains("not a regular file"), "{queue}: {error}");
            }
        }
        fs::write(&path, b"").unwrap();
        assert_eq!(read_input(&path).unwrap(), b"");
        assert_eq!(read_head(&path, 2).unwrap(), b"");
    }

    #[test]
    fn what_has_no_end_is_given_up() {
        let error = read(io::repeat(b'7')).unwrap_err().to_string();
        assert_eq!(error, "its content does not end, maximum 536870912");
    }
}
