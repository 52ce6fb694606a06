//! Standard output and standard error: color only on a terminal, a closed pipe is no error, and of names and pieces of files
//! nothing that a terminal acts on or does not show.

use std::io::{self, Write as _};
use std::process::ExitCode;

use cyclide_io::text::{escaped, escaped_lines};

use crate::output::failure::Failure;

const RED: &str = "\x1b[1;31m";
const YELLOW: &str = "\x1b[1;33m";
const PLAIN: &str = "\x1b[0m";

/// Writes a text for people, or JSON, to standard output. Nobody reading on (`cyclide … | head`) is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    print_bytes(escaped_lines(text).as_bytes())
}

/// The same for the content of a file, as it is.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::write("standard output", &error)),
        _ => Ok(()),
    }
}

/// Writes a report to standard error, where standard output is taken.
pub fn print_aside(text: &str) {
    // There is no one left to tell that standard error is closed.
    let _ = io::stderr().lock().write_all(escaped_lines(text).as_bytes());
}

/// Says what was chosen.
pub fn note(message: &str) {
    show(PLAIN, "note", message);
}

/// Shows an error.
fn error(message: &str) {
    show(RED, "error", message);
}

impl Failure {
    /// Prints the message and gives the exit code.
    pub fn show(self) -> ExitCode {
        let (code, message) = match self {
            Self::Refused(message) => (1, message),
            Self::Usage(message) => (2, message + "\n\nFor more information, try '--help'."),
            Self::File(message) => (3, message),
            Self::Check(message) => (4, message + "\nThis is a bug in cyclide; nothing was written."),
        };
        error(&message);
        ExitCode::from(code)
    }
}

/// Shows a warning.
pub fn warning(message: &str) {
    show(YELLOW, "warning", message);
}

/// The stream takes the colors out where they are not wanted: no terminal, `NO_COLOR`, `TERM=dumb`.
fn show(colour: &str, label: &str, message: &str) {
    // There is no one left to tell that standard error is closed.
    let _ = writeln!(anstream::stderr().lock(), "{colour}{label}:{PLAIN} {}", escaped_lines(message));
}

/// Ends the run with what the argument parser says: help, the version, or an error.
pub fn exit(error: &clap::Error) -> ! {
    let is_plain = |argument: std::ffi::OsString| escaped(&argument.to_string_lossy()) == argument.to_string_lossy();
    if std::env::args_os().all(is_plain) {
        error.exit();
    }
    // It quotes what was typed: then without colors, which are escapes too.
    print_aside(&error.render().to_string());
    std::process::exit(error.exit_code())
}
