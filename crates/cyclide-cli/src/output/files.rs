//! The last steps of a run that writes files: all complete under temporary names, then what is printed, then the files take
//! their places. So standard output that cannot be written leaves the old files as they were.

use std::path::Path;

use cyclide_io::{StagedFiles, WriteOptions};

use crate::output::failure::Failure;
use crate::output::terminal;

/// Writes files and prints a text.
pub fn write<P: AsRef<Path>, B: AsRef<[u8]>>(
    files: &[(P, B)],
    options: WriteOptions,
    text: &str,
) -> Result<(), Failure> {
    let name = |index: usize| files[index].0.as_ref().display().to_string();
    let staged = StagedFiles::new(files, options).map_err(|(i, error)| Failure::write(name(i), &error))?;
    terminal::print(text)?;
    staged.commit().map_err(|(i, error)| {
        let written: Vec<String> = (0..i).map(name).collect();
        Failure::write(name(i), &error).but_wrote(&written)
    })
}
