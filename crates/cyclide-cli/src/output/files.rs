//! The last steps of a run that writes files: all complete under temporary names, then what is printed, then the files take
//! their places. So standard output that cannot be written leaves the old files as they were.

use std::path::Path;

use cyclide_io::file::{StagedFiles, WriteError, WriteOptions};

use crate::output::failure::Failure;
use crate::output::signals;
use crate::output::terminal;

/// Writes files and prints a text.
pub fn write<P: AsRef<Path>, B: AsRef<[u8]>>(
    files: &[(P, B)],
    options: WriteOptions,
    text: &str,
) -> Result<(), Failure> {
    signals::remove_files_before_the_end();
    finish(files, StagedFiles::new(files, options), text)
}

/// Writes the files of a set and prints a text. If nothing else is in their folder, it has all of them or none at any time, however the
/// run ends.
pub fn write_set<P: AsRef<Path>, B: AsRef<[u8]>>(
    files: &[(P, B)],
    options: WriteOptions,
    text: &str,
) -> Result<(), Failure> {
    signals::remove_files_before_the_end();
    finish(files, StagedFiles::whole_folder(files, options), text)
}

/// As [`write_set`], of a folder that is made if it does not exist.
pub fn write_folder<B: AsRef<[u8]>>(
    folder: &Path,
    files: &[(String, B)],
    options: WriteOptions,
    text: &str,
) -> Result<(), Failure> {
    let above = folder.parent().unwrap_or(folder);
    std::fs::create_dir_all(above).map_err(|error| Failure::write(above.display(), &error))?;
    let files: Vec<_> = files.iter().map(|(name, bytes)| (folder.join(name), bytes)).collect();
    write_set(&files, options, text)
}

fn finish<P: AsRef<Path>, B: AsRef<[u8]>>(
    files: &[(P, B)],
    staged: Result<StagedFiles<'_>, WriteError>,
    text: &str,
) -> Result<(), Failure> {
    let name = |index: usize| files[index].0.as_ref().display().to_string();
    let failure = |failed: WriteError| {
        let written: Vec<String> = failed.written.iter().copied().map(name).collect();
        Failure::write(name(failed.index), &failed.error).but_wrote(&written)
    };
    let staged = staged.map_err(failure)?;
    terminal::print(text)?;
    staged.commit().map_err(failure)
}
