//! The `cyclide` command: points, meshes and model documents in, curves and surfaces made of circles out.
//!
//! Arguments are read as typed, turned into a plan that is known to make sense ([`arguments`]), and carried out
//! ([`commands`]). Results go to standard output, everything else to standard error ([`output`]).

mod arguments;
mod commands;
mod output;

use std::process::ExitCode;

use arguments::args::Args;
use arguments::mistaken;
use arguments::plan::Plan;
use clap::Parser as _;
use commands::{compare, gallery, help, inspect, make, manuals, sample, schedule, start};
use output::terminal;

fn main() -> ExitCode {
    let typed = Args::try_parse().unwrap_or_else(|error| terminal::exit(&mistaken::explain(error)));
    let outcome = typed.plan().and_then(|plan| match plan {
        Plan::Make(plan) => make::run(&plan),
        Plan::Compare(plan) => compare::run(&plan),
        Plan::Sample(plan) => sample::run(&plan),
        Plan::Schedule(plan) => schedule::run(&plan),
        Plan::Report(plan) => inspect::report(&plan),
        Plan::New(plan) => start::run(&plan),
        Plan::Gallery(plan) => gallery::run(&plan),
        Plan::Schema => inspect::schema(),
        Plan::Completions(shell) => manuals::completions(shell),
        Plan::Help(word) => help::run(word.as_deref()),
        Plan::Man(folder, write) => manuals::man(&folder, write),
    });
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.show(),
    }
}
