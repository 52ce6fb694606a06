//! The error type of reading models; it wraps the kernel's.

pub(crate) mod hints;

use std::path::{Path, PathBuf};

use cyclide::ShortNumber;

use crate::text::escape::escaped;
use crate::text::place::Diagnostic;
use hints::words_of;

/// Result of a fallible call of this crate.
///
/// ```
/// let read: cyclide_io::Result<cyclide_io::Document> = "{}".parse();
/// assert!(read.is_err());
/// ```
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a model was not read or built.
///
/// ```
/// use cyclide_io::{Document, Error};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 0}}}"#;
/// let error = text.parse::<Document>().and_then(|document| document.build()).unwrap_err();
/// assert!(matches!(error, Error::Input(_)) && error.to_string().contains("objects.c.radius"));
/// ```
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text of an input file was refused, at a place in it.
    #[error("{0}")]
    Input(#[from] Box<Diagnostic>),
    /// A file could not be read.
    #[error("{}", unread(path, source, place.as_deref()))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
        /// The message at the place of the document that names the file; `None` if it was not made from a text.
        place: Option<Box<Diagnostic>>,
    },
    /// The kernel refused an object that was not made from a text.
    #[error("{}: {}{} [{}]", escaped(object), of_contour(*contour), words_of(source), source.reason())]
    Geometry {
        /// Name of the object.
        object: String,
        /// The contour, if it has several.
        contour: Option<usize>,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// A grid that was not made from a text is circular, but no patch fits into some of its quads.
    #[error("{}: {} [{CROSSING_QUAD}]", escaped(object), rejected_quads(quads, *steps, *moved))]
    RejectedQuads {
        /// Name of the object.
        object: String,
        /// The quads, s fastest.
        quads: Vec<usize>,
        /// Steps that were made.
        steps: usize,
        /// How far a vertex was moved at most.
        moved: f64,
    },
}

/// The message as it is displayed: what a program prints whose `main` returns the error.
impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

/// The reason for quads whose sides cross; the kernel's of a single one.
pub(crate) const CROSSING_QUAD: &str = "crossing-quad";

/// Quads named in a message at most.
const NAMED_QUADS: usize = 12;

/// The sentence about quads of a circular grid, by index, that no patch fits into.
pub(crate) fn rejected_quads(quads: &[usize], steps: usize, moved: f64) -> String {
    let named: Vec<String> = quads.iter().take(NAMED_QUADS).map(ToString::to_string).collect();
    let more = match quads.len() - named.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let noun = if quads.len() == 1 { "quad" } else { "quads" };
    let moves = match steps {
        0 => "no vertex was moved".to_owned(),
        _ => format!("vertices were moved by up to {} in {steps} steps", ShortNumber(moved)),
    };
    format!("{noun} {}{more}: sides cross or have no length, so no patch fits; {moves}", named.join(", "))
}

fn unread(path: &Path, source: &std::io::Error, place: Option<&Diagnostic>) -> String {
    place.map_or_else(|| format!("cannot read {}: {source}", escaped(&path.display().to_string())), ToString::to_string)
}

/// The words before what was refused of one contour of several.
pub(crate) fn of_contour(contour: Option<usize>) -> String {
    contour.map_or_else(String::new, |contour| format!("contour {contour}: "))
}

#[cfg(test)]
mod tests {
    use cyclide::error::PatchError;
    /// What `fn main() -> Result<(), Box<dyn std::error::Error>>` prints.
    fn shown_by_main(error: impl std::error::Error + 'static) -> String {
        format!("{:?}", Box::<dyn std::error::Error>::from(error))
    }

    #[test]
    fn errors_that_main_returns_can_be_read() {
        let frame = cyclide::Error::Patch(PatchError::FrameNotOrthonormal { measured: 8.0, limit: 1e-9 });
        let wrapped = super::Error::Geometry { object: "roof".to_owned(), contour: None, source: frame.clone() };
        assert_eq!(shown_by_main(wrapped), format!("roof: {frame} [frame-not-orthonormal]"));
    }
}
