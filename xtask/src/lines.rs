//! `cargo xtask lines`: how many lines of code, of tests and of comments each room has.
//!
//! A line of code has something besides white space and comments. Tests are files under `tests`, files named `tests.rs` or
//! `…_tests.rs`, and what follows `#[cfg(test)]` in a file: test modules stand at its end.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Folders of Rust code, from the root of the repository.
const FOLDERS: [&str; 4] = ["crates", "xtask", "fuzz", "benches"];

#[derive(Clone, Copy, Default)]
struct Count {
    code: usize,
    tests: usize,
    comments: usize,
}

impl Count {
    fn of(text: &str, is_test: bool) -> Self {
        let mut count = Self::default();
        let mut in_test = is_test;
        for line in text.lines().map(str::trim) {
            in_test |= line == "#[cfg(test)]";
            match line {
                "" => {}
                line if line.starts_with("//") => count.comments += 1,
                _ if in_test => count.tests += 1,
                _ => count.code += 1,
            }
        }
        count
    }

    fn plus(self, other: Self) -> Self {
        Self { code: self.code + other.code, tests: self.tests + other.tests, comments: self.comments + other.comments }
    }
}

pub fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut rooms: BTreeMap<String, Count> = BTreeMap::new();
    for folder in FOLDERS {
        let mut files = Vec::new();
        if let Err(error) = gather(&root.join(folder), &mut files) {
            eprintln!("{folder}: {error}");
            return ExitCode::FAILURE;
        }
        for file in files {
            let Ok(text) = std::fs::read_to_string(&file) else { continue };
            let names: Vec<String> =
                file.strip_prefix(&root).unwrap_or(&file).iter().map(|n| n.to_string_lossy().into_owned()).collect();
            let name = names.last().map_or("", String::as_str);
            let is_test = names.iter().any(|n| n == "tests") || name == "tests.rs" || name.ends_with("_tests.rs");
            let count = rooms.entry(room(&names)).or_default();
            *count = count.plus(Count::of(&text, is_test));
        }
    }
    println!("{:<34} {:>7} {:>7} {:>9}", "room", "code", "tests", "comments");
    let line =
        |name: &str, count: Count| println!("{name:<34} {:>7} {:>7} {:>9}", count.code, count.tests, count.comments);
    rooms.iter().for_each(|(name, count)| line(name, *count));
    line("all", rooms.values().copied().fold(Count::default(), Count::plus));
    ExitCode::SUCCESS
}

/// `crates/NAME/src/ROOM`, whether that is a folder or a file; of what is no source of a crate the first two names.
fn room(names: &[String]) -> String {
    let short = match names {
        [a, b, src, room, ..] if src == "src" => vec![a.as_str(), b, room.strip_suffix(".rs").unwrap_or(room)],
        [a, b, other, ..] if a == "crates" => vec![a.as_str(), b, other],
        [a, b, ..] => vec![a.as_str(), b],
        _ => names.iter().map(String::as_str).collect(),
    };
    short.join("/")
}

fn gather(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            if path.file_name().is_none_or(|name| name != "target") {
                gather(&path, files)?;
            }
        } else if path.extension().is_some_and(|suffix| suffix == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_code_of_tests_and_of_comments_are_told_apart() {
        let text = "//! About.\n\nfn f() {} // here\n/// It.\nfn g() {}\n#[cfg(test)]\nmod tests {\n    // No.\n}\n";
        let Count { code, tests, comments } = Count::of(text, false);
        assert_eq!([code, tests, comments], [2, 3, 3]);
        let names = |path: &str| path.split('/').map(String::from).collect::<Vec<_>>();
        assert_eq!(room(&names("crates/cyclide/src/curve/arc.rs")), "crates/cyclide/curve");
        assert_eq!(room(&names("crates/cyclide/src/lib.rs")), "crates/cyclide/lib");
        assert_eq!(room(&names("crates/cyclide/tests/laws.rs")), "crates/cyclide/tests");
    }
}
