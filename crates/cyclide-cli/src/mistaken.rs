//! Files and options of another command: the answer names what was given, and the command that takes it.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory as _};

use crate::args::Args;
use crate::failure::Failure;

/// What a command reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// A model document.
    Document,
    /// A list of points.
    Points,
}

/// What a file is, by its suffix or by its first bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Found {
    Document,
    Points,
    /// Points as JSON, which a document holds.
    PointsJson,
    /// Points in rows and columns, or the samples of a surface.
    Grid,
    Mesh,
    /// A format that is written and not read.
    Written(&'static str),
    /// A format that is neither written nor read, and what to save in its place.
    Foreign(&'static str, &'static str),
}

/// What the program reads, said where a file is none of it.
const READS: &str = "it reads model documents ('cyclide new' starts one), lists of points as CSV ('cyclide curve') and meshes of quads as OBJ (in a document: 'cyclide new cyclidic-net')";

/// Bytes of a file that tell what it is.
pub const HEAD: usize = 4096;

/// Refuses an input that its suffix says to be of another kind, before its first line is called a mistake.
pub fn refuse_suffix(path: &Path, wanted: Wanted) -> Result<(), Failure> {
    by_suffix(path).map_or(Ok(()), |found| refuse(path, found, wanted))
}

/// The same by the first bytes of the file.
pub fn refuse_content(path: &Path, bytes: &[u8], wanted: Wanted) -> Result<(), Failure> {
    by_content(&bytes[..bytes.len().min(HEAD)]).map_or(Ok(()), |found| refuse(path, found, wanted))
}

fn refuse(path: &Path, found: Found, wanted: Wanted) -> Result<(), Failure> {
    let net = "'cyclide new cyclidic-net' prints a document for it";
    let (what, answer) = match (found, wanted) {
        (Found::Document, Wanted::Document) | (Found::Points, Wanted::Points) => return Ok(()),
        (Found::Document, Wanted::Points) => ("a model document", "see 'cyclide build'".to_owned()),
        (Found::Points, Wanted::Document) => (
            "a list of points",
            "see 'cyclide curve', or 'cyclide new circle-spline' for a document that reads it".to_owned(),
        ),
        (Found::PointsJson, _) => {
            ("a list of points as JSON", "'cyclide new circle-spline' prints a document with room for it".to_owned())
        }
        (Found::Grid, Wanted::Points) => {
            let choose = "if it is a curve all the same, choose its columns: --columns x,y,z";
            ("points of a surface (its columns speak of rows or patches)", format!("{net}; {choose}"))
        }
        (Found::Grid, Wanted::Document) => ("points of a surface", net.to_owned()),
        (Found::Mesh, _) => ("a mesh", net.to_owned()),
        (Found::Written(format), _) => {
            let message = format!("{} is {format}, which cyclide writes and does not read: {READS}", path.display());
            return Err(Failure::Usage(message));
        }
        (Found::Foreign(format, instead), _) => {
            let message = format!("{} is {format}, which cyclide does not read: {instead}; {READS}", path.display());
            return Err(Failure::Usage(message));
        }
    };
    let wanted = match wanted {
        Wanted::Document => "a model document",
        Wanted::Points => "a list of points",
    };
    Err(Failure::Usage(format!("{} seems to be {what}, not {wanted}: {answer}", path.display())))
}

fn by_suffix(path: &Path) -> Option<Found> {
    let suffix = path.extension()?.to_string_lossy().to_lowercase();
    Some(match suffix.as_str() {
        "json" => Found::Document,
        "csv" | "tsv" | "xyz" => Found::Points,
        "obj" => Found::Mesh,
        "step" | "stp" => Found::Written("STEP"),
        "dxf" => Found::Written("DXF"),
        "svg" => Found::Written("SVG"),
        "glb" => Found::Written("GLB"),
        "stl" => Found::Written("STL"),
        "png" => Found::Written("a picture"),
        "iges" | "igs" | "brep" | "3dm" | "sat" | "fcstd" => {
            Found::Foreign("a CAD file", "export points of its curves as CSV, or a mesh of quads as OBJ")
        }
        "gltf" | "ply" | "off" | "3mf" | "fbx" | "dae" | "blend" => {
            Found::Foreign("a mesh of another format", "save it as OBJ, with its quads")
        }
        "dwg" | "pdf" | "ai" | "eps" => Found::Foreign("a drawing", "export points of its curves as CSV"),
        "xlsx" | "xls" | "ods" => Found::Foreign("a spreadsheet", "save it as CSV"),
        "gpx" | "kml" | "geojson" => Found::Foreign("a geographic file", "save its points as CSV, in a plane grid"),
        _ => return None,
    })
}

