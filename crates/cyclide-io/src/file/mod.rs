//! Writing files whole or not at all.
//!
//! Each file is made complete under a temporary name in its own folder and takes its place by a rename: nobody ever sees
//! half of it, and whatever goes wrong before leaves the old file as it was. Of several files all are made before the
//! first takes its place, in their order; a rename that fails then (rare: the folder was writable a moment ago) leaves
//! those before it replaced. A run that is killed may leave a temporary file, which the next one for the same target
//! removes.
//!
//! What is not a regular file (a pipe, a device, a terminal) is never replaced: it is written into, after the renames of
//! the files before it. Of a link the file it leads to is replaced and the link stays.

mod stale;
mod standard;
mod target;
mod temporary;

use std::error::Error;
use std::fmt;
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use stale::remove_stale;
pub use standard::{leads_to_standard_input, leads_to_standard_output};
use target::Target;
pub use target::same_file;
use temporary::Temporary;

/// How files are written.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// let options = cyclide_io::WriteOptions { durable: true, ..Default::default() };
/// cyclide_io::write_file(&path, b"text", options)?;
/// assert_eq!(std::fs::read(&path)?, b"text");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WriteOptions {
    /// Files that are read-only, or that the user may not write, are replaced too.
    pub force: bool,
    /// The content, and then the names, are on the disk before the call returns, so that they survive a loss of power.
    pub durable: bool,
}

/// Writes a file whole or not at all.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// cyclide_io::write_file(&path, b"text", cyclide_io::WriteOptions::default())?;
/// assert_eq!(std::fs::read(&path)?, b"text");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the file system; a file that is read-only.
pub fn write_file(path: &Path, bytes: &[u8], options: WriteOptions) -> io::Result<()> {
    write_files(&[(path, bytes)], options).map_err(|(_, error)| error)
}

/// Writes several files as [`write_file`] does: none is replaced before all are complete under temporary names.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let files = ["a.txt", "b.txt"].map(|name| (folder.path().join(name), name.as_bytes()));
/// cyclide_io::write_files(&files, cyclide_io::WriteOptions::default()).map_err(|(_, error)| error)?;
/// assert_eq!(std::fs::read(&files[1].0)?, b"b.txt");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the file system, with the index of the file; those before it may have been written.
pub fn write_files<P: AsRef<Path>, B: AsRef<[u8]>>(
    files: &[(P, B)],
    options: WriteOptions,
) -> Result<(), (usize, io::Error)> {
    StagedFiles::new(files, options)?.commit()
}

/// Files that are complete but have not taken their places; dropped, they are removed.
///
/// ```
/// use cyclide_io::{StagedFiles, WriteOptions};
/// let folder = tempfile::tempdir()?;
/// let files = [(folder.path().join("a.txt"), b"text")];
/// let staged = StagedFiles::new(&files, WriteOptions::default()).map_err(|(_, error)| error)?;
/// assert!(!files[0].0.exists());
/// staged.commit().map_err(|(_, error)| error)?;
/// assert!(files[0].0.exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StagedFiles<'a> {
    files: Vec<Staged<'a>>,
    options: WriteOptions,
}

#[derive(Debug)]
enum Staged<'a> {
    File(Temporary),
    /// Bytes for what is no regular file.
    Stream(PathBuf, &'a [u8]),
}

impl<'a> StagedFiles<'a> {
    /// Makes the files under temporary names, and removes temporary files of the same targets that a run left which was
    /// killed.
    ///
    /// # Errors
    /// Those of the file system, with the index of the file; nothing has been replaced.
    pub fn new<P: AsRef<Path>, B: AsRef<[u8]>>(
        files: &'a [(P, B)],
        options: WriteOptions,
    ) -> Result<Self, (usize, io::Error)> {
        let targets = files.iter().enumerate().map(|(i, (path, _))| Target::of(path.as_ref()).map_err(|e| (i, e)));
        let targets = targets.collect::<Result<Vec<_>, _>>()?;
        remove_stale(&targets);
        let staged = targets.into_iter().zip(files).enumerate().map(|(i, (target, (_, bytes)))| match target {
            Target::Stream(path) => Ok(Staged::Stream(path, bytes.as_ref())),
            Target::File { path, old } => {
                Temporary::new(path, old.as_ref(), bytes.as_ref(), options).map(Staged::File).map_err(|e| (i, e))
            }
        });
        Ok(Self { files: staged.collect::<Result<_, _>>()?, options })
    }

    /// Lets the files take their places, in their order.
    ///
    /// # Errors
    /// Those of the file system, with the index of the file; those before it have been written, the others not. With
    /// [`NotDurable`] inside, all have been written.
    pub fn commit(self) -> Result<(), (usize, io::Error)> {
        let mut folders: Vec<PathBuf> = Vec::new();
        let mut place = |staged: Staged<'_>| match staged {
            Staged::Stream(path, bytes) => write_into(&path, bytes),
            Staged::File(temporary) => {
                let folder = temporary.folder().to_path_buf();
                temporary.replace()?;
                if self.options.durable && !folders.contains(&folder) {
                    folders.push(folder);
                }
                Ok(())
            }
        };
        let placed = self.files.into_iter().enumerate().try_for_each(|(i, staged)| place(staged).map_err(|e| (i, e)));
        // The names that were given before another one failed are kept too.
        let synced = sync_folders(&folders).map_err(|e| (0, e));
        placed.and(synced)
    }
}

/// All files have taken their places, but the names in a folder could not be brought to the disk: inside an
/// [`io::Error`].
///
/// ```
/// use cyclide_io::{NotDurable, WriteOptions, write_file};
/// let folder = tempfile::tempdir()?;
/// match write_file(&folder.path().join("a.txt"), b"text", WriteOptions { durable: true, ..WriteOptions::default() }) {
///     Err(error) if error.get_ref().is_some_and(|inner| inner.is::<NotDurable>()) => eprintln!("written, but: {error}"),
///     other => other?,
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct NotDurable {
    folder: PathBuf,
    error: io::Error,
}

impl fmt::Display for NotDurable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { folder, error } = self;
        let folder = folder.display();
        write!(
            f,
            "all files are written, but it is not sure that they survive a loss of power: folder {folder}: {error}"
        )
    }
}

impl Error for NotDurable {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&self.error)
    }
}

/// Writes into a pipe or device. Where it leads to a file all the same (`/dev/stdout`), the bytes are added at its end.
fn write_into(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut stream = OpenOptions::new().append(true).open(path)?;
    stream.write_all(bytes)?;
    stream.flush()
}

/// Brings the names in folders to the disk, where folders can be opened.
fn sync_folders(folders: &[PathBuf]) -> io::Result<()> {
    let sync = |folder: &PathBuf| if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) };
    folders.iter().try_for_each(|folder| {
        sync(folder).map_err(|error| {
            let kind = error.kind();
            io::Error::new(kind, NotDurable { folder: folder.clone(), error })
        })
    })
}

#[cfg(test)]
mod tests;
