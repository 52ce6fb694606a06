//! Files that a command reads and writes: where its model comes from, how it writes, and the names that it refuses.

use std::path::{Path, PathBuf};

use clap::Args as ClapArgs;
use cyclide_io::{
    Document, Format,
    file::{WriteOptions, is_folder_name, leads_to_standard_input, same_file},
    input::PointColumns,
};

use crate::output::failure::Failure;
use crate::output::standard::{is_standard, is_standard_output};

/// What a document may read.
#[derive(Debug, Clone, Default, ClapArgs)]
pub struct ReadArgs {
    /// The document may read only files below DIR, for documents from untrusted sources: `..` and links cannot lead out of it.
    #[arg(long, value_name = "DIR")]
    pub read_below: Option<PathBuf>,
}

/// Where the model comes from.
pub enum Input {
    /// A model document; the name `-` is standard input.
    File(PathBuf),
    /// A document made from the command line; it refers to files by their paths as given.
    Made {
        document: Box<Document>,
        /// The columns of its file: unless they were named, the file is looked at for what it is.
        columns: PointColumns,
        /// Whether the names of the columns may determine the unit: not if it was given.
        unit_of_columns: bool,
    },
}

/// How files are written.
#[derive(Debug, Clone, Copy, Default, ClapArgs)]
pub struct WriteArgs {
    /// Also replace read-only files.
    #[arg(long)]
    pub force: bool,
    /// Wait until the files are on disk, so that they survive a power failure.
    #[arg(long)]
    pub durable: bool,
}

impl WriteArgs {
    pub const fn options(self) -> WriteOptions {
        WriteOptions { force: self.force, durable: self.durable }
    }
}

/// Refuses the suffix of a format that another command writes; names without one, and unknown ones, may be meant.
pub fn refuse_other_suffix(path: &Path, suffix: &str, what: &str) -> Result<(), Failure> {
    match Format::from_path(path) {
        Ok(format) if format.name() != suffix => {
            Err(Failure::Usage(format!("{}: {what}; for this format see 'cyclide build'", path.display())))
        }
        _ => Ok(()),
    }
}

/// Refuses the name of a folder (`out/`) where a file is expected: the separator would be dropped silently.
pub fn refuse_folder_name(path: &Path) -> Result<(), Failure> {
    if is_folder_name(path) {
        let path = path.display();
        return Err(Failure::Usage(format!("{path} is a folder: a file name is required")));
    }
    Ok(())
}

/// Refuses the name of a file where a folder is meant.
pub fn refuse_file_name(path: &Path) -> Result<(), Failure> {
    let page = path.extension().is_some_and(|suffix| suffix.eq_ignore_ascii_case("html"));
    if is_standard_output(path) || !path.is_dir() && (page || Format::from_path(path).is_ok()) {
        return Err(Failure::Usage(format!("{}: a folder name is required, for several files", path.display())));
    }
    Ok(())
}

/// Refuses to overwrite an input file.
pub fn refuse_overwriting(output: Option<&Path>, input: &Path) -> Result<(), Failure> {
    let is_input = |output: &&Path| {
        if is_standard(input) { leads_to_standard_input(output) } else { same_file(output, input) }
    };
    match output.filter(|output| !is_standard(output)).filter(is_input) {
        None => Ok(()),
        Some(path) => Err(Failure::Usage(format!("{} is an input and will not be overwritten", path.display()))),
    }
}
