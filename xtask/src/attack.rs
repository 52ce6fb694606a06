//! `cargo xtask attack`: random documents against the built program.

use cyclide_testkit::attack::runner::{self, Limits, Outcome};
use cyclide_testkit::attack::{self, Attack};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

const HELP: &str = "\
usage: cargo xtask attack [--seed S] [--count N] [--from I] [--only CLASS] [--program FILE] [--jobs J]
                          [--seconds T] [--mebibytes M] [--keep FOLDER] [--png] [--one]

Builds N random documents (default 1000; with --only N of that class) into every format that their objects can have, each in a process of its own
with T seconds of processor time (default 20) and M mebibytes of address space (default 2048). Prints what became of
them, by class, and every document that was not built or refused by name: seed and number make it again
(`--from NUMBER --count 1 --keep FOLDER`). Ends with 1 if there was one.
`--one` builds one format of each document, in turn; `--png` pictures too.
";

/// What was asked for.
struct Request {
    seed: u64,
    numbers: std::ops::Range<u64>,
    only: Option<String>,
    program: PathBuf,
    jobs: usize,
    limits: Limits,
    keep: Option<PathBuf>,
    png: bool,
    one: bool,
}

pub fn main(arguments: &[String]) -> ExitCode {
    if arguments.iter().any(|a| a == "--help" || a == "-h") {
        print!("{HELP}");
        return ExitCode::SUCCESS;
    }
    match parse(arguments).and_then(|request| run(&request)) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("{message}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn parse(arguments: &[String]) -> Result<Request, String> {
    let (mut count, mut from) = (1000, 0);
    let mut request = Request {
        seed: 1,
        numbers: 0..0,
        only: None,
        program: PathBuf::from("target/release/cyclide"),
        jobs: std::thread::available_parallelism().map_or(1, usize::from),
        limits: Limits { seconds: 20, mebibytes: 2048 },
        keep: None,
        png: false,
        one: false,
    };
    let mut rest = arguments.iter();
    while let Some(option) = rest.next() {
        match option.as_str() {
            "--png" => request.png = true,
            "--one" => request.one = true,
            _ => {}
        }
        if option == "--png" || option == "--one" {
            continue;
        }
        let value = rest.next().ok_or_else(|| format!("{option} needs a value"))?;
        let number = || value.parse::<u64>().map_err(|_| format!("{option}: '{value}' is not a count"));
        match option.as_str() {
            "--seed" => request.seed = number()?,
            "--count" => count = number()?,
            "--from" => from = number()?,
            "--only" => request.only = Some(value.clone()),
            "--program" => request.program = PathBuf::from(value),
            "--jobs" => request.jobs = (number()? as usize).max(1),
            "--seconds" => request.limits.seconds = number()?,
            "--mebibytes" => request.limits.mebibytes = number()?,
            "--keep" => request.keep = Some(PathBuf::from(value)),
            _ => return Err(format!("no option {option}")),
        }
    }
    request.numbers = from..from + count;
    Ok(request)
}

/// Counts by class of document and outcome.
type Counts = BTreeMap<(&'static str, &'static str), usize>;

/// Refuses a program that does not run: every document would count as a crash.
fn check_program(program: &Path) -> Result<(), String> {
    let runs = Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    if runs { Ok(()) } else { Err(format!("{} does not run: build it, or name it by --program", program.display())) }
}

/// Runs the attack; gives the number of faults.
fn run(request: &Request) -> Result<usize, String> {
    check_program(&request.program)?;
    let next = AtomicU64::new(request.numbers.start);
    // Documents still to be built: with one class those of others are passed over, up to a thousand times as many.
    let wanted = request.numbers.end - request.numbers.start;
    let taken = AtomicU64::new(0);
    let last = match request.only {
        Some(_) => request.numbers.start + 1000 * wanted,
        None => request.numbers.end,
    };
    let found = Mutex::new((Counts::new(), 0));
    let scratch = request
        .keep
        .clone()
        .unwrap_or_else(|| std::env::temp_dir().join(format!("cyclide-attack-{}", std::process::id())));
    let folders: Vec<PathBuf> = (0..request.jobs).map(|job| scratch.join(job.to_string())).collect();
    for folder in &folders {
        std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    std::thread::scope(|scope| {
        for folder in &folders {
            let (next, taken, found) = (&next, &taken, &found);
            scope.spawn(move || {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= last {
                        break;
                    }
                    let attack = attack::document(request.seed, number);
                    if request.only.as_ref().is_some_and(|only| only != attack.class) {
                        continue;
                    }
                    if taken.fetch_add(1, Ordering::Relaxed) >= wanted {
                        break;
                    }
                    let mut formats = runner::formats(&attack);
                    formats.extend(request.png.then_some("png"));
                    if request.one {
                        formats = vec![formats[number as usize % formats.len()]];
                    }
                    let outcomes = runner::run(&request.program, &attack, folder, request.limits, &[], &formats);
                    if let Ok(mut found) = found.lock() {
                        note(request, number, &attack, &outcomes, &mut found);
                    }
                }
            });
        }
    });
    if request.keep.is_none() {
        // Scratch of our own.
        let _ = std::fs::remove_dir_all(&scratch);
    }
    let (counts, faults) = found.into_inner().map_err(|_| "a thread failed".to_owned())?;
    for ((class, word), count) in &counts {
        println!("{count:>8} {word:<10} {class}");
    }
    println!("{faults} faults");
    Ok(faults)
}

fn note(
    request: &Request,
    number: u64,
    attack: &Attack,
    outcomes: &[(&'static str, Outcome)],
    (counts, faults): &mut (Counts, usize),
) {
    for (format, outcome) in outcomes {
        *counts.entry((attack.class, outcome.word())).or_default() += 1;
        if outcome.is_fault() {
            *faults += 1;
            let tolerance = attack.tolerance.map_or(String::new(), |t| format!(" --tolerance {t:e}"));
            println!(
                "seed {} number {number} ({}), {format}{tolerance}: {outcome:?}\n  {}",
                request.seed, attack.class, attack.document
            );
        }
    }
}
