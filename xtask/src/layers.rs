//! `cargo xtask layers`: the rooms of the kernel and who may use whom.
//!
//! Reads every source file of the kernel, finds the rooms it names (`crate::room`, `crate::{room, …}`, and `super`
//! chains that reach the root) and fails on an arrow that points up. Also fails on what the kernel must not contain:
//! files, clocks, processes, `unsafe`, `f32`.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The rooms with what each may use, itself apart. `error` and `warning` stand beside `base`; `lib` sees all.
const ROOMS: [(&str, &[&str]); 9] = [
    ("error", &[]),
    ("warning", &["error", "base"]),
    ("base", &["error", "warning"]),
    ("conformal", &["error", "warning", "base"]),
    ("rational", &["error", "warning", "base", "conformal"]),
    ("curve", &["error", "warning", "base", "conformal", "rational"]),
    ("mesh", &["error", "warning", "base", "conformal", "rational", "curve"]),
    ("construct", &["error", "warning", "base", "conformal", "rational", "curve"]),
    ("model", &["error", "warning", "base", "conformal", "rational", "curve", "mesh", "construct"]),
];

/// What has no place in a kernel without I/O, clock and hand-written `unsafe`, with `f64` only.
const FORBIDDEN: [&str; 12] = [
    "std::fs",
    "std::io",
    "std::net",
    "std::env",
    "std::process",
    "std::thread",
    "std::time",
    "SystemTime",
    "Instant",
    "println!",
    "unsafe",
    "f32",
];

/// One thing that is wrong, with its place.
#[derive(Debug, PartialEq)]
struct Fault {
    file: PathBuf,
    line: usize,
    what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file.display(), self.line, self.what)
    }
}

/// Runs the task.
pub fn main() -> ExitCode {
    match check_kernel() {
        Ok((files, faults)) => {
            for fault in &faults {
                println!("{fault}");
            }
            println!("{files} files, {} faults", faults.len());
            if faults.is_empty() && files > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            eprintln!("the kernel's sources cannot be read: {error}");
            ExitCode::from(2)
        }
    }
}

/// Number of source files of the kernel, and all their faults.
fn check_kernel() -> std::io::Result<(usize, Vec<Fault>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/cyclide/src");
    let mut files = Vec::new();
    collect(&root, &mut files)?;
    let mut faults = Vec::new();
    for file in &files {
        faults.extend(check(file.strip_prefix(&root).unwrap_or(file), &fs::read_to_string(file)?));
    }
    Ok((files.len(), faults))
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder)?.map(|e| e.map(|e| e.path())).collect::<Result<_, _>>()?;
    entries.sort();
    for path in entries {
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

/// The faults of one file; `file` is relative to the kernel's `src`.
fn check(file: &Path, text: &str) -> Vec<Fault> {
    let mut modules: Vec<String> = file.with_extension("").iter().map(|p| p.to_string_lossy().into_owned()).collect();
    if modules.last().is_some_and(|m| m == "mod") {
        modules.pop();
    }
    let room = modules.first().map_or("", String::as_str);
    let may_use = ROOMS.iter().find(|(name, _)| *name == room).map(|(_, uses)| *uses);
    let fault =
        |at: usize, what: String| Fault { file: file.to_path_buf(), line: text[..at].matches('\n').count() + 1, what };
    let mut faults = Vec::new();
    if room != "lib" && may_use.is_none() {
        faults
            .push(fault(0, format!("{room} is not a room of the kernel: say in xtask/src/layers.rs what it may use")));
    }
    let code = without_comments(text);
    for (at, name) in used_rooms(&code, modules.len()) {
        if name != room && may_use.is_some_and(|uses| !uses.contains(&name.as_str())) {
            faults.push(fault(at, format!("{room} must not use {name}")));
        }
    }
    for word in FORBIDDEN {
        for (at, _) in code.match_indices(word) {
            if is_word(&code, at, word.len()) {
                faults.push(fault(at, format!("{word} has no place in the kernel")));
            }
        }
    }
    faults
}

/// The text with every comment blanked, byte for byte, so that places stay the same. Strings are kept.
fn without_comments(text: &str) -> String {
    let lines = text.split_inclusive('\n').map(|line| match line.find("//") {
        Some(at) => format!("{}{}", &line[..at], line[at..].replace(|c: char| c != '\n', " ")),
        None => line.to_owned(),
    });
    lines.collect()
}

fn is_word(code: &str, at: usize, length: usize) -> bool {
    let part_of_name = |c: char| c.is_alphanumeric() || c == '_';
    !code[..at].ends_with(part_of_name) && !code[at + length..].starts_with(part_of_name)
}

/// The rooms named in a file at this depth of modules, with their places.
fn used_rooms(code: &str, depth: usize) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut paths: Vec<usize> = code.match_indices("crate::").map(|(at, _)| at + "crate::".len()).collect();
    for (at, _) in code.match_indices("super::") {
        let chain = code[at..].split("super::").take_while(|part| part.is_empty()).count();
        let starts_here = !code[..at].ends_with("super::");
        // A chain of `depth` or more reaches the root of the crate (an inline module may be one deeper).
        if starts_here && chain >= depth.max(1) {
            paths.push(at + chain * "super::".len());
        }
    }
    for at in paths {
        let rest = &code[at..];
        if let Some(group) = rest.strip_prefix('{') {
            let mut level = 0_usize;
            let mut start = true;
            for (offset, c) in group.char_indices() {
                match c {
                    '{' => level += 1,
                    '}' if level == 0 => break,
                    '}' => level -= 1,
                    ',' if level == 0 => start = true,
                    c if start && c.is_alphabetic() => {
                        found.push((at, name_at(&group[offset..])));
                        start = false;
                    }
                    _ => {}
                }
            }
        } else {
            found.push((at, name_at(rest)));
        }
    }
    found.retain(|(_, name)| ROOMS.iter().any(|(room, _)| room == name));
    found
}

