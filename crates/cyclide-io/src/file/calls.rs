//! The calls that change the file system, in one place: tests let each of them fail in turn (`faults.rs`).

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

#[cfg(test)]
use super::faults::fault;

/// Outside of tests no call fails on purpose.
#[cfg(not(test))]
const fn fault() -> io::Result<()> {
    Ok(())
}

/// A new folder with a name of its own, for its owner only.
pub(super) fn create_hidden_folder(within: &Path, prefix: &str, random: usize) -> io::Result<PathBuf> {
    fault()?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix).rand_bytes(random);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
    Ok(builder.tempdir_in(within)?.keep())
}

/// A new folder with the rights that any has.
pub(super) fn create_folder(path: &Path) -> io::Result<()> {
    fault()?;
    fs::create_dir(path)
}

/// A new file. One that takes the place of another is private to its owner until it gets the rights of that; any other is as
/// readable as any file made in the ordinary way (the system takes the user's mask off these bits).
pub(super) fn create_file(path: &Path, is_private: bool) -> io::Result<File> {
    fault()?;
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, if is_private { 0o600 } else { 0o666 });
    #[cfg(not(unix))]
    let _ = is_private;
    options.open(path)
}

/// Writes all bytes; a fault comes in the middle of them, as on a disk that is full.
pub(super) fn write(file: &mut File, bytes: &[u8]) -> io::Result<()> {
    if let Err(error) = fault() {
        file.write_all(&bytes[..bytes.len() / 2])?;
        return Err(error);
    }
    file.write_all(bytes)
}

/// Brings a file, or the names in a folder, to the disk.
pub(super) fn sync(file: &File) -> io::Result<()> {
    fault()?;
    file.sync_all()
}

/// Opens a folder, where folders can be opened.
pub(super) fn open_folder(path: &Path) -> io::Result<File> {
    fault()?;
    File::open(path)
}

pub(super) fn open_stream(path: &Path) -> io::Result<File> {
    fault()?;
    OpenOptions::new().append(true).open(path)
}

pub(super) fn set_permissions(file: &File, rights: fs::Permissions) -> io::Result<()> {
    fault()?;
    file.set_permissions(rights)
}

pub(super) fn rename(from: &Path, to: &Path) -> io::Result<()> {
    fault()?;
    fs::rename(from, to)
}

/// A second name for a file.
pub(super) fn link(file: &Path, name: &Path) -> io::Result<()> {
    fault()?;
    fs::hard_link(file, name)
}

pub(super) fn remove_file(path: &Path) -> io::Result<()> {
    fault()?;
    fs::remove_file(path)
}

/// Exchanges what two names lead to, in one step, where the system and the file system can.
#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
pub(super) fn exchange(a: &Path, b: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    fault()?;
    Ok(renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
pub(super) fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    fault()?;
    Err(io::ErrorKind::Unsupported.into())
}
