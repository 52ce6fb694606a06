//! Names that lead to standard input and output: the file behind a redirection, an open file of the process.

use std::path::Path;

/// True if this is the regular file from which standard input is read (`< m.json`): writing it destroys the input.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// // Nothing reads from a name that does not exist.
/// assert!(!cyclide_io::file::leads_to_standard_input(&folder.path().join("m.json")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn leads_to_standard_input(path: &Path) -> bool {
    behind::standard_input().is_some_and(|input| input.is_file() && behind::is_at(&input, path))
}

/// True if this is the target of standard output, be it a file, a pipe or a device: `/dev/fd/1`, or the name after `>`.
/// False for the null device, where nothing can be mixed.
///
/// ```
/// assert!(!cyclide_io::file::leads_to_standard_output(std::path::Path::new("/dev/null")));
/// ```
#[must_use]
pub fn leads_to_standard_output(path: &Path) -> bool {
    let null = Path::new("/dev/null");
    behind::standard_output().is_some_and(|output| behind::is_at(&output, path) && !behind::is_at(&output, null))
}

#[cfg(unix)]
mod behind {
    use std::fs::{self, File, Metadata};
    use std::io;
    use std::os::fd::AsFd;
    use std::path::Path;

    use super::super::target::is_one_file;

    pub(super) fn standard_input() -> Option<Metadata> {
        of(io::stdin())
    }

    pub(super) fn standard_output() -> Option<Metadata> {
        of(io::stdout())
    }

    fn of(stream: impl AsFd) -> Option<Metadata> {
        File::from(stream.as_fd().try_clone_to_owned().ok()?).metadata().ok()
    }

    pub(super) fn is_at(stream: &Metadata, path: &Path) -> bool {
        fs::metadata(path).is_ok_and(|found| is_one_file(stream, &found))
    }
}

/// Elsewhere files have no numbers to compare.
#[cfg(not(unix))]
mod behind {
    use std::fs::Metadata;
    use std::path::Path;

    pub(super) const fn standard_input() -> Option<Metadata> {
        None
    }

    pub(super) const fn standard_output() -> Option<Metadata> {
        None
    }

    pub(super) const fn is_at(_: &Metadata, _: &Path) -> bool {
        false
    }
}
