//! Random documents of every class against the built program: each is written, or refused by name, within the limits on
//! time and memory. `cargo xtask attack` goes on where this ends.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide_testkit::attack;
use cyclide_testkit::attack::runner::{self, Limits};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Documents, each in one of the formats that its object can have, in turn.
const DOCUMENTS: u64 = 200;
const SEED: u64 = 77;
/// As in `xtask attack`; the seconds are of processor time, so that a busy machine changes nothing.
const LIMITS: Limits = Limits { seconds: 20, mebibytes: 2048 };

#[test]
fn random_documents_are_written_or_refused_by_name() {
    let program = Path::new(env!("CARGO_BIN_EXE_cyclide"));
    let scratch = tempfile::tempdir().unwrap();
    let (next, faults) = (AtomicU64::new(0), Mutex::new(Vec::new()));
    let jobs = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for job in 0..jobs {
            let folder = scratch.path().join(job.to_string());
            std::fs::create_dir(&folder).unwrap();
            let (next, faults) = (&next, &faults);
            scope.spawn(move || {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= DOCUMENTS {
                        break;
                    }
                    let attack = attack::document(SEED, number);
                    let formats = runner::formats(&attack);
                    // One format each, and of every fourth document one of the later ones.
                    let later = runner::later_formats(&attack);
                    let first = formats.len() - later.len();
                    let mut asked = vec![formats[number as usize % first]];
                    if number % 4 == 0 {
                        asked.push(later[(number / 4) as usize % later.len()]);
                    }
                    for (format, outcome) in runner::run(program, &attack, &folder, LIMITS, &[], &asked) {
                        if outcome.is_fault() {
                            let fault = format!("--seed {SEED} --from {number}, {format}: {outcome:?}");
                            faults.lock().unwrap().push(fault);
                        }
                    }
                }
            });
        }
    });
    let faults = faults.into_inner().unwrap();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
