//! Random documents of every type into every format: each is written and passes its own check, or is refused by name.
//!
//! The same as `cargo xtask attack --count 2000`, on documents that are always the same.

use cyclide_testkit::attack::runner::{self, Limits};
use cyclide_testkit::attack::{self};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

const DOCUMENTS: u64 = 2000;
/// Far above what any of them takes.
const LIMITS: Limits = Limits { seconds: 20, mebibytes: 2048 };

#[test]
fn random_documents_are_written_or_refused_by_name() {
    let program = Path::new(env!("CARGO_BIN_EXE_cyclide"));
    let jobs = std::thread::available_parallelism().map_or(1, usize::from);
    let (next, faults, written) = (AtomicU64::new(0), Mutex::new(Vec::new()), AtomicU64::new(0));
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                let Ok(folder) = tempfile::tempdir() else { return };
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= DOCUMENTS {
                        break;
                    }
                    let attack = attack::document(10, number);
                    let formats = runner::formats(&attack);
                    for (format, outcome) in runner::run(program, &attack, folder.path(), LIMITS, &[], &formats) {
                        if outcome.is_fault() {
                            let fault = format!("{number} {format}: {outcome:?} {attack:?}");
                            faults.lock().map(|mut faults| faults.push(fault)).ok();
                        } else if outcome == runner::Outcome::Written {
                            written.fetch_add(1, Ordering::Relaxed);
                        }
                    }
                }
            });
        }
    });
    let faults = faults.into_inner().unwrap_or_default();
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    // Most documents are right ones.
    let written = written.into_inner();
    assert!(written > 4 * DOCUMENTS, "{written} files of {DOCUMENTS} documents");
}
