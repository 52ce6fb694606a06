//! Files and options of another command: the answer names what was given, and the command that takes it.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory as _};
use cyclide_io::formats::InputKind;

use crate::arguments::args::Args;
use crate::output::failure::Failure;
use crate::output::standard::is_standard;

/// What a command reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// A model document.
    Document,
    /// A list of points.
    Points,
}

/// What the program reads, said where a file is none of it.
const READS: &str = "it reads model documents ('cyclide new' prints one), lists of points as CSV ('cyclide curve') and, from within documents, quad meshes as OBJ ('cyclide new cyclidic-net') and polygon meshes as OBJ, STL, PLY and GLB ('cyclide new smooth-mesh', 'cyclide new principal-grid', 'cyclide new smooth-polyhedron')";

/// Refuses an input that its suffix says to be of another kind, before its first line is called a mistake.
pub fn refuse_suffix(path: &Path, wanted: Wanted) -> Result<(), Failure> {
    InputKind::of_path(path).map_or(Ok(()), |found| refuse(path, found, wanted))
}

/// The same by the first bytes of the file.
pub fn refuse_content(path: &Path, bytes: &[u8], wanted: Wanted) -> Result<(), Failure> {
    InputKind::of_bytes(bytes).map_or(Ok(()), |found| refuse(path, found, wanted))
}

fn refuse(path: &Path, found: InputKind, wanted: Wanted) -> Result<(), Failure> {
    let net = "'cyclide new cyclidic-net' prints a document for it";
    let polygons = "'cyclide new smooth-mesh' prints a document that makes it smooth, 'cyclide new principal-grid' one that computes a net on it, 'cyclide new smooth-polyhedron' one that rounds a convex mesh";
    let path = if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() };
    let answer = match (found, wanted) {
        (InputKind::Document, Wanted::Document) | (InputKind::Points, Wanted::Points) => return Ok(()),
        (InputKind::Written(format), _) => {
            return Err(Failure::Usage(format!("{path} is {format}, which cyclide writes but does not read: {READS}")));
        }
        (InputKind::Foreign(format, instead), _) => {
            let message = format!("{path} is {format}, which cyclide does not read: {instead}; {READS}");
            return Err(Failure::Usage(message));
        }
        (InputKind::Document, Wanted::Points) => "see 'cyclide build'".to_owned(),
        (InputKind::Points, Wanted::Document) => {
            "see 'cyclide curve', or 'cyclide new fair-spline' for a document that reads it".to_owned()
        }
        (InputKind::PointsJson, _) => "'cyclide new fair-spline' prints a document that can contain it".to_owned(),
        (InputKind::PointGrid, Wanted::Points) => {
            format!("{net}; if it is a curve after all, select its columns: --columns x,y,z")
        }
        (InputKind::PointGrid, Wanted::Document) => net.to_owned(),
        (InputKind::Mesh, _) => format!("{net} if its faces are quads, {polygons}"),
        (InputKind::PolygonMesh, _) => polygons.to_owned(),
    };
    let wanted = match wanted {
        Wanted::Document => InputKind::Document,
        Wanted::Points => InputKind::Points,
    };
    Err(Failure::Usage(format!("{path} seems to be {}, not {}: {answer}", found.name(), wanted.name())))
}

/// The tip of an error about the arguments: the command that has the option, or that reads the file.
pub fn explain(mut error: clap::Error) -> clap::Error {
    let given = |error: &clap::Error, kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    let tip = match error.kind() {
        ErrorKind::UnknownArgument => given(&error, ContextKind::InvalidArg).and_then(|option| option_tip(&option)),
        ErrorKind::InvalidSubcommand => given(&error, ContextKind::InvalidSubcommand).and_then(|word| file_tip(&word)),
        _ => None,
    };
    if let Some(tip) = tip {
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
    }
    error
}

/// The commands that have an option.
fn option_tip(option: &str) -> Option<String> {
    let program = Args::command();
    let has = |command: &&Command| {
        command.get_arguments().any(|argument| {
            argument.get_long().is_some_and(|long| option.strip_prefix("--") == Some(long))
                || argument.get_short().is_some_and(|short| option == format!("-{short}"))
        })
    };
    let owners: Vec<String> =
        program.get_subcommands().filter(has).map(|command| format!("'cyclide {}'", command.get_name())).collect();
    (!owners.is_empty()).then(|| format!("'{option}' is an option of {}", owners.join(", ")))
}

/// The command that takes a file which stands in the place of a command.
fn file_tip(word: &str) -> Option<String> {
    match InputKind::of_path(Path::new(word))? {
        InputKind::Document => Some(format!("build a model document with 'cyclide build {word} -o FILE'")),
        InputKind::Points => Some(format!("make a curve from points with 'cyclide curve {word} -o FILE'")),
        InputKind::Mesh => {
            Some("start a document for a mesh with 'cyclide new cyclidic-net' or 'cyclide new smooth-mesh'".to_owned())
        }
        InputKind::PolygonMesh => Some("start a document for a mesh with 'cyclide new smooth-mesh'".to_owned()),
        _ => Some(format!("the program does not read {word}: {READS}")),
    }
}
