//! Builds a document with the program, into every format that its object can have, in a process of its own with limits
//! on time and memory.

use super::Attack;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What one document may cost.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Processor time, seconds.
    pub seconds: u64,
    /// Address space, mebibytes.
    pub mebibytes: u64,
}

/// What became of a document, or of one format of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// A file was written.
    Written,
    /// An input error, by its name.
    Refused(String),
    /// A file that did not pass its check: exit code 4.
    Wrong(String),
    /// Any other end: a panic, an abort, an error without a name.
    Crash(String),
    /// The processor time was used up.
    Slow,
    /// Memory ran out.
    Memory(String),
}

impl Outcome {
    /// True if it is a fault of the program.
    #[must_use]
    pub fn is_fault(&self) -> bool {
        !matches!(self, Self::Written | Self::Refused(_))
    }

    /// Its class in one word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Written => "written",
            Self::Refused(_) => "refused",
            Self::Wrong(_) => "wrong file",
            Self::Crash(_) => "crash",
            Self::Slow => "slow",
            Self::Memory(_) => "memory",
        }
    }
}

/// Formats with geometry of an object with surfaces, and of curves, with the options that make them.
#[must_use]
pub fn formats(attack: &Attack) -> Vec<&'static str> {
    let mut formats = vec!["step", "svg", "json", "glb", "obj"];
    formats.extend(if attack.has_surfaces { vec!["stl"] } else { vec!["dxf", "csv"] });
    formats.extend(later_formats(attack));
    formats
}

/// Those that came later, at the end of the others: which of these a document is tried in does not change by them.
#[must_use]
pub fn later_formats(attack: &Attack) -> &'static [&'static str] {
    if attack.has_surfaces { &["vtu", "mesh", "xml", "ply", "3mf"] } else { &["vtu", "mesh", "xml"] }
}

/// Reports in words give five digits.
const REPORTED: f64 = 1e-4;

/// Builds a document into all of the formats at once; those that fail on their own are left out and the rest is tried
/// again. `arguments` are added to each command. The folder is for this document alone.
#[must_use]
pub fn run(
    program: &Path,
    attack: &Attack,
    folder: &Path,
    limits: Limits,
    arguments: &[&str],
    formats: &[&'static str],
) -> Vec<(&'static str, Outcome)> {
    let document = folder.join("attack.json");
    if let Err(error) = std::fs::write(&document, attack.document.to_string()) {
        return vec![("document", Outcome::Crash(error.to_string()))];
    }
    let mut left = formats.to_vec();
    let mut found = Vec::new();
    while !left.is_empty() {
        let output = command(program, limits)
            .arg("build")
            .arg(&document)
            .args(arguments)
            .args(asked(attack))
            .args(left.iter().flat_map(|format| [PathBuf::from("-o"), folder.join(format!("o.{format}"))]))
            .stdin(Stdio::null())
            .output();
        let outcome = match output {
            Ok(output) => match outcome(&output) {
                Outcome::Written => area_as_known(attack, &output),
                other => other,
            },
            Err(error) => Outcome::Crash(error.to_string()),
        };
        if outcome == Outcome::Written {
            found.extend(left.drain(..).map(|format| (format, Outcome::Written)));
            break;
        }
        let alone = |format: &&'static str| match &outcome {
            Outcome::Refused(text) | Outcome::Wrong(text) => text.contains(&format!("o.{format}:")),
            _ => false,
        };
        let Some(format) = left.iter().copied().find(|format| alone(format)) else {
            found.push(("all", outcome));
            break;
        };
        left.retain(|other| *other != format);
        found.push((format, outcome));
    }
    found
}

/// Written, if the report gives the area that is known.
fn area_as_known(attack: &Attack, output: &Output) -> Outcome {
    let Some(known) = attack.area else { return Outcome::Written };
    let text = String::from_utf8_lossy(&output.stdout);
    let area = |line: &str| line.trim_start().strip_prefix("area ")?.split_whitespace().next()?.parse::<f64>().ok();
    match text.lines().find_map(area) {
        Some(found) if (found / known - 1.0).abs() <= REPORTED => Outcome::Written,
        found => Outcome::Wrong(format!("area {found:?} instead of {known}")),
    }
}

fn asked(attack: &Attack) -> Vec<String> {
    attack.tolerance.map_or_else(Vec::new, |tolerance| vec!["--tolerance".to_owned(), format!("{tolerance:e}")])
}

/// The program under limits, where there is a shell that sets them.
fn command(program: &Path, limits: Limits) -> Command {
    if !cfg!(unix) {
        return Command::new(program);
    }
    let mut command = Command::new("sh");
    let script = format!("ulimit -v {}; ulimit -t {}; exec \"$@\"", limits.mebibytes << 10, limits.seconds);
    command.args(["-c", &script, "sh"]).arg(program);
    command
}

fn outcome(output: &Output) -> Outcome {
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.starts_with("error")).unwrap_or_default();
    let named = line.ends_with(']') && line.contains(" [")
        || text.contains("error: attack.json")
        || line.contains("attack.json:");
    match output.status.code() {
        Some(0) => Outcome::Written,
        Some(1 | 2) if named => Outcome::Refused(line.to_owned()),
        Some(4) => Outcome::Wrong(line.to_owned()),
        None if text.contains("memory allocation") => Outcome::Memory(last_line(&text)),
        // The signal at the end of the time, and the shell's word for it.
        None if text.is_empty() || !text.contains("panicked") => Outcome::Slow,
        Some(134) if text.contains("memory allocation") => Outcome::Memory(last_line(&text)),
        Some(137 | 152) => Outcome::Slow,
        _ => Outcome::Crash(last_line(&text)),
    }
}

fn last_line(text: &str) -> String {
    text.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default().to_owned()
}
