//! Developer tasks of cyclide: `cargo xtask <task>`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command-line program reports by printing")]

mod attack;
mod faces;
mod layers;
mod lines;
mod pages;
mod reference;
mod roof;
mod scan;

use std::process::ExitCode;

const HELP: &str = "\
usage: cargo xtask <task> [arguments]

tasks:
  attack [--seed S] [--count N]
             random documents of every type against the built program; `cargo xtask attack --help`
  faces FOLDER
             write bodies of rational faces that no document makes, for the tests of foreign readers
  layers     fail on a forbidden arrow between the rooms of the kernel or between the crates, and on I/O, clocks,
             unsafe code or f32 in the kernel
  lines      lines of code, of tests and of comments in each room
  pages      write the page of each kind of object, docs/kinds, from the doc comments of the documents
  reference [--only CONSTRUCT,… | --curves | --surfaces] FILE…
             run reference cases (cyclide-reference/1) through the public API; `cargo xtask reference --help`
  roof       write the free-form roofs of the examples: examples/roof.obj, examples/roof-20.obj
  scan       write the scanned stone of the examples, coarse and fine: examples/stone.ply, stone-5000.ply
";

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let task = arguments.next();
    let rest: Vec<String> = arguments.collect();
    match task.as_deref() {
        Some("attack") => attack::main(&rest),
        Some("faces") => faces::main(&rest),
        Some("layers") => layers::main(),
        Some("lines") => lines::main(),
        Some("pages") => pages::main(),
        Some("reference") => reference::main(&rest),
        Some("roof") => roof::main(),
        Some("scan") => scan::main(),
        Some("help" | "--help" | "-h") => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        Some(other) => {
            eprint!("no task {other}\n\n{HELP}");
            ExitCode::from(2)
        }
        None => {
            eprint!("{HELP}");
            ExitCode::from(2)
        }
    }
}