fn by_content(head: &[u8]) -> Option<Found> {
    let magic: [(&[u8], Found); 4] = [
        (b"glTF", Found::Written("GLB")),
        (b"\x89PNG", Found::Written("a picture")),
        (b"%PDF", Found::Foreign("a drawing", "export points of its curves as CSV")),
        (b"PK\x03\x04", Found::Foreign("an archive or a spreadsheet", "unpack it, or save it as CSV")),
    ];
    if let Some((_, found)) = magic.iter().find(|(start, _)| head.starts_with(start)) {
        return Some(*found);
    }
    let text = String::from_utf8_lossy(head);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    match text.as_bytes().first()? {
        b'{' if text.contains("\"cyclide\"") => Some(Found::Document),
        b'{' => text.contains("\"cyclide-nurbs\"").then_some(Found::Written("a file of exact B-splines")),
        b'[' => text[1..].trim_start().starts_with('[').then_some(Found::PointsJson),
        b'<' => text.contains("<svg").then_some(Found::Written("SVG")),
        _ if text.starts_with("ISO-10303-21") => Some(Found::Written("STEP")),
        _ if text.starts_with("0\nSECTION") || text.starts_with("0\r\nSECTION") => Some(Found::Written("DXF")),
        _ => by_lines(text),
    }
}

/// Meshes and lists of points, by their first lines that are no remark.
fn by_lines(text: &str) -> Option<Found> {
    let fields = |line: &str| -> Vec<String> {
        let fields = line.split([',', ';', '\t', ' ']).map(|f| f.trim_matches('"').to_lowercase());
        fields.filter(|field| !field.is_empty()).collect()
    };
    let number = |field: &String| field.parse::<f64>().is_ok();
    for line in text.lines().take(20) {
        let names = fields(line.trim_start_matches('#'));
        let has = |name: &str| names.iter().any(|field| field == name);
        let grid = [["patch", "s"], ["i", "j"], ["row", "column"], ["row", "col"], ["u", "v"]];
        if has("x") && has("y") && grid.iter().any(|pair| pair.iter().all(|name| has(name))) {
            return Some(Found::Grid);
        }
        if line.trim_start().starts_with('#') {
            continue;
        }
        match names.as_slice() {
            [] => {}
            [word, ..] if word == "mtllib" => return Some(Found::Mesh),
            [word, rest @ ..]
                if ["v", "vn", "vt", "f"].contains(&word.as_str()) && rest.len() >= 2 && number(&rest[0]) =>
            {
                return Some(Found::Mesh);
            }
            [first, second, ..] if number(first) && number(second) => return Some(Found::Points),
            _ => {}
        }
    }
    None
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
    match by_suffix(Path::new(word))? {
        Found::Document => Some(format!("build a model document with 'cyclide build {word} -o FILE'")),
        Found::Points => Some(format!("make a curve of points with 'cyclide curve {word} -o FILE'")),
        Found::Mesh => Some("start a document for a mesh with 'cyclide new cyclidic-net'".to_owned()),
        _ => Some(format!("the program does not read {word}: {READS}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bytes_tell_what_a_file_is() {
        for (head, found) in [
            (&b"{\"cyclide\": 1}"[..], Some(Found::Document)),
            (b"\xef\xbb\xbf {\n\"cyclide\": 1}", Some(Found::Document)),
            (b"{\"cyclide-nurbs\": 1}", Some(Found::Written("a file of exact B-splines"))),
            (b"{\"other\": 1}", None),
            (b"[[0, 1], [2, 3]]", Some(Found::PointsJson)),
            (b"ISO-10303-21;\nHEADER;", Some(Found::Written("STEP"))),
            (b"  0\nSECTION\n  2\nHEADER", Some(Found::Written("DXF"))),
            (b"<?xml version=\"1.0\"?>\n<svg>", Some(Found::Written("SVG"))),
            (b"# roof\nv 0 0 0\nv 1 0 0\n", Some(Found::Mesh)),
            (b"mtllib a.mtl\no roof\n", Some(Found::Mesh)),
            (b"# x_m,y_m\n0,1\n", Some(Found::Points)),
            (b"x;y\n0;1\n", Some(Found::Points)),
            (b"0 1 2\n", Some(Found::Points)),
            (b"i,j,x,y,z\n0,0,1,2,3\n", Some(Found::Grid)),
            (b"patch,s,t,x,y,z\n", Some(Found::Grid)),
            (b"t,x,y,z,tangent_x\n0,1,2,3,4\n", Some(Found::Points)),
            (b"vertex v\n", None),
            (b"", None),
            (b"\xff\xfe\x00", None),
        ] {
            assert_eq!(by_content(head), found, "{}", String::from_utf8_lossy(head));
        }
    }
}
