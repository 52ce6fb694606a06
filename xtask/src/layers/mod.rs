//! `cargo xtask layers`: fails on an arrow that the map of ARCHITECTURE.md forbids.
//!
//! Three checks: paths between the rooms of a crate (`use crate::…`, `crate::…`, `super::…` written out of a room),
//! what no kernel file may touch (files, clock, terminal, processes, unsafe code, single precision), and dependencies between the crates
//! of the workspace.

mod houses;
mod manifest;
mod source;

use houses::{HOUSES, House};
use source::{Finding, Source};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Modules of `std` that the kernel does without: it has no input, output, clock, threads or environment.
const FORBIDDEN_STD: [&str; 7] = ["fs", "io", "time", "env", "net", "process", "thread"];

/// Macros that print.
const FORBIDDEN_MACROS: [&str; 5] = ["println", "print", "eprintln", "eprint", "dbg"];

/// Single words: no hand-written unsafe code, double precision only.
const FORBIDDEN_WORDS: [&str; 2] = ["unsafe", "f32"];

/// Folders of the kernel's sentences, and what these do not say: options of the command and JSON.
const SENTENCES: [&str; 2] = ["error/subjects/", "warning/subjects/"];
const FOREIGN_WORDS: [&str; 4] = ["`--", "\\\"", "JSON", "document"];

/// The crates of the workspace and the crates of it that each may depend on; every crate may use the test kit in its tests, and
/// the kernel the grids, which its examples of errors need.
const CRATES: [(&str, &[&str]); 6] = [
    ("cyclide", &[]),
    ("cyclide-grids", &["cyclide"]),
    ("cyclide-io", &["cyclide", "cyclide-grids"]),
    ("cyclide-cli", &["cyclide", "cyclide-io"]),
    ("cyclide-testkit", &["cyclide", "cyclide-grids", "cyclide-io"]),
    ("xtask", &["cyclide", "cyclide-io", "cyclide-testkit"]),
];

