//! `help`: the help of a command, and the manual of a kind of object, made of what the program knows of it.

use clap::{CommandFactory as _, Parser as _};
use cyclide_io::{document::ObjectSpec, manual::KindPage, text::did_you_mean};

use crate::arguments::args::Args;
use crate::output::failure::Failure;
use crate::output::terminal;

/// The word for the list of kinds.
const KINDS: &str = "kinds";

/// Prints what is known of a command or kind, or the help of the program.
pub fn run(word: Option<&str>) -> Result<(), Failure> {
    let Some(word) = word else { return of_program(&["cyclide", "--help"]) };
    if word == KINDS {
        return terminal::print(&format!("{}\n'cyclide help KIND' prints the manual of one.\n", KindPage::list()));
    }
    if let Some(page) = KindPage::of(word) {
        return terminal::print(&page.to_text());
    }
    let program = Args::command();
    let commands: Vec<&str> = program.get_subcommands().map(clap::Command::get_name).collect();
    if commands.contains(&word) {
        return of_program(&["cyclide", word, "--help"]);
    }
    let known = commands.into_iter().chain([KINDS]).chain(ObjectSpec::TYPES.iter().copied());
    let near = did_you_mean(word, known);
    let hint = if near.is_empty() { format!("; 'cyclide help {KINDS}' lists the kinds") } else { near };
    Err(Failure::Usage(format!("there is no command or kind of object `{word}`{hint}")))
}

/// Ends the run with the help that the parser prints for these arguments.
fn of_program(arguments: &[&str]) -> Result<(), Failure> {
    Args::try_parse_from(arguments).map_or_else(|help| terminal::exit(&help), |_| Ok(()))
}
