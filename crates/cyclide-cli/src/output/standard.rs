//! Standard input and standard output among the names of files.

use std::path::Path;

use cyclide_io::file::leads_to_standard_output;

/// True for the names of standard input and standard output.
pub fn is_standard(path: &Path) -> bool {
    ["-", "/dev/stdin", "/dev/stdout"].iter().any(|name| path.as_os_str() == *name)
}

/// True for an output that is standard output, by its name or by what it leads to. As a file it would be opened a second
/// time, beside the report.
pub fn is_standard_output(path: &Path) -> bool {
    is_standard(path) || leads_to_standard_output(path)
}