/// Runs the task.
pub fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    match check(&root) {
        Ok(outcome) => {
            for violation in &outcome.violations {
                println!("{violation}");
            }
            println!(
                "layers: {} files in rooms and {} crates read, {} forbidden",
                outcome.files,
                outcome.crates,
                outcome.violations.len()
            );
            if outcome.violations.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

/// What was read and what is wrong with it.
#[derive(Debug, Default)]
struct Outcome {
    files: usize,
    crates: usize,
    violations: Vec<String>,
}

fn check(root: &Path) -> Result<Outcome, String> {
    let mut outcome = Outcome::default();
    for house in HOUSES {
        let sources = root.join(house.sources);
        for path in rust_files(&sources)? {
            let relative = path.strip_prefix(&sources).map_err(|e| e.to_string())?;
            let name = relative.to_string_lossy().replace('\\', "/");
            let found = violations_in_file(house, &name, &read(&path)?);
            outcome.violations.extend(found.into_iter().map(|v| format!("{}/{v}", house.sources)));
            outcome.files += 1;
        }
    }
    for folder in crate_folders(root)? {
        let text = read(&folder.join("Cargo.toml"))?;
        outcome.violations.extend(violations_in_manifest(&text));
        outcome.crates += 1;
    }
    Ok(outcome)
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let list = fs::read_dir(folder).and_then(|list| list.map(|entry| Ok(entry?.path())).collect());
    let mut list: Vec<PathBuf> = list.map_err(|e: std::io::Error| format!("{}: {e}", folder.display()))?;
    list.sort();
    Ok(list)
}

fn rust_files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut files = Vec::new();
    for path in entries(folder)? {
        if path.is_dir() {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

fn crate_folders(root: &Path) -> Result<Vec<PathBuf>, String> {
    let mut folders = entries(&root.join("crates"))?;
    folders.retain(|f| f.join("Cargo.toml").is_file());
    folders.push(root.join("xtask"));
    Ok(folders)
}

/// The forbidden paths of a file of a crate, in the kernel macros and keywords too; `name` is its path below `src`.
fn violations_in_file(house: &House, name: &str, text: &str) -> Vec<String> {
    let module: Vec<&str> =
        name.trim_end_matches(".rs").split('/').filter(|part| !matches!(*part, "mod" | "lib" | "main")).collect();
    let source = Source::parse(text);
    let mut violations = Vec::new();
    let mut report = |line: usize, what: String| violations.push(format!("{name}:{line}: {what}"));
    let room = module.first().copied();
    let allowed = room.and_then(|room| house.allowed(room));
    if let (Some(room), None) = (room, allowed) {
        report(1, format!("room {room} is not in the map: say in xtask/src/layers/houses.rs what it may use"));
        return violations;
    }
    for Finding { line, path } in source.paths() {
        if let (Some(room), Some(allowed), Some(target)) = (room, allowed, room_reached(house, &module, path)) {
            if house.allowed(target).is_none() {
                report(*line, format!("{} goes around the rooms: name the room of {target}", path.join("::")));
            } else if target != room && !allowed.contains(&target) {
                report(*line, format!("{room} must not use {target} ({})", path.join("::")));
            }
        }
    }
    if house.is_kernel {
        violations.extend(violations_of_kernel(name, &source));
        violations.extend(foreign_words(name, text));
    }
    violations
}

/// What has no place in a file of the kernel.
fn violations_of_kernel(name: &str, source: &Source) -> Vec<String> {
    let mut violations = Vec::new();
    let mut report = |line: usize, what: String| violations.push(format!("{name}:{line}: {what}"));
    for Finding { line, path } in source.paths() {
        if matches!(path[0].as_str(), "std" | "core") && FORBIDDEN_STD.contains(&path[1].as_str()) {
            report(*line, format!("{} has no place in the kernel", path.join("::")));
        }
    }
    for (line, name) in source.macros() {
        if FORBIDDEN_MACROS.contains(&name.as_str()) {
            report(*line, format!("{name}! has no place in the kernel"));
        }
    }
    for word in FORBIDDEN_WORDS {
        for line in source.keyword(word) {
            report(line, format!("{word} has no place in the kernel"));
        }
    }
    violations
}

/// The first name below the crate root that a path goes through; `None` if it does not leave its room that way.
fn room_reached<'a>(house: &House, module: &[&str], path: &'a [String]) -> Option<&'a str> {
    if path[0] == "crate" {
        return path.get(1).map(String::as_str);
    }
    let supers = path.iter().take_while(|part| *part == "super").count();
    let next = path.get(supers)?;
    // Inside an inline module one more `super` is needed; a name of this file then is no name of a room.
    let is_room = house.allowed(next).is_some();
    (supers > 0 && supers >= module.len() && is_room).then_some(next)
}

/// The forbidden dependencies of a crate.
fn violations_in_manifest(text: &str) -> Vec<String> {
    let manifest = manifest::parse(text);
    let Some((name, allowed)) = CRATES.iter().find(|(name, _)| *name == manifest.name) else {
        return vec![format!("crate {} is not in the map", manifest.name)];
    };
    let forbidden = manifest.dependencies.iter().filter(|dependency| {
        let ours = CRATES.iter().any(|(name, _)| *name == dependency.name);
        let test_kit = dependency.for_tests && ["cyclide-testkit", "cyclide-grids"].contains(&dependency.name.as_str());
        ours && !test_kit && !allowed.contains(&dependency.name.as_str())
    });
    forbidden.map(|dependency| format!("crate {name} must not depend on {}", dependency.name)).collect()
}

/// Words of the command and of documents in the kernel's sentences.
fn foreign_words(name: &str, text: &str) -> Vec<String> {
    if !SENTENCES.iter().any(|folder| name.starts_with(folder)) {
        return Vec::new();
    }
    let code = text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"));
    let found = code.filter_map(|(i, line)| Some((i, FOREIGN_WORDS.iter().find(|word| line.contains(**word))?)));
    found
        .map(|(i, word)| format!("{name}:{}: the kernel knows no {word} of documents and the command", i + 1))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::houses::{CLI, IO, KERNEL};
    use super::*;

    #[test]
    fn the_workspace_has_no_forbidden_arrow() {
        let outcome = check(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).unwrap();
        assert_eq!(outcome.violations, Vec::<String>::new());
        assert!(outcome.files > 20 && outcome.crates == CRATES.len(), "{outcome:?}");
    }

    /// Rooms that use each other in a ring have no ground: every arrow of a map points to a room before.
    #[test]
    fn maps_have_an_order() {
        for house in HOUSES {
            for (index, (room, allowed)) in house.rooms.iter().enumerate() {
                let before = |name: &str| house.rooms[..index].iter().any(|(other, _)| *other == name);
                let up: Vec<_> = allowed.iter().filter(|name| !before(name)).collect();
                assert!(up.is_empty(), "{}: {room} uses {up:?}", house.sources);
            }
        }
    }

    #[test]
    fn readers_writers_and_the_command_have_rooms_too() {
        for (house, file, text) in [
            (&IO, "check/made.rs", "use crate::formats::Format;"),
            (&IO, "document/mod.rs", "use crate::report::Report;"),
            (&IO, "export/job.rs", "fn f(e: &crate::Exporter) {}"),
            (&IO, "loose.rs", ""),
            (&CLI, "output/failure.rs", "use crate::arguments::plan::Plan;"),
        ] {
            assert_eq!(violations_in_file(house, file, text).len(), 1, "{file}: {text}");
        }
        for (house, file, text) in [
            (&IO, "formats/step/mod.rs", "use crate::export::job::Job; use crate::{check::made::Made, text::number};"),
            (&IO, "file/mod.rs", "use std::fs; fn f(x: f64) { println!(\"{}\", x as f32); }"),
            (&CLI, "main.rs", "mod output; use output::failure::Failure;"),
            (&CLI, "commands/make.rs", "use crate::output::terminal;"),
        ] {
            assert_eq!(violations_in_file(house, file, text), Vec::<String>::new(), "{file}: {text}");
        }
    }

    #[test]
    fn arrows_that_point_up_are_found() {
        for (file, text) in [
            ("base/quat.rs", "use crate::curve::Arc;"),
            ("base/mod.rs", "use super::model;"),
            ("error.rs", "use super::base::quat::Quat;"),
            ("curve/arc/mod.rs", "fn f() -> crate::construct::Biarc { todo() }"),
            ("curve/circle.rs", "use crate::{base::vector::Vec3, model::Model};"),
            ("curve/arc/measure.rs", "use super::super::super::mesh::flatten;"),
            ("mesh/flatten.rs", "pub use crate :: construct :: *;"),
            ("construct/curves/biarc.rs", "use crate::mesh::flatten;"),
            ("curve/arc.rs", "use crate::Model;"),
            ("curve/arc.rs", "impl crate::{\n    base::x::Y,\n    Model,\n} {}"),
            ("newroom/x.rs", ""),
        ] {
            assert_eq!(violations_in_file(&KERNEL, file, text).len(), 1, "{file}: {text}");
        }
    }

    #[test]
    fn arrows_that_point_down_pass() {
        for (file, text) in [
            ("model/lower.rs", "use crate::construct::Biarc; use crate::{curve::{Arc, Circle}, error::Result};"),
            ("curve/arc/mod.rs", "use super::param_curve::ParamCurve; use crate::curve::Circle;"),
            ("base/quat.rs", "// use crate::model::Model;\n/* crate::curve */ const S: &str = \"crate::curve::Arc\";"),
            ("base/quat.rs", "fn f<'a>(c: char) -> bool { c == '\"' || c == 'c' } // crate::curve"),
            ("base/quat.rs", "const S: &str = r#\"a \" crate::curve::Arc\"#;"),
            ("lib.rs", "mod curve; pub use crate::model::Model;"),
        ] {
            assert_eq!(violations_in_file(&KERNEL, file, text), Vec::<String>::new(), "{file}: {text}");
        }
    }

    #[test]
    fn input_output_and_unsafe_are_found() {
        for text in [
            "use std::fs;",
            "use std::{fmt, io::Write};",
            "fn f() { let t = std::time::Instant::now(); }",
            "fn f() { println!(\"{}\", 1); }",
            "fn f() { eprint ! (\"x\"); }",
            "unsafe fn f() {}",
            "fn f(x: f64) { g(x as f32); }",
            "fn f() { core::time::Duration::ZERO; }",
        ] {
            for file in ["base/quat.rs", "lib.rs"] {
                assert_eq!(violations_in_file(&KERNEL, file, text).len(), 1, "{file}: {text}");
            }
        }
        assert!(
            violations_in_file(&KERNEL, "base/quat.rs", "use std::fmt; fn print() { write!(f, \"\"); }").is_empty()
        );
    }

    #[test]
    fn sentences_that_speak_of_options_are_found() {
        for (text, count) in [
            ("says \"take `--outliers drop`\";", 1),
            ("says \"take \\\"umbilics\\\"\";", 1),
            ("/// In a document.\nsays \"take pieces\";", 0),
        ] {
            assert_eq!(violations_in_file(&KERNEL, "error/subjects/fit.rs", text).len(), count, "{text}");
        }
    }

    #[test]
    fn crates_that_point_up_are_found() {
        let manifest =
            |name: &str, rest: &str| violations_in_manifest(&format!("[package]\nname = \"{name}\"\n{rest}"));
        assert_eq!(manifest("cyclide", "[dependencies]\ncyclide-io.workspace = true").len(), 1);
        assert_eq!(manifest("cyclide", "[dependencies.cyclide-testkit]\npath = \"..\"").len(), 1);
        assert_eq!(manifest("cyclide-io", "[dependencies]\ncyclide-cli = { path = \"..\" }").len(), 1);
        assert_eq!(
            manifest("cyclide-io", "[target.'cfg(unix)'.dependencies]\nother = { package = \"xtask\" }").len(),
            1
        );
        assert_eq!(manifest("stranger", "").len(), 1);
        assert!(manifest("cyclide", "[dev-dependencies]\ncyclide-testkit.workspace = true # ours").is_empty());
        assert!(manifest("cyclide-cli", "[dependencies]\ncyclide.workspace = true\ncyclide-io = \"1\"").is_empty());
    }
}
