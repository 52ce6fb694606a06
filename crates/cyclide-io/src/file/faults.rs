//! Every call that changes the file system fails once, as SQLite tests it: after each fault all is new or all is old.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

use super::{NotDurable, StagedFiles, WriteError, WriteOptions};

thread_local! {
    /// The calls that still succeed, and whether all behind them fail.
    static PLAN: Cell<Option<(usize, bool)>> = const { Cell::new(None) };
}

/// Fails if its turn has come.
pub(super) fn fault() -> io::Result<()> {
    match PLAN.get() {
        None => Ok(()),
        Some((0, all)) => {
            PLAN.set(if all { Some((0, true)) } else { None });
            Err(io::ErrorKind::StorageFull.into())
        }
        Some((more, all)) => {
            PLAN.set(Some((more - 1, all)));
            Ok(())
        }
    }
}

/// Runs something of which the call after `succeed` others fails, or this and all behind it; true beside its result if it came to
/// that.
fn with_fault<T>(succeed: usize, all: bool, run: impl FnOnce() -> T) -> (T, bool) {
    PLAN.set(Some((succeed, all)));
    let result = run();
    let reached = !matches!(PLAN.replace(None), Some((more, _)) if more > 0 || !all);
    (result, reached)
}

/// The files below a folder with their content, and the folders.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            all.extend(content(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
            all.insert(name + "/", Vec::new());
        } else {
            all.insert(name, fs::read(&path).unwrap());
        }
    }
    all
}

/// How files are written.
type Write = fn(&[(std::path::PathBuf, &'static str)], WriteOptions) -> Result<(), WriteError>;

fn one_by_one(files: &[(std::path::PathBuf, &'static str)], options: WriteOptions) -> Result<(), WriteError> {
    StagedFiles::new(files, options)?.commit()
}

fn whole_folder(files: &[(std::path::PathBuf, &'static str)], options: WriteOptions) -> Result<(), WriteError> {
    StagedFiles::whole_folder(files, options)?.commit()
}

/// Old files and new ones: what is there, what is written.
const CASES: [(&[&str], &[&str], Write); 7] = [
    (&[], &["a"], one_by_one),
    (&["a"], &["a"], one_by_one),
    (&["a", "c", "d"], &["a", "b", "c", "sub/d", "e"], one_by_one),
    (&["other"], &["set/a", "set/b"], whole_folder),
    (&["set/a", "set/b"], &["set/a", "set/b", "set/c"], whole_folder),
    // Something else is there: one by one.
    (&["set/a", "set/mine"], &["set/a", "set/b", "set/c"], whole_folder),
    (&["set/a", "set/sub/b"], &["set/a", "set/b"], whole_folder),
];

#[test]
fn after_each_fault_all_is_new_or_all_is_old() {
    for (number, (before, written, write)) in CASES.into_iter().enumerate() {
        for (durable, all) in [(false, false), (false, true), (true, false), (true, true)] {
            let mut faults = 0;
            loop {
                let folder = tempfile::tempdir().unwrap();
                let at = |name: &str| folder.path().join(name);
                fs::create_dir(at("sub")).unwrap();
                for name in before {
                    fs::create_dir_all(at(name).parent().unwrap()).unwrap();
                    fs::write(at(name), "old").unwrap();
                }
                let old = content(folder.path());
                let files: Vec<_> = written.iter().map(|name| (at(name), "new")).collect();
                let mut new = old.clone();
                new.extend(written.iter().map(|name| ((*name).to_owned(), b"new".to_vec())));
                if written[0].starts_with("set/") {
                    new.insert("set/".to_owned(), Vec::new());
                }
                let options = WriteOptions { durable, ..WriteOptions::default() };
                let (result, reached) = with_fault(faults, all, || write(&files, options));
                let found = content(folder.path());
                let case = format!("case {number}, durable {durable}, all {all}, fault {faults}: {result:?}");
                match result {
                    Ok(()) => assert_eq!(found, new, "{case}"),
                    Err(failed) if failed.error.get_ref().is_some_and(|inner| inner.is::<NotDurable>()) => {
                        assert!(found == new || found == old && failed.index == 0, "{case}");
                        assert!(durable, "{case}");
                    }
                    Err(failed) => {
                        assert!(failed.index < files.len(), "{case}");
                        // A disk that does not come back lets nothing be undone: the error says what is new.
                        let mut mixed = old.clone();
                        mixed.extend(failed.written.iter().map(|index| (written[*index].to_owned(), b"new".to_vec())));
                        assert_eq!(found, mixed, "{case}");
                        assert!(all || failed.written.is_empty(), "{case}");
                    }
                }
                if !reached {
                    assert!(faults >= 4, "{case}: too few calls are tried");
                    break;
                }
                faults += 1;
            }
        }
    }
}
