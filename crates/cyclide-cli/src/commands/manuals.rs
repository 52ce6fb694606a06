//! `completions` and `man`: what shells and readers of manuals want, made from the definition of the arguments.

use std::path::{Path, PathBuf};

use clap::{Command, CommandFactory as _};
use clap_complete::Shell;
use clap_mangen::Man;
use cyclide_io::file::WriteOptions;

use crate::arguments::args::Args;
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::terminal;

/// Prints the completion script of a shell.
pub fn completions(shell: Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "cyclide", &mut script);
    terminal::print_bytes(&script)
}

/// Writes the manual pages to a folder: one of the program and one per command.
pub fn man(folder: &Path, options: WriteOptions) -> Result<(), Failure> {
    let mut program = Args::command().disable_help_subcommand(true);
    program.build();
    let commands = program.get_subcommands().filter(|command| !command.is_hide_set()).cloned();
    let pages = std::iter::once(program.clone()).chain(commands).map(|command| page(folder, command));
    let pages = pages.collect::<Result<Vec<_>, _>>()?;
    std::fs::create_dir_all(folder).map_err(|error| Failure::write(folder.display(), &error))?;
    let first = folder.join("cyclide.1");
    let text = format!("{} pages; read them with: man -l {}\n", pages.len(), first.display());
    files::write(&pages, options, &text)
}

fn page(folder: &Path, command: Command) -> Result<(PathBuf, Vec<u8>), Failure> {
    let page = Man::new(command).source(concat!("cyclide ", env!("CARGO_PKG_VERSION"))).manual("cyclide");
    let path = folder.join(page.get_filename());
    let mut text = Vec::new();
    page.render(&mut text).map_err(|error| Failure::write(path.display(), &error))?;
    // What stands behind the options is examples; the generator cannot know.
    let text = String::from_utf8_lossy(&text).replace(".SH EXTRA\n", ".SH EXAMPLES\n");
    Ok((path, text.into_bytes()))
}
