//! Writing files whole or not at all.
//!
//! Each file is made complete in a temporary folder beside the place that it will have and takes that place by a rename: nobody
//! ever sees half of it, and whatever goes wrong before leaves the old file as it was. Of several files all are made before the
//! first takes its place, in their order; if one cannot, those before it give theirs up again. A set that is the whole content of a
//! folder takes its place in one step (`swap.rs`). A signal does not interrupt these steps (`under_way.rs`); a run that is killed may
//! leave its temporary folder, which the next one that writes beside it removes (`stage.rs`).
//!
//! What is not a regular file (a pipe, a device, a terminal) is never replaced: it is written into, after the renames of
//! the files before it. Of a link the file it leads to is replaced and the link stays.

mod calls;
mod error;
#[cfg(test)]
mod faults;
mod place;
mod rights;
mod stage;
mod standard;
mod swap;
mod target;
mod under_way;

use std::collections::HashSet;
use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

pub use error::{NotDurable, WriteError};
use place::{Complete, Placed};
use stage::Stage;
pub use standard::{leads_to_standard_input, leads_to_standard_output};
use swap::NewFolder;
use target::{Target, folder_of};
pub use target::{is_folder_name, same_file};
pub use under_way::Abandoned;
use under_way::step;

/// How files are written.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// let options = cyclide_io::file::WriteOptions { durable: true, ..Default::default() };
/// cyclide_io::file::write_file(&path, b"text", options)?;
/// assert_eq!(std::fs::read(&path)?, b"text");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WriteOptions {
    /// Also replaces files that are read-only or that the user may not write.
    pub force: bool,
    /// Flushes the content, and then the names, to disk before the call returns, so that they survive a power failure.
    pub durable: bool,
}

/// Writes a file completely or not at all.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("a.txt");
/// cyclide_io::file::write_file(&path, b"text", cyclide_io::file::WriteOptions::default())?;
/// assert_eq!(std::fs::read(&path)?, b"text");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the file system; a file that is read-only.
pub fn write_file(path: &Path, bytes: &[u8], options: WriteOptions) -> io::Result<()> {
    write_files(&[(path, bytes)], options).map_err(|failed| failed.error)
}

/// Writes several files as [`write_file`] does: none is replaced before all are complete under temporary names.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let files = ["a.txt", "b.txt"].map(|name| (folder.path().join(name), name.as_bytes()));
/// cyclide_io::file::write_files(&files, cyclide_io::file::WriteOptions::default())?;
/// assert_eq!(std::fs::read(&files[1].0)?, b"b.txt");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the file system, with the file.
pub fn write_files<P: AsRef<Path>, B: AsRef<[u8]>>(files: &[(P, B)], options: WriteOptions) -> Result<(), WriteError> {
    StagedFiles::new(files, options)?.commit()
}

/// Files that are complete but not yet in place; they are removed when this is dropped.
///
/// ```
/// use cyclide_io::file::{StagedFiles, WriteOptions};
/// let folder = tempfile::tempdir()?;
/// let files = [(folder.path().join("a.txt"), b"text")];
/// let staged = StagedFiles::new(&files, WriteOptions::default())?;
/// assert!(!files[0].0.exists());
/// staged.commit()?;
/// assert!(files[0].0.exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StagedFiles<'a> {
    files: Vec<Staged<'a>>,
    /// The folder that takes its place with all of them.
    folder: Option<NewFolder>,
    options: WriteOptions,
    /// Where they are; removed when they have taken their places.
    stages: Vec<(PathBuf, Stage)>,
}

#[derive(Debug)]
enum Staged<'a> {
    File(Complete),
    /// Bytes for what is no regular file.
    Stream(PathBuf, &'a [u8]),
}

impl<'a> StagedFiles<'a> {
    /// Creates the files in temporary folders, and removes leftovers of killed runs.
    ///
    /// # Errors
    /// Those of the file system, with the file; nothing has been replaced.
    pub fn new<P: AsRef<Path>, B: AsRef<[u8]>>(files: &'a [(P, B)], options: WriteOptions) -> Result<Self, WriteError> {
        let mut staged = Self { files: Vec::new(), folder: None, options, stages: Vec::new() };
        let targets = files.iter().enumerate();
        let targets = targets.map(|(i, (path, _))| Target::of(path.as_ref()).map_err(|e| WriteError::of(i, e)));
        // All are looked at before the first is made.
        let targets = targets.collect::<Result<Vec<_>, _>>()?;
        for (index, (target, (_, bytes))) in targets.into_iter().zip(files).enumerate() {
            let made = match target {
                Target::Stream(path) => Ok(Staged::Stream(path, bytes.as_ref())),
                Target::File { path, old } => {
                    staged.complete(index, path, old.as_ref(), bytes.as_ref()).map(Staged::File)
                }
            };
            staged.files.push(made.map_err(|e| WriteError::of(index, e))?);
        }
        Ok(staged)
    }

