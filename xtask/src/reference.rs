//! `cargo xtask reference`: the command around the runner of the test kit.

use cyclide_testkit::reference::{CURVE_CONSTRUCTS, Report, SURFACE_CONSTRUCTS, run};
use std::process::ExitCode;

const HELP: &str = "\
usage: cargo xtask reference [--only CONSTRUCT,… | --curves | --surfaces] FILE…

Runs every case of the files (format cyclide-reference/1) through the public API of `cyclide` and compares every
expected field at the case's own tolerance; a field that is not compared, a missing or an unexpected error, and a wrong
reason are failures. Prints per construct the cases passed and failed and the largest error over the allowed one.

  --only A,B  run these constructs only; cases of others are skipped and counted
  --curves    run the constructs about curves only
  --surfaces  run the constructs about patches and nets only (volumes are listed as unknown)

Ends with `N passed, M failed`. Exit status: 0 all passed; 1 a case failed, a construct is unknown (one that the kernel
does not have: it is listed, with the number of its cases), a construct of --only is in none of the
files, or nothing was run; 2 a file cannot be read, or the arguments are wrong.
";

/// What the arguments ask for.
#[derive(Debug, PartialEq)]
struct Request {
    files: Vec<String>,
    only: Option<Vec<String>>,
    /// Every construct of `only` must occur.
    named: bool,
}

fn parse(arguments: &[String]) -> Result<Request, String> {
    let mut request = Request { files: Vec::new(), only: None, named: false };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        match argument.as_str() {
            "--only" | "--curves" | "--surfaces" if request.only.is_some() => {
                return Err("--only, --curves and --surfaces exclude each other".into());
            }
            "--only" => {
                let names = rest.next().ok_or("--only needs a list of constructs")?;
                request.only = Some(names.split(',').map(str::to_owned).collect());
                request.named = true;
            }
            "--curves" => request.only = Some(CURVE_CONSTRUCTS.map(str::to_owned).to_vec()),
            "--surfaces" => request.only = Some(SURFACE_CONSTRUCTS.map(str::to_owned).to_vec()),
            option if option.starts_with('-') => return Err(format!("no option {option}")),
            file => request.files.push(file.into()),
        }
    }
    if request.files.is_empty() { Err("no file given".into()) } else { Ok(request) }
}

/// Runs the task.
pub fn main(arguments: &[String]) -> ExitCode {
    if arguments.iter().any(|a| a == "--help" || a == "-h") {
        print!("{HELP}");
        return ExitCode::SUCCESS;
    }
    let request = match parse(arguments) {
        Ok(request) => request,
        Err(message) => {
            eprint!("{message}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    let mut report = Report::default();
    for file in &request.files {
        let outcome = std::fs::read_to_string(file).map_err(|e| e.to_string());
        if let Err(message) = outcome.and_then(|text| run(&text, request.only.as_deref(), &mut report)) {
            eprintln!("{file}: {message}");
            return ExitCode::from(2);
        }
    }
    let seen = |name: &String| {
        report.tallies().iter().any(|(n, _)| n == name) || report.unknown().iter().any(|(n, _)| n == name)
    };
    let named = request.only.filter(|_| request.named).unwrap_or_default();
    let missing: Vec<&String> = named.iter().filter(|name| !seen(name)).collect();
    for name in &missing {
        println!("{name}: in none of the files");
    }
    println!("{report}");
    if report.is_success() && missing.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> Result<Request, String> {
        parse(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn arguments() {
        let request = parsed("a.json --only biarc,arc-split b.json").unwrap();
        assert_eq!(request.files, ["a.json", "b.json"]);
        assert_eq!(request.only.unwrap(), ["biarc", "arc-split"]);
        assert_eq!(parsed("--curves a.json").unwrap().only.unwrap().len(), CURVE_CONSTRUCTS.len());
        assert_eq!(parsed("--surfaces a.json").unwrap().only.unwrap().len(), SURFACE_CONSTRUCTS.len());
        for wrong in ["", "--surfaces --curves a.json", "--only", "--curves", "--only a --curves f", "--fast f"] {
            assert!(parsed(wrong).is_err(), "{wrong}");
        }
    }
}
