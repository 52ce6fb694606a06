//! The `cyclide` command: points, meshes and model documents in, curves and surfaces made of circles out.
//!
//! Arguments are read as typed ([`args`]), turned into a plan that is known to make sense ([`plan`]), and carried out
//! ([`make`], [`inspect`], [`start`], [`gallery`], [`manuals`]), whose files [`outputs`] writes; what belongs to another
//! command is answered with it ([`mistaken`]), and what has no effect is said ([`effect`]). Results go to standard output,
//! everything else to standard error.

mod args;
mod effect;
mod failure;
mod gallery;
mod inspect;
mod load;
mod make;
mod manuals;
mod mistaken;
mod outputs;
mod plan;
mod progress;
mod start;
mod terminal;

use std::process::ExitCode;

use clap::Parser as _;
use plan::Plan;

fn main() -> ExitCode {
    let typed = args::Args::try_parse().unwrap_or_else(|error| mistaken::explain(error).exit());
    let outcome = typed.plan().and_then(|plan| match plan {
        Plan::Make(plan) => make::run(&plan),
        Plan::Sample(plan) => inspect::sample(&plan),
        Plan::Report(plan) => inspect::report(&plan),
        Plan::New(plan) => start::run(&plan),
        Plan::Gallery(plan) => gallery::run(&plan),
        Plan::Schema => inspect::schema(),
        Plan::Completions(shell) => manuals::completions(shell),
        Plan::Man(folder, write) => manuals::man(&folder, write),
    });
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.show(),
    }
}