fn name_at(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whats(file: &str, text: &str) -> Vec<String> {
        check(Path::new(file), text).into_iter().map(|f| format!("{}: {}", f.line, f.what)).collect()
    }

    #[test]
    fn the_kernel_keeps_its_layers() {
        let (files, faults) = check_kernel().unwrap();
        assert!(files > 40);
        assert_eq!(faults, []);
    }

    #[test]
    fn arrows_that_point_down_pass() {
        assert!(
            whats("model/lower.rs", "use crate::curve::Arc;\nuse crate::{base::quat::Quat, mesh::flatten};").is_empty()
        );
        assert!(whats("curve/arc/mod.rs", "use super::super::base::Quat;\nuse super::nurbs;").is_empty());
        assert!(whats("lib.rs", "pub use model::Model;\nuse crate::curve::Arc;").is_empty());
    }

    #[test]
    fn arrows_that_point_up_fail_in_every_spelling() {
        assert_eq!(whats("base/quat.rs", "\nuse crate::curve::Arc;"), ["2: base must not use curve"]);
        assert_eq!(whats("curve/arc.rs", "fn f() { crate::model::g() }"), ["1: curve must not use model"]);
        assert_eq!(whats("curve/mod.rs", "use super::construct::x;"), ["1: curve must not use construct"]);
        assert_eq!(whats("curve/arc/mod.rs", "use super::super::mesh::x;"), ["1: curve must not use mesh"]);
        let grouped = "use crate::{base::{a, model}, construct::biarc, model::Item};";
        assert_eq!(whats("mesh/flatten.rs", grouped), ["1: mesh must not use construct", "1: mesh must not use model"]);
    }

    #[test]
    fn comments_do_not_count() {
        assert!(whats("base/quat.rs", "/// See `crate::model::Model`.\n// unsafe").is_empty());
    }

    #[test]
    fn files_clocks_and_single_precision_fail() {
        assert_eq!(whats("base/a.rs", "use std::fs::File;"), ["1: std::fs has no place in the kernel"]);
        assert_eq!(whats("base/a.rs", "let x = 1.0 as f32;"), ["1: f32 has no place in the kernel"]);
        assert!(whats("base/a.rs", "let f32x = unsafe_looking;").is_empty());
    }

    #[test]
    fn a_new_room_must_be_declared() {
        assert_eq!(whats("utils/a.rs", "").len(), 1);
    }
}