    /// Like [`new`](Self::new), for files that together are the content of one folder. The folder is created if it does not
    /// exist, and contains all of them or none, however the run ends. This also holds for an existing folder, unless it contains
    /// anything other than regular files with these names or is the working directory: then the files are replaced one by one.
    ///
    /// ```
    /// use cyclide_io::file::{StagedFiles, WriteOptions};
    /// let folder = tempfile::tempdir()?;
    /// let files = ["a.txt", "b.txt"].map(|name| (folder.path().join("set").join(name), name.as_bytes()));
    /// StagedFiles::whole_folder(&files, WriteOptions::default())?.commit()?;
    /// assert_eq!(std::fs::read(&files[1].0)?, b"b.txt");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn whole_folder<P: AsRef<Path>, B: AsRef<[u8]>>(
        files: &'a [(P, B)],
        options: WriteOptions,
    ) -> Result<Self, WriteError> {
        let first = |error| WriteError::of(0, error);
        let names: HashSet<&OsStr> = files.iter().filter_map(|(path, _)| path.as_ref().file_name()).collect();
        let mut folders = files.iter().map(|(path, _)| folder_of(path.as_ref()));
        let folder = folders.next().filter(|first| names.len() == files.len() && folders.all(|other| other == *first));
        let new = folder.map_or(Ok(None), |folder| NewFolder::new(folder, &names)).map_err(first)?;
        let Some((stage, new)) = new else { return Self::new(files, options) };
        let mut staged = Self { files: Vec::new(), folder: None, options, stages: Vec::new() };
        for (index, (path, bytes)) in files.iter().enumerate() {
            let name = path.as_ref().file_name().unwrap_or_default();
            let (at, target) = (new.at.join(name), new.target.join(name));
            let old = fs::metadata(&target).ok();
            let paths = [at, stage.at(&format!("old-{index}")), target];
            let _step = step();
            let made = Complete::new(paths, old.as_ref(), bytes.as_ref(), options);
            staged.files.push(Staged::File(made.map_err(|e| WriteError::of(index, e))?));
        }
        if options.durable {
            sync_folder(&new.at).map_err(first)?;
        }
        staged.stages.push((folder_of(&new.target).to_path_buf(), stage));
        staged.folder = Some(new);
        Ok(staged)
    }

    /// Makes a file in the temporary folder beside its target.
    fn complete(
        &mut self,
        index: usize,
        target: PathBuf,
        old: Option<&fs::Metadata>,
        bytes: &[u8],
    ) -> io::Result<Complete> {
        let folder = folder_of(&target);
        let found = self.stages.iter().position(|(other, _)| other == folder);
        if found.is_none() {
            self.stages.push((folder.to_path_buf(), Stage::new(folder)?));
        }
        let stage = &self.stages[found.unwrap_or(self.stages.len() - 1)].1;
        let paths = [stage.at(&format!("new-{index}")), stage.at(&format!("old-{index}")), target];
        let _step = step();
        Complete::new(paths, old, bytes, self.options)
    }

    /// Moves the files into place, in order.
    ///
    /// # Errors Those of the file system, with the file: the others have their old content again, as far as possible. With
    /// [`NotDurable`] inside, all files have been written.
    pub fn commit(self) -> Result<(), WriteError> {
        // The temporary folders are removed after the last step.
        let Self { files, folder, options, stages: _stages } = self;
        let mut held = Some(step());
        let swapped = match &folder {
            Some(folder) => folder.place(&names(&files)).map_err(|e| WriteError::of(0, e))?,
            None => false,
        };
        let mut folders: Vec<PathBuf> = Vec::new();
        if let (Some(folder), true) = (&folder, swapped) {
            folders.push(folder_of(&folder.target).to_path_buf());
        } else {
            let mut placed = Vec::with_capacity(files.len());
            for (index, staged) in files.into_iter().enumerate() {
                let done = match staged {
                    Staged::Stream(path, bytes) => {
                        // Whoever reads may wait.
                        drop(held.take());
                        let written = write_into(&path, bytes);
                        held = Some(step());
                        written.map(|()| None)
                    }
                    Staged::File(complete) => {
                        if folders.iter().all(|other| other != complete.folder()) {
                            folders.push(complete.folder().to_path_buf());
                        }
                        complete.place().map(Some)
                    }
                };
                match done {
                    Ok(done) => placed.push(done),
                    Err(error) => return Err(WriteError { index, error, written: undo(placed) }),
                }
            }
        }
        drop(held);
        if options.durable {
            folders.iter().try_for_each(|folder| sync_folder(folder)).map_err(|e| WriteError::of(0, e))?;
        }
        Ok(())
    }
}

/// The names of the files, of which none is a stream.
fn names<'s>(files: &'s [Staged<'_>]) -> HashSet<&'s OsStr> {
    let name = |staged: &'s Staged<'_>| match staged {
        Staged::File(complete) => complete.target.file_name(),
        Staged::Stream(..) => None,
    };
    files.iter().filter_map(name).collect()
}

/// Lets old files take their places again, the last first; gives the indices of those that stay new. `None` is a stream.
fn undo(placed: Vec<Option<Placed>>) -> Vec<usize> {
    let stays = |placed: Option<Placed>| placed.is_none_or(|placed| !placed.undo());
    let mut written: Vec<usize> =
        placed.into_iter().enumerate().rev().filter_map(|(index, placed)| stays(placed).then_some(index)).collect();
    written.reverse();
    written
}

/// Writes into a pipe or device. Where it leads to a file all the same (`/dev/stdout`), the bytes are added at its end.
fn write_into(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut stream = calls::open_stream(path)?;
    calls::write(&mut stream, bytes)?;
    stream.flush()
}

/// Brings the names in a folder to the disk, where folders can be opened.
fn sync_folder(folder: &Path) -> io::Result<()> {
    let sync = || if cfg!(unix) { calls::sync(&calls::open_folder(folder)?) } else { Ok(()) };
    sync().map_err(|error| {
        let kind = error.kind();
        io::Error::new(kind, NotDurable { folder: folder.to_path_buf(), error })
    })
}

#[cfg(test)]
mod tests;
